//! Running a round of a study on all threads, with progress, an emergency stop, and a store.

use super::conduct::{Progress, StudyError};
use super::elsewhere::{RunMaker, made_elsewhere};
use super::file::Study;
use super::keep::{Keeping, KeptList};
use super::part::{OpenRound, Part};
use super::response::StudyResponse;
use loosepin_bounds::{Failure, RunInputs, SampleTable};
use loosepin_simulate::Execution;
use loosepin_store::Shard;
use rayon::prelude::*;
use std::collections::BTreeMap;
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
    /// Which of the runs are made here.
    pub part: Part,
    /// Makes the runs in place of the threads.
    pub maker: Option<&'s dyn RunMaker>,
    /// What the inverse question has loosened, as [`super::elsewhere::AskedRuns::loosened`].
    pub loosened: &'s [(usize, f64)],
}

impl Runner<'_> {
    /// Counts the runs of a finished table for the progress.
    pub fn advance(&self, runs: usize) {
        self.before.fetch_add(runs, Ordering::Relaxed);
    }

    /// Runs `round` and adds its rows to `table`; those that are kept are taken over.
    ///
    /// # Errors
    /// The study was interrupted, the store cannot be used, or runs are missing that are made elsewhere.
    pub fn run(&self, round: &[RunInputs], table: &mut SampleTable) -> Result<(), StudyError> {
        let begin = table.len();
        let before = self.before.load(Ordering::Relaxed) + begin;
        let mut open = OpenRound { runs_before: before, runs: round.len(), made: 0, missing: BTreeMap::new() };
        let mut done = before;
        for (number, batch) in round.chunks(RUNS_PER_BATCH).enumerate() {
            let first = begin + number * RUNS_PER_BATCH;
            let kept = self.list.find(first, batch)?;
            let is_waiting: Vec<bool> = (kept.iter().zip(first as u64..))
                .map(|(kept, place)| kept.is_none() && self.part.makes(place, round.len()))
                .collect();
            let known = kept.iter().flatten().count();
            let making = is_waiting.iter().filter(|is_waiting| **is_waiting).count();
            let finished = AtomicUsize::new(done + known);
            let note = |index: usize, row: &Row| {
                self.list.keep(first + index, &batch[index], row);
                let runs = finished.fetch_add(1, Ordering::Relaxed) + 1;
                if runs.is_multiple_of(RUNS_PER_REPORT) {
                    self.progress.runs(runs, self.most_runs);
                }
            };
            let is_stopped = || self.stop.load(Ordering::Relaxed) || self.list.is_broken();
            let work = Work { batch, is_waiting: &is_waiting, response: self.response };
            let outcomes = match self.maker {
                None => self.pool.install(|| evaluate(&work, kept, &is_stopped, &note)),
                Some(maker) => {
                    let made = made_elsewhere(maker, &work, kept, self.loosened, &is_stopped, &note);
                    // What came back before something went wrong is kept.
                    made.or_else(|error| self.list.settle().and(Err(error)))?
                }
            };
            if self.list.is_broken() {
                self.list.settle()?;
            }
            let made =
                outcomes.iter().zip(&is_waiting).filter(|(row, is_waiting)| **is_waiting && row.is_some()).count();
            for ((inputs, outcome), place) in batch.iter().zip(&outcomes).zip(first as u64..) {
                match outcome {
                    // Rows behind one that is missing are in the store, and wait there.
                    Some(outcome) if open.missing.is_empty() || made < making => {
                        table.push(inputs.clone(), outcome.as_deref().map_err(|&failure| failure))?;
                    }
                    Some(_) => {}
                    None => {
                        let maker = Shard::maker(place, self.part.shards().unwrap_or(1));
                        *open.missing.entry(maker).or_default() += 1;
                    }
                }
            }
            if made < making {
                self.list.settle()?;
                let finished = Box::new(super::assemble::runs_table(self.study, self.response, table));
                return Err(StudyError::Interrupted { finished, most_runs: self.most_runs });
            }
            open.made += made;
            done += known + made;
            self.progress.runs(done, self.most_runs);
        }
        if open.missing.is_empty() {
            return Ok(());
        }
        self.list.settle()?;
        Err(StudyError::RoundOpen(open))
    }
}

/// Columns and extras of a finished run, or why it gave nothing.
pub(super) type Row = Result<Vec<f64>, Failure>;

/// A batch of runs, and which of them are to be made.
pub(super) struct Work<'w> {
    pub batch: &'w [RunInputs],
    pub is_waiting: &'w [bool],
    pub response: &'w StudyResponse,
}

/// The rows of a batch, those that are `kept` as they are; nothing for runs that are not to be made, or that a stop has kept from
/// starting.
///
/// Each thread takes the next run as soon as one of its lanes is free; which thread and which lane a run meets has no influence on
/// its bits. Runs with other laws have other equations: each thread takes those of one combination after those of another.
pub(super) fn evaluate(
    work: &Work<'_>,
    kept: Vec<Option<Row>>,
    is_stopped: &(dyn Fn() -> bool + Sync),
    finished: &(dyn Fn(usize, &Row) + Sync),
) -> Vec<Option<Row>> {
    let Work { batch, is_waiting, response } = *work;
    let mut queues: Vec<(Vec<usize>, AtomicUsize)> =
        response.mechanisms.iter().map(|_| (Vec::new(), AtomicUsize::new(0))).collect();
    for (index, inputs) in batch.iter().enumerate().filter(|(index, _)| is_waiting[*index]) {
        queues[response.variant(&inputs.epistemic)].0.push(index);
    }
    let execution = Execution::best();
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
                response.run_all(variant, execution, next, |index, outcome| {
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
