//! Tables and entries of a TOML file with their places.

use std::sync::LazyLock;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::keys::{Key, Keys, Kind};
use super::path::EntryPath;
use crate::diagnostics::Span;
use crate::units::{Dimension, Rule};

/// A table whose keys have been checked.
#[derive(Debug, Clone)]
pub struct Table<'t> {
    /// Its path.
    pub path: EntryPath,
    /// Its header.
    pub span: Span,
    pub(super) entries: &'t DeTable<'t>,
    pub(super) keys: &'static Keys,
}

/// One `key = value`.
#[derive(Debug, Clone)]
pub struct Entry<'t> {
    /// Its path.
    pub path: EntryPath,
    /// The key as written.
    pub name: &'t str,
    /// Place of the key.
    pub key_span: Span,
    /// Place of the value.
    pub span: Span,
    pub(super) value: &'t DeValue<'t>,
    /// Its row in the table of keys, where there is one.
    pub(super) key: Option<&'static Key>,
}

/// The text or number of a quantity.
#[derive(Debug, Clone, Copy)]
pub enum Written<'t> {
    /// Text.
    Text(&'t str),
    /// A bare number.
    Number(f64),
}

/// What stands in a table that is left out.
static NOTHING: LazyLock<DeTable<'static>> = LazyLock::new(DeTable::new);

impl<'t> Table<'t> {
    /// A table that is left out at `path`, as if it were there without keys.
    pub fn omitted(path: EntryPath, keys: &'static Keys) -> Table<'t> {
        Table { path, span: Span::default(), entries: &NOTHING, keys }
    }

    /// The entry of a key that the table may have; absent where it is not written.
    pub fn get(&self, key: &str) -> Option<Entry<'t>> {
        let known = self.keys.find(key);
        debug_assert!(known.is_some(), "the reader asks for '{key}', which the table of keys does not have");
        let (written, value) = self.entries.get_key_value(key)?;
        Some(Entry { key: known, ..Entry::below(&self.path, written, value) })
    }

    /// Dimension and rule of a key, where it is a quantity of fixed dimension.
    pub fn due_quantity(&self, key: &str) -> Option<(Dimension, Rule)> {
        quantity_of(self.keys.find(key)?)
    }

    /// Description of a key in the table of keys.
    pub fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.find(name)
    }

    /// Whether a key is written that the table cannot have: it was reported.
    pub fn has_unknown(&self) -> bool {
        self.entries.keys().any(|written| self.keys.find(written.get_ref()).is_none())
    }

    /// Whether a key is written.
    pub fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }
}

impl<'t> Entry<'t> {
    /// A key with its value in the table at `path`, without a row in a table of keys.
    pub(super) fn below(
        path: &EntryPath,
        written: &'t Spanned<DeString<'t>>,
        value: &'t Spanned<DeValue<'t>>,
    ) -> Entry<'t> {
        Entry {
            path: path.join(written.get_ref()),
            name: written.get_ref(),
            key_span: written.span().into(),
            span: value.span().into(),
            value: value.get_ref(),
            key: None,
        }
    }

    /// An element of a list.
    pub(super) fn element(&self, index: usize, value: &'t Spanned<DeValue<'t>>) -> Entry<'t> {
        Entry {
            path: self.path.join(&(index + 1).to_string()),
            name: self.name,
            key_span: value.span().into(),
            span: value.span().into(),
            value: value.get_ref(),
            key: None,
        }
    }

    /// Dimension and rule that the table of keys demands, where it is a quantity of fixed dimension.
    pub fn due_quantity(&self) -> Option<(Dimension, Rule)> {
        quantity_of(self.key?)
    }

    /// An example of its key, with its meaning: `mass = "0.3 kg" (mass of the body)`. None of an element of a list, or of a key without an
    /// example.
    pub fn example(&self) -> Option<String> {
        let key = self.key.filter(|key| !key.example.is_empty())?;
        Some(format!("{} = {} ({})", key.name, key.example, key.doc))
    }

    /// A copy with the place of its key, for diagnostics about a name that is a key.
    pub fn at_key(&self) -> Entry<'t> {
        Entry { span: self.key_span, ..self.clone() }
    }

    /// Least and most that the table of keys allows, where it is a count.
    pub(super) fn count_limits(&self) -> Option<(u64, u64)> {
        match self.key?.kind {
            Kind::Count { least, most } => Some((least, most)),
            _ => None,
        }
    }

    /// Rule that the table of keys demands, where it is a bare number.
    pub(super) fn number_rule(&self) -> Option<Rule> {
        match self.key?.kind {
            Kind::Number { rule } => Some(rule),
            Kind::AnyOf(kinds) => kinds.iter().find_map(|kind| match kind {
                Kind::Number { rule } => Some(*rule),
                _ => None,
            }),
            _ => None,
        }
    }

    /// Whether the entry is a text.
    pub fn is_text(&self) -> bool {
        self.value.is_str()
    }

    /// The text of the entry, if it is text.
    pub fn as_text(&self) -> Option<&'t str> {
        self.value.as_str()
    }

    /// Whether the entry is a table.
    pub fn is_table(&self) -> bool {
        self.value.is_table()
    }

    /// The entry of a key, if this entry is a table; the key need not be known.
    pub fn get(&self, key: &str) -> Option<Entry<'t>> {
        let (written, value) = self.value.as_table()?.get_key_value(key)?;
        Some(Entry::below(&self.path, written, value))
    }

    /// Whether the entry is a table with this key.
    pub fn holds(&self, key: &str) -> bool {
        self.value.as_table().is_some_and(|table| table.contains_key(key))
    }

    /// Whether the entry is a list.
    pub fn is_list(&self) -> bool {
        self.value.is_array()
    }

    /// Whether the entry is an empty list.
    pub fn is_empty_list(&self) -> bool {
        self.value.as_array().is_some_and(|list| list.is_empty())
    }

    /// Its value in words, for messages: `the number 3`, `a table`.
    pub fn found(&self) -> String {
        match self.value {
            DeValue::String(text) => format!("the text \"{}\"", shortened(text)),
            DeValue::Integer(number) => format!("the number {number}"),
            DeValue::Float(number) => format!("the number {number}"),
            DeValue::Boolean(value) => format!("the truth value {value}"),
            DeValue::Datetime(value) => format!("the date {value}"),
            DeValue::Array(_) => "a list".to_owned(),
            DeValue::Table(_) => "a table".to_owned(),
        }
    }
}

fn quantity_of(key: &Key) -> Option<(Dimension, Rule)> {
    match key.kind {
        Kind::Quantity { dimension, rule } => Some((dimension, rule)),
        _ => None,
    }
}

/// Text cut to what fits in a message, without line breaks or control characters.
pub(super) fn shortened(text: &str) -> String {
    const SHOWN_CHARS: usize = 60;
    let mut shown: String =
        text.chars().take(SHOWN_CHARS).map(|character| if character.is_control() { ' ' } else { character }).collect();
    if text.chars().count() > SHOWN_CHARS {
        shown.push('…');
    }
    shown
}
