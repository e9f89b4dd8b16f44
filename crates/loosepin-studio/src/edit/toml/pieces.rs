//! A text with pieces that are replaced.

use std::ops::Range;

use loosepin::diagnostics::Source;

use crate::messages::{Change, Document};
use crate::network::refusal::Refusal;

/// Replaced bytes, and their replacement.
pub type Replacement = (Range<usize>, String);

/// Replacements in a text.
pub struct Replacements<'t> {
    old: &'t str,
    /// Its lines end by two characters.
    is_dos: bool,
    /// In the order of the text, without overlaps.
    pieces: Vec<Replacement>,
}

impl<'t> Replacements<'t> {
    /// No replacements.
    pub fn new(old: &'t str) -> Self {
        Self { old, is_dos: old.contains("\r\n"), pieces: Vec::new() }
    }

    /// Puts `new` in place of some bytes. Its lines end as those of the text do. Insertions at one place stay in the order in which they
    /// are made; what several take out goes once.
    ///
    /// # Errors
    /// Something else is to stand there already.
    pub fn replace(&mut self, range: Range<usize>, new: &str) -> Result<(), Refusal> {
        let new = new.replace("\r\n", "\n");
        let new = if self.is_dos { new.replace('\n', "\r\n") } else { new };
        if self.old[range.clone()] == new {
            return Ok(());
        }
        let first = self.pieces.partition_point(|(known, _)| known.end <= range.start);
        let count = self.pieces[first..].partition_point(|(known, _)| known.start < range.end);
        let here = &self.pieces[first..first + count];
        let piece = match here {
            [] => (range, new),
            [known] if *known == (range.clone(), new.clone()) => return Ok(()),
            [one, .., last] | [one @ last] if new.is_empty() && here.iter().all(|(_, known)| known.is_empty()) => {
                (range.start.min(one.0.start)..range.end.max(last.0.end), new)
            }
            _ => {
                return Err(Refusal::bad("two changes would be at the same place in the text")
                    .with_hint("make them one after the other, or in the text"));
            }
        };
        self.pieces.splice(first..first + count, [piece]);
        Ok(())
    }

    /// Whether anything is replaced.
    pub fn is_changed(&self) -> bool {
        !self.pieces.is_empty()
    }

    /// The new text; `None` if it is the old one.
    pub fn text(&self) -> Option<String> {
        let mut new = String::with_capacity(self.old.len());
        let mut from = 0;
        for (range, piece) in &self.pieces {
            new.push_str(&self.old[from..range.start]);
            new.push_str(piece);
            from = range.end;
        }
        new.push_str(&self.old[from..]);
        self.is_changed().then_some(new)
    }

    /// The pieces as the page counts them in `source`, which is the old text.
    pub fn changes(&self, document: Document, source: &Source) -> Vec<Change> {
        let change = |(range, insert): &Replacement| Change {
            document,
            from: source.utf16_units(range.start),
            to: source.utf16_units(range.end),
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

    fn replaced(text: &str, pieces: &[(Range<usize>, &str)]) -> Result<String, String> {
        let mut all = Replacements::new(text);
        for (range, new) in pieces {
            all.replace(range.clone(), new).map_err(|refusal| refusal.message)?;
        }
        Ok(all.text().unwrap_or_else(|| text.to_owned()))
    }

    #[test]
    fn no_change_is_lost_beside_another() {
        let text = "0123456789";
        // What both take out goes once, in whatever order, and whatever stands between; what is said twice is done once.
        for pieces in
            [[(2..5, ""), (4..8, "")], [(4..8, ""), (2..5, "")], [(2..8, ""), (3..4, "")], [(2..8, ""), (2..8, "")]]
        {
            assert_eq!(replaced(text, &pieces).unwrap(), "0189", "{pieces:?}");
        }
        assert_eq!(replaced(text, &[(1..3, ""), (4..5, ""), (7..9, ""), (2..8, "")]).unwrap(), "09");
        assert_eq!(replaced(text, &[(2..4, "x"), (2..4, "x")]).unwrap(), "01x456789");
        // Side by side, and insertions at both ends.
        let beside = [(4..6, "b"), (2..4, "a"), (2..2, "<"), (6..6, ">"), (6..6, "!")];
        assert_eq!(replaced(text, &beside).unwrap(), "01<ab>!6789");
        // Of two that would stand at one place, neither is lost in silence.
        for pieces in [
            [(2..5, "x"), (4..8, "")],
            [(2..5, "x"), (2..5, "y")],
            [(2..5, ""), (3..3, "x")],
            [(3..3, "x"), (2..5, "")],
        ] {
            assert!(replaced(text, &pieces).is_err(), "{pieces:?}");
        }
    }

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
