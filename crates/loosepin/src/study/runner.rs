//! Running a round of a study on all threads, with progress, an emergency stop, and a store.

use super::conduct::{Progress, StudyError};
use super::file::Study;
use super::keep::{Keeping, KeptList};
use super::response::StudyResponse;
use crate::bounds::{Failure, RunInputs, SampleTable};
use crate::math::Vectors;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Runs that are handed to the threads at once: so many that the lanes which idle at the end hardly count.
const RUNS_PER_BATCH: usize = 8192;
/// Runs between two reports of progress.
const RUNS_PER_REPORT: usize = 64;

/// What runs need, whatever they are for.
#[derive(Clone, Copy)]
pub(super) struct Runner<'s> {
    pub study: &'s Study,
    pub response: &'s StudyResponse,
    pub pool: &'s rayon::ThreadPool,
    pub progress: &'s dyn Progress,
    pub stop: &'s AtomicBool,
    pub most_runs: usize,
    /// Runs in tables that are finished.
    pub before: &'s AtomicUsize,
    /// Where finished runs are kept.
    pub keeping: &'s Keeping<'s>,
    /// The list that is being run.
    pub list: KeptList<'s>,
}

impl Runner<'_> {
    /// Counts the runs of a finished table for the progress.
    pub fn advance(&self, runs: usize) {
        self.before.fetch_add(runs, Ordering::Relaxed);
    }

    /// Runs `round` and adds its rows to `table`; those that are kept are taken over.
    ///
    /// # Errors
    /// The study was interrupted, or the store cannot be used.
    pub fn run(&self, round: &[RunInputs], table: &mut SampleTable) -> Result<(), StudyError> {
        for batch in round.chunks(RUNS_PER_BATCH) {
            let before = self.before.load(Ordering::Relaxed);
            let first = table.len();
            let kept = self.list.find(first, batch)?;
            let done = AtomicUsize::new(before + first + kept.iter().flatten().count());
            let finished = |index: usize, row: &Row| {
                self.list.keep(first + index, &batch[index], row);
                let runs = done.fetch_add(1, Ordering::Relaxed) + 1;
                if runs.is_multiple_of(RUNS_PER_REPORT) {
                    self.progress.runs(runs, self.most_runs);
                }
            };
            let is_stopped = || self.stop.load(Ordering::Relaxed) || self.list.is_broken();
            let outcomes = self.pool.install(|| evaluate(batch, kept, self.response, &is_stopped, &finished));
            if self.list.is_broken() {
                self.list.settle()?;
            }
            let is_stopped = outcomes.iter().any(Option::is_none);
            for (inputs, outcome) in batch.iter().zip(outcomes) {
                if let Some(outcome) = outcome {
                    table.push(inputs.clone(), outcome.as_deref().map_err(|&failure| failure))?;
                }
            }
            if is_stopped {
                self.list.settle()?;
                let finished = Box::new(super::assemble::runs_table(self.study, self.response, table));
                return Err(StudyError::Interrupted { finished, most_runs: self.most_runs });
            }
            self.progress.runs(before + table.len(), self.most_runs);
        }
        Ok(())
    }
}

/// Columns and extras of a finished run, or why it gave nothing.
pub(super) type Row = Result<Vec<f64>, Failure>;

/// The rows of a batch, those that are `kept` as they are; nothing for runs that a stop has kept from starting.
///
/// Each thread takes the next run as soon as one of its lanes is free; which thread and which lane a run meets has no influence on
/// its bits. Runs with other laws have other equations: each thread takes those of one combination after those of another.
fn evaluate(
    batch: &[RunInputs],
    kept: Vec<Option<Row>>,
    response: &StudyResponse,
    is_stopped: &(dyn Fn() -> bool + Sync),
    finished: &(dyn Fn(usize, &Row) + Sync),
) -> Vec<Option<Row>> {
    let mut queues: Vec<(Vec<usize>, AtomicUsize)> =
        response.mechanisms.iter().map(|_| (Vec::new(), AtomicUsize::new(0))).collect();
    for (index, inputs) in batch.iter().enumerate().filter(|(index, _)| kept[*index].is_none()) {
        queues[response.variant(&inputs.epistemic)].0.push(index);
    }
    let vectors = Vectors::best();
    let parts: Vec<Vec<(usize, Row)>> = (0..rayon::current_num_threads())
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
                response.run_all(variant, vectors, next, |index, outcome| {
                    let row = outcome.map_err(|failure| Failure(failure.number()));
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
