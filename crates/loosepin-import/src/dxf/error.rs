//! Errors of a DXF file, with their place.

use std::fmt;

use thiserror::Error;

/// Characters of the file that a message shows, at most.
const SHOWN_CHARS: usize = 24;

/// An error in a DXF file, with its place.
#[derive(Debug, Error)]
#[error("{place}: {problem}")]
pub(crate) struct DxfError {
    place: FilePosition,
    problem: DxfProblem,
}

/// A place in a file.
#[derive(Debug, Clone, Copy)]
pub(super) enum FilePosition {
    /// Line of a text, from 1.
    Line(usize),
    /// Byte of a binary file, from 0.
    Byte(usize),
}

impl FilePosition {
    pub fn error(self, problem: DxfProblem) -> DxfError {
        DxfError { place: self, problem }
    }
}

impl fmt::Display for FilePosition {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FilePosition::Line(line) => write!(formatter, "line {line}"),
            FilePosition::Byte(byte) => write!(formatter, "byte {byte}"),
        }
    }
}

/// The error.
#[derive(Debug, Error)]
pub(super) enum DxfProblem {
    #[error("'{}' is not a group code; a group code is a whole number", shown(text))]
    NotACode { text: String },
    #[error("there is no group code {code}")]
    UnknownCode { code: i32 },
    #[error("'{}' is not a number; the value of a group {code} is", shown(text))]
    NotANumber { code: i32, text: String },
    #[error("the file ends within a group")]
    EndsInGroup,
    #[error("the file ends within the section {}", shown(section))]
    EndsInSection { section: String },
    #[error("a group {code} stands outside of every section")]
    NoSection { code: i32 },
    #[error("the section has no name")]
    NamelessSection,
    #[error("a group {code} stands before the first entity")]
    NoEntity { code: i32 },
    #[error("a group {code} stands before the first vertex of its polyline")]
    NoVertex { code: i32 },
}

/// The beginning of a text of the file, which may be anything.
fn shown(text: &str) -> String {
    let mut shown: String = text.chars().take(SHOWN_CHARS).flat_map(char::escape_debug).collect();
    if text.chars().nth(SHOWN_CHARS).is_some() {
        shown.push('…');
    }
    shown
}
