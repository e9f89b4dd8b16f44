//! `loosepin check`.

mod beams;
mod bending;
mod elements;
mod force_law;
mod law_words;
mod mechanism;
mod study;
mod trial;

use std::path::Path;

use loosepin::diagnostics::Complaints;
use loosepin::mechanism::Mechanism;
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
            let mechanism = Mechanism::new(&model, &values).map_err(|error| error.complaint(&model))?;
            // A study has a cycle of its own, with limits of its own.
            trial::check_run(&mechanism, &values).map_err(|failure| failure.complaint(&model))?;
            let tried = trial::try_out(&mechanism, &values).map_err(|failure| failure.complaint(&model))?;
            Ok(mechanism::words(&mechanism, &values, &tried))
        }
        InputFile::Study(study) => {
            warn(&study.warnings);
            let values = study::middle_values(&study)?;
            let model = &study.model;
            let mechanism = Mechanism::new(model, &values).map_err(|error| error.complaint(model))?;
            let tried = trial::try_out(&mechanism, &values).map_err(|failure| failure.complaint(model))?;
            study::words(&study, &values, &tried)
        }
    }
}

#[cfg(test)]
mod tests;
