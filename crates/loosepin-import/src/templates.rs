//! Commented files to start from, for `loosepin new`.

use std::io;
use std::path::{Path, PathBuf};

use loosepin_files::{io_error_words, read_named, write_new_files};
use loosepin_text::diagnostics::{Code, problems};

/// A model file and a study file to start from.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// The name to ask for it by.
    pub name: &'static str,
    /// Text of `about.md`: what mechanism it is in one line, an empty line, what to look at.
    about: &'static str,
    /// Text of `model.toml`.
    pub model: &'static str,
    /// Text of `study.toml`.
    pub study: &'static str,
}

/// Templates from their folders in `templates/`.
macro_rules! templates {
    ($($name:literal)*) => {
        &[$(Template {
            name: $name,
            about: include_str!(concat!("../templates/", $name, "/about.md")),
            model: include_str!(concat!("../templates/", $name, "/model.toml")),
            study: include_str!(concat!("../templates/", $name, "/study.toml")),
        }),*]
    };
}

/// The templates of planar mechanisms, in the order in which they are listed.
pub static TEMPLATES: &[Template] = templates! {
    "slider-crank"
    "four-bar"
    "offset-slider-crank"
    "inverted-slider-crank"
    "whitworth-quick-return"
    "scotch-yoke"
    "double-slider"
    "watt-six-bar"
    "stephenson-six-bar"
    "toggle-press"
    "worn-press"
    "pantograph"
    "two-link-arm"
    "three-link-arm"
    "space-manipulator"
    "flexible-slider-crank"
    "flexible-four-bar"
};

/// The templates of mechanisms in space, in the order in which they are listed, after the planar ones.
pub static SPATIAL_TEMPLATES: &[Template] = templates! {
    "spatial-slider-crank"
    "spatial-four-bar"
    "universal-joint-shaft"
    "spherical-platform"
    "six-axis-arm"
    "bricard"
    "suspension-corner"
    "steering-linkage"
};

/// Every template, in the order in which they are listed.
pub fn all_templates() -> impl Iterator<Item = &'static Template> {
    TEMPLATES.iter().chain(SPATIAL_TEMPLATES)
}

impl Template {
    /// The mechanism in one line.
    pub fn description(&self) -> &'static str {
        self.about.lines().next().unwrap_or_default()
    }

    /// The mechanism and its results in one paragraph without line breaks.
    pub fn paragraph(&self) -> String {
        self.about.lines().skip(1).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
    }
}

/// The template called `name`.
pub fn find_template(name: &str) -> Option<&'static Template> {
    all_templates().find(|template| template.name == name)
}

problems! {
    /// Why a template cannot be written.
    #[derive(Debug)]
    pub enum TemplateError {
        Exists { path: PathBuf } => Code::FileExists,
            says("{} already exists; it is not overwritten", path.display()),
            hint("give another folder, for example: loosepin new TEMPLATE my_mechanism");
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {}", path.display(), io_error_words(source));
    }
}

/// Writes `model.toml` and `study.toml` into a folder, which is made where there is none; gives their paths. Both are there whole, or none
/// is. Where a machine has stopped between the two in a folder that was there before, doing it again writes the other one.
///
/// # Errors
/// One of the files is there already (then neither is written), or the file system refuses.
pub fn write_template(template: &Template, folder: &Path) -> Result<[PathBuf; 2], TemplateError> {
    let files = [("model.toml", template.model), ("study.toml", template.study)];
    let paths = files.map(|(name, _)| folder.join(name));
    let mut missing: Vec<(&str, &[u8])> = Vec::new();
    for ((name, text), path) in files.iter().zip(&paths) {
        match read_named(path, text.len() as u64) {
            Ok(held) if held == text.as_bytes() => {}
            _ if path.symlink_metadata().is_ok() => return Err(TemplateError::Exists { path: path.clone() }),
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(TemplateError::Write { path: path.clone(), source: error });
            }
            _ => missing.push((name, text.as_bytes())),
        }
    }
    if missing.is_empty() {
        let [path, _] = paths;
        return Err(TemplateError::Exists { path });
    }
    match write_new_files(folder, &missing) {
        Ok(()) => Ok(paths),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            Err(TemplateError::Exists { path: folder.join(missing[0].0) })
        }
        Err(source) => Err(TemplateError::Write { path: folder.to_owned(), source }),
    }
}
