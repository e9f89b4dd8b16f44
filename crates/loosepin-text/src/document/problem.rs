//! Errors of the entries of a file, whatever they mean.

use crate::diagnostics::{Code, problems};
use crate::units::{Dimension, Rule, listed, quoted};

/// The largest file that is read.
pub(super) const MAX_FILE_BYTES: usize = 1 << 20;

problems! {
    /// An error in a file or an entry of it. `entry` and `table` are paths in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum DocumentProblem {
        NotReadable { file: String, reason: String, hint: Option<String> } => Code::FileNotReadable,
            says("cannot read {file}: {reason}"),
            hint_of(hint.clone());
        NotUtf8 => Code::NotUtf8,
            says("the file is not UTF-8 text from this position on"),
            hint("save the file as UTF-8");
        TooLarge { file: String, size_bytes: usize } => Code::FileTooLarge,
            says("{file} has {size_bytes} bytes; must be at most {MAX_FILE_BYTES}");
        Syntax { reason: String, line: String } => Code::TomlSyntax,
            says("this is not TOML: {reason}"),
            hint_of(number_with_comma(line)
                .map(|written| format!("decimal numbers have a point: {written}"))
                .or_else(|| in_straight_quotes(line)));
        DecimalComma { entry: String, written: String } => Code::ExpressionSyntax,
            says("{entry} has a decimal comma; numbers have a point"),
            hint("write \"{written}\"");
        DuplicateKey { key: String, is_listed: bool } => Code::TomlSyntax,
            says("'{key}' is defined twice"),
            hint_of(Some(if *is_listed {
                format!("write tables with names as [{key}.NAME], with one pair of brackets")
            } else {
                "define each key and each table once".to_owned()
            }));
        UnknownKey {
            table: String,
            key: String,
            nearest: Option<String>,
            /// What else differs, where the nearest one is the same thing by another name.
            note: &'static str,
            known: Vec<&'static str>,
        } => Code::UnknownKey,
            says("{} has no key '{key}'", or_file(table)),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'? {note}").trim_end().to_owned(),
                None => format!("its keys are {}", known.join(", ")),
            }));
        NotYetSupported { entry: String, instead: String } => Code::NotYetSupported,
            says("this version does not support {entry} yet"),
            hint("{instead}");
        RemovedKey { entry: String, instead: String } => Code::UnknownKey,
            says("{entry} is no longer supported"),
            hint("{instead}");
        MissingKey { table: String, key: &'static str, example: &'static str, doc: &'static str } => Code::MissingKey,
            says("{}{key} is missing", prefix(table)),
            hint_of(Some(match *example {
                "" => (*doc).to_owned(),
                example => format!("for example {key} = {example} ({doc})"),
            }));
        MissingTag { table: String, key: &'static str, choices: Vec<&'static str> } => Code::MissingKey,
            says("{}{key} is missing; must be {}", prefix(table), one_of(choices));
        MissingOneOf { table: String, keys: Vec<&'static str>, example: String } => Code::MissingKey,
            says("{}one of {} is missing", prefix(table), quoted(keys)),
            hint_of((!example.is_empty()).then(|| format!("for example {example}")));
        MoreThanOneOf { table: String, given: Vec<&'static str>, keys: Vec<&'static str> } => Code::ConflictingKeys,
            says("{}{} cannot be used together; give exactly one of {}", prefix(table), quoted(given), quoted(keys));
        WrongType {
            entry: String,
            found: String,
            due: &'static str,
            /// An example, `mass = "0.3 kg"`; empty if the key has none.
            example: String,
        } => Code::WrongType,
            says("{entry} is {found}; expected {due}"),
            hint_of(match *due {
                _ if !example.is_empty() => Some(format!("for example {example}")),
                TEXT_WITH_UNIT => Some("values with units are written as text, for example \"0.5 mm\"".to_owned()),
                PAIR => Some("for example [\"50 mm\", \"0 mm\"]".to_owned()),
                THREE => Some("for example [\"50 mm\", \"0 mm\", \"10 mm\"], along x, y and z".to_owned()),
                _ => None,
            });
        ControlCharacter { entry: String, character: char } => Code::WrongType,
            says("{entry} contains the control character {}, which cannot be shown", character.escape_unicode()),
            hint("remove it");
        ToFillIn { entry: String } => Code::ToFillIn,
            says("{entry} is still to be filled in");
        WrongLength { entry: String, found: usize, due: usize } => Code::WrongType,
            says("{entry} has {found} entries; expected {due}");
        UnknownChoice {
            entry: String,
            found: String,
            choices: Vec<&'static str>,
            nearest: Option<String>,
            /// Meaning of the key; empty if it has none.
            doc: &'static str,
        } => Code::UnknownChoice,
            says("{entry} is '{found}'; must be {}", one_of(choices)),
            hint_of(match nearest {
                Some(nearest) => Some(format!("did you mean \"{nearest}\"?")),
                None => (!doc.is_empty()).then(|| (*doc).to_owned()),
            });
        BadName { what: &'static str, name: String } => Code::BadName,
            says("{what} cannot be called '{name}'; names begin with a letter or _ and have letters, digits, _ and -");
        BadCount { entry: String, found: String, least: u64, most: u64 } => Code::BadCount,
            says("{entry} is {found}; must be a whole number from {least} to {most}"),
            hint_of(plain_count(found, *least, *most).map(|plain| format!("write it without point and exponent: {plain}")));
        MissingUnit { entry: String, found: String, due: Dimension } => Code::MissingUnit,
            says("{entry} is {found} without a unit; must be {due}"),
            hint_of(Some(with_unit(found, *due)));
        WrongDimension { entry: String, found: Dimension, due: Dimension } => Code::WrongDimension,
            says("{entry} is {found}; must be {due}"),
            hint_of(Some(match due.example() {
                Some(example) if *due == Dimension::ANGULAR_VELOCITY && *found == Dimension::FREQUENCY => {
                    format!("1 Hz is 60 rpm; for example \"{example}\"")
                }
                Some(example) => format!("for example \"{example}\""),
                None => format!("its unit is {}", due.si_unit()),
            }));
        NotFinite { entry: String, found: String } => Code::NotFinite,
            says("{entry} is {found}; must be finite");
        BreaksRule { entry: String, found: String, rule: Rule } =>
            if is_probability(rule) { Code::BadProbability } else { Code::BreaksRule },
            says("{entry} {found}; must be {}", rule.words()),
            hint_of(is_probability(rule)
                .then(|| "probabilities are written as numbers, 97.5 % is 0.975".to_owned()));
    }
}

/// The whole number within the limits that `found` writes in another way, such as `1e3`.
fn plain_count(found: &str, least: u64, most: u64) -> Option<u64> {
    let value: f64 = found.parse().ok()?;
    let is_exact = value.fract() == 0.0 && (0.0..9e15).contains(&value);
    let count = is_exact.then_some(value as u64)?;
    (least..=most).contains(&count).then_some(count)
}

fn is_probability(rule: &Rule) -> bool {
    matches!(rule, Rule::Probability | Rule::RequiredProbability)
}

/// A table in front of its problem; empty for the top of the file.
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

/// The value of a line with straight quotes around it, where it has others or none.
fn in_straight_quotes(line: &str) -> Option<String> {
    const CURLY: [char; 10] = ['“', '”', '„', '‟', '«', '»', '‘', '’', '‚', '′'];
    let (key, value) = line.split_once('=')?;
    let (key, value) = (key.trim(), value.split('#').next().unwrap_or_default().trim());
    let bare = value.trim_matches(CURLY);
    let is_number_with_unit = bare.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c))
        && bare.contains(char::is_alphabetic)
        && !bare.contains(['"', '\'', '[', '{', ',']);
    if bare.len() < value.len() {
        return Some(format!("quotes are straight: {key} = \"{bare}\""));
    }
    is_number_with_unit.then(|| format!("a value with its unit is text: {key} = \"{bare}\""))
}

/// How a number without a unit is written with one: the customary unit and that of SI.
fn with_unit(found: &str, due: Dimension) -> String {
    let customary = due.example().and_then(|example| example.split_once(' ')).map(|(_, unit)| unit);
    let si = due.si_unit();
    let number = if found.parse::<f64>().is_ok() { found } else { "1" };
    match customary {
        Some(unit) if unit != si => format!("write the unit, for example \"{number} {unit}\" or \"{number} {si}\""),
        _ => format!("write the unit, for example \"{number} {si}\""),
    }
}

/// The value that is due where two belong together, in words.
pub(super) const PAIR: &str = "a list of two";

/// The value that is due for a vector in space, in words.
pub(super) const THREE: &str = "a list of three";

/// The value that is due for a quantity, in words.
pub(super) const TEXT_WITH_UNIT: &str = "text with a unit";
