//! The runs of a study as a table: one row a run, every column with its name and unit.

use loosepin_text::units::SiUnit;
use std::borrow::Cow;

/// One run a row. All columns have the same length; [`crate::files::runs_parquet`] refuses others.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunsTable {
    /// The columns, in the order in which they are written.
    pub columns: Vec<RunColumn>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct RunColumn {
    /// Its name: `index`, the path of an uncertain input, the name of a scalar output, `status`, a counter.
    pub name: String,
    /// Unit of its values; [`SiUnit::NONE`] for counts and text.
    pub unit: SiUnit,
    /// Its values.
    pub data: RunData,
}

/// Values of one column.
#[derive(Debug, Clone, PartialEq)]
pub enum RunData {
    /// Numbers. Not-a-number means that the run has no such value, and is written as a null.
    F64(Vec<f64>),
    /// Counts and indices.
    U64(Vec<u64>),
    /// Words.
    Text(Vec<Cow<'static, str>>),
}

impl RunData {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            RunData::F64(values) => values.len(),
            RunData::U64(values) => values.len(),
            RunData::Text(values) => values.len(),
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether a row may be without a value.
    pub fn is_nullable(&self) -> bool {
        matches!(self, RunData::F64(_))
    }
}

/// An angle as it stands in the names of columns of runs: to 1e-9 rad.
pub fn named_angle_rad(angle_rad: f64) -> f64 {
    (angle_rad * 1e9).round() / 1e9
}
