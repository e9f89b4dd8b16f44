//! What the page calls a file.

use loosepin::study::InputFile;

/// The name of a model, or that of the study.
pub(super) fn title(file: &InputFile) -> String {
    match file {
        InputFile::Model(model) => model.name().to_owned(),
        InputFile::Study(study) => study.name.clone(),
    }
}
