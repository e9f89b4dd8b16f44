//! Runs of a study that are made outside this process: the requests here, and the runs there.
//!
//! Only runs travel. The rounds, the store and the bounds stay with whoever conducts the study, and a run has the same bits
//! wherever it is made: so have the results.

use crate::error::StudyError;
use crate::runs::evaluate::{RunOutcome, Work};
use loosepin_bounds::{Failure, RunInputs};

/// Requested runs.
#[derive(Debug, Clone, Copy)]
pub struct RequestedRuns<'r> {
    /// Inputs that the inverse question has loosened: place in [`Study::allowances`](crate::Study::allowances), value in SI. None of them: the study as it stands.
    pub loosened: &'r [(usize, f64)],
    /// The inputs of each run.
    pub runs: &'r [&'r RunInputs],
}

/// Makes runs outside of this process.
pub trait RunProvider: Sync {
    /// Makes the requested runs, in any order, and passes each to `finished` with its place as soon as it is known. Returns before all are
    /// made where `is_stopped` says so.
    ///
    /// # Errors
    /// In words, why they cannot be made.
    fn make(
        &self,
        asked: &RequestedRuns<'_>,
        is_stopped: &dyn Fn() -> bool,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, Failure>),
    ) -> Result<(), String>;
}

/// The rows of a batch made by `provider`, the `kept` ones unchanged; `None` for runs that are not to be made, or that a stop has kept from
/// being made.
pub(crate) fn provided_rows(
    provider: &dyn RunProvider,
    work: &Work<'_>,
    kept: Vec<Option<RunOutcome>>,
    loosened: &[(usize, f64)],
    is_stopped: &dyn Fn() -> bool,
    finished: &dyn Fn(usize, &RunOutcome),
) -> Result<Vec<Option<RunOutcome>>, StudyError> {
    let mut rows = kept;
    let places: Vec<usize> = (0..rows.len()).filter(|&index| work.is_waiting[index]).collect();
    let runs: Vec<&RunInputs> = places.iter().map(|&index| &work.batch[index]).collect();
    if runs.is_empty() {
        return Ok(rows);
    }
    let due = work.response.row_length();
    let mut strange = None;
    let mut take = |place: usize, row: RunOutcome| {
        let length = row.as_ref().map_or(due, Vec::len);
        match places.get(place) {
            Some(&index) if length == due => {
                finished(index, &row);
                rows[index] = Some(row);
            }
            _ => strange = Some(format!("run {place} came back with {length} numbers; there are {due} in a row")),
        }
    };
    let made = provider.make(&RequestedRuns { loosened, runs: &runs }, is_stopped, &mut take);
    match made.err().or(strange) {
        Some(reason) => Err(StudyError::NotMade { reason }),
        None => Ok(rows),
    }
}
