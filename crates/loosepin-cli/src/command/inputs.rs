//! Reads the input files of a command.

use std::path::Path;

use loosepin::check::warnings;
use loosepin::diagnostics::{Diagnostic, Diagnostics};
use loosepin::model::Model;
use loosepin::simulate::SmallestClearance;
use loosepin::study::{InputFile, Study};
pub use loosepin::study::{add_model, add_planar_model, add_study};

use crate::console;
use crate::ending::Failure;

/// Reads a model file that is to be run, and shows its warnings.
///
/// # Errors
/// All errors in the file, and values that a run needs and that are missing; a study file.
pub fn read_model(path: &Path) -> Result<Model, Failure> {
    let model = InputFile::from_path(path)?.into_model()?;
    warn(&model.warnings);
    model.demand_dynamics()?;
    Ok(model)
}

/// Reads a study file and its model, which is to be run, and shows their warnings; `set` are values `path=value` in place of those of the model file.
///
/// # Errors
/// All errors in the files and settings, and values that a run needs and that are missing; a model file.
pub fn read_study(path: &Path, set: &[String]) -> Result<Study, Failure> {
    let file = InputFile::from_path_with_settings(path, set)?;
    let found = warnings(&file);
    let study = file.into_study()?;
    warn(&found);
    study.model.demand_complete()?;
    Ok(study)
}

/// Compares the tolerance of `--tolerance` with the smallest clearance, and warns if it is coarse.
///
/// # Errors
/// The tolerance is larger than the clearance.
pub fn check_tolerance(tolerance_m: f64, smallest: Option<SmallestClearance>) -> Result<(), Failure> {
    let Some(smallest) = smallest else { return Ok(()) };
    if let Some(warning) = smallest.check(tolerance_m).map_err(|error| Failure::of(&error))? {
        warn(&[Diagnostic::warning(&warning, None)]);
    }
    Ok(())
}

/// Shows warnings.
pub fn warn(warnings: &[Diagnostic]) {
    let diagnostics: Diagnostics = warnings.iter().cloned().collect();
    if !diagnostics.is_empty() {
        console::report(&diagnostics);
    }
}
