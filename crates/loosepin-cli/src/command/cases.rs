//! `loosepin cases`.

use std::path::Path;

use loosepin::cases::{Case, CaseProblem, case_names, compare_all};
use loosepin::diagnostics::{Diagnostics, nearest_name};
use loosepin::files::{io_error_words, replace_named};
use loosepin::report::{cases_page, cases_text};
use loosepin::units::counted_or_no;

use crate::arguments::{CasesAction, CasesArguments, CasesRunArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Lists the reference cases, or runs them.
pub fn run(arguments: &CasesArguments) -> Ending {
    match &arguments.action {
        Some(CasesAction::Run(run)) => run_cases(run),
        None => list(&arguments.folder.path),
    }
}

fn list(folder: &Path) -> Ending {
    let cases = read(folder, &case_names(folder)?)?;
    let width = cases.iter().map(|case| case.name.len()).max().unwrap_or(0);
    let line = |case: &Case| {
        let numbers = counted_or_no(case.count(), "number", "numbers");
        format!("{:width$}  {:>11}  {}\n", case.name, numbers, case.model.name)
    };
    console::print(&cases.iter().map(line).collect::<String>())?;
    Ok(Done::Well)
}

fn run_cases(arguments: &CasesRunArguments) -> Ending {
    let folder = &arguments.folder.path;
    let known = case_names(folder)?;
    if let Some(name) = arguments.names.iter().find(|name| !known.contains(name)) {
        let nearest = nearest_name(name, known.iter().map(String::as_str)).map(str::to_owned);
        return Err(Failure::of(&CaseProblem::UnknownCase { name: name.clone(), nearest, known }));
    }
    let names = if arguments.names.is_empty() { known } else { arguments.names.clone() };
    let records = compare_all(&read(folder, &names)?)?;
    console::print(&cases_text(&records))?;
    if let Some(path) = &arguments.write {
        replace_named(path, cases_page(&records).as_bytes()).map_err(|error| {
            let (file, reason) = (path.display().to_string(), io_error_words(&error));
            Failure::of(&CaseProblem::NotWritten { file, reason })
        })?;
    }
    let is_within = records.iter().all(|record| record.numbers.iter().all(|number| number.is_within()));
    Ok(if is_within { Done::Well } else { Done::RequirementNotMet })
}

/// Reads cases; the errors of all of them are reported together.
fn read(folder: &Path, names: &[String]) -> Result<Vec<Case>, Diagnostics> {
    let mut cases = Vec::new();
    let mut diagnostics = Diagnostics::new();
    for name in names {
        match Case::from_folder(&folder.join(name)) {
            Ok(case) => cases.push(case),
            Err(others) => diagnostics.extend(others),
        }
    }
    if diagnostics.is_empty() { Ok(cases) } else { Err(diagnostics) }
}
