//! Commented files to start from, for `loosepin new`.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

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

/// Every template, in the order in which they are listed.
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
    TEMPLATES.iter().find(|template| template.name == name)
}

problems! {
    /// Why a template cannot be written.
    #[derive(Debug)]
    pub enum TemplateError {
        Exists { path: PathBuf } => Code::FileExists,
            says("{} is there already; it is not overwritten", path.display()),
            hint("give another folder, for example: loosepin new TEMPLATE my_mechanism");
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {source}", path.display());
    }
}

/// Writes `model.toml` and `study.toml` into a folder, which is made where there is none; gives their paths.
///
/// # Errors
/// One of the files is there already (then neither is written), or the file system refuses.
pub fn write_template(template: &Template, folder: &Path) -> Result<[PathBuf; 2], TemplateError> {
    let files = [(folder.join("model.toml"), template.model), (folder.join("study.toml"), template.study)];
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists()) {
        return Err(TemplateError::Exists { path: path.clone() });
    }
    fs::create_dir_all(folder).map_err(|source| TemplateError::Write { path: folder.to_owned(), source })?;
    for (path, text) in &files {
        // A file that appeared since is not overwritten either.
        let written = OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(path)
            .and_then(|mut file| file.write_all(text.as_bytes()));
        written.map_err(|source| TemplateError::Write { path: path.clone(), source })?;
    }
    Ok(files.map(|(path, _)| path))
}
