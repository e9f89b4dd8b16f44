//! What can be wrong with a reference case.

use thiserror::Error;

use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::document::listed;

/// What can be wrong with a reference case. `entry` is a path in words.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum CaseProblem {
    /// A folder without cases.
    #[error("{folder} holds no reference case: no folder with a model.toml and an expected.toml")]
    NoCases {
        /// The folder.
        folder: String,
    },
    /// A page that cannot be written.
    #[error("cannot write {file}: {reason}")]
    NotWritten {
        /// The file.
        file: String,
        /// What the operating system says.
        reason: String,
    },
    /// A case that is not there.
    #[error("there is no reference case '{name}'")]
    UnknownCase {
        /// The name.
        name: String,
        /// The nearest case.
        nearest: Option<String>,
        /// All cases.
        known: Vec<String>,
    },
    /// A name that the model or a file does not have.
    #[error("{entry}: there is no {what} '{name}'")]
    UnknownName {
        /// The entry.
        entry: String,
        /// What is called so.
        what: &'static str,
        /// The name.
        name: String,
        /// All that there are.
        known: Vec<String>,
    },
    /// A key that the quantity does not use.
    #[error("{entry} has no effect on the quantity \"{quantity}\"")]
    KeyWithoutEffect {
        /// The entry.
        entry: String,
        /// The quantity.
        quantity: &'static str,
    },
    /// A list of another length than that of the values.
    #[error("{entry} has {found} entries; expected one for each of the {due} values")]
    ListLength {
        /// The entry.
        entry: String,
        /// How many there are.
        found: usize,
        /// How many should.
        due: usize,
    },
    /// Nothing to compare.
    #[error("{entry} expects nothing; a case without a number to meet would be met by any program")]
    NothingExpected {
        /// The entry, or the file.
        entry: String,
    },
    /// An angle at which the quasi-static answer is not computed.
    #[error("the quasi-static answer has no position at {angle_deg} deg; it has one for each whole degree of a turn")]
    NoPosition {
        /// The angle, degrees.
        angle_deg: String,
    },
    /// A cell of a reference file that is no number.
    #[error("the cell '{cell}' is no number")]
    BadCell {
        /// The cell.
        cell: String,
    },
    /// A row of a reference file with too few or too many cells.
    #[error("the row has {found} cells; the header has {due}")]
    BadRow {
        /// Cells of the row.
        found: usize,
        /// Cells of the header.
        due: usize,
    },
    /// A reference file that no run can be compared with.
    #[error("{file}: {rows} rows that end at {end_s} s; expected at least two, at equal times from zero")]
    BadTimes {
        /// The file.
        file: String,
        /// How many there are.
        rows: usize,
        /// The last time, s.
        end_s: String,
    },
}

impl Problem for CaseProblem {
    fn code(&self) -> Code {
        match self {
            Self::NoCases { .. } => Code::FileNotReadable,
            Self::NotWritten { .. } => Code::FolderNotUsable,
            Self::UnknownCase { .. } | Self::UnknownName { .. } => Code::UnknownReference,
            Self::KeyWithoutEffect { .. } => Code::ConflictingKeys,
            Self::NothingExpected { .. } => Code::AskNotPossible,
            Self::ListLength { .. } | Self::BadCell { .. } | Self::BadRow { .. } | Self::BadTimes { .. } => {
                Code::WrongType
            }
            Self::NoPosition { .. } => Code::AskNotPossible,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::NoCases { .. } => Some("the cases are in the repository; name their folder: --folder DIR".to_owned()),
            Self::UnknownCase { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::UnknownCase { known, .. } => Some(format!("there is {}", listed(known, "and"))),
            Self::UnknownName { what, known, .. } if known.is_empty() => Some(format!("there is no {what} at all")),
            Self::UnknownName { known, .. } => Some(format!("there is {}", listed(known, "and"))),
            _ => None,
        }
    }
}
