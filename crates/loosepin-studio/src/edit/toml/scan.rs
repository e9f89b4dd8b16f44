//! Spans of a TOML text: the lines of each header and entry, each key, each value.
//!
//! The parser of the `toml` crate gives its words and their places (`toml_parser`): `toml` itself keeps one place of a table that has
//! several headers.

use std::collections::BTreeMap;
use std::iter::Peekable;
use std::ops::Range;

use loosepin::document::parse_toml;
use toml_parser::Source;
use toml_parser::parser::{Event, EventKind, parse_document};

/// Most keys with dots between them.
const MAX_KEYS: usize = 80;

/// A key as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// Without quotes.
    pub name: String,
    /// Bytes, quotes and all.
    pub span: Range<usize>,
}

/// A value as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// Bytes, quotes and all.
    pub span: Range<usize>,
    /// Contents.
    pub kind: ValueKind,
}

/// Contents of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum ValueKind {
    /// Text, without quotes.
    Text(String),
    /// A number, a truth value or a date.
    Other,
    /// `[ ... ]`.
    List(Vec<Value>),
    /// `{ ... }`.
    Table(Vec<Item>),
}

/// An entry of a table in braces.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// One key, or more with dots between them.
    pub keys: Vec<Key>,
    /// Value.
    pub value: Value,
}

impl Item {
    /// From the first key to the end of the value.
    pub fn span(&self) -> Range<usize> {
        self.keys.first().map_or(self.value.span.start, |key| key.span.start)..self.value.span.end
    }
}

/// A header, or an entry on lines of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// Whole lines, line ends included.
    pub lines: Range<usize>,
    /// One key, or more with dots between them.
    pub keys: Vec<Key>,
    /// Keys from the top of the file; an element of a list of tables is `#0`, `#1`, ...
    pub path: Vec<String>,
    /// Value of an entry; `None` for a header.
    pub value: Option<Value>,
}

/// A text with its statements.
#[derive(Debug, Clone, PartialEq)]
pub struct Scanned {
    /// In the order of the text.
    pub statements: Vec<Statement>,
}

impl Scanned {
    /// The value with this path.
    pub fn value_at(&self, path: &[String]) -> Option<&Value> {
        self.statements.iter().find_map(|one| {
            let rest = path.strip_prefix(one.path.as_slice())?;
            one.value.as_ref()?.inside(rest)
        })
    }
}

impl Value {
    /// The value with this path in a table in braces.
    pub fn inside(&self, path: &[String]) -> Option<&Value> {
        if path.is_empty() {
            return Some(self);
        }
        let ValueKind::Table(items) = &self.kind else { return None };
        items.iter().find_map(|item| {
            let rest = path.get(item.keys.len()..)?;
            let is_here = item.keys.iter().map(|key| &key.name).eq(&path[..item.keys.len()]);
            is_here.then(|| item.value.inside(rest)).flatten()
        })
    }
}

/// Name of an element of a list in a path.
pub fn element(index: usize) -> String {
    format!("#{index}")
}

/// The statements of a text; `None` if it is not TOML.
pub fn scan(text: &str) -> Option<Scanned> {
    // Whatever is not right, or too deep, is found here.
    parse_toml(&loosepin::diagnostics::Source::new("", text)).ok()?;
    let source = Source::new(text);
    let mut events: Vec<Event> = Vec::new();
    parse_document(&source.lex().into_vec(), &mut events, &mut ());
    let is_said = |event: &Event| {
        use EventKind::{Comment, KeySep, KeyValSep, Newline, ValueSep, Whitespace};
        !matches!(event.kind(), Comment | KeySep | KeyValSep | Newline | ValueSep | Whitespace)
    };
    events.retain(is_said);
    Reader { source, events: events.into_iter().peekable() }.statements()
}

/// Goes through keys, values and the brackets around them.
struct Reader<'t> {
    source: Source<'t>,
    events: Peekable<std::vec::IntoIter<Event>>,
}

impl Reader<'_> {
    fn statements(mut self) -> Option<Scanned> {
        let text = self.source.input();
        let mut statements = Vec::new();
        let mut base: Vec<String> = Vec::new();
        // How many elements each list of tables has so far.
        let mut lists: BTreeMap<Vec<String>, usize> = BTreeMap::new();
        while let Some(first) = self.events.peek().copied() {
            let start = text[..first.span().start()].rfind('\n').map_or(0, |end| end + 1);
            let is_list = first.kind() == EventKind::ArrayTableOpen;
            let is_header = is_list || first.kind() == EventKind::StdTableOpen;
            if is_header {
                self.events.next();
            }
            let keys = self.keys()?;
            let names = keys.iter().map(|key| key.name.clone());
            let (path, value, end) = if is_header {
                let mut path = Vec::new();
                let last = keys.len() - 1;
                for (place, name) in names.enumerate() {
                    path.push(name);
                    let count = lists.get(&path).copied();
                    if is_list && place == last {
                        lists.insert(path.clone(), count.unwrap_or(0) + 1);
                        path.push(element(count.unwrap_or(0)));
                    } else if let Some(count) = count {
                        path.push(element(count.saturating_sub(1)));
                    }
                }
                base.clone_from(&path);
                (path, None, self.events.next()?.span().end())
            } else {
                let value = self.value()?;
                let end = value.span.end;
                (base.iter().cloned().chain(names).collect(), Some(value), end)
            };
            let end = text[end..].find('\n').map_or(text.len(), |line_end| end + line_end + 1);
            statements.push(Statement { lines: start..end, keys, path, value });
        }
        Some(Scanned { statements })
    }

    /// Keys with dots between them; never empty.
    fn keys(&mut self) -> Option<Vec<Key>> {
        let mut keys = Vec::new();
        while let Some(event) = self.events.next_if(|event| event.kind() == EventKind::SimpleKey) {
            let mut name = String::new();
            self.source.get(event)?.decode_key(&mut name, &mut ());
            keys.push(Key { name, span: event.span().start()..event.span().end() });
        }
        (1..=MAX_KEYS).contains(&keys.len()).then_some(keys)
    }

    fn value(&mut self) -> Option<Value> {
        let first = self.events.next()?;
        let mut end = first.span().end();
        let mut closes = |event: &Event, kind: EventKind| {
            end = event.span().end();
            event.kind() == kind
        };
        let kind = match first.kind() {
            EventKind::Scalar if first.encoding().is_some() => {
                let mut text = String::new();
                _ = self.source.get(first)?.decode_scalar(&mut text, &mut ());
                ValueKind::Text(text)
            }
            EventKind::Scalar => ValueKind::Other,
            EventKind::ArrayOpen => {
                let mut values = Vec::new();
                while self.events.next_if(|event| closes(event, EventKind::ArrayClose)).is_none() {
                    values.push(self.value()?);
                }
                ValueKind::List(values)
            }
            EventKind::InlineTableOpen => {
                let mut items = Vec::new();
                while self.events.next_if(|event| closes(event, EventKind::InlineTableClose)).is_none() {
                    items.push(Item { keys: self.keys()?, value: self.value()? });
                }
                ValueKind::Table(items)
            }
            _ => return None,
        };
        Some(Value { span: first.span().start()..end, kind })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ODD: &str = "\u{feff}a.\"b c\" = 'x' # \"no\" end\r\n[ t . u ] # [x]\r\nk = { p = [1, 2], 'q' = \"}\\\"\" } # }\n\n[[list]]\nm = \"\"\"\n[no]\n\"\"\"\n\
        n = [ # ]\n  1,\n  \"]\",\n]\n[list.in]\nd = 1979-05-27 07:32:00\n[[list]]\n[list.in]\nlast = true";

    #[test]
    fn every_statement_has_its_lines_and_its_path() {
        let scanned = scan(ODD).unwrap();
        let found: Vec<String> = scanned.statements.iter().map(|one| one.path.join("/")).collect();
        let due = [
            "a/b c",
            "t/u",
            "t/u/k",
            "list/#0",
            "list/#0/m",
            "list/#0/n",
            "list/#0/in",
            "list/#0/in/d",
            "list/#1",
            "list/#1/in",
            "list/#1/in/last",
        ];
        assert_eq!(found, due);
        let lines: Vec<&str> = scanned.statements.iter().map(|one| &ODD[one.lines.clone()]).collect();
        assert_eq!(lines[0], "\u{feff}a.\"b c\" = 'x' # \"no\" end\r\n");
        assert_eq!(lines[4], "m = \"\"\"\n[no]\n\"\"\"\n");
        assert_eq!(lines[10], "last = true");
        let Some(Value { kind: ValueKind::Table(items), .. }) = &scanned.statements[2].value else { panic!("a table") };
        assert_eq!(items[1].value.kind, ValueKind::Text("}\"".to_owned()));
        assert_eq!(&ODD[items[0].span()], "p = [1, 2]");
    }

    #[test]
    fn what_is_not_toml_has_no_statements() {
        for text in ["a", "a = ", "a = [", "[a", "a = \"b", "a = 1\na = 2", "a = {b = 1"] {
            assert_eq!(scan(text), None, "{text}");
        }
        assert_eq!(scan("").map(|scanned| scanned.statements.len()), Some(0));
        let deep = format!("a = {}{}", "[".repeat(5000), "]".repeat(5000));
        assert_eq!(scan(&deep), None);
    }
}
