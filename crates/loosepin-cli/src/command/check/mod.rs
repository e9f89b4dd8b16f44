//! `loosepin check`.

mod beams;
mod bending;
mod elements;
mod force_law;
mod mechanism;
mod names;
mod study;
mod trial;

use std::collections::HashSet;
use std::path::Path;

use loosepin::diagnostics::{Complaint, Complaints};
use loosepin::mechanism::Mechanism;
use loosepin::study::InputFile;

use crate::arguments::CheckArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Says what each file is; a file that is wrong does not keep the others from being looked at.
pub fn run(arguments: &CheckArguments) -> Ending {
    let mut complaints = Complaints::new();
    // A study repeats what its model says, which may be one of the files.
    let mut seen = HashSet::new();
    let mut gap = "";
    for path in &arguments.files {
        match describe(path, &mut seen) {
            Ok(text) => {
                console::print(&format!("{gap}{}: {text}", path.display()))?;
                gap = "\n";
            }
            Err(Failure::Complaints(mut found)) => {
                found.remove_repeats(&mut seen);
                complaints.extend(found);
            }
            Err(failure) => return Err(failure),
        }
    }
    if complaints.is_empty() { Ok(Done::Well) } else { Err(complaints.into()) }
}

fn describe(path: &Path, seen: &mut HashSet<String>) -> Result<String, Failure> {
    describe_input(InputFile::from_path(path)?, seen)
}

fn describe_input(file: InputFile, seen: &mut HashSet<String>) -> Result<String, Failure> {
    match file {
        InputFile::Model(model) => {
            warn_once(&model.warnings, seen);
            let values = model.quantities.nominal();
            let mechanism = Mechanism::new(&model, &values).map_err(|error| error.complaint(&model))?;
            if !mechanism.is_driven() {
                // Forces decide where it goes: without them nothing is known of it.
                model.demand_dynamics()?;
            }
            // A study has a cycle of its own, with limits of its own.
            trial::check_run(&mechanism, &values).map_err(|failure| failure.complaint(&model))?;
            let tried = trial::try_out(&mechanism, &values).map_err(|failure| failure.complaint(&model))?;
            Ok(mechanism::words(&mechanism, &values, &tried))
        }
        InputFile::Study(study) => {
            warn_once(&study.warnings, seen);
            let values = study::middle_values(&study)?;
            let model = &study.model;
            let mechanism = Mechanism::new(model, &values).map_err(|error| error.complaint(model))?;
            if study.needs_runs() || !mechanism.is_driven() {
                model.demand_dynamics()?;
            }
            let tried = trial::try_out(&mechanism, &values).map_err(|failure| failure.complaint(model))?;
            study::words(&study, &values, &tried)
        }
    }
}

/// Shows the warnings that were not shown for an earlier file.
fn warn_once(warnings: &[Complaint], seen: &mut HashSet<String>) {
    let mut complaints: Complaints = warnings.iter().cloned().collect();
    complaints.remove_repeats(seen);
    if !complaints.is_empty() {
        console::complain(&complaints);
    }
}

#[cfg(test)]
mod tests;
