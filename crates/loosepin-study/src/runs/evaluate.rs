//! Runs on all threads of this process.

use crate::response::study_response::StudyResponse;
use loosepin_bounds::{Failure, RunInputs};
use loosepin_simulate::{Execution, RunFailure};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Columns and extras of a finished run, or what is known of one that failed: as a rule the number of the reason.
pub(crate) type RunOutcome<F = Failure> = Result<Vec<f64>, F>;

/// A batch of runs, and which of them are to be made.
pub(crate) struct Work<'w> {
    pub batch: &'w [RunInputs],
    pub is_waiting: &'w [bool],
    pub response: &'w StudyResponse,
    /// Ends lives of wear, which are many cycles each, in their middle.
    pub stop: &'w AtomicBool,
}

/// [`evaluate_into`], with the number of the reason for a failed run.
pub(crate) fn evaluate(
    work: &Work<'_>,
    kept: Vec<Option<RunOutcome>>,
    is_stopped: &(dyn Fn() -> bool + Sync),
    finished: &(dyn Fn(usize, &RunOutcome) + Sync),
) -> Vec<Option<RunOutcome>> {
    evaluate_into(work, kept, is_stopped, finished, |failure| Failure(failure.number()))
}

/// The rows of a batch, the `kept` ones unchanged; `None` for runs that are not to be made, or that a stop has kept from starting or from
/// ending.
///
/// Each thread takes the next run as soon as one of its lanes is free; which thread and which lane a run meets has no influence on
/// its bits. Runs with other laws have other equations: each thread takes those of one combination after those of another. `describe`
/// gives what is known of a failed run.
pub(crate) fn evaluate_into<F: Send>(
    work: &Work<'_>,
    kept: Vec<Option<RunOutcome<F>>>,
    is_stopped: &(dyn Fn() -> bool + Sync),
    finished: &(dyn Fn(usize, &RunOutcome<F>) + Sync),
    describe: impl Fn(RunFailure) -> F + Sync,
) -> Vec<Option<RunOutcome<F>>> {
    let Work { batch, is_waiting, response, stop } = *work;
    let mut queues: Vec<(Vec<usize>, AtomicUsize)> =
        (0..response.variants()).map(|_| (Vec::new(), AtomicUsize::new(0))).collect();
    for (index, inputs) in batch.iter().enumerate().filter(|(index, _)| is_waiting[*index]) {
        queues[response.variant(&inputs.epistemic)].0.push(index);
    }
    let execution = Execution::best();
    let parts: Vec<Vec<(usize, RunOutcome<F>)>> = (0..rayon::current_num_threads())
        .into_par_iter()
        .with_max_len(1)
        .map(|_| {
            let mut rows = Vec::new();
            for (variant, (queue, taken)) in queues.iter().enumerate() {
                let next = || {
                    let index = *queue.get(taken.fetch_add(1, Ordering::Relaxed))?;
                    let inputs = batch.get(index).filter(|_| !is_stopped())?;
                    Some((index, &inputs.random[..], &inputs.epistemic[..]))
                };
                response.run_all_until(variant, execution, stop, next, |index, outcome| {
                    // It is made when the study goes on: nothing of it is kept.
                    if matches!(outcome, Err(RunFailure::Stopped { .. })) {
                        return;
                    }
                    let row = outcome.map_err(&describe);
                    finished(index, &row);
                    rows.push((index, row));
                });
            }
            rows
        })
        .collect();
    let mut rows = kept;
    for (index, row) in parts.into_iter().flatten() {
        rows[index] = Some(row);
    }
    rows
}
