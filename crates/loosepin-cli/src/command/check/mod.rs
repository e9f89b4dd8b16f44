//! `loosepin check`.

mod elements;
mod law_words;
mod mechanism;
mod study;
mod trial;

use std::path::Path;

use loosepin::diagnostics::Complaints;
use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Values};
use loosepin::study::InputFile;

use super::inputs::warn;
use crate::arguments::CheckArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Says what each file is; a file that is wrong does not keep the others from being looked at.
pub fn run(arguments: &CheckArguments) -> Ending {
    let mut complaints = Complaints::new();
    let mut gap = "";
    for path in &arguments.files {
        match describe(path) {
            Ok(text) => {
                console::print(&format!("{gap}{}: {text}", path.display()))?;
                gap = "\n";
            }
            Err(Failure::Complaints(found)) => complaints.extend(found),
            Err(failure) => return Err(failure),
        }
    }
    if complaints.is_empty() { Ok(Done::Well) } else { Err(complaints.into()) }
}

fn describe(path: &Path) -> Result<String, Failure> {
    describe_input(InputFile::from_path(path)?)
}

fn describe_input(file: InputFile) -> Result<String, Failure> {
    match file {
        InputFile::Model(model) => {
            warn(&model.warnings);
            let values = model.quantities.nominal();
            let (mechanism, tried) = compile_and_try(&model, &values)?;
            Ok(mechanism::words(&mechanism, &values, &tried))
        }
        InputFile::Study(study) => {
            warn(&study.warnings);
            let values = study::middle_values(&study)?;
            let (_, tried) = compile_and_try(&study.model, &values)?;
            study::words(&study, &tried)
        }
    }
}

fn compile_and_try(model: &Model, values: &Values) -> Result<(Mechanism, trial::Trial), Failure> {
    let mechanism = Mechanism::new(model, values).map_err(|error| error.complaint(model))?;
    let tried = trial::try_out(&mechanism, values).map_err(|failure| failure.complaint(model))?;
    Ok((mechanism, tried))
}

#[cfg(test)]
mod tests;
