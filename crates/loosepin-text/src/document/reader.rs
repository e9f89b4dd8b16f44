//! The layer between TOML and meaning: every accessor either gives the value or leaves a diagnostic at its place.

use std::path::Path;
use std::sync::Arc;

use loosepin_files::{Refused, read_named};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::entry::{Entry, Table, Written, shortened};
use super::keys::{Keys, Kind};
use super::path::{EntryPath, is_name};
use super::problem::{DocumentProblem, MAX_FILE_BYTES, PAIR, TEXT_WITH_UNIT, THREE};
use super::suggested_file::{file_of_like_name, files_inside};
use super::synonyms::by_synonym;
use crate::diagnostics::{
    Diagnostic, Diagnostics, Place, Problem, RefusedFile, Source, Span, first_control_character, nearest_name,
};
use crate::tolerance::for_single_value;
use crate::units::{Dimension, Measured, Rule, format_refused, parse_quantity};
use crate::work;

/// Mark in a file where a value is still to be filled in.
const TO_FILL_IN: &str = "?";

/// Why a file cannot be read, with the name that was probably meant.
pub fn not_readable(path: &Path, error: &std::io::Error) -> Diagnostics {
    let reason = match error.kind() {
        _ if Refused::of(error) == Some(Refused::NotAFile) => "it is neither a file nor a folder".to_owned(),
        std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
        std::io::ErrorKind::PermissionDenied => "reading it is not permitted".to_owned(),
        std::io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string(),
    };
    let hint = match error.kind() {
        std::io::ErrorKind::NotFound => file_of_like_name(path),
        std::io::ErrorKind::IsADirectory => files_inside(path),
        _ => None,
    };
    let file = path.display().to_string();
    let refused_file = RefusedFile { path: file.clone(), reason: error.kind(), os_code: error.raw_os_error() };
    let diagnostic = Diagnostic::error(&DocumentProblem::NotReadable { file, reason, hint }, None);
    Diagnostic { refused_file: Some(Box::new(refused_file)), ..diagnostic }.into()
}

/// Reads a file as UTF-8 text.
///
/// # Errors
/// A file that cannot be read, is too large, or is not UTF-8 (with the place of the first wrong byte).
pub fn read_source(path: &Path) -> Result<Arc<Source>, Diagnostics> {
    let name = path.display().to_string();
    match read_named(path, MAX_FILE_BYTES as u64) {
        Ok(bytes) => source_from_bytes(&name, bytes),
        Err(error) => match Refused::of(&error) {
            Some(Refused::TooLarge { size_bytes, .. }) => {
                let size_bytes = usize::try_from(size_bytes).unwrap_or(usize::MAX);
                Err(Diagnostics::one(&DocumentProblem::TooLarge { file: name, size_bytes }, None))
            }
            _ => Err(not_readable(path, &error)),
        },
    }
}

/// Reads the file that a text names as `written`: from the folder of `source`, or among the files that were given with it.
///
/// # Errors
/// As for [`read_source`]; a file that was not given.
pub fn read_beside(source: &Source, written: &str) -> Result<Arc<Source>, Diagnostics> {
    let path = Path::new(source.name()).parent().unwrap_or(Path::new("")).join(written);
    let Some(files) = source.files() else { return read_source(&path) };
    let name = path.display().to_string();
    files.iter().find(|file| file.name() == name).cloned().ok_or_else(|| {
        let reason = "it was not given with the text that names it".to_owned();
        Diagnostics::one(&DocumentProblem::NotReadable { file: name, reason, hint: None }, None)
    })
}

/// As [`read_source`], from bytes.
pub fn source_from_bytes(name: &str, bytes: Vec<u8>) -> Result<Arc<Source>, Diagnostics> {
    match String::from_utf8(bytes) {
        Ok(text) => Ok(Source::new(name, text)),
        Err(error) => {
            let valid_bytes = error.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
            // The replacement character stands where the wrong byte was; what precedes it is unchanged.
            let place = Place::new(&Source::new(name, text), valid_bytes..valid_bytes + '\u{fffd}'.len_utf8());
            Err(Diagnostics::one(&DocumentProblem::NotUtf8, Some(place)))
        }
    }
}

/// Parses a text as TOML.
///
/// # Errors
/// Every place where it is not TOML.
pub fn parse_toml(source: &Arc<Source>) -> Result<Spanned<DeTable<'_>>, Diagnostics> {
    let size_bytes = source.text().len();
    if size_bytes > MAX_FILE_BYTES {
        let problem = DocumentProblem::TooLarge { file: source.name().to_owned(), size_bytes };
        return Err(Diagnostics::one(&problem, None));
    }
    work::add(size_bytes);
    let (table, errors) = DeTable::parse_recoverable(source.text());
    if errors.is_empty() {
        return Ok(table);
    }
    let mut diagnostics = Diagnostics::new();
    for error in errors {
        let place = error.span().map(|span| Place::new(source, span));
        let problem = if error.message() == "duplicate key" {
            let key = error.span().map(|span| source.text()[source.clamp(span.into())].to_owned());
            let line = place.as_ref().map_or(String::new(), |place| line_of(source, place));
            let is_listed = line.trim_start().starts_with("[[");
            DocumentProblem::DuplicateKey { key: shortened(&key.unwrap_or_default()), is_listed }
        } else {
            let line = place.as_ref().map_or(String::new(), |place| line_of(source, place));
            DocumentProblem::Syntax { reason: error.message().replace('\n', "; "), line }
        };
        diagnostics.push(Diagnostic::error(&problem, place));
    }
    Err(diagnostics)
}

/// The line that a place is in; empty where it is longer than any that somebody writes, so that thousands of errors in one line do not
/// copy it each.
fn line_of(source: &Source, place: &Place) -> String {
    const LONGEST_BYTES: usize = 500;
    let at = source.clamp(place.span).start;
    let text = source.text();
    let first = text.floor_char_boundary(at.saturating_sub(LONGEST_BYTES));
    let last = text.floor_char_boundary(at.saturating_add(LONGEST_BYTES));
    let start = text[first..at].rfind('\n').map(|end| first + end + 1).or((first == 0).then_some(0));
    let end = text[at..last].find('\n').map(|end| at + end).or((last == text.len()).then_some(last));
    let line = start.zip(end).map_or("", |(start, end)| &text[start..end]);
    line.strip_suffix('\r').unwrap_or(line).to_owned()
}

/// Collects diagnostics while a file is read.
#[derive(Debug)]
pub struct Reader {
    /// The file.
    pub source: Arc<Source>,
    /// Diagnostics so far.
    pub diagnostics: Diagnostics,
}

impl Reader {
    /// A reader that has read nothing yet.
    pub fn new(source: &Arc<Source>) -> Reader {
        Reader { source: Arc::clone(source), diagnostics: Diagnostics::new() }
    }

    /// A place in the file.
    pub fn place(&self, span: Span) -> Place {
        Place::new(&self.source, span)
    }

    /// Adds an error at a place of the file.
    pub fn report(&mut self, problem: &dyn Problem, span: Span) {
        let place = self.place(span);
        self.diagnostics.push(Diagnostic::error(problem, Some(place)));
    }

    /// Adds an error at a place of the file from which nothing can be read then.
    pub fn refuse<T>(&mut self, problem: &dyn Problem, span: Span) -> Option<T> {
        self.report(problem, span);
        None
    }

    /// A table at the top of the file.
    pub fn root<'t>(&mut self, entries: &'t DeTable<'t>, keys: &'static Keys) -> Table<'t> {
        self.checked_table(EntryPath::default(), Span::default(), entries, keys)
    }

    /// The table behind an entry, its keys checked.
    pub fn table<'t>(&mut self, entry: &Entry<'t>, keys: &'static Keys) -> Option<Table<'t>> {
        match entry.value {
            DeValue::Table(entries) => Some(self.checked_table(entry.path.clone(), entry.key_span, entries, keys)),
            _ => self.wrong_type(entry, "a table"),
        }
    }

    /// The choice behind the key of a table that decides which other keys it has.
    pub fn tag<T: Copy>(&mut self, entry: &Entry<'_>, key: &'static str, choices: &[(&'static str, T)]) -> Option<T> {
        if !entry.is_table() {
            return self.wrong_type(entry, "a table");
        }
        let Some(tag) = entry.get(key) else {
            let keys = choices.iter().map(|(word, _)| *word).collect();
            let problem = DocumentProblem::MissingTag { table: entry.path.describe(), key, choices: keys };
            return self.refuse(&problem, entry.key_span);
        };
        self.choice(&tag, choices)
    }

    fn checked_table<'t>(
        &mut self,
        path: EntryPath,
        span: Span,
        entries: &'t DeTable<'t>,
        keys: &'static Keys,
    ) -> Table<'t> {
        work::add(entries.len());
        let table = Table { path, span, entries, keys };
        let words = table.path.describe();
        let mut meant = Vec::new();
        let mut has_unknown = false;
        let mut has_planned = false;
        for written in entries.keys() {
            let key: &str = written.get_ref();
            if keys.find(key).is_some() {
                continue;
            }
            let problem = if let Some((_, instead)) = keys.planned.iter().find(|(planned, _)| *planned == key) {
                has_planned = true;
                DocumentProblem::NotYetSupported {
                    entry: table.path.join(key).describe(),
                    instead: (*instead).to_owned(),
                }
            } else if let Some((_, instead)) = keys.removed.iter().find(|(removed, _)| *removed == key) {
                DocumentProblem::RemovedKey { entry: table.path.join(key).describe(), instead: (*instead).to_owned() }
            } else {
                let known: Vec<&'static str> = keys.keys.iter().map(|key| key.name).collect();
                let other = by_synonym(key, &known);
                let nearest = other.map(|(same, _)| same).or_else(|| nearest_name(key, known.iter().copied()));
                let (nearest, note) = (nearest.map(str::to_owned), other.map_or("", |(_, note)| note));
                has_unknown = true;
                meant.extend(nearest.clone());
                DocumentProblem::UnknownKey { table: words.clone(), key: shortened(key), nearest, note, known }
            };
            self.report(&problem, written.span().into());
        }
        for key in keys.keys.iter().filter(|key| key.is_required && !table.has(key.name)) {
            // A misspelt key is one slip, not two; and a planned one stands where another would.
            if has_planned || meant.iter().any(|meant| meant == key.name) {
                continue;
            }
            let problem =
                DocumentProblem::MissingKey { table: words.clone(), key: key.name, example: key.example, doc: key.doc };
            self.report(&problem, span);
        }
        for group in keys.exactly_one {
            let given: Vec<&'static str> = group.iter().copied().filter(|key| table.has(key)).collect();
            match given.as_slice() {
                [_] => {}
                // Whatever was reported may have been meant for it.
                [] if has_unknown || has_planned => {}
                [] => {
                    let first = group.first().and_then(|key| keys.find(key)).filter(|key| !key.example.is_empty());
                    let example =
                        first.map_or(String::new(), |key| format!("{} = {} ({})", key.name, key.example, key.doc));
                    let problem = DocumentProblem::MissingOneOf { table: words.clone(), keys: group.to_vec(), example };
                    self.report(&problem, span)
                }
                [_, second, ..] => {
                    let place = table.get(second).map_or(span, |entry| entry.key_span);
                    let problem = DocumentProblem::MoreThanOneOf {
                        table: words.clone(),
                        given: given.clone(),
                        keys: group.to_vec(),
                    };
                    self.report(&problem, place);
                }
            }
        }
        table
    }

    /// Whether a table has a key that it needs because of what else stands in it; reports if not, unless the key is there
    /// misspelt and was reported.
    pub fn demand(&mut self, table: &Table<'_>, key: &str) -> bool {
        if table.has(key) {
            return true;
        }
        // What a table always needs was demanded when it was opened.
        let Some(key) = table.keys.find(key).filter(|key| !key.is_required) else { return false };
        let known = || table.keys.keys.iter().map(|key| key.name);
        let is_meant = table.entries.keys().any(|written| {
            let written: &str = written.get_ref();
            table.keys.find(written).is_none() && nearest_name(written, known()) == Some(key.name)
        });
        if !is_meant {
            let (table_words, span) = (table.path.describe(), table.span);
            let problem =
                DocumentProblem::MissingKey { table: table_words, key: key.name, example: key.example, doc: key.doc };
            self.report(&problem, span);
        }
        false
    }

    /// The entries of a table whose keys are names, each with a name that can be used.
    pub fn named<'t>(&mut self, entry: &Entry<'t>, what: &'static str) -> Vec<Entry<'t>> {
        let entries = self.any_keys(entry);
        entries
            .into_iter()
            .filter(|entry| {
                let usable = is_name(entry.name);
                if !usable {
                    self.report(&DocumentProblem::BadName { what, name: shortened(entry.name) }, entry.key_span);
                }
                usable
            })
            .collect()
    }

    /// The entries of a table, in the order of the file, whatever their keys.
    pub fn any_keys<'t>(&mut self, entry: &Entry<'t>) -> Vec<Entry<'t>> {
        let DeValue::Table(entries) = entry.value else {
            self.wrong_type::<()>(entry, "a table");
            return Vec::new();
        };
        work::add(entries.len());
        entries.iter().map(|(key, value)| Entry::below(&entry.path, key, value)).collect()
    }

    /// The elements of a list.
    pub fn list<'t>(&mut self, entry: &Entry<'t>) -> Option<Vec<Entry<'t>>> {
        match entry.value {
            DeValue::Array(elements) => {
                Some(elements.iter().enumerate().map(|(index, value)| entry.element(index, value)).collect())
            }
            _ => self.wrong_type(entry, "a list"),
        }
    }

    /// The elements of a list of two.
    pub fn pair<'t>(&mut self, entry: &Entry<'t>) -> Option<[Entry<'t>; 2]> {
        if !matches!(entry.value, DeValue::Array(_)) {
            return self.wrong_type(entry, PAIR);
        }
        let elements = self.list(entry)?;
        match <[Entry<'t>; 2]>::try_from(elements) {
            Ok(pair) => Some(pair),
            Err(elements) => {
                let problem =
                    DocumentProblem::WrongLength { entry: entry.path.describe(), found: elements.len(), due: 2 };
                self.refuse(&problem, entry.span)
            }
        }
    }

    /// The elements of a list of three.
    pub fn three<'t>(&mut self, entry: &Entry<'t>) -> Option<[Entry<'t>; 3]> {
        if !matches!(entry.value, DeValue::Array(_)) {
            return self.wrong_type(entry, THREE);
        }
        let elements = self.list(entry)?;
        match <[Entry<'t>; 3]>::try_from(elements) {
            Ok(three) => Some(three),
            Err(elements) => {
                let problem =
                    DocumentProblem::WrongLength { entry: entry.path.describe(), found: elements.len(), due: 3 };
                self.refuse(&problem, entry.span)
            }
        }
    }

    /// Reports that something else is due here.
    pub fn wrong_type<T>(&mut self, entry: &Entry<'_>, due: &'static str) -> Option<T> {
        let pair_of_brackets = entry.key.filter(|key| {
            // [[random]] instead of [random].
            key.example.is_empty() && due == "a table" && matches!(entry.value, DeValue::Array(_))
        });
        let pair_of_brackets = pair_of_brackets.map(|key| {
            let line = if matches!(key.kind, Kind::Tables { .. }) {
                ", and in it a line for each: the path, then = { ... }"
            } else {
                ""
            };
            format!("[{}], with one pair of brackets{line} ({})", key.name, key.doc)
        });
        let example = pair_of_brackets.or_else(|| entry.example()).unwrap_or_default();
        let problem = DocumentProblem::WrongType { entry: entry.path.describe(), found: entry.found(), due, example };
        self.refuse(&problem, entry.span)
    }

    /// The number at an entry; `None`, without a diagnostic, if it is something else.
    pub fn number_at(&self, entry: &Entry<'_>) -> Option<f64> {
        match entry.value {
            DeValue::Integer(number) => number.as_str().parse().ok(),
            DeValue::Float(number) => number.as_str().parse().ok(),
            _ => None,
        }
    }

    /// Text that is not empty and can be shown.
    pub fn text<'t>(&mut self, entry: &Entry<'t>) -> Option<&'t str> {
        match entry.value {
            DeValue::String(text) if let Some(character) = first_control_character(text) => {
                let problem = DocumentProblem::ControlCharacter { entry: entry.path.describe(), character };
                self.refuse(&problem, entry.span)
            }
            DeValue::String(text) if !text.trim().is_empty() => Some(text),
            DeValue::String(_) => {
                let problem = DocumentProblem::WrongType {
                    entry: entry.path.describe(),
                    found: "empty".to_owned(),
                    due: "text that is not empty",
                    example: String::new(),
                };
                self.refuse(&problem, entry.span)
            }
            _ => self.wrong_type(entry, "text"),
        }
    }

    /// One of a few words, each with its value.
    pub fn choice<T: Copy>(&mut self, entry: &Entry<'_>, choices: &[(&'static str, T)]) -> Option<T> {
        let text = self.text(entry)?;
        if let Some((_, meaning)) = choices.iter().find(|(word, _)| *word == text) {
            return Some(*meaning);
        }
        let choices: Vec<&'static str> = choices.iter().map(|(word, _)| *word).collect();
        let other = by_synonym(text, &choices).map(|(same, _)| same);
        let nearest = other.or_else(|| nearest_name(text, choices.iter().copied())).map(str::to_owned);
        let doc = entry.key.map_or("", |key| key.doc);
        let problem = DocumentProblem::UnknownChoice {
            entry: entry.path.describe(),
            found: shortened(text),
            choices,
            nearest,
            doc,
        };
        self.refuse(&problem, entry.span)
    }

    /// The whole number at an entry, within the limits of the table of keys.
    pub fn count_of(&mut self, entry: &Entry<'_>) -> Option<u64> {
        let (least, most) = entry.count_limits()?;
        let found = match entry.value {
            DeValue::Integer(number) => {
                match i128::from_str_radix(number.as_str(), number.radix()).ok().and_then(|n| u64::try_from(n).ok()) {
                    Some(count) if (least..=most).contains(&count) => return Some(count),
                    _ => shortened(&number.to_string()),
                }
            }
            DeValue::Float(number) => shortened(number.as_str()),
            _ => return self.wrong_type(entry, "a whole number"),
        };
        self.refuse(&DocumentProblem::BadCount { entry: entry.path.describe(), found, least, most }, entry.span)
    }

    /// The bare number behind a key, keeping the rule of the table of keys; absent where it is not written.
    pub fn number(&mut self, table: &Table<'_>, key: &str) -> Option<f64> {
        self.number_of(&table.get(key)?)
    }

    /// The bare number at an entry, keeping the rule of the table of keys.
    pub fn number_of(&mut self, entry: &Entry<'_>) -> Option<f64> {
        let rule = entry.number_rule()?;
        let value = match entry.value {
            DeValue::Integer(_) | DeValue::Float(_) => self.bare_number(entry)?,
            _ => return self.wrong_type(entry, "a number"),
        };
        self.keeps(entry, value, Dimension::NUMBER, rule).then_some(value)
    }

    fn bare_number(&mut self, entry: &Entry<'_>) -> Option<f64> {
        let (text, value) = match entry.value {
            DeValue::Integer(number) => {
                let value = i128::from_str_radix(number.as_str(), number.radix()).map_or(f64::INFINITY, |n| n as f64);
                (number.to_string(), value)
            }
            DeValue::Float(number) => (number.to_string(), number.as_str().parse().unwrap_or(f64::NAN)),
            _ => return None,
        };
        if value.is_finite() {
            return Some(value);
        }
        let problem = DocumentProblem::NotFinite { entry: entry.path.describe(), found: shortened(&text) };
        self.refuse(&problem, entry.span)
    }

    /// The text or number of a quantity; reports anything else.
    pub fn written<'t>(&mut self, entry: &Entry<'t>) -> Option<Written<'t>> {
        match entry.value {
            DeValue::String(text) if text.trim() == TO_FILL_IN => {
                self.refuse(&DocumentProblem::ToFillIn { entry: entry.path.describe() }, entry.span)
            }
            DeValue::String(text) => Some(Written::Text(text)),
            DeValue::Integer(_) | DeValue::Float(_) => self.bare_number(entry).map(Written::Number),
            _ => self.wrong_type(entry, TEXT_WITH_UNIT),
        }
    }

    /// A value of a given dimension, without parameters.
    pub fn measured(&mut self, entry: &Entry<'_>, dimension: Dimension, rule: Rule) -> Option<f64> {
        let measured = match self.written(entry)? {
            Written::Number(value_si) => Measured { value_si, dimension: Dimension::NUMBER },
            Written::Text(text) => match parse_quantity(text) {
                Ok(measured) => measured,
                Err(error) => {
                    if let Some(written) = with_point(text) {
                        let problem = DocumentProblem::DecimalComma { entry: entry.path.describe(), written };
                        return self.refuse(&problem, entry.span);
                    }
                    let error = for_single_value(error, text, Some(dimension), None);
                    let span = self.inside(entry, text, &error.span);
                    return self.refuse(&error.problem, span);
                }
            },
        };
        self.measures(entry, measured.dimension, dimension)
            .then_some(measured.value_si)
            .filter(|value_si| self.keeps(entry, *value_si, dimension, rule))
    }

    /// As [`Reader::measured`], where one of the words of `before` may stand before the value, as `±` does.
    pub fn measured_beyond(
        &mut self,
        entry: &Entry<'_>,
        before: &[&str],
        dimension: Dimension,
        rule: Rule,
    ) -> Option<f64> {
        if let DeValue::String(text) = entry.value
            && let Some(rest) = before.iter().find_map(|word| text.trim_start().strip_prefix(word))
            && let Ok(measured) = parse_quantity(rest)
        {
            return self
                .measures(entry, measured.dimension, dimension)
                .then_some(measured.value_si)
                .filter(|value_si| self.keeps(entry, *value_si, dimension, rule));
        }
        self.measured(entry, dimension, rule)
    }

    /// Whether a value measures what is due; reports if not.
    pub fn measures(&mut self, entry: &Entry<'_>, found: Dimension, due: Dimension) -> bool {
        if found == due {
            return true;
        }
        let words = entry.path.describe();
        let problem = if found.is_number() {
            let found = match entry.value {
                DeValue::String(text) => shortened(text),
                DeValue::Integer(number) => number.to_string(),
                DeValue::Float(number) => number.to_string(),
                _ => String::new(),
            };
            DocumentProblem::MissingUnit { entry: words, found, due }
        } else {
            DocumentProblem::WrongDimension { entry: words, found, due }
        };
        self.report(&problem, entry.span);
        false
    }

    /// Whether a value keeps its rule; reports if not.
    pub fn keeps(&mut self, entry: &Entry<'_>, value_si: f64, dimension: Dimension, rule: Rule) -> bool {
        if rule.allows(value_si) {
            return true;
        }
        let found = format_refused(value_si, dimension);
        let problem = DocumentProblem::BreaksRule { entry: entry.path.describe(), found, rule };
        self.report(&problem, entry.span);
        false
    }

    /// A part of a text as a part of the file; the whole value where escapes have moved the bytes.
    pub fn inside(&self, entry: &Entry<'_>, text: &str, part: &std::ops::Range<usize>) -> Span {
        const QUOTE_BYTES: usize = 1;
        let raw = &self.source.text()[self.source.clamp(entry.span)];
        let is_verbatim =
            raw.len() == text.len() + 2 * QUOTE_BYTES && raw.get(QUOTE_BYTES..raw.len() - 1) == Some(text);
        if !is_verbatim {
            return entry.span;
        }
        let start = entry.span.start + QUOTE_BYTES;
        Span { start: start + part.start, end: start + part.end.max(part.start + 1).min(text.len() + 1) }
    }
}
/// A quantity with a decimal comma, `50,5 mm`, with a decimal point; `None` if the text is something else.
fn with_point(text: &str) -> Option<String> {
    let (before, after) = text.split_once(',')?;
    let is_number = before.ends_with(|c: char| c.is_ascii_digit()) && after.starts_with(|c: char| c.is_ascii_digit());
    let written = format!("{before}.{after}");
    (is_number && parse_quantity(&written).is_ok()).then_some(written)
}
