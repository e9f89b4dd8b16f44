//! Errors of the entries of a file, whatever they mean.

use thiserror::Error;

use crate::diagnostics::{Code, Problem};
use crate::units::{Dimension, Rule, listed, quoted};

/// The largest file that is read.
pub(super) const LARGEST_FILE_BYTES: usize = 1 << 20;

/// An error in a file or an entry of it. `entry` and `table` are paths in words.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum DocumentProblem {
    #[error("cannot read {file}: {reason}")]
    NotReadable { file: String, reason: String, hint: Option<String> },
    #[error("the file is not UTF-8 text from here on")]
    NotUtf8,
    #[error("{file} has {size_bytes} bytes; a file of at most {LARGEST_FILE_BYTES} is read")]
    TooLarge { file: String, size_bytes: usize },
    #[error("not TOML here: {reason}")]
    Syntax { reason: String, line: String },
    #[error("{entry} has a decimal comma; numbers have a point")]
    DecimalComma { entry: String, written: String },
    #[error("'{key}' is defined twice")]
    DuplicateKey { key: String },
    #[error("{} has no key '{key}'", or_file(.table))]
    UnknownKey { table: String, key: String, nearest: Option<String>, known: Vec<&'static str> },
    #[error("{entry} is not yet supported by this version")]
    NotYetSupported { entry: String, instead: String },
    #[error("{entry} is not supported any more")]
    RemovedKey { entry: String, instead: String },
    #[error("{}{key} is missing", prefix(.table))]
    MissingKey { table: String, key: &'static str, example: &'static str, doc: &'static str },
    #[error("{}{key} is missing; must be {}", prefix(.table), one_of(.choices))]
    MissingTag { table: String, key: &'static str, choices: Vec<&'static str> },
    #[error("{}one of {} is missing", prefix(.table), quoted(.keys))]
    MissingOneOf { table: String, keys: Vec<&'static str> },
    #[error("{}{} cannot be used together; give exactly one of {}", prefix(.table), quoted(.given), quoted(.keys))]
    MoreThanOneOf { table: String, given: Vec<&'static str>, keys: Vec<&'static str> },
    #[error("{entry} is {found}; expected {due}")]
    WrongType { entry: String, found: String, due: &'static str },
    #[error("{entry} is still to be filled in")]
    ToFillIn { entry: String },
    #[error("{entry} has {found} entries; expected {due}")]
    WrongLength { entry: String, found: usize, due: usize },
    #[error("{entry} is '{found}'; must be {}", one_of(.choices))]
    UnknownChoice { entry: String, found: String, choices: Vec<&'static str>, nearest: Option<String> },
    #[error("{what} cannot be called '{name}'; names begin with a letter or _ and have letters, digits, _ and -")]
    BadName { what: &'static str, name: String },
    #[error("{entry} is {found}; must be a whole number from {least} to {most}")]
    BadCount { entry: String, found: String, least: u64, most: u64 },
    #[error("{entry} is {found} without a unit; must be {due}")]
    MissingUnit { entry: String, found: String, due: Dimension },
    #[error("{entry} is {found}; must be {due}")]
    WrongDimension { entry: String, found: Dimension, due: Dimension },
    #[error("{entry} is {found}; must be finite")]
    NotFinite { entry: String, found: String },
    #[error("{entry} {found}; must be {}", .rule.words())]
    BreaksRule { entry: String, found: String, rule: Rule },
}

/// A table in front of what is wrong with it; nothing for the top of the file.
fn prefix(table: &str) -> String {
    if table.is_empty() { String::new() } else { format!("{table}: ") }
}

fn or_file(table: &str) -> &str {
    if table.is_empty() { "the file" } else { table }
}

fn one_of(choices: &[&'static str]) -> String {
    let quoted: Vec<String> = choices.iter().map(|choice| format!("\"{choice}\"")).collect();
    listed(&quoted, "or")
}

/// The first number behind an equals sign that is written with a decimal comma, with a point instead.
fn number_with_comma(line: &str) -> Option<String> {
    line.split('=').skip(1).find_map(|value| {
        let (before, rest) = value.trim_start().split_once(',')?;
        let after: String = rest.chars().take_while(char::is_ascii_digit).collect();
        let digits = before.strip_prefix(['+', '-']).unwrap_or(before);
        let is_number = !digits.is_empty() && digits.chars().all(|letter| letter.is_ascii_digit()) && !after.is_empty();
        is_number.then(|| format!("{before}.{after}"))
    })
}

impl Problem for DocumentProblem {
    fn code(&self) -> Code {
        match self {
            Self::NotReadable { .. } => Code::FileNotReadable,
            Self::NotUtf8 => Code::NotUtf8,
            Self::TooLarge { .. } => Code::FileTooLarge,
            Self::Syntax { .. } | Self::DuplicateKey { .. } => Code::TomlSyntax,
            Self::UnknownKey { .. } | Self::RemovedKey { .. } => Code::UnknownKey,
            Self::NotYetSupported { .. } => Code::NotYetSupported,
            Self::MissingKey { .. } | Self::MissingTag { .. } | Self::MissingOneOf { .. } => Code::MissingKey,
            Self::MoreThanOneOf { .. } => Code::ConflictingKeys,
            Self::WrongType { .. } | Self::WrongLength { .. } => Code::WrongType,
            Self::UnknownChoice { .. } => Code::UnknownChoice,
            Self::ToFillIn { .. } => Code::ToFillIn,
            Self::BadName { .. } => Code::BadName,
            Self::BadCount { .. } => Code::BadCount,
            Self::DecimalComma { .. } => Code::ExpressionSyntax,
            Self::MissingUnit { .. } => Code::MissingUnit,
            Self::WrongDimension { .. } => Code::WrongDimension,
            Self::NotFinite { .. } => Code::NotFinite,
            Self::BreaksRule { rule: Rule::Probability | Rule::RequiredProbability, .. } => Code::BadProbability,
            Self::BreaksRule { .. } => Code::BreaksRule,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::BreaksRule { rule: Rule::Probability | Rule::RequiredProbability, .. } => {
                Some("probabilities are written as numbers, 97.5 % is 0.975".to_owned())
            }
            Self::NotReadable { hint, .. } => hint.clone(),
            Self::DecimalComma { written, .. } => Some(format!("write \"{written}\"")),
            Self::Syntax { line, .. } => {
                number_with_comma(line).map(|written| format!("decimal numbers have a point: {written}"))
            }
            Self::DuplicateKey { .. } => Some("define each key and each table once".to_owned()),
            Self::NotUtf8 => Some("save the file as UTF-8".to_owned()),
            Self::UnknownKey { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownKey { known, .. } => Some(format!("its keys are {}", known.join(", "))),
            Self::NotYetSupported { instead, .. } | Self::RemovedKey { instead, .. } => Some(instead.clone()),
            Self::MissingKey { key, example, doc, .. } if !example.is_empty() => {
                Some(format!("for example {key} = {example} ({doc})"))
            }
            Self::MissingKey { doc, .. } => Some((*doc).to_owned()),
            Self::UnknownChoice { nearest: Some(nearest), .. } => Some(format!("did you mean \"{nearest}\"?")),
            Self::MissingUnit { due, found, .. } => {
                let customary = due.example().and_then(|example| example.split_once(' ')).map(|(_, unit)| unit);
                let si = due.si_unit();
                let number = if found.parse::<f64>().is_ok() { found.as_str() } else { "1" };
                Some(match customary {
                    Some(unit) if unit != si => {
                        format!("write the unit, for example \"{number} {unit}\" or \"{number} {si}\"")
                    }
                    _ => format!("write the unit, for example \"{number} {si}\""),
                })
            }
            Self::WrongDimension { due, .. } => Some(match due.example() {
                Some(example) => format!("for example \"{example}\""),
                None => format!("its unit is {}", due.si_unit()),
            }),
            Self::WrongType { due, .. } if *due == TEXT_WITH_UNIT => {
                Some("values with units are written as text, for example \"0.5 mm\"".to_owned())
            }
            _ => None,
        }
    }
}

/// The value that is due for a quantity, in words.
pub(super) const TEXT_WITH_UNIT: &str = "text with a unit";
