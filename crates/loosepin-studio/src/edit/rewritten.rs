//! A text with pieces that are replaced.

use std::ops::Range;

use loosepin::diagnostics::Source;

use crate::messages::{Change, Document};
use crate::places::utf16_units;

/// A text and what is to be replaced in it.
pub struct Rewritten<'a> {
    old: &'a Source,
    /// Bytes that go, and what comes in their place; in the order of the text.
    pieces: Vec<(Range<usize>, String)>,
}

impl<'a> Rewritten<'a> {
    /// The text as it is.
    pub fn new(old: &'a Source) -> Self {
        Self { old, pieces: Vec::new() }
    }

    /// Puts `new` in place of some bytes, which no other piece has. Its lines end as those of the text do.
    pub fn replace(&mut self, range: Range<usize>, new: String) {
        let new = if self.old.text().contains("\r\n") { new.replace('\n', "\r\n") } else { new };
        if self.old.text()[range.clone()] != new {
            self.pieces.push((range, new));
            // Insertions at one place stay in the order in which they were made.
            self.pieces.sort_by_key(|(range, _)| range.start);
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
        let units = |byte: usize| utf16_units(self.old, byte);
        let change = |(range, insert): &(Range<usize>, String)| Change {
            document,
            from: units(range.start),
            to: units(range.end),
            insert: insert.clone(),
        };
        self.pieces.iter().map(change).collect()
    }
}
