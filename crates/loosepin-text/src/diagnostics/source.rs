//! Files under examination and places in them.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::work;

/// Bytes between two positions of a text that are counted once and kept.
const STRIDE_BYTES: usize = 512;

/// The text of a file and the name it is reported by.
#[derive(Debug, Clone)]
pub struct Source {
    name: String,
    text: String,
    /// Files that were given with it, where those that it names are not to be opened.
    files: Option<Arc<[Arc<Source>]>>,
    /// Positions of the text, about [`STRIDE_BYTES`] apart: thousands of diagnostics do not count from the beginning each.
    positions: OnceLock<Vec<Position>>,
}

impl PartialEq for Source {
    fn eq(&self, other: &Source) -> bool {
        (&self.name, &self.text, &self.files) == (&other.name, &other.text, &other.files)
    }
}

impl Eq for Source {}

/// The first byte of a character, and the count of units before it.
#[derive(Debug, Clone, Copy, Default)]
struct Position {
    byte: usize,
    /// Line ends.
    lines: usize,
    /// Characters since the last line end; a byte order mark takes no column.
    columns: usize,
    utf16_units: usize,
}

impl Position {
    fn passed(mut self, character: char) -> Position {
        self.byte += character.len_utf8();
        self.utf16_units += character.len_utf16();
        match character {
            '\n' => {
                self.lines += 1;
                self.columns = 0;
            }
            '\u{feff}' => {}
            _ => self.columns += 1,
        }
        self
    }
}

/// A byte range of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// First byte.
    pub start: usize,
    /// Behind the last byte.
    pub end: usize,
}

impl From<Range<usize>> for Span {
    fn from(range: Range<usize>) -> Span {
        Span { start: range.start, end: range.end.max(range.start) }
    }
}

impl Source {
    /// A text called `name`, usually the path as the person gave it.
    pub fn new(name: impl Into<String>, text: impl Into<String>) -> Arc<Source> {
        Arc::new(Source { name: name.into(), text: text.into(), files: None, positions: OnceLock::new() })
    }

    /// A source with the files that it may name, by their paths: no other is opened.
    pub fn with_files(name: impl Into<String>, text: impl Into<String>, files: Arc<[Arc<Source>]>) -> Arc<Source> {
        Arc::new(Source { name: name.into(), text: text.into(), files: Some(files), positions: OnceLock::new() })
    }

    /// The files that were given with it; `None` if those that it names are opened.
    pub fn files(&self) -> Option<&[Arc<Source>]> {
        self.files.as_deref()
    }

    /// The name it is reported by.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Line and column of a byte, both from 1; columns count characters. A byte beyond the end is the end.
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let position = self.position(byte);
        (position.lines + 1, position.columns + 1)
    }

    /// UTF-16 units before a byte, as browsers count. A byte beyond the end is the end.
    pub fn utf16_units(&self, byte: usize) -> usize {
        self.position(byte).utf16_units
    }

    /// The position of the character that holds a byte.
    fn position(&self, byte: usize) -> Position {
        let byte = byte.min(self.text.len());
        let known = self.positions.get_or_init(|| self.counted());
        let start = known.partition_point(|position| position.byte <= byte).checked_sub(1);
        let mut position = start.map_or(Position::default(), |start| known[start]);
        let known_byte = position.byte;
        for character in self.text[position.byte..].chars() {
            let next = position.passed(character);
            if next.byte > byte {
                break;
            }
            position = next;
        }
        work::add(position.byte - known_byte);
        position
    }

    fn counted(&self) -> Vec<Position> {
        let mut known = Vec::with_capacity(self.text.len() / STRIDE_BYTES + 1);
        let mut position = Position::default();
        work::add(self.text.len());
        for character in self.text.chars() {
            if position.byte >= known.len() * STRIDE_BYTES {
                known.push(position);
            }
            position = position.passed(character);
        }
        known
    }

    /// The span cut to the text and to whole characters, so that it can be indexed.
    pub fn clamp(&self, span: Span) -> Range<usize> {
        let mut start = span.start.min(self.text.len());
        while !self.text.is_char_boundary(start) {
            start -= 1;
        }
        let mut end = span.end.clamp(start, self.text.len());
        while !self.text.is_char_boundary(end) {
            end += 1;
        }
        start..end
    }
}

/// A span of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub source: Arc<Source>,
    /// Span in the file.
    pub span: Span,
}

impl Place {
    /// A span of a file.
    pub fn new(source: &Arc<Source>, span: impl Into<Span>) -> Place {
        Place { source: Arc::clone(source), span: span.into() }
    }

    /// Line and column, both from 1.
    pub fn line_and_column(&self) -> (usize, usize) {
        self.source.line_and_column(self.span.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters() {
        let source = Source::new("x.toml", "\u{feff}a = 1\r\nµ = \"ü\"\n");
        assert_eq!(source.line_and_column(3), (1, 1));
        assert_eq!(source.line_and_column(10), (2, 1));
        assert_eq!(source.line_and_column(source.text().find('ü').expect("ü")), (2, 6));
        assert_eq!(source.line_and_column(9999), (3, 1));
        assert_eq!(source.clamp(Span { start: 11, end: 9999 }), 10..source.text().len());
    }

    #[test]
    fn positions_are_those_counted_from_the_beginning() {
        let text = "\u{feff}a = \"µ𝛼\"\r\n# ünïcödé\n\n".repeat(70) + &"long µ𝛼 ".repeat(300);
        let source = Source::new("x.toml", text.clone());
        assert!(text.len() > 4 * STRIDE_BYTES);
        for (byte, _) in text.char_indices().chain([(text.len(), ' ')]) {
            let before = &text[..byte];
            let line_start = before.rfind('\n').map_or(0, |end| end + 1);
            let column = before[line_start..].chars().filter(|character| *character != '\u{feff}').count() + 1;
            assert_eq!(source.line_and_column(byte), (before.matches('\n').count() + 1, column), "byte {byte}");
            assert_eq!(source.utf16_units(byte), before.encode_utf16().count(), "byte {byte}");
        }
    }
}
