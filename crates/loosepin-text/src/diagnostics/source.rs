//! Files under examination and places in them.

use std::ops::Range;
use std::sync::Arc;

/// The text of a file and the name it is reported by.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    name: String,
    text: String,
    /// Files that were given with it, where those that it names are not to be opened.
    files: Option<Arc<[Arc<Source>]>>,
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
        Arc::new(Source { name: name.into(), text: text.into(), files: None })
    }

    /// A source with the files that it may name, by their paths: no other is opened.
    pub fn with_files(name: impl Into<String>, text: impl Into<String>, files: Arc<[Arc<Source>]>) -> Arc<Source> {
        Arc::new(Source { name: name.into(), text: text.into(), files: Some(files) })
    }

    /// The files that were given with it; nothing where those that it names are opened.
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
        let mut byte = byte.min(self.text.len());
        while !self.text.is_char_boundary(byte) {
            byte -= 1;
        }
        let before = &self.text[..byte];
        let line_start = before.rfind('\n').map_or(0, |index| index + 1);
        let line = before.matches('\n').count() + 1;
        // A byte order mark takes no column.
        let column = before[line_start..].chars().filter(|character| *character != '\u{feff}').count() + 1;
        (line, column)
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
    /// Where in it.
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
}
