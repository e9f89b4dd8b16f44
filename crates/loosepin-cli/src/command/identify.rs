//! `loosepin identify`.

use loosepin::diagnostics::Complaints;
use loosepin::identify::record::{Consistent, Identification, Outcome};
use loosepin::identify::{IdentifyProblem, Options, identify, narrowed, write_narrowed};
use loosepin::report::identification_text;
use loosepin::result::json::to_json;
use loosepin::study::Study;

use super::inputs::read_study;
use crate::arguments::IdentifyArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Shows what the readings of a study say of its plays, and writes the narrowed study where that is asked for.
pub fn run(arguments: &IdentifyArguments) -> Ending {
    let study = read_study(&arguments.study)?;
    let options =
        Options { confidence: arguments.confidence, specimen: arguments.specimen.clone(), ..Options::default() };
    let answer = identify(&study, &options)?;
    let text = if arguments.json {
        to_json(&answer).map_err(|error| Failure::of(&IdentifyProblem::NoJson { reason: error.to_string() }))?
    } else {
        identification_text(&answer)
    };
    console::print(&text)?;
    let is_misfit = answer.specimens.iter().any(|specimen| matches!(specimen.outcome, Outcome::Misfit(_)));
    if let Some(path) = &arguments.write {
        // What is not explained is no ground for narrowing.
        if is_misfit {
            console::message(&format!(
                "{} is not written: no values of the plays explain the readings",
                path.display()
            ));
        } else {
            write(&study, &answer, path)?;
        }
    }
    Ok(if is_misfit { Done::Misfit } else { Done::Well })
}

fn write(study: &Study, answer: &Identification, path: &std::path::Path) -> Result<(), Failure> {
    let known = only_specimen(answer)?;
    let (text, changes) = narrowed(study, known);
    write_narrowed(study, path, &text)?;
    console::message(&format!(
        "wrote {}: {}",
        path.display(),
        match changes.len() {
            0 => "no interval is narrower than before".to_owned(),
            count => console::counted(count, "interval narrowed", "intervals narrowed"),
        }
    ));
    for change in changes {
        let [before, after] = [&change.before, &change.after].map(|ends| format!("{} to {}", ends[0], ends[1]));
        console::message(&console::indented(&format!("{}: {after}, before {before}", change.path)));
    }
    Ok(())
}

/// The one specimen that a study can be narrowed to.
fn only_specimen(answer: &Identification) -> Result<&Consistent, Complaints> {
    let mut known = answer.specimens.iter().filter_map(|specimen| match &specimen.outcome {
        Outcome::Consistent(known) => Some(known),
        Outcome::Misfit(_) => None,
    });
    match (known.next(), known.next()) {
        (Some(only), None) => Ok(only),
        _ => Err(Complaints::one(&IdentifyProblem::SeveralSpecimens { found: answer.specimens.len() }, None)),
    }
}
