//! Lines and entries that come into a text. All else keeps its bytes.

use std::ops::Range;

use super::pieces::{Replacement, Replacements};
use super::scan::{Scanned, Statement, Value, ValueKind, scan};
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
pub struct EditedText {
    text: String,
}

impl EditedText {
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
                .with_hint("correct its problems first; they are listed below the drawing")
        })
    }

    /// Puts pieces in place. New lines end as those of the text do.
    ///
    /// # Errors
    /// Two of them would stand at the same place.
    pub fn replace(&mut self, pieces: impl IntoIterator<Item = Replacement>) -> Result<(), Refusal> {
        let mut all = Replacements::new(&self.text);
        for (range, new) in pieces {
            all.replace(range, &new)?;
        }
        if let Some(new) = all.text() {
            self.text = new;
        }
        Ok(())
    }

    /// Span of the value of an entry.
    ///
    /// # Errors
    /// The text is not TOML.
    pub fn value_span(&self, path: &[&str]) -> Result<Option<Range<usize>>, Refusal> {
        Ok(self.scanned()?.value_at(&owned(path)).map(|value| value.span.clone()))
    }

    /// Puts lines where a line begins, or behind the last one.
    ///
    /// # Errors
    /// As [`EditedText::replace`].
    pub fn insert(&mut self, at: usize, new: &str) -> Result<(), Refusal> {
        let before = if at == 0 || self.text[..at].ends_with('\n') { "" } else { "\n" };
        self.replace([(at..at, format!("{before}{new}"))])
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
                self.insert(at, &format!("{before}{block}{after}"))
            }
            // `group = { ... }` at the top of the file.
            Some(last) if own_keys(last) && last.path.len() == 1 => {
                let piece = last.value.as_ref().and_then(|value| into_braces(value, name, &inline));
                self.replace([piece.ok_or_else(|| elsewhere(group))?])
            }
            // `group.name = ...` at the top of the file: what stands so cannot have a header too.
            Some(last) if own_keys(last) => {
                let at = last.lines.end;
                self.insert(at, &format!("{group}.{name} = {inline}{comment}\n"))
            }
            Some(last) => {
                let at = last.lines.end;
                let after = if at == self.text.len() || is_blank_line(&self.text[at..]) { "" } else { "\n" };
                self.insert(at, &format!("\n{block}{after}"))
            }
        }
    }

    /// Place for a group that does not exist yet: before the first one that follows it in the usual order. What a study knows of numbers
    /// comes before what it asks.
    fn place_of(&self, scanned: &Scanned, group: &str) -> usize {
        let order = |one: &Statement| {
            ORDER.iter().position(|known| one.path.first().is_some_and(|first| first == known)).unwrap_or(ORDER.len())
        };
        let own = ORDER.iter().position(|known| *known == group).unwrap_or(ORDER.len());
        let is_later = |one: &Statement| match group {
            "random" | "epistemic" => starts_with(&one.path, &["ask"]),
            _ => order(one) > own,
        };
        let later = scanned.statements.iter().find(|one| one.value.is_none() && is_later(one));
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
            return self.insert(at, &format!("{indent}{key} = {value}\n"));
        }
        if let Some(braces) = scanned.value_at(&owned(table)) {
            let piece = into_braces(braces, key, value).ok_or_else(|| elsewhere(&table.join(".")))?;
            return self.replace([piece]);
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
            return self.insert(one.lines.end, &line);
        }
        match table {
            [first] => {
                let at = self.place_of(&scanned, first);
                let is_end = at == self.text.len();
                let (before, after) = if is_end { ("\n", "") } else { ("", "\n") };
                self.insert(at, &format!("{before}[{first}]\n{key} = {value}\n{after}"))
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
}

fn elsewhere(what: &str) -> Refusal {
    Refusal::bad(format!("nothing can be added to '{what}' here, because of the way it is written"))
        .with_hint("change it in the text")
}

/// A path as [`Statement`] has it.
pub fn owned(path: &[&str]) -> Vec<String> {
    path.iter().map(|step| (*step).to_owned()).collect()
}

/// Whether a path begins with these steps.
fn starts_with(path: &[String], steps: &[&str]) -> bool {
    path.len() >= steps.len() && path.iter().zip(steps).all(|(one, other)| one == other)
}

/// Whether a text begins with a line in which nothing stands.
pub fn is_blank_line(text: &str) -> bool {
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
fn into_braces(braces: &Value, key: &str, value: &str) -> Option<Replacement> {
    let ValueKind::Table(items) = &braces.kind else { return None };
    Some(match items.last() {
        Some(last) => (last.value.span.end..last.value.span.end, format!(", {key} = {value}")),
        None => (braces.span.clone(), format!("{{ {key} = {value} }}")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_entry(text: &str, table: &str) -> String {
        let mut lines = EditedText::new(text);
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
