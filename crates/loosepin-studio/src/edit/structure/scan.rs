//! Where everything stands in a text that is TOML: the lines of each header and entry, each key, each value.
//!
//! The text was read as TOML before: what is found here is where things stand, not whether they are right.

use std::collections::BTreeMap;
use std::ops::Range;

use loosepin::diagnostics::Source;
use loosepin::document::parse_toml;

/// Tables in tables, at most.
const DEEPEST: usize = 80;

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
    /// Value of an entry; none of a header.
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

/// The statements of a text; nothing where it is not TOML.
pub fn scan(text: &str) -> Option<Scanned> {
    let source = Source::new("", text);
    parse_toml(&source).ok()?;
    Scanner { text, at: 0 }.statements()
}

struct Scanner<'t> {
    text: &'t str,
    at: usize,
}

impl Scanner<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn next(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn take(&mut self, expected: &str) -> bool {
        let is_there = self.rest().starts_with(expected);
        self.at += if is_there { expected.len() } else { 0 };
        is_there
    }

    fn skip_spaces(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start_matches([' ', '\t']).len();
    }

    /// Past spaces, line ends and comments.
    fn skip_blank(&mut self) {
        loop {
            self.at += self.rest().len() - self.rest().trim_start_matches([' ', '\t', '\r', '\n']).len();
            if self.next() != Some('#') {
                return;
            }
            self.skip_line();
        }
    }

    /// Past the end of the line.
    fn skip_line(&mut self) {
        self.at += self.rest().find('\n').map_or(self.rest().len(), |end| end + 1);
    }

    fn statements(mut self) -> Option<Scanned> {
        let mut statements = Vec::new();
        let mut base: Vec<String> = Vec::new();
        // How many elements each list of tables has so far.
        let mut lists: BTreeMap<Vec<String>, usize> = BTreeMap::new();
        self.take("\u{feff}");
        loop {
            self.skip_blank();
            if self.rest().is_empty() {
                return Some(Scanned { statements });
            }
            let start = self.text[..self.at].rfind('\n').map_or(0, |end| end + 1);
            let is_header = self.take("[");
            let is_list = is_header && self.take("[");
            self.skip_spaces();
            let keys = self.keys()?;
            let names = keys.iter().map(|key| key.name.clone());
            let (path, value) = if is_header {
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
                (path, None)
            } else {
                self.skip_spaces();
                if !self.take("=") {
                    return None;
                }
                self.skip_spaces();
                let value = self.value(0)?;
                (base.iter().cloned().chain(names).collect(), Some(value))
            };
            self.skip_line();
            statements.push(Statement { lines: start..self.at, keys, path, value });
        }
    }

    /// Keys with dots between them; never empty.
    fn keys(&mut self) -> Option<Vec<Key>> {
        let mut keys = Vec::new();
        loop {
            self.skip_spaces();
            keys.push(self.key()?);
            if keys.len() > DEEPEST {
                return None;
            }
            let after = self.at;
            self.skip_spaces();
            if !self.take(".") {
                self.at = after;
                return Some(keys);
            }
        }
    }

    fn key(&mut self) -> Option<Key> {
        let start = self.at;
        let name = match self.next()? {
            '"' | '\'' => self.string()?,
            _ => {
                let is_bare = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-');
                let length = self.rest().find(|c| !is_bare(c)).unwrap_or(self.rest().len());
                self.at += length;
                self.text[start..self.at].to_owned()
            }
        };
        (self.at > start).then_some(Key { name, span: start..self.at })
    }

    /// Past a text in quotes: its contents.
    fn string(&mut self) -> Option<String> {
        let start = self.at;
        let mark = self.next()?;
        let three: String = [mark; 3].iter().collect();
        let is_long = self.take(&three);
        let end = if is_long { three.as_str() } else { &three[..1] };
        if !is_long {
            self.at += 1;
        }
        loop {
            if mark == '"' && self.take("\\") {
                self.at += self.next()?.len_utf8();
            } else if self.take(end) {
                // Two more quotes may belong to the text.
                while is_long && self.take(&three[..1]) {}
                break;
            } else {
                self.at += self.next()?.len_utf8();
            }
        }
        let written = &self.text[start..self.at];
        if !is_long && !written.contains('\\') {
            return Some(written[1..written.len() - 1].to_owned());
        }
        let source = Source::new("", format!("x = {written}"));
        let toml = parse_toml(&source).ok()?;
        Some(toml.get_ref().get("x")?.get_ref().as_str()?.to_owned())
    }

    fn value(&mut self, depth: usize) -> Option<Value> {
        if depth > DEEPEST {
            return None;
        }
        let start = self.at;
        let kind = match self.next()? {
            '"' | '\'' => ValueKind::Text(self.string()?),
            '[' => {
                self.at += 1;
                let mut values = Vec::new();
                loop {
                    self.skip_blank();
                    if self.take("]") {
                        break ValueKind::List(values);
                    }
                    values.push(self.value(depth + 1)?);
                    self.skip_blank();
                    self.take(",");
                }
            }
            '{' => {
                self.at += 1;
                let mut items = Vec::new();
                loop {
                    self.skip_blank();
                    if self.take("}") {
                        break ValueKind::Table(items);
                    }
                    let keys = self.keys()?;
                    self.skip_spaces();
                    if !self.take("=") {
                        return None;
                    }
                    self.skip_spaces();
                    items.push(Item { keys, value: self.value(depth + 1)? });
                    self.skip_blank();
                    self.take(",");
                }
            }
            _ => {
                let end = self.rest().find([',', ']', '}', '#', '\n', '\r']).unwrap_or(self.rest().len());
                let written = self.rest()[..end].trim_end().len();
                self.at += written;
                (written > 0).then_some(ValueKind::Other)?
            }
        };
        Some(Value { span: start..self.at, kind })
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
