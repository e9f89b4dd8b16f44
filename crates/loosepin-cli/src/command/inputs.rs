//! Reading what a command is given.

use std::path::Path;

use loosepin::diagnostics::{Complaint, Complaints, Place, Problem};
use loosepin::model::Model;
use loosepin::simulate::record::Override;
use loosepin::study::{InputFile, InputFileProblem, Study};
pub use loosepin::study::{add_model, add_study};

use crate::console;
use crate::ending::Failure;

/// Reads a model file, and says what looks like an oversight in it.
///
/// # Errors
/// Everything that is wrong with it; a study file.
pub fn read_model(path: &Path) -> Result<Model, Failure> {
    match InputFile::from_path(path)? {
        InputFile::Model(model) => {
            warn(&model.warnings);
            Ok(*model)
        }
        InputFile::Study(study) => {
            let problem = InputFileProblem::StudyForModel { model: study.model_path.display().to_string() };
            Err(at_top(&problem, study.source()).into())
        }
    }
}

/// Reads a study file and its model, and says what looks like an oversight in them.
///
/// # Errors
/// Everything that is wrong with them; a model file.
pub fn read_study(path: &Path) -> Result<Study, Failure> {
    match InputFile::from_path(path)? {
        InputFile::Study(study) => {
            warn(&study.warnings);
            Ok(*study)
        }
        InputFile::Model(model) => Err(at_top(&InputFileProblem::ModelForStudy, model.source()).into()),
    }
}

/// A complaint about a file as a whole.
fn at_top(problem: &dyn Problem, source: &std::sync::Arc<loosepin::diagnostics::Source>) -> Complaint {
    Complaint::error(problem, Some(Place::new(source, 0..0)))
}

/// Shows warnings.
pub fn warn(warnings: &[Complaint]) {
    let mut complaints = Complaints::new();
    warnings.iter().for_each(|warning| complaints.push(warning.clone()));
    if !complaints.is_empty() {
        console::complain(&complaints);
    }
}

/// Settings as they stand in a record.
pub fn overrides(set: &[String]) -> Vec<Override> {
    set.iter()
        .filter_map(|text| text.split_once('='))
        .map(|(path, written)| Override { path: path.trim().to_owned(), written: written.trim().to_owned() })
        .collect()
}
