//! Columns that are learned, and how.

use crate::data::table::SampleTable;
use loosepin_surrogate::Choice;

/// Values of the epistemic inputs at which direct runs are made, at most.
pub const MAX_WITNESSES: usize = 24;

/// Columns that are learned together: a number, or a curve place by place.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnGroup {
    /// Name, as in messages.
    pub name: String,
    /// Columns of the response.
    pub columns: Vec<usize>,
}

impl ColumnGroup {
    /// Values of its columns in `run`; `None` if it did not deliver all of them.
    pub(crate) fn row(&self, table: &SampleTable, run: usize) -> Option<Vec<f64>> {
        let values: Vec<f64> = self.columns.iter().map(|&column| table.values(run)[column]).collect();
        values.iter().all(|value| value.is_finite()).then_some(values)
    }
}

/// How surrogates are made.
#[derive(Debug, Clone, PartialEq)]
pub struct SurrogateSettings {
    /// Which kind.
    pub choice: Choice,
    /// Runs to learn from, for each combination of the members of lists; at least [`loosepin_surrogate::FEWEST_RUNS`].
    pub training: usize,
    /// Direct runs at each witness: a multiple of the replicates, two in each at least, and no more than the inner runs.
    pub confirming: usize,
    /// Groups that are learned; every column that is asked for stands in one group.
    pub groups: Vec<ColumnGroup>,
}
