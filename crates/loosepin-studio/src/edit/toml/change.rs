//! The change from one text to another, line by line, as the page makes it.

use std::ops::Range;

use loosepin::diagnostics::Source;

use crate::messages::{Change, Document};

/// Lines that are compared with each other, at most; larger changes become one.
const MAX_PAIRS: usize = 1_000_000;

/// The changes from an old text to a new one; lines that both have stay unchanged.
pub fn changes(document: Document, old: &Source, new: &str) -> Vec<Change> {
    let before: Vec<&str> = old.text().split_inclusive('\n').collect();
    let after: Vec<&str> = new.split_inclusive('\n').collect();
    let mut starts = vec![0];
    starts.extend(before.iter().scan(0, |end, line| {
        *end += line.len();
        Some(*end)
    }));
    let units = |line: usize| old.utf16_units(starts[line]);
    let change = |old_lines: Range<usize>, new_lines: Range<usize>| Change {
        document,
        from: units(old_lines.start),
        to: units(old_lines.end),
        insert: after[new_lines].concat(),
    };
    differing(&before, &after).into_iter().map(|(old, new)| change(old, new)).collect()
}

/// Stretches of lines that differ: those of the old text and those in their place.
fn differing(before: &[&str], after: &[&str]) -> Vec<(Range<usize>, Range<usize>)> {
    let head = before.iter().zip(after).take_while(|(old, new)| old == new).count();
    let (old, new) = (&before[head..], &after[head..]);
    let tail = old.iter().rev().zip(new.iter().rev()).take_while(|(old, new)| old == new).count();
    let (old, new) = (&old[..old.len() - tail], &new[..new.len() - tail]);
    if old.is_empty() && new.is_empty() {
        return Vec::new();
    }
    if old.len().saturating_mul(new.len()) > MAX_PAIRS {
        return vec![(head..head + old.len(), head..head + new.len())];
    }
    // The longest list of lines that both have in this order: from each pair of places on.
    let width = new.len() + 1;
    let mut common = vec![0_u32; (old.len() + 1) * width];
    for row in (0..old.len()).rev() {
        for column in (0..new.len()).rev() {
            common[row * width + column] = if old[row] == new[column] {
                common[(row + 1) * width + column + 1] + 1
            } else {
                common[(row + 1) * width + column].max(common[row * width + column + 1])
            };
        }
    }
    let mut found: Vec<(Range<usize>, Range<usize>)> = Vec::new();
    let (mut row, mut column) = (0, 0);
    while row < old.len() || column < new.len() {
        let (from_row, from_column) = (row, column);
        while (row < old.len() || column < new.len())
            && !(row < old.len() && column < new.len() && old[row] == new[column])
        {
            let is_taken_out = column == new.len()
                || row < old.len() && common[(row + 1) * width + column] >= common[row * width + column + 1];
            if is_taken_out { row += 1 } else { column += 1 }
        }
        if row > from_row || column > from_column {
            found.push((head + from_row..head + row, head + from_column..head + column));
        }
        while row < old.len() && column < new.len() && old[row] == new[column] {
            row += 1;
            column += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_lines_that_differ_are_changed() {
        let source = Source::new("", "a\nµ\nb\nc\nd");
        let found = changes(Document::Model, &source, "a\nµ\nc\nx\nd\n");
        let found: Vec<(usize, usize, &str)> =
            found.iter().map(|one| (one.from, one.to, one.insert.as_str())).collect();
        assert_eq!(found, [(4, 6, ""), (8, 9, "x\nd\n")]);
        assert_eq!(changes(Document::Model, &source, source.text()), []);
        let long: String = (0..3000).map(|line| format!("{line}\n")).collect();
        let turned: String = (0..3000).rev().map(|line| format!("{line}\n")).collect();
        assert_eq!(changes(Document::Model, &Source::new("", long.clone()), &turned).len(), 1);
    }
}
