//! Errors of a table of measured values.

use thiserror::Error;

use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::units::{Dimension, ExpressionProblem};

/// An error in a table of measured values.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeasuredProblem {
    /// No header, or no row below it.
    #[error("the table has no {what}")]
    Empty {
        /// The missing column.
        what: &'static str,
    },
    /// A cell of the header without a unit.
    #[error("the header '{text}' is not written name [unit]")]
    NoUnit {
        /// The cell.
        text: String,
    },
    /// A unit that cannot be read.
    #[error("{error}")]
    Unit {
        /// Why.
        error: ExpressionProblem,
    },
    /// A first column that is no time and no angle.
    #[error("the first column '{name}' is {found}; it must be a time or an angle of the drive")]
    FirstColumn {
        /// Its name.
        name: String,
        /// Its dimension.
        found: Dimension,
    },
    /// Nothing beside the first column.
    #[error("the table has no column beside '{name}'")]
    NothingMeasured {
        /// Name of the first column.
        name: String,
    },
    /// Two columns of the same name.
    #[error("the column '{name}' is there twice")]
    ColumnTwice {
        /// The name.
        name: String,
    },
    /// A column without values.
    #[error("the column '{name}' has no value")]
    NoValue {
        /// Its name.
        name: String,
    },
    /// Several columns, and none of them named.
    #[error("the table has {} columns; the study names none of them", known.len())]
    WhichColumn {
        /// Their names.
        known: Vec<String>,
    },
    /// A column that is not there.
    #[error("the table has no column '{name}'")]
    NoColumn {
        /// The name.
        name: String,
        /// The nearest column.
        nearest: Option<String>,
        /// All columns.
        known: Vec<String>,
    },
    /// A row of another length.
    #[error("the row has {found} cells; the header has {due}")]
    RowLength {
        /// Cells of the row.
        found: usize,
        /// Cells of the header.
        due: usize,
    },
    /// A line of comment.
    #[error("a table has no lines of comment")]
    Comment,
    /// A cell that is no finite number.
    #[error("'{text}' is no finite number")]
    NotANumber {
        /// The cell.
        text: String,
    },
    /// A row that does not lie behind the one before.
    #[error("{name} {found} stands behind {before}; the rows must go upwards")]
    NotIncreasing {
        /// Name of the first column.
        name: String,
        /// Its value, as written.
        found: String,
        /// The value before, as written.
        before: String,
    },
    /// A column that is no output of the model.
    #[error("the model has no output '{name}'")]
    UnknownOutput {
        /// The name.
        name: String,
        /// The nearest output.
        nearest: Option<String>,
        /// All outputs.
        known: Vec<String>,
    },
    /// A column of another dimension than its output.
    #[error("the column '{name}' is {found}; the output is {due}")]
    OtherDimension {
        /// The name.
        name: String,
        /// Dimension of the column.
        found: Dimension,
        /// Dimension of the output.
        due: String,
    },
    /// A row outside what was recorded.
    #[error("{name} {found} lies outside what was recorded, {from} to {to}")]
    OutsideRecord {
        /// Name of the first column.
        name: String,
        /// The value with its unit.
        found: String,
        /// Where the record begins.
        from: String,
        /// Where it ends.
        to: String,
    },
    /// A file that is no table.
    #[error("the file cannot be read as a table: {reason}")]
    NoTable {
        /// Why.
        reason: String,
    },
}

impl Problem for MeasuredProblem {
    fn code(&self) -> Code {
        match self {
            Self::Unit { error } => error.code(),
            Self::OutsideRecord { .. } => Code::MeasuredOutside,
            _ => Code::MeasuredTable,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Empty { .. } | Self::NothingMeasured { .. } => {
                Some("for example a first line: angle [deg], slider [mm]".to_owned())
            }
            Self::NoUnit { text } | Self::NotANumber { text } if text.starts_with('#') => {
                Some("a table has no lines of comment: take the # away, or leave the line out".to_owned())
            }
            Self::NoUnit { text } if text.contains(';') => Some("columns are separated by commas".to_owned()),
            Self::NoUnit { .. } => Some("for example: angle [deg], slider [mm]; a pure number has [1]".to_owned()),
            Self::Unit { error } => error.hint(),
            Self::NoColumn { nearest: Some(nearest), .. } | Self::UnknownOutput { nearest: Some(nearest), .. } => {
                Some(format!("did you mean '{nearest}'?"))
            }
            Self::UnknownOutput { known, .. } | Self::NoColumn { known, .. } => {
                Some(format!("there is {}", known.join(", ")))
            }
            Self::WhichColumn { known } => {
                let first = known.first().map_or("name", String::as_str);
                Some(format!("name it, for example column = \"{first}\"; there is {}", known.join(", ")))
            }
            Self::OutsideRecord { .. } => Some("record more turns with --turns, or cut the table".to_owned()),
            Self::Comment => Some("leave the line out".to_owned()),
            Self::RowLength { found, due } if found > due => {
                Some("a comma separates columns; decimal numbers have a point".to_owned())
            }
            Self::NotANumber { text } if text.contains('\u{2212}') => {
                Some("the minus sign of numbers is the hyphen of the keyboard".to_owned())
            }
            Self::NotANumber { text } if text.contains(',') => Some("decimal numbers have a point".to_owned()),
            Self::NotANumber { .. } => Some("leave a cell empty where nothing was measured".to_owned()),
            _ => None,
        }
    }
}
