//! Groups of a file of text: a line with the code, a line with the value.

use std::borrow::Cow;
use std::slice::Split;

use super::error::{DxfError, DxfProblem, FilePosition};
use super::group::{Group, Value, ValueType};

/// The byte order mark that some editors write before a text.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// The groups of a file of text. Its lines end as on Windows or as on Unix, its code page is any: bytes that are not UTF-8 come
/// out as replacement characters, in layers and texts that nothing here depends on.
pub(super) struct TextGroups<'a> {
    lines: Split<'a, u8, fn(&u8) -> bool>,
    /// Lines read.
    line: usize,
}

impl<'a> TextGroups<'a> {
    pub fn of(bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
        Self { lines: bytes.split(|byte| *byte == b'\n'), line: 0 }
    }

    /// The line that was read last.
    pub fn place(&self) -> FilePosition {
        FilePosition::Line(self.line)
    }

    pub fn next(&mut self) -> Result<Option<Group<'a>>, DxfError> {
        let Some(code) = self.next_line() else { return Ok(None) };
        if code.is_empty() && self.lines.clone().all(|line| line.trim_ascii().is_empty()) {
            return Ok(None);
        }
        let Ok(code) = code.parse() else {
            return Err(self.place().error(DxfProblem::NotACode { text: code.into_owned() }));
        };
        if ValueType::of(code).is_none() {
            return Err(self.place().error(DxfProblem::UnknownCode { code }));
        }
        let Some(value) = self.next_line() else { return Err(self.place().error(DxfProblem::EndsInGroup)) };
        Ok(Some(Group { code, value: Value::Text(value), place: self.place() }))
    }

    fn next_line(&mut self) -> Option<Cow<'a, str>> {
        let line = self.lines.next()?;
        self.line += 1;
        Some(String::from_utf8_lossy(line.trim_ascii()))
    }
}
