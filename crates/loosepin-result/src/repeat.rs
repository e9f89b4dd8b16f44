//! How a result is made again: the command, and the texts that it reads.

use std::path::{Component, Path};

use loosepin_text::diagnostics::Source;
use serde::{Deserialize, Serialize};

/// Name for a folder that no file names.
const UNNAMED_FOLDER: &str = "inputs";
/// Folder for a file of the command line whose name another one has.
const FOLDER_OF_MEASURED: &str = "measured";

/// The command and its files. No times are in it, and no folders but those by which the files find each other, so that it is the same
/// whenever and wherever the result is made.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Repeat {
    /// The command, to be given in the folder in which the files are.
    pub command: String,
    /// The files, that of the command first.
    pub files: Vec<InputText>,
}

/// A file that a result is computed from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputText {
    /// Its name, with the folders by which the files name each other: `parts/pin.csv`. Parts are separated by `/`, and none is `..`.
    pub name: String,
    /// Role of the file.
    #[serde(default)]
    pub role: InputRole,
    /// Text of the file, byte for byte.
    pub text: String,
}

/// Role of an input file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum InputRole {
    /// A study.
    Study,
    /// A model.
    Model,
    /// A table that a study or a model names; any file in records of older versions.
    #[default]
    Table,
    /// A table of measured curves, named on the command line.
    Measured,
}

impl Repeat {
    /// `loosepin WORD FILE` with `arguments`; the first of `sources` is the file.
    pub fn new<'a>(
        word: &str,
        arguments: &[String],
        sources: impl IntoIterator<Item = (InputRole, &'a Source)>,
    ) -> Self {
        let sources: Vec<(InputRole, &Source)> = sources.into_iter().collect();
        let folder = sources.first().and_then(|(_, first)| Path::new(first.name()).parent()).unwrap_or(Path::new(""));
        let places: Vec<RelativePath> =
            sources.iter().map(|(_, source)| RelativePath::of(Path::new(source.name()), folder)).collect();
        // So far above the folder of the first file the files reach.
        let above = places.iter().map(|place| place.above).max().unwrap_or(0);
        let mut repeat = Self::default();
        for ((role, source), place) in sources.into_iter().zip(places) {
            let file = InputText { name: place.below(above), role, text: source.text().to_owned() };
            // A study and its model may name the same table.
            if !repeat.files.contains(&file) {
                repeat.files.push(file);
            }
        }
        let file = repeat.files.first().map(|file| shell_word(&file.name));
        let parts = ["loosepin".to_owned(), word.to_owned()].into_iter().chain(file);
        let command: Vec<String> = parts.chain(arguments.iter().map(|argument| shell_word(argument))).collect();
        repeat.command = command.join(" ");
        repeat
    }

    /// Adds the table of measured curves that the command line names by `option`.
    pub fn add_measured(&mut self, option: &str, source: &Source) {
        let plain = file_name(Path::new(source.name()));
        let is_taken = |name: &str| self.files.iter().any(|file| file.name == name && file.text != source.text());
        let mut name = plain.clone();
        while is_taken(&name) {
            name = format!("{FOLDER_OF_MEASURED}/{name}");
        }
        self.command = format!("{} {option} {}", self.command, shell_word(&name));
        if self.files.iter().all(|file| file.name != name) {
            self.files.push(InputText { name, role: InputRole::Measured, text: source.text().to_owned() });
        }
    }

    /// The first file of a kind.
    pub fn file_of(&self, role: InputRole) -> Option<&InputText> {
        self.files.iter().find(|file| file.role == role)
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }
}

/// Path of a file relative to the folder of the first one.
struct RelativePath {
    /// Steps up from that folder.
    above: usize,
    /// Names from there.
    names: Vec<String>,
}

impl RelativePath {
    /// The names by which `path` is reached from `folder`. A file that is named without it, by a path of its own, counts as beside the first.
    fn of(path: &Path, folder: &Path) -> Self {
        let mut place = RelativePath { above: 0, names: Vec::new() };
        let Ok(rest) = path.strip_prefix(folder) else { return RelativePath { names: vec![file_name(path)], ..place } };
        for component in rest.components() {
            match component {
                Component::Normal(name) => place.names.push(name.to_string_lossy().into_owned()),
                Component::ParentDir if place.names.pop().is_none() => place.above += 1,
                Component::ParentDir | Component::CurDir => {}
                Component::RootDir | Component::Prefix(_) => {
                    return RelativePath { above: 0, names: vec![file_name(path)] };
                }
            }
        }
        place
    }

    /// The name from the folder `above` that of the first file.
    fn below(&self, above: usize) -> String {
        let unnamed = std::iter::repeat_n(UNNAMED_FOLDER, above - self.above);
        unnamed.chain(self.names.iter().map(String::as_str)).collect::<Vec<&str>>().join("/")
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned())
}

/// As a shell takes it for one word: as it is, or in single quotes.
pub fn shell_word(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/._-+,:@%=".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::{InputRole, Repeat, shell_word};
    use loosepin_text::diagnostics::Source;

    fn names(repeat: &Repeat) -> Vec<&str> {
        repeat.files.iter().map(|file| file.name.as_str()).collect()
    }

    #[test]
    fn analytic_a_command_can_be_given_to_a_shell() {
        let study = Source::new("/home/somebody/study one.toml", "a = 1\n");
        let model = Source::new("/home/somebody/model.toml", "b = 2\n");
        let arguments = ["--set", "joint.pin.radial_clearance=0.3 mm"].map(str::to_owned);
        let repeat = Repeat::new("study", &arguments, [(InputRole::Study, &*study), (InputRole::Model, &*model)]);
        assert_eq!(repeat.command, "loosepin study 'study one.toml' --set 'joint.pin.radial_clearance=0.3 mm'");
        assert_eq!(names(&repeat), ["study one.toml", "model.toml"]);
        assert_eq!(repeat.file_of(InputRole::Model).map(|file| file.text.as_str()), Some("b = 2\n"));
        assert!(Repeat::default().is_empty());
    }

    #[test]
    fn analytic_files_keep_the_folders_by_which_they_name_each_other() {
        let of = |paths: &[&str]| {
            let sources: Vec<_> = paths.iter().map(|path| Source::new(*path, *path)).collect();
            let repeat = Repeat::new("study", &[], sources.iter().map(|source| (InputRole::Table, &**source)));
            (repeat.command.clone(), repeat.files.into_iter().map(|file| file.name).collect::<Vec<_>>())
        };
        let command = |name: &str| format!("loosepin study {name}");
        let beside = ["desk/study.toml", "desk/model.toml", "desk/parts/pin.csv"];
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        assert_eq!(of(&beside), (command("study.toml"), names(&["study.toml", "model.toml", "parts/pin.csv"])));
        // The same wherever the command is given.
        assert_eq!(of(&["study.toml", "model.toml", "parts/pin.csv"]), of(&beside));
        let above = ["/a/studies/study.toml", "/a/studies/../models/model.toml", "/a/studies/../models/pin.csv"];
        let due = names(&["inputs/study.toml", "models/model.toml", "models/pin.csv"]);
        assert_eq!(of(&above), (command("inputs/study.toml"), due));
        let elsewhere = ["desk/study.toml", "/opt/models/model.toml", "/opt/models/pin.csv"];
        assert_eq!(of(&elsewhere).1, ["study.toml", "model.toml", "pin.csv"]);
        assert_eq!(of(&["study.toml", "/opt/models/model.toml"]).1, ["study.toml", "model.toml"]);
    }

    #[test]
    fn analytic_measured_tables_stand_beside_the_model() {
        let model = Source::new("desk/model.toml", "a = 1\n");
        let table = Source::new("desk/run.csv", "t\n");
        let mut repeat = Repeat::new("simulate", &[], [(InputRole::Model, &*model), (InputRole::Table, &*table)]);
        repeat.add_measured("--measured", &Source::new("/data/first run.csv", "1\n"));
        repeat.add_measured("--measured", &Source::new("/data/run.csv", "2\n"));
        repeat.add_measured("--measured", &table);
        let due =
            "loosepin simulate model.toml --measured 'first run.csv' --measured measured/run.csv --measured run.csv";
        assert_eq!(repeat.command, due);
        assert_eq!(names(&repeat), ["model.toml", "run.csv", "first run.csv", "measured/run.csv"]);
        assert_eq!(repeat.files[2].role, InputRole::Measured);
    }

    #[test]
    fn words_are_quoted_where_a_shell_would_take_them_apart() {
        assert_eq!(shell_word("../cases/worn-pin/model.toml"), "../cases/worn-pin/model.toml");
        assert_eq!(shell_word("my mechanism/model.toml"), "'my mechanism/model.toml'");
        assert_eq!(shell_word("it's $HOME.toml"), "'it'\\''s $HOME.toml'");
        assert_eq!(shell_word(""), "''");
    }
}
