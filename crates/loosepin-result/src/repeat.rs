//! How a result is made again: the command, and the texts that it reads.

use std::path::Path;

use loosepin_text::diagnostics::Source;
use serde::{Deserialize, Serialize};

/// The command and its files. Neither times nor folders are in it, so that it is the same whenever and wherever the result is made.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Repeat {
    /// The command, to be given beside the files.
    pub command: String,
    /// The files, that of the command first.
    pub files: Vec<InputText>,
}

/// A file that a result is computed from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputText {
    /// Its name, without folders.
    pub name: String,
    /// What it says.
    pub text: String,
}

impl Repeat {
    /// `loosepin WORD FILE` with `arguments`; the first of `sources` is the file.
    pub fn new<'a>(word: &str, arguments: &[String], sources: impl IntoIterator<Item = &'a Source>) -> Self {
        let files: Vec<InputText> = sources
            .into_iter()
            .map(|source| InputText { name: file_name(source.name()), text: source.text().to_owned() })
            .collect();
        let file = files.first().map(|file| quoted(&file.name));
        let parts = ["loosepin".to_owned(), word.to_owned()].into_iter().chain(file);
        let command: Vec<String> = parts.chain(arguments.iter().map(|argument| quoted(argument))).collect();
        Self { command: command.join(" "), files }
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }
}

fn file_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// As a shell takes it for one word.
pub fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:+%,".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::Repeat;
    use loosepin_text::diagnostics::Source;

    #[test]
    fn analytic_a_command_can_be_given_to_a_shell() {
        let study = Source::new("/home/somebody/study one.toml", "a = 1\n");
        let model = Source::new("model.toml", "b = 2\n");
        let arguments = ["--set", "joint.pin.radial_clearance=0.3 mm"].map(str::to_owned);
        let repeat = Repeat::new("study", &arguments, [&*study, &*model]);
        assert_eq!(repeat.command, "loosepin study 'study one.toml' --set 'joint.pin.radial_clearance=0.3 mm'");
        let names: Vec<&str> = repeat.files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!((names, repeat.files[1].text.as_str()), (vec!["study one.toml", "model.toml"], "b = 2\n"));
        assert!(Repeat::default().is_empty());
    }
}
