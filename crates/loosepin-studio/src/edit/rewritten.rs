//! A text with pieces that are replaced.

use std::ops::Range;

use loosepin::diagnostics::Source;

use crate::messages::{Change, Document};

/// A text and what is to be replaced in it.
pub struct Rewritten<'a> {
    old: &'a Source,
    /// Its lines end by two characters.
    is_dos: bool,
    /// Bytes that go, and what comes in their place; in the order of the text.
    pieces: Vec<(Range<usize>, String)>,
}

impl<'a> Rewritten<'a> {
    /// The text as it is.
    pub fn new(old: &'a Source) -> Self {
        Self { old, is_dos: old.text().contains("\r\n"), pieces: Vec::new() }
    }

    /// Puts `new` in place of some bytes, which no other piece has. Its lines end as those of the text do.
    pub fn replace(&mut self, range: Range<usize>, new: String) {
        let new = if self.is_dos { new.replace('\n', "\r\n") } else { new };
        if self.old.text()[range.clone()] != new {
            // Insertions at one place stay in the order in which they were made.
            let place = self.pieces.partition_point(|(known, _)| known.start <= range.start);
            self.pieces.insert(place, (range, new));
        }
    }

    /// Whether anything is replaced.
    pub fn is_changed(&self) -> bool {
        !self.pieces.is_empty()
    }

    /// The new text; nothing where it is the old one.
    pub fn text(&self) -> Option<String> {
        let old = self.old.text();
        let mut new = String::with_capacity(old.len());
        let mut from = 0;
        for (range, piece) in &self.pieces {
            new.push_str(&old[from..range.start]);
            new.push_str(piece);
            from = range.end;
        }
        new.push_str(&old[from..]);
        self.is_changed().then_some(new)
    }

    /// The pieces as the page counts them.
    pub fn changes(&self, document: Document) -> Vec<Change> {
        let units = |byte: usize| self.old.utf16_units(byte);
        let change = |(range, insert): &(Range<usize>, String)| Change {
            document,
            from: units(range.start),
            to: units(range.end),
            insert: insert.clone(),
        };
        self.pieces.iter().map(change).collect()
    }
}

/// A text with the changes that belong to it, which are counted in UTF-16 units.
pub fn applied(text: &str, changes: &[Change], document: Document) -> String {
    let mut own: Vec<&Change> = changes.iter().filter(|change| change.document == document).collect();
    // Insertions at one place stay in their order.
    own.sort_by_key(|change| change.from);
    let units: Vec<u16> = text.encode_utf16().collect();
    let piece = |from: usize, to: usize| String::from_utf16_lossy(units.get(from..to).unwrap_or_default());
    let mut new = String::with_capacity(text.len());
    let mut from = 0;
    for change in own {
        new.push_str(&piece(from, change.from));
        new.push_str(&change.insert);
        from = change.to;
    }
    new.push_str(&piece(from, units.len()));
    new
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_counted_as_browsers_count() {
        let change = |document, from, to, insert: &str| Change { document, from, to, insert: insert.to_owned() };
        // α of mathematics has two units.
        let text = "# 𝛼\na = 1\nb = 2\n";
        let changes = [
            change(Document::Model, 15, 16, "4"),
            change(Document::Study, 0, 1, "x"),
            change(Document::Model, 9, 10, "3"),
            change(Document::Model, 17, 17, "c = 5\n"),
            change(Document::Model, 17, 17, "d = 6\n"),
        ];
        assert_eq!(applied(text, &changes, Document::Model), "# 𝛼\na = 3\nb = 4\nc = 5\nd = 6\n");
        assert_eq!(applied(text, &[], Document::Model), text);
    }
}
