//! Runs: inputs and outputs, one row each.

use std::any::Any;
use std::sync::Arc;

use super::rows::Rows;
use super::scratch::Scratch;
use super::type_map::TypeMap;
pub use loosepin_terms::Purpose;
use thiserror::Error;

/// The inputs of one run, and its place in the plan.
#[derive(Debug, Clone, PartialEq)]
pub struct RunInputs {
    /// Round of the plan, counted from 0.
    pub round: u32,
    /// Purpose of the run.
    pub purpose: Purpose,
    /// Outer index: which u (double loop) or which point of the joint box (extreme); 0 in the mixture.
    pub point: u32,
    /// Replicate: which scrambling of the inner points.
    pub replicate: u32,
    /// Inner index within the replicate.
    pub index: u32,
    /// Values of the random inputs.
    pub random: Vec<f64>,
    /// Values of the epistemic inputs.
    pub epistemic: Vec<f64>,
}

/// Why a run gave nothing; the meaning of the code belongs to the response.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Failure(pub u16);

/// Why a row does not fit the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum TableError {
    #[error("run {run} has {found} columns; the table has {expected}")]
    WrongColumns { run: usize, found: usize, expected: usize },
}

/// Runs in the order of the plan, one row each: inputs, and columns or the reason for failure.
///
/// A column of a finished run that is not finite (the quantity does not exist for this run) counts as failed for that
/// column alone.
#[derive(Debug, Clone, Default)]
pub struct SampleTable {
    inputs: Arc<Vec<RunInputs>>,
    failures: Vec<Option<Failure>>,
    values: Rows,
    beside: TypeMap,
}

impl SampleTable {
    /// An empty table for a response with this number of columns.
    pub fn new(columns: usize) -> Self {
        Self { values: Rows::new(columns, None), ..Self::default() }
    }

    /// An empty table with room for `runs` runs, so that adding them never needs room for a second copy. Where there is no such room
    /// now, it is looked for when it is needed: a plan may come to fewer runs. The columns of the runs, and what is gathered from them,
    /// are kept in `scratch`; in memory without one.
    pub fn with_capacity(columns: usize, runs: usize, scratch: Option<Scratch>) -> Self {
        let mut table = Self { values: Rows::new(columns, scratch), ..Self::default() };
        let _ = Arc::make_mut(&mut table.inputs).try_reserve_exact(runs);
        let _ = table.failures.try_reserve_exact(runs);
        table.values.reserve(runs);
        table
    }

    /// Adds a run.
    ///
    /// # Errors
    ///
    /// [`TableError::WrongColumns`] where the row has another number of columns than the table.
    pub fn push(&mut self, inputs: RunInputs, outcome: Result<&[f64], Failure>) -> Result<(), TableError> {
        let run = self.inputs.len();
        match outcome {
            Ok(values) => {
                let expected = self.columns();
                if values.len() != expected {
                    return Err(TableError::WrongColumns { run, found: values.len(), expected });
                }
                self.values.push(values.iter().copied());
                self.failures.push(None);
            }
            Err(failure) => {
                self.values.push(std::iter::repeat_n(f64::NAN, self.columns()));
                self.failures.push(Some(failure));
            }
        }
        Arc::make_mut(&mut self.inputs).push(inputs);
        Ok(())
    }

    /// The same runs with a single column in place of theirs: what `of` makes of each row.
    pub(crate) fn with_one_column(&self, of: impl Fn(&[f64]) -> f64) -> Self {
        let mut values = Rows::new(1, None);
        for run in 0..self.len() {
            let is_finished = self.failures[run].is_none();
            values.push(std::iter::once(if is_finished { of(self.values(run)) } else { f64::NAN }));
        }
        Self { inputs: Arc::clone(&self.inputs), failures: self.failures.clone(), values, beside: TypeMap::default() }
    }

    /// Rounds that the runs were made in, which is the number of the next one.
    pub fn rounds(&self) -> u32 {
        self.inputs.iter().map(|inputs| inputs.round + 1).max().unwrap_or(0)
    }

    /// Number of runs.
    pub fn len(&self) -> usize {
        self.inputs.len()
    }

    /// Whether nothing has been run.
    pub fn is_empty(&self) -> bool {
        self.inputs.is_empty()
    }

    /// Number of columns of the response.
    pub fn columns(&self) -> usize {
        self.values.columns()
    }

    /// Inputs of all runs.
    pub fn inputs(&self) -> &[RunInputs] {
        &self.inputs
    }

    /// Columns of run `run`, not numbers where it failed.
    pub fn values(&self, run: usize) -> &[f64] {
        self.values.row(run)
    }

    /// The file that takes what is gathered from the columns, where there is one.
    pub(crate) fn scratch(&self) -> Option<&Scratch> {
        self.values.scratch()
    }

    /// Why run `run` failed, if it did.
    pub fn failure(&self, run: usize) -> Option<Failure> {
        self.failures[run]
    }

    /// Derived values stored with the rows for the lifetime of the table. Rows are only ever added, so that what is known of some of them
    /// stays true; a copy of the table begins without.
    pub(crate) fn kept<K: Any + Send + Sync + Default>(&self) -> Arc<K> {
        self.beside.get()
    }

    /// How many runs failed.
    pub fn failed(&self) -> usize {
        self.failures.iter().flatten().count()
    }
}
