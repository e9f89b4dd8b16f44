//! Lines and entries that come into a text, and that go out of it. All else keeps its bytes.

use std::collections::BTreeMap;
use std::ops::Range;

use super::scan::{Item, Scanned, Statement, Value, ValueKind, element, scan};
use crate::network::refusal::Refusal;

/// Tables of a model in their usual order, for a table of which there is none yet.
const ORDER: [&str; 13] = [
    "parameter",
    "body",
    "contact",
    "joint",
    "coupling",
    "cam",
    "spring",
    "load",
    "drive",
    "control",
    "initial",
    "assembly",
    "cycle",
];

/// A text that is changed piece by piece.
#[derive(Debug, Clone)]
pub struct Lines {
    text: String,
}

/// Bytes and what comes in their place.
type Piece = (Range<usize>, String);

impl Lines {
    /// A text as it is.
    pub fn new(text: &str) -> Self {
        Self { text: text.to_owned() }
    }

    /// The text as it is now.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its statements.
    ///
    /// # Errors
    /// It is not TOML.
    pub fn scanned(&self) -> Result<Scanned, Refusal> {
        scan(&self.text).ok_or_else(|| {
            Refusal::bad("the text cannot be read")
                .with_hint("mend its problems first; they are listed below the drawing")
        })
    }

    /// Puts pieces in place, which do not overlap. New lines end as those of the text do.
    pub fn replace(&mut self, mut pieces: Vec<Piece>) {
        let is_dos = self.text.contains("\r\n");
        pieces.sort_by_key(|(range, _)| range.start);
        let mut limit = self.text.len();
        // What would fall into another piece is left out: who reads the text again sees that something is missing.
        let is_apart = |(range, _): &Piece| {
            let is_apart = range.start <= range.end && range.end <= limit;
            limit = if is_apart { range.start } else { limit };
            is_apart
        };
        let mut pieces: Vec<Piece> = pieces.into_iter().rev().filter(is_apart).collect();
        let mut text = String::with_capacity(self.text.len());
        let mut from = 0;
        while let Some((range, new)) = pieces.pop() {
            let new = if is_dos { new.replace("\r\n", "\n").replace('\n', "\r\n") } else { new };
            text.push_str(&self.text[from..range.start]);
            text.push_str(&new);
            from = range.end;
        }
        text.push_str(&self.text[from..]);
        self.text = text;
    }

    fn insert(&mut self, at: usize, new: &str) {
        let before = if at == 0 || self.text[..at].ends_with('\n') { "" } else { "\n" };
        self.replace(vec![(at..at, format!("{before}{new}"))]);
    }

    /// Adds a table of a group: `[group.name]` with entries, or the like in braces where the group is written so.
    ///
    /// # Errors
    /// The text is not TOML.
    pub fn add_table(
        &mut self,
        group: &str,
        name: &str,
        comment: &str,
        entries: &[(&str, String)],
    ) -> Result<(), Refusal> {
        let scanned = self.scanned()?;
        let of_group: Vec<&Statement> =
            scanned.statements.iter().filter(|one| one.path.first().is_some_and(|first| first == group)).collect();
        let comment = if comment.is_empty() { String::new() } else { format!("  # {comment}") };
        let lines: String = entries.iter().map(|(key, value)| format!("{key} = {value}\n")).collect();
        let block = format!("[{group}.{name}]{comment}\n{lines}");
        let inline: Vec<String> = entries.iter().map(|(key, value)| format!("{key} = {value}")).collect();
        let inline = format!("{{ {} }}", inline.join(", "));
        let own_keys = |one: &Statement| one.value.is_some() && one.keys.len() == one.path.len();
        match of_group.last() {
            None => {
                let at = self.place_of(&scanned, group);
                let after = if at == self.text.len() { "" } else { "\n" };
                let before = if at == self.text.len() && at > 0 { "\n" } else { "" };
                self.insert(at, &format!("{before}{block}{after}"));
            }
            // `group = { ... }` at the top of the file.
            Some(last) if own_keys(last) && last.path.len() == 1 => {
                let piece = last.value.as_ref().and_then(|value| into_braces(value, name, &inline));
                self.replace(vec![piece.ok_or_else(|| elsewhere(group))?]);
            }
            // `group.name = ...` at the top of the file: what stands so cannot have a header too.
            Some(last) if own_keys(last) => {
                let at = last.lines.end;
                self.insert(at, &format!("{group}.{name} = {inline}{comment}\n"));
            }
            Some(last) => {
                let at = last.lines.end;
                let after = if at == self.text.len() || is_blank_line(&self.text[at..]) { "" } else { "\n" };
                self.insert(at, &format!("\n{block}{after}"));
            }
        }
        Ok(())
    }

    /// Where a group begins of which there is none: before the first one that comes after it in the usual order.
    fn place_of(&self, scanned: &Scanned, group: &str) -> usize {
        let order = |one: &Statement| {
            ORDER.iter().position(|known| one.path.first().is_some_and(|first| first == known)).unwrap_or(ORDER.len())
        };
        let own = ORDER.iter().position(|known| *known == group).unwrap_or(ORDER.len());
        let later = scanned.statements.iter().find(|one| one.value.is_none() && order(one) > own);
        later.map_or(self.text.len(), |one| above_comments(&self.text, one.lines.start))
    }

    /// Adds an entry to a table, which is made where it is not there.
    ///
    /// # Errors
    /// The text is not TOML; the table is written in a way in which nothing can be added.
    pub fn add_entry(&mut self, table: &[&str], key: &str, value: &str) -> Result<(), Refusal> {
        let scanned = self.scanned()?;
        let is_table = |path: &[String]| path.iter().map(String::as_str).eq(table.iter().copied());
        let header = scanned.statements.iter().position(|one| one.value.is_none() && is_table(&one.path));
        if let Some(header) = header {
            let own = scanned.statements[header + 1..].iter().take_while(|one| one.value.is_some());
            let last = own.last();
            let at = last.unwrap_or(&scanned.statements[header]).lines.end;
            let indent = last.map_or("", |one| indent(&self.text, one));
            self.insert(at, &format!("{indent}{key} = {value}\n"));
            return Ok(());
        }
        let path: Vec<String> = table.iter().map(|step| (*step).to_owned()).collect();
        if let Some(braces) = scanned.value_at(&path) {
            let piece = into_braces(braces, key, value).ok_or_else(|| elsewhere(&table.join(".")))?;
            self.replace(vec![piece]);
            return Ok(());
        }
        // `points.pin = ...` below the header of the body.
        let dotted = scanned.statements.iter().rfind(|one| {
            one.value.is_some() && one.path.len() == table.len() + 1 && is_table(&one.path[..table.len()])
        });
        if let Some(one) = dotted {
            let before = one.keys.len().checked_sub(2).and_then(|last| one.keys.get(last));
            let before = before.zip(one.keys.first()).ok_or_else(|| elsewhere(&table.join(".")))?;
            let prefix = &self.text[before.1.span.start..before.0.span.end];
            let line = format!("{}{prefix}.{key} = {value}\n", indent(&self.text, one));
            self.insert(one.lines.end, &line);
            return Ok(());
        }
        match table {
            [first] => {
                let at = self.place_of(&scanned, first);
                let is_end = at == self.text.len();
                let (before, after) = if is_end { ("\n", "") } else { ("", "\n") };
                self.insert(at, &format!("{before}[{first}]\n{key} = {value}\n{after}"));
                Ok(())
            }
            [group @ "body", name] if !scanned.statements.iter().any(|one| starts_with(&one.path, table)) => {
                self.add_table(group, name, "", &[(key, value.to_owned())])
            }
            [parent @ .., last] if !parent.is_empty() => {
                self.add_entry(parent, last, &format!("{{ {key} = {value} }}"))
            }
            _ => Err(elsewhere(&table.join("."))),
        }
    }

    /// Takes out everything that stands under some paths. Comments on lines of their own outside of it stay.
    ///
    /// # Errors
    /// The text is not TOML.
    pub fn remove(&mut self, paths: &[Vec<String>]) -> Result<(), Refusal> {
        let scanned = self.scanned()?;
        let stems = Stems::of(paths);
        let which = |path: &[String]| stems.first_of(path);
        let goes = |path: &[String]| which(path).is_some();
        let mut pieces: Vec<Piece> = Vec::new();
        let mut first: Option<usize> = None;
        for (index, statement) in scanned.statements.iter().enumerate() {
            if let Some(gone) = which(&statement.path) {
                let start = *first.get_or_insert(statement.lines.start);
                // A comment between two things that go belongs to neither.
                let next = scanned.statements.get(index + 1).and_then(|next| which(&next.path));
                if next != Some(gone) {
                    pieces.push((self.without_gap(start..statement.lines.end), String::new()));
                    first = None;
                }
            } else if let Some(value) = &statement.value {
                cut(&self.text, &mut statement.path.clone(), value, &goes, &mut pieces);
            }
        }
        self.replace(pieces);
        Ok(())
    }

    /// Lines with the blank ones before them, where blank ones or the end follow.
    fn without_gap(&self, lines: Range<usize>) -> Range<usize> {
        let before = self.text[..lines.start].trim_end_matches([' ', '\t', '\r', '\n']).len();
        let gap = self.text[before..lines.start].find('\n').map_or(lines.start, |end| before + end + 1);
        let is_gap_after = lines.end == self.text.len() || is_blank_line(&self.text[lines.end..]);
        if before == 0 && is_gap_after {
            // At the beginning, the blank line behind it goes.
            let end = self.text[lines.end..].find('\n').map_or(self.text.len(), |end| lines.end + end + 1);
            return lines.start..end;
        }
        if is_gap_after { gap.min(lines.start)..lines.end } else { lines }
    }
}

/// Paths by which others are found that begin with one of them, however many they are.
pub struct Stems<'p> {
    /// Each with its place in the list.
    paths: BTreeMap<&'p [String], usize>,
    longest: usize,
}

impl<'p> Stems<'p> {
    /// Some paths.
    pub fn of(paths: &'p [Vec<String>]) -> Self {
        let mut found = BTreeMap::new();
        for (place, path) in paths.iter().enumerate() {
            found.entry(path.as_slice()).or_insert(place);
        }
        let longest = paths.iter().map(Vec::len).max().unwrap_or(0);
        Self { paths: found, longest }
    }

    /// Place of the first one with which `path` begins.
    pub fn first_of(&self, path: &[String]) -> Option<usize> {
        (0..=path.len().min(self.longest)).filter_map(|steps| self.paths.get(&path[..steps]).copied()).min()
    }
}

fn elsewhere(what: &str) -> Refusal {
    Refusal::bad(format!("'{what}' is written in a way in which nothing can be added to it here"))
        .with_hint("change it in the text")
}

/// Whether a path begins with these steps.
pub fn starts_with(path: &[String], steps: &[&str]) -> bool {
    path.len() >= steps.len() && path.iter().zip(steps).all(|(one, other)| one == other)
}

fn is_blank_line(text: &str) -> bool {
    text.split('\n').next().is_some_and(|line| line.trim().is_empty()) && !text.is_empty()
}

fn indent<'t>(text: &'t str, statement: &Statement) -> &'t str {
    let line = &text[statement.lines.clone()];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}

/// Above the lines of comments that stand directly above a line.
fn above_comments(text: &str, mut start: usize) -> usize {
    while let Some(before) = text[..start].strip_suffix('\n') {
        let line = before.rfind('\n').map_or(0, |end| end + 1);
        if !before[line..].trim_start().starts_with('#') {
            break;
        }
        start = line;
    }
    start
}

/// An entry more in a table in braces.
fn into_braces(braces: &Value, key: &str, value: &str) -> Option<Piece> {
    let ValueKind::Table(items) = &braces.kind else { return None };
    Some(match items.last() {
        Some(last) => (last.value.span.end..last.value.span.end, format!(", {key} = {value}")),
        None => (braces.span.clone(), format!("{{ {key} = {value} }}")),
    })
}

/// Cuts out of a value what goes.
fn cut(text: &str, path: &mut Vec<String>, value: &Value, goes: &impl Fn(&[String]) -> bool, pieces: &mut Vec<Piece>) {
    let (spans, steps, values): (Vec<Range<usize>>, Vec<Vec<String>>, Vec<&Value>) = match &value.kind {
        ValueKind::Table(items) => {
            let steps = |item: &Item| item.keys.iter().map(|key| key.name.clone()).collect();
            (
                items.iter().map(Item::span).collect(),
                items.iter().map(steps).collect(),
                items.iter().map(|item| &item.value).collect(),
            )
        }
        ValueKind::List(values) => (
            values.iter().map(|value| value.span.clone()).collect(),
            (0..values.len()).map(|index| vec![element(index)]).collect(),
            values.iter().collect(),
        ),
        ValueKind::Text(_) | ValueKind::Other => return,
    };
    let mut is_gone = Vec::new();
    for (steps, value) in steps.iter().zip(&values) {
        let before = path.len();
        path.extend(steps.iter().cloned());
        is_gone.push(goes(path));
        if !goes(path) {
            cut(text, path, value, goes, pieces);
        }
        path.truncate(before);
    }
    let mut last_kept: Option<usize> = None;
    for (index, span) in spans.iter().enumerate() {
        if !is_gone[index] {
            last_kept = Some(index);
            continue;
        }
        let next = spans.get(index + 1).map(|next| next.start);
        match (next, last_kept) {
            // Up to the next one; a comment between them stays.
            (Some(next), _) => {
                let comma = comma_after(text, span.end, next).unwrap_or(span.end);
                let end = comma + (text[comma..next].len() - text[comma..next].trim_start_matches([' ', '\t']).len());
                pieces.push((span.start..end, String::new()));
            }
            (None, Some(kept)) => {
                // With the comma before it; what stood between goes already.
                let from = comma_after(text, spans[kept].end, span.start).map_or(spans[kept].end, |comma| comma - 1);
                let gone_between = kept + 1 < index;
                if gone_between {
                    pieces.retain(|(range, _)| range.start < from || range.start > span.start);
                }
                pieces.push((from..span.end, String::new()));
            }
            (None, None) => {
                let comma = comma_after(text, span.end, value.span.end).unwrap_or(span.end);
                pieces.push((span.start..comma, String::new()));
            }
        }
    }
}

/// Behind the comma that follows a value, where one does before `limit`.
fn comma_after(text: &str, from: usize, limit: usize) -> Option<usize> {
    let mut at = from;
    while at < limit {
        match text[at..].chars().next()? {
            ',' => return Some(at + 1),
            '#' => at += text[at..].find('\n')?,
            letter if letter.is_whitespace() => at += letter.len_utf8(),
            _ => return None,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn removed(text: &str, path: &str) -> String {
        let mut lines = Lines::new(text);
        lines.remove(&[path.split('/').map(str::to_owned).collect()]).unwrap();
        assert!(lines.scanned().is_ok(), "{text}\n{}", lines.text());
        lines.text().to_owned()
    }

    #[test]
    fn what_goes_takes_its_lines_and_nothing_else() {
        let text = "# top\n[a.x]  # one\nk = 1\n# inside\n[a.x.points]\np = 2\n\n# of y\n[a.y]\nk = 3\n";
        assert_eq!(removed(text, "a/x"), "# top\n\n# of y\n[a.y]\nk = 3\n");
        assert_eq!(removed(text, "a/y"), "# top\n[a.x]  # one\nk = 1\n# inside\n[a.x.points]\np = 2\n\n# of y\n");
        let braces = "t = { a = 1, b = 2, c = 3 }  # all\n";
        assert_eq!(removed(braces, "t/a"), "t = { b = 2, c = 3 }  # all\n");
        assert_eq!(removed(braces, "t/b"), "t = { a = 1, c = 3 }  # all\n");
        assert_eq!(removed(braces, "t/c"), "t = { a = 1, b = 2 }  # all\n");
        assert_eq!(removed("t = { a = 1 }\n", "t/a"), "t = {  }\n");
        assert_eq!(
            removed("l = [\n  { x = 1 }, # one\n  { x = 2 }, # two\n]\n", "l/#1"),
            "l = [\n  { x = 1 }, # two\n]\n"
        );
        assert_eq!(removed("[[q]]\na = 1\n\n[[q]]\na = 2\n\n[[q]]\na = 3\n", "q/#1"), "[[q]]\na = 1\n\n[[q]]\na = 3\n");
    }

    #[test]
    fn several_go_from_one_list() {
        for (first, second) in [("#0", "#1"), ("#0", "#2"), ("#1", "#2"), ("#1", "#3"), ("#2", "#3")] {
            let mut lines = Lines::new("l = [10, 11, 12, 13]");
            let path = |step: &str| vec!["l".to_owned(), step.to_owned()];
            lines.remove(&[path(first), path(second)]).unwrap();
            let scanned = lines.scanned().unwrap_or_else(|_| panic!("{}", lines.text()));
            let Some(Value { kind: ValueKind::List(left), .. }) = &scanned.statements[0].value else {
                panic!("a list")
            };
            let left: Vec<&str> = left.iter().map(|value| &lines.text()[value.span.clone()]).collect();
            let due: Vec<String> = (0..4)
                .filter(|n| ![first, second].contains(&element(*n).as_str()))
                .map(|n| (10 + n).to_string())
                .collect();
            assert_eq!(left, due);
        }
    }

    fn with_entry(text: &str, table: &str) -> String {
        let mut lines = Lines::new(text);
        lines.add_entry(&table.split('/').collect::<Vec<_>>(), "new", "1").unwrap();
        assert!(lines.scanned().is_ok(), "{text}\n{}", lines.text());
        lines.text().to_owned()
    }

    #[test]
    fn an_entry_comes_to_where_its_table_is() {
        for (text, due) in [
            ("[body.a]\n  k = 1 # c\n# d\n[x]\n", "[body.a]\n  k = 1 # c\n  new = 1\n# d\n[x]\n"),
            ("[body]\na = { k = 1 } # c\n", "[body]\na = { k = 1, new = 1 } # c\n"),
            ("[body]\na = {}", "[body]\na = { new = 1 }"),
            ("[body]\na.k = 1\n", "[body]\na.k = 1\na.new = 1\n"),
            ("body.a.k = 1\r\n", "body.a.k = 1\r\nbody.a.new = 1\r\n"),
            ("body = { a = { k = 1 } }\n", "body = { a = { k = 1, new = 1 } }\n"),
            ("[body.b]\nk = 1", "[body.b]\nk = 1\n\n[body.a]\nnew = 1\n"),
            ("n = 1\n", "n = 1\n\n[body.a]\nnew = 1\n"),
            ("n = 1\n\n# the joints\n[joint.j]\n", "n = 1\n\n[body.a]\nnew = 1\n\n# the joints\n[joint.j]\n"),
        ] {
            assert_eq!(with_entry(text, "body/a"), due, "{text}");
        }
        assert_eq!(with_entry("[body.a]\nk = 1\n", "body/a/points"), "[body.a]\nk = 1\npoints = { new = 1 }\n");
        assert_eq!(with_entry("[output.o]\n", "assembly/guess"), "[assembly]\nguess = { new = 1 }\n\n[output.o]\n");
    }
}
