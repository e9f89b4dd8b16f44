//! The texts of a study and its files, so that the study can be read again without the files.

use std::path::PathBuf;
use std::sync::Arc;

use crate::file::Study;
use crate::model::StudyModel;
use loosepin_text::diagnostics::{Diagnostics, Source};

/// A text, and the name that it is reported by.
pub type NamedText = (String, String);

/// The texts of a study, of its model, and of the tables that they name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyTexts {
    /// The study file.
    pub study: NamedText,
    /// The model file.
    pub model: NamedText,
    /// The path of the model, as commands have it.
    pub model_path: String,
    /// Tables, by the path that they were read from.
    pub tables: Vec<NamedText>,
}

impl Study {
    /// Everything that the study was read from.
    pub fn texts(&self) -> StudyTexts {
        StudyTexts {
            study: named_text(self.source()),
            model: named_text(self.model.source()),
            model_path: self.model_path.display().to_string(),
            tables: self.tables().iter().chain(self.model.tables()).map(named_text).collect(),
        }
    }

    /// The study that has these texts; no file is opened.
    ///
    /// # Errors
    /// As for [`Study::from_path`]; a table that is not among the texts.
    pub fn from_texts(texts: &StudyTexts) -> Result<Study, Diagnostics> {
        let model = model_from_texts(&texts.model, &texts.tables)?;
        let study = with_tables(&texts.study, &texts.tables);
        Study::of_model(&study, model, &PathBuf::from(&texts.model_path))
    }
}

/// The text of the file of `model`, and the tables that it names.
pub fn model_texts(model: &StudyModel) -> (NamedText, Vec<NamedText>) {
    (named_text(model.source()), model.tables().iter().map(named_text).collect())
}

/// The model that has these texts; no file is opened.
///
/// # Errors
/// As for [`StudyModel::from_source`]; a table that is not among the texts.
pub fn model_from_texts(model: &NamedText, tables: &[NamedText]) -> Result<StudyModel, Diagnostics> {
    StudyModel::from_source(with_tables(model, tables))
}

fn named_text(source: &Arc<Source>) -> NamedText {
    (source.name().to_owned(), source.text().to_owned())
}

fn with_tables((name, text): &NamedText, tables: &[NamedText]) -> Arc<Source> {
    Source::with_files(name, text, tables.iter().map(|(name, text)| Source::new(name, text)).collect())
}

/// The study at `path` in the repository, with texts of its files replaced; each of them is there.
#[cfg(test)]
pub fn study_with(path: &str, replaced: &[(&str, &str)]) -> Study {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    let mut texts = Study::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}")).texts();
    for (old, new) in replaced {
        assert!(texts.study.1.contains(old) || texts.model.1.contains(old), "{old}");
        texts.study.1 = texts.study.1.replace(old, new);
        texts.model.1 = texts.model.1.replace(old, new);
    }
    Study::from_texts(&texts).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study_inputs;
    use std::path::Path;

    /// A study whose model and which itself name tables.
    fn written(folder: &Path) -> PathBuf {
        let case = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin/model.toml");
        let model = std::fs::read_to_string(case).unwrap();
        std::fs::create_dir(folder.join("measured")).unwrap();
        std::fs::write(folder.join("model.toml"), model).unwrap();
        let sample: String = (0..12).map(|row| format!("{}\n", 119.96 + 0.007 * f64::from(row))).collect();
        std::fs::write(folder.join("measured/rods.csv"), format!("rod length [mm]\n{sample}")).unwrap();
        let study = "name = \"measured rods\"\nmodel = \"model.toml\"\n[random]\n\
            \"parameter.rod_length\" = { samples = \"measured/rods.csv\" }\n\
            [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n";
        std::fs::write(folder.join("study.toml"), study).unwrap();
        folder.join("study.toml")
    }

    #[test]
    fn identity_a_study_of_texts_is_that_of_the_files() {
        let desk = tempfile::tempdir().unwrap();
        let read = Study::from_path(&written(desk.path())).unwrap();
        let texts = read.texts();
        assert_eq!(texts.tables.len(), 1);
        // Nothing is opened any more.
        drop(desk);
        let again = Study::from_texts(&texts).unwrap();
        assert_eq!(again.texts(), texts);
        assert_eq!(study_inputs(&again, &[], None).to_string(), study_inputs(&read, &[], None).to_string());
        assert_eq!(again.random[0].variable.quantile(0.3), read.random[0].variable.quantile(0.3));
        let missing = Study::from_texts(&StudyTexts { tables: Vec::new(), ..texts }).unwrap_err().to_string();
        assert!(missing.contains("rods.csv") && missing.contains("was not given"), "{missing}");
    }
}
