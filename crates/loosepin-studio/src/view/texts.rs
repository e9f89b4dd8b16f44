//! Texts of the page with the tables that they name, and the study or model that they make.

use std::collections::HashSet;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use loosepin::diagnostics::{Diagnostics, Source};
use loosepin::model::Model;
use loosepin::result::repeat::InputRole;
use loosepin::study::result::StudyResult;
use loosepin::study::{InputFile, Study, StudyModel, named_model};

use crate::files::folder::Folder;
use crate::messages::{Look, Shown};
use crate::network::refusal::Refusal;

/// Most names of tables that are looked up for a text.
const MAX_TABLES: usize = 64;

/// A model and perhaps a study of it, with their tables: nothing else is opened to read them.
pub struct Texts {
    /// The model, named by its path in the served folder.
    pub model: Arc<Source>,
    /// The study.
    pub study: Option<Arc<Source>>,
}

impl Texts {
    /// The texts sent by the page.
    pub fn sent(folder: &Folder, look: &Look) -> Self {
        let study = look.study.as_ref().map(|study| (study.path.as_str(), study.text.as_str()));
        Self::new(folder, (&look.model.path, &look.model.text), study)
    }

    /// The texts of a study on the disk.
    ///
    /// # Errors
    /// It, or its model, is not in the served folder.
    pub fn of_study(folder: &Folder, path: &str) -> Result<Self, Refusal> {
        let study = folder.read(path)?.text;
        let model_path = model_beside(path, &study).ok_or_else(|| {
            Refusal::bad(format!("'{path}' names no model")).with_hint("a study has the line: model = \"model.toml\"")
        })?;
        let model = folder.read(&plain(&model_path))?.text;
        Ok(Self::new(folder, (&model_path, &model), Some((path, &study))))
    }

    /// The texts of a study as the page shows it.
    ///
    /// # Errors
    /// The study names another model than the one that is shown: the command would run that one.
    pub fn shown(folder: &Folder, shown: &Shown) -> Result<Self, Refusal> {
        let Shown { model, study } = shown;
        let named = model_beside(&study.path, &study.text).map(|path| plain(&path));
        if named.as_deref() != Some(plain(&model.path).as_str()) {
            let named = named.map_or("no model".to_owned(), |path| format!("the model '{path}'"));
            let message = format!("'{}' names {named}; the page shows '{}'", study.path, model.path);
            return Err(Refusal::bad(message).with_hint("save it, and open it again"));
        }
        Ok(Self::new(folder, (&model.path, &model.text), Some((&study.path, &study.text))))
    }

    /// The planar model, which alone is changed in the drawing.
    ///
    /// # Errors
    /// It cannot be read, or is in space.
    pub fn planar_model(&self) -> Result<Model, Refusal> {
        let model = StudyModel::from_source(Arc::clone(&self.model)).map_err(|_| unreadable("model"))?;
        model.into_planar().map_err(|_| {
            Refusal::bad("links and joints of a mechanism in space are not changed in the drawing")
                .with_hint("change them in the text of the model")
        })
    }

    /// The texts in a result, with its tables.
    ///
    /// # Errors
    /// An older version has kept none.
    pub fn of_result(result: &StudyResult) -> Result<Self, Refusal> {
        let file = |role| result.repeat.file_of(role).map(|file| (file.name.as_str(), file.text.as_str()));
        let (Some(model), Some(study)) = (file(InputRole::Model), file(InputRole::Study)) else {
            return Err(Refusal::bad("this result does not hold its model and its study")
                .with_hint("an older version wrote it: run the study again"));
        };
        let table = |path: &str| {
            let found = result.repeat.files.iter().find(|file| file.role == InputRole::Table && file.name == path);
            found.map(|file| file.text.clone())
        };
        Ok(Self::with_tables(model, Some(study), &table))
    }

    /// The same with other texts in their places.
    pub fn with(&self, folder: &Folder, model: Option<&str>, study: Option<&str>) -> Self {
        let old = &self.model;
        let model = (old.name(), model.unwrap_or(old.text()));
        let study = self.study.as_ref().map(|old| (old.name(), study.unwrap_or(old.text())));
        Self::new(folder, model, study)
    }

    fn new(folder: &Folder, model: (&str, &str), study: Option<(&str, &str)>) -> Self {
        Self::with_tables(model, study, &|path| folder.read_table(path).ok())
    }

    fn with_tables(model: (&str, &str), study: Option<(&str, &str)>, read: &dyn Fn(&str) -> Option<String>) -> Self {
        let texts = std::iter::once(model).chain(study);
        let tables: Arc<[Arc<Source>]> = texts.flat_map(|(path, text)| tables(read, path, text)).collect();
        let source = |(path, text): (&str, &str)| Source::with_files(path, text, Arc::clone(&tables));
        Self { model: source(model), study: study.map(source) }
    }

    /// The study, or the model where there is none. The study may have no uncertain input and no question yet.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn read(&self) -> Result<InputFile, Diagnostics> {
        self.read_by(Study::draft_of_model)
    }

    /// As [`Texts::read`], with all that a run needs.
    ///
    /// # Errors
    /// Everything that is wrong with them, or missing.
    pub fn read_to_run(&self) -> Result<InputFile, Diagnostics> {
        self.read_by(Study::of_model)
    }

    fn read_by(
        &self,
        read: fn(&Arc<Source>, StudyModel, &Path) -> Result<Study, Diagnostics>,
    ) -> Result<InputFile, Diagnostics> {
        let model = StudyModel::from_source(Arc::clone(&self.model))?;
        match &self.study {
            None => Ok(InputFile::Model(model)),
            Some(study) => {
                let path = PathBuf::from(self.model.name());
                Ok(InputFile::Study(Box::new(read(study, model, &path)?)))
            }
        }
    }
}

/// A text that cannot be read is not changed.
pub fn unreadable(which: &str) -> Refusal {
    Refusal::bad(format!("the {which} cannot be read"))
        .with_hint("correct its problems first; they are listed below the drawing")
}

/// The path of the model that the text of a study at `path` names.
pub fn model_beside(path: &str, study: &str) -> Option<String> {
    let written = named_model(&Source::new(path, study))?;
    Some(beside(path, &written))
}

/// What a text at `path` names as `written`: as the library joins them.
pub fn beside(path: &str, written: &str) -> String {
    Path::new(path).parent().unwrap_or(Path::new("")).join(written).display().to_string()
}

/// A path without `.` and `..`; what leads out of the folder stays as it is, and is refused when it is opened.
pub fn plain(path: &str) -> String {
    let mut names = Vec::new();
    for component in Path::new(path).components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir if !names.is_empty() => {
                names.pop();
            }
            Component::Normal(name) => names.push(name.to_string_lossy()),
            _ => return path.to_owned(),
        }
    }
    names.join("/")
}

/// The tables that a text at `path` names: every string that ends as a table does. One that cannot be read is left out; whoever reads
/// the text says so at its place.
fn tables(read: &dyn Fn(&str) -> Option<String>, path: &str, text: &str) -> Vec<Arc<Source>> {
    let strings = text.split(['"', '\'', '\n']).filter(|string| string.to_ascii_lowercase().ends_with(".csv"));
    let mut looked_up = HashSet::new();
    let names = strings.map(|written| beside(path, written)).filter(|name| looked_up.insert(name.clone()));
    names.take(MAX_TABLES).filter_map(|name| Some(Source::new(name.as_str(), read(&plain(&name))?))).collect()
}

/// The texts of the tables that the file at a path names.
pub fn tables_of(folder: &Folder, path: &str) -> Vec<String> {
    let Ok(file) = folder.read(path) else { return Vec::new() };
    let found = tables(&|path| folder.read_table(path).ok(), path, &file.text);
    found.iter().map(|table| table.text().to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_names_tables_of_the_folder_alone() {
        let desk = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(desk.path().join("served/rods")).unwrap();
        std::fs::write(desk.path().join("served/measured.csv"), "1\n2\n").unwrap();
        std::fs::write(desk.path().join("outside.csv"), "3\n").unwrap();
        let folder = Folder::new(&desk.path().join("served")).unwrap();
        let text = "a = { samples = \"../measured.csv\" }\nb = '../../outside.csv'\nc = \"missing.csv\"\n";
        let found = tables(&|path| folder.read_table(path).ok(), "rods/study.toml", text);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].name(), found[0].text()), ("rods/../measured.csv", "1\n2\n"));
        assert_eq!(plain("rods/./../measured.csv"), "measured.csv");
        assert_eq!(plain("rods/../../outside.csv"), "rods/../../outside.csv");
    }
}
