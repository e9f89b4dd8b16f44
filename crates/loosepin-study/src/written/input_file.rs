//! A file whose kind is not known beforehand.

use std::path::Path;

use loosepin_text::diagnostics::{Code, Diagnostic, Diagnostics, Place, problems};
use loosepin_text::document::{parse_toml, read_source};

use crate::file::Study;
use crate::file::says_study;
use crate::model::StudyModel;
use loosepin_mechanics::model::Model;

/// Kind and content of a file.
#[derive(Debug, Clone)]
pub enum InputFile {
    /// A mechanism with its nominal values.
    Model(StudyModel),
    /// The uncertain inputs of a model, and the questions.
    Study(Box<Study>),
}

impl InputFile {
    /// Reads a file as a study if it has keys of one at its top and no body, and as a model otherwise.
    ///
    /// # Errors
    /// Everything that is wrong with the file, each with its place; a file that says nothing.
    pub fn from_path(path: &Path) -> Result<InputFile, Diagnostics> {
        Self::from_path_with_settings(path, &[])
    }

    /// The same; the values of settings `path=value` stand in place of those of a study's model. A model by itself stays as it is.
    ///
    /// # Errors
    /// As for [`InputFile::from_path`], and settings that cannot be read.
    pub fn from_path_with_settings(path: &Path, set: &[String]) -> Result<InputFile, Diagnostics> {
        let is_study = {
            let source = read_source(path)?;
            let toml = parse_toml(&source)?;
            if toml.get_ref().is_empty() {
                return Err(Diagnostics::one(&InputFileProblem::Empty, Some(Place::new(&source, 0..0))));
            }
            says_study(&source)
        };
        if is_study {
            Study::from_path_with_settings(path, set).map(|study| InputFile::Study(Box::new(study)))
        } else {
            StudyModel::from_source(read_source(path)?).map(InputFile::Model)
        }
    }

    /// The model, or that of the study.
    pub fn model(&self) -> &StudyModel {
        match self {
            InputFile::Model(model) => model,
            InputFile::Study(study) => &study.model,
        }
    }

    /// Warnings about likely mistakes in a valid file.
    pub fn warnings(&self) -> &[Diagnostic] {
        match self {
            InputFile::Model(model) => model.warnings(),
            InputFile::Study(study) => &study.warnings,
        }
    }

    /// The planar model.
    ///
    /// # Errors
    /// It is a study; the model is in space.
    pub fn into_model(self) -> Result<Model, Diagnostics> {
        self.into_any_model()?.into_planar()
    }

    /// The model, in the plane or in space.
    ///
    /// # Errors
    /// It is a study.
    pub fn into_any_model(self) -> Result<StudyModel, Diagnostics> {
        match self {
            InputFile::Model(model) => Ok(model),
            InputFile::Study(study) => {
                let problem = InputFileProblem::StudyForModel { model: study.model_path.display().to_string() };
                Err(Diagnostics::one(&problem, Some(Place::new(study.source(), 0..0))))
            }
        }
    }

    /// The study.
    ///
    /// # Errors
    /// It is a model.
    pub fn into_study(self) -> Result<Study, Diagnostics> {
        match self {
            InputFile::Study(study) => Ok(*study),
            InputFile::Model(model) => {
                Err(Diagnostics::one(&InputFileProblem::ModelForStudy, Some(Place::new(model.source(), 0..0))))
            }
        }
    }
}

problems! {
    /// A file of the wrong kind.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub enum InputFileProblem {
        /// A study where a model is due.
        StudyForModel { model: String } => Code::WrongKindOfFile,
            says("this is a study; expected a model"),
            hint("its model is {model}");
        /// An empty file.
        Empty => Code::WrongKindOfFile,
            says("the file is empty: neither a model nor a study"),
            hint("`loosepin new slider-crank` writes an example of both");
        /// A model where a study is due.
        ModelForStudy => Code::WrongKindOfFile,
            says("this is a model; expected a study"),
            hint("a study names its model with the key `model`; for a single run use `loosepin simulate`");
    }
}
