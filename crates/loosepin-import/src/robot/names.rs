//! Names of a description as names of a model: valid, and each once.

use std::collections::HashSet;

/// Characters of a name, at most.
const MAX_CHARS: usize = 60;

/// Names that are taken.
#[derive(Debug, Default)]
pub(crate) struct Names {
    taken: HashSet<String>,
    /// Names that had to be changed, with what they became.
    pub changed: Vec<(String, String)>,
}

impl Names {
    /// Names among which `reserved` is taken.
    pub fn without(reserved: &[&str]) -> Names {
        Names { taken: reserved.iter().map(|name| (*name).to_owned()).collect(), changed: Vec::new() }
    }

    /// The name that stands for `wanted`.
    pub fn claim(&mut self, wanted: &str) -> String {
        let valid = valid(wanted);
        let mut name = valid.clone();
        let mut number = 2_usize;
        while !self.taken.insert(name.clone()) {
            name = format!("{valid}_{number}");
            number += 1;
        }
        if name != wanted {
            self.changed.push((wanted.to_owned(), name.clone()));
        }
        name
    }
}

/// Letters, digits, `_` and `-` of ASCII, which need no quotes in TOML; it begins with a letter or `_`.
fn valid(wanted: &str) -> String {
    let is_usual = |character: char| character.is_ascii_alphanumeric() || matches!(character, '_' | '-');
    let name: String =
        wanted.chars().take(MAX_CHARS).map(|character| if is_usual(character) { character } else { '_' }).collect();
    match name.chars().next() {
        None => "unnamed".to_owned(),
        Some(first) if first.is_ascii_alphabetic() || first == '_' => name,
        Some(_) => format!("_{name}"),
    }
}
