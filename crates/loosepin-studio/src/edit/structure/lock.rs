//! Numbers that dragging does not change: their line ends with the comment `# locked`.
//!
//! A lock is a note in the model for people and for the studio; runs do not look at it. All numbers of one line are locked together.

use std::ops::Range;

use crate::edit::toml::lines::EditedText;
use crate::edit::toml::scan::{Scanned, Statement, scan};
use crate::network::refusal::Refusal;

const LOCKED: &str = "locked";
const LOCKED_AND: &str = "locked:";

/// The lines of a text that are locked, in bytes and in the order of the text.
pub struct Locks(Vec<Range<usize>>);

impl Locks {
    /// The locked lines of a text; none if it is not TOML.
    pub fn of(text: &str) -> Self {
        // Most texts have none, and are looked at often.
        if !text.contains(LOCKED) {
            return Self(Vec::new());
        }
        let statements = scan(text).map(|scanned| scanned.statements).unwrap_or_default();
        Self(statements.iter().filter(|one| note(text, one).is_some()).map(|one| one.lines.clone()).collect())
    }

    /// Whether a byte stands in a locked line.
    pub fn hold(&self, byte: usize) -> bool {
        let next = self.0.partition_point(|lines| lines.start <= byte);
        next.checked_sub(1).is_some_and(|last| self.0[last].contains(&byte))
    }
}

/// The note at the end of the lines of an entry: from the mark of the comment to the end of the line.
fn note(text: &str, statement: &Statement) -> Option<Range<usize>> {
    let value = statement.value.as_ref()?;
    let comment = comment(text, statement, value.span.end)?;
    let words = text[comment.clone()].trim_start_matches('#').trim();
    (words == LOCKED || words.starts_with(LOCKED_AND)).then_some(comment)
}

/// The comment behind a value, without the end of the line.
fn comment(text: &str, statement: &Statement, from: usize) -> Option<Range<usize>> {
    let rest = text.get(from..statement.lines.end)?;
    let start = from + rest.find('#')?;
    Some(start..from + rest.trim_end().len())
}

/// Locks the line in which a byte stands, or unlocks it. Both after each other give the first bytes.
///
/// # Errors
/// There is no entry at this place.
pub fn locked(lines: &EditedText, byte: usize, is_locked: bool) -> Result<EditedText, Refusal> {
    let scanned: Scanned = lines.scanned()?;
    let text = lines.text();
    let statement = scanned.statements.iter().find(|one| one.lines.contains(&byte));
    let found = statement.and_then(|one| one.value.as_ref().map(|value| (one, value.span.end)));
    let (statement, end) = found.ok_or_else(|| Refusal::bad("this number is not on its own line"))?;
    let note = note(text, statement);
    let mut new = lines.clone();
    match (note, is_locked) {
        (Some(_), true) | (None, false) => {}
        (None, true) => {
            let piece = match comment(text, statement, end) {
                None => (end..end, format!("  # {LOCKED}")),
                Some(comment) => {
                    let words = text[comment.clone()].trim_start_matches(['#', ' ', '\t']);
                    let at = comment.end - words.len();
                    (at..at, format!("{LOCKED_AND} "))
                }
            };
            new.replace([piece])?;
        }
        (Some(comment), false) => {
            let words = text[comment.clone()].trim_start_matches(['#', ' ', '\t']);
            let from = comment.end - words.len();
            let piece = if words == LOCKED {
                end..comment.end
            } else if words == LOCKED_AND {
                // Nothing else stands in the comment; the space behind it came with it.
                let behind = if text[comment.end..].starts_with(' ') { 1 } else { 0 };
                from..comment.end + behind
            } else {
                let rest = words.strip_prefix(LOCKED_AND).unwrap_or(words);
                from..comment.end - rest.strip_prefix(' ').unwrap_or(rest).len()
            };
            new.replace([(piece, String::new())])?;
        }
    }
    Ok(new)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_a_comment_and_goes_without_a_trace() {
        for (text, locked_text) in [
            ("a = \"1 mm\"\n", "a = \"1 mm\"  # locked\n"),
            ("a = \"1 # mm\"", "a = \"1 # mm\"  # locked"),
            ("a = 1   # top dead centre\r\n", "a = 1   # locked: top dead centre\r\n"),
            ("a = 1  \r\n", "a = 1  # locked  \r\n"),
            ("a = { b = 1 } #c\n", "a = { b = 1 } #locked: c\n"),
            ("a = [\n 1, # no\n]\n", "a = [\n 1, # no\n]  # locked\n"),
            ("a = 1 #\n", "a = 1 #locked: \n"),
        ] {
            let lines = EditedText::new(text);
            let byte = text.find('1').unwrap();
            let new = locked(&lines, byte, true).unwrap();
            assert_eq!(new.text(), locked_text);
            assert!(Locks::of(new.text()).hold(byte) && !Locks::of(text).hold(byte), "{text}");
            assert_eq!(locked(&new, byte, true).unwrap().text(), locked_text);
            assert_eq!(locked(&new, byte, false).unwrap().text(), text);
        }
        let text = "# locked\nb = 1 # not locked\nc = \"# locked\"\n";
        let locks = Locks::of(text);
        assert!((0..text.len()).all(|byte| !locks.hold(byte)));
    }
}
