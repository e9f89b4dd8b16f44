//! Lines and entries that go out of a text. All else keeps its bytes.

use std::collections::BTreeMap;
use std::ops::Range;

use super::lines::{EditedText, is_blank_line};
use super::pieces::Replacement;
use super::scan::{Item, Value, ValueKind, element};
use crate::network::refusal::Refusal;

impl EditedText {
    /// Takes out everything that stands under some paths. Comments on lines of their own outside of it stay.
    ///
    /// # Errors
    /// The text is not TOML.
    pub fn remove(&mut self, paths: &[Vec<String>]) -> Result<(), Refusal> {
        let scanned = self.scanned()?;
        let stems = PathPrefixes::of(paths);
        let which = |path: &[String]| stems.first_of(path);
        let goes = |path: &[String]| which(path).is_some();
        let mut pieces: Vec<Replacement> = Vec::new();
        let mut first: Option<usize> = None;
        for (index, statement) in scanned.statements.iter().enumerate() {
            if let Some(gone) = which(&statement.path) {
                let start = *first.get_or_insert(statement.lines.start);
                let next =
                    scanned.statements.get(index + 1).and_then(|next| Some((which(&next.path)?, next.lines.start)));
                // A comment between two things that go belongs to neither; blank lines go with both.
                let goes_on = next.is_some_and(|(other, start)| {
                    other == gone || self.text()[statement.lines.end..start].trim().is_empty()
                });
                if !goes_on {
                    pieces.push((self.without_gap(start..statement.lines.end), String::new()));
                    first = None;
                }
            } else if let Some(value) = &statement.value {
                cut(self.text(), &mut statement.path.clone(), value, &goes, &mut pieces);
            }
        }
        self.replace(pieces)
    }

    /// Lines with the blank ones before them, where blank ones or the end follow.
    fn without_gap(&self, lines: Range<usize>) -> Range<usize> {
        let before = self.text()[..lines.start].trim_end_matches([' ', '\t', '\r', '\n']).len();
        let gap = self.text()[before..lines.start].find('\n').map_or(lines.start, |end| before + end + 1);
        let is_gap_after = lines.end == self.text().len() || is_blank_line(&self.text()[lines.end..]);
        if before == 0 && is_gap_after {
            // At the beginning, the blank line behind it goes.
            let end = self.text()[lines.end..].find('\n').map_or(self.text().len(), |end| lines.end + end + 1);
            return lines.start..end;
        }
        if is_gap_after { gap.min(lines.start)..lines.end } else { lines }
    }
}

/// Paths by which others are found that begin with one of them, however many they are.
pub struct PathPrefixes<'p> {
    /// Each with its place in the list.
    paths: BTreeMap<&'p [String], usize>,
    longest: usize,
}

impl<'p> PathPrefixes<'p> {
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

/// Cuts the removed parts out of a value.
fn cut(
    text: &str,
    path: &mut Vec<String>,
    value: &Value,
    goes: &impl Fn(&[String]) -> bool,
    pieces: &mut Vec<Replacement>,
) {
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
        let mut lines = EditedText::new(text);
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
            let mut lines = EditedText::new("l = [10, 11, 12, 13]");
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

    #[test]
    fn blank_lines_between_what_goes_go_once() {
        let both = |text: &str| {
            let mut lines = EditedText::new(text);
            lines.remove(&["a", "b"].map(|name| vec!["joint".to_owned(), name.to_owned()])).unwrap();
            lines.text().to_owned()
        };
        // The blank line belongs to both that go.
        assert_eq!(both("[joint.a]\nk = 1\n\n[joint.b]\nk = 2\n\n[x]\n"), "[x]\n");
        assert_eq!(both("# top\n\n[joint.a]\n\n\n[joint.b]\n\n[x]\n"), "# top\n\n[x]\n");
        assert_eq!(both("[x]\n\n[joint.a]\n\n[joint.b]\n"), "[x]\n");
    }
}
