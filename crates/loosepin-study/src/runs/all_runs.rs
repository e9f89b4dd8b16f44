//! The runs of a study so far, and the one way to make more of them: on threads or elsewhere, with progress, an emergency stop, and
//! a store.

use crate::drafts::progress::{Drafts, PilotRun, Stage};
use crate::error::{StudyError, TooManyFailed};
use crate::file::Study;
use crate::response::study_response::StudyResponse;
use crate::run_options::RunOptions;
use crate::runs::evaluate::{RunOutcome, Work, evaluate};
use crate::runs::external_runs::provided_rows;
use crate::runs::failures::failures;
use crate::runs::keep::{RunLists, StoredRuns};
use crate::runs::run_subset::{OpenRound, RunSubset};
use crate::runs::table::{RunsTable, runs_table};
use loosepin_bounds::{DoubleLoop, RunInputs, SampleTable};
use loosepin_store::Shard;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Runs that are handed to the threads at once: so many that the lanes which idle at the end hardly count.
const RUNS_PER_BATCH: usize = 8192;
/// Runs between two reports of progress.
const RUNS_PER_REPORT: usize = 64;

/// Runs of one study: of the study itself, or of one with loosened inputs.
pub(crate) struct Runs<'s> {
    pub options: &'s RunOptions<'s>,
    pub pool: Arc<rayon::ThreadPool>,
    pub study: &'s Study,
    pub response: &'s StudyResponse,
    /// Inputs that the inverse question has loosened, as [`crate::runs::external_runs::RequestedRuns::loosened`].
    pub loosened: &'s [(usize, f64)],
    /// Runs at most, of all lists.
    pub most_runs: usize,
    /// The runs so far.
    pub table: SampleTable,
    lists: Arc<RunLists<'s>>,
    list: StoredRuns<'s>,
    /// Tells drafts, where they are wanted.
    pub drafts: Option<&'s dyn Drafts>,
}

impl<'s> Runs<'s> {
    /// No runs yet, of which `table` is to hold `most_runs` at most; `before` were made elsewhere.
    ///
    /// # Errors
    /// There are no threads to be had.
    pub fn new(
        options: &'s RunOptions<'s>,
        (study, response): (&'s Study, &'s StudyResponse),
        table: SampleTable,
        (before, most_runs): (usize, usize),
    ) -> Result<Self, StudyError> {
        let pool = Arc::new(rayon::ThreadPoolBuilder::new().num_threads(options.threads).build()?);
        let lists = Arc::new(RunLists::new(options.store, before));
        let list = lists.begin();
        Ok(Self { options, pool, study, response, loosened: &[], most_runs, table, lists, list, drafts: None })
    }

    /// The next list: no runs yet of another study, on the same threads.
    pub fn of_another<'o>(&self, study: &'o Study, response: &'o StudyResponse, table: SampleTable) -> Runs<'o>
    where
        's: 'o,
    {
        let (pool, lists, list) = (self.pool.clone(), self.lists.clone(), self.lists.begin());
        let Self { options, most_runs, .. } = *self;
        Runs { options, pool, study, response, loosened: &[], most_runs, table, lists, list, drafts: None }
    }

    /// Tells what `plan` says of the runs so far.
    pub fn tell_draft(&self, plan: &DoubleLoop) {
        let draft = self.drafts.and_then(|drafts| self.pool.install(|| drafts.of(plan, &self.table)));
        if let Some(draft) = draft {
            self.options.progress.draft(&draft);
        }
    }

    /// Makes the runs of the pilot in `round`, the first one, and reports their draft; the rows by their place, the other places have no
    /// entry.
    ///
    /// # Errors
    /// The store cannot be used.
    fn make_pilot(&self, round: &[RunInputs]) -> Result<BTreeMap<usize, RunOutcome>, StudyError> {
        let (pool, RunOptions { progress, run_subset, provider, stop, .. }) = (&self.pool, *self.options);
        let Some(drafts) = self.drafts.filter(|_| run_subset == RunSubset::Whole && provider.is_none()) else {
            return Ok(BTreeMap::new());
        };
        let is_in_pilot: Vec<bool> = round.iter().map(|inputs| drafts.is_in_pilot(inputs)).collect();
        if !is_in_pilot.contains(&true) {
            return Ok(BTreeMap::new());
        }
        let kept = self.list.find(0, round)?;
        let is_waiting: Vec<bool> =
            kept.iter().zip(&is_in_pilot).map(|(kept, &is_own)| kept.is_none() && is_own).collect();
        let known = kept.iter().zip(&is_in_pilot).filter(|(kept, is_own)| kept.is_some() && **is_own).count();
        let finished = AtomicUsize::new(known);
        let note = |place: usize, row: &RunOutcome| self.note(place, &round[place], row, &finished);
        let work = Work { batch: round, is_waiting: &is_waiting, response: self.response, stop };
        let rows = pool.install(|| evaluate(&work, kept, &|| self.is_stopped(), &note));
        let own = rows.iter().zip(round).zip(&is_in_pilot).filter(|(_, is_own)| **is_own).map(|(run, _)| run);
        let finished: Option<Vec<PilotRun<'_>>> =
            own.map(|(row, inputs)| Some((inputs, row.as_ref()?.as_deref().map_err(|&failure| failure)))).collect();
        if let Some(draft) = finished.and_then(|runs| pool.install(|| drafts.of_pilot(&runs))) {
            progress.draft(&draft);
        }
        let made = rows.into_iter().zip(is_waiting).enumerate().filter(|(_, (_, is_waiting))| *is_waiting);
        Ok(made.filter_map(|(place, (row, _))| Some((place, row?))).collect())
    }

    /// Keeps the row of a run that is finished and counts it.
    fn note(&self, place: usize, inputs: &RunInputs, row: &RunOutcome, finished: &AtomicUsize) {
        self.list.keep(place, inputs, row);
        let runs = finished.fetch_add(1, Ordering::Relaxed) + 1;
        if runs.is_multiple_of(RUNS_PER_REPORT) {
            self.options.progress.runs(runs, self.most_runs);
        }
    }

    /// Whether no further run is to begin.
    fn is_stopped(&self) -> bool {
        self.options.stop.load(Ordering::Relaxed) || self.list.is_broken()
    }

    /// The runs so far as a table for people.
    pub fn runs_table(&self) -> RunsTable {
        runs_table(self.study, self.response, &self.table)
    }

    /// Counts the runs of this list for the progress of those that follow.
    pub fn close(&self) {
        self.lists.close(self.table.len());
    }

    /// That no more of the runs so far failed than may: bounds would say little, and every further round as little.
    ///
    /// # Errors
    /// More failed.
    pub fn refuse_failures(&self) -> Result<(), StudyError> {
        let (made, failed, most_failed) = (self.table.len(), self.table.failed(), self.study.sampling.most_failed);
        if failed as f64 <= most_failed * made as f64 {
            return Ok(());
        }
        let commonest = failures(self.study, self.response, &self.table).into_iter().next();
        let runs = self.runs_table();
        Err(StudyError::TooManyFailed(Box::new(TooManyFailed { runs, made, failed, most_failed, commonest })))
    }

    /// The rows that `response`, of a study like this one, gives for the inputs of `runs`; `None` for a run that fails. They are not kept.
    ///
    /// # Errors
    /// The study was interrupted.
    pub fn make_again(&self, response: &StudyResponse, runs: &[usize]) -> Result<Vec<Option<Vec<f64>>>, StudyError> {
        let (pool, RunOptions { stop, progress, .. }) = (&self.pool, *self.options);
        progress.stage(Stage::Runs);
        let batch: Vec<RunInputs> = runs.iter().map(|&run| self.table.inputs()[run].clone()).collect();
        let work = Work { batch: &batch, is_waiting: &vec![true; batch.len()], response, stop };
        let is_stopped = || stop.load(Ordering::Relaxed);
        let rows =
            pool.install(|| evaluate(&work, vec![None; batch.len()], &is_stopped, &|_: usize, _: &RunOutcome| {}));
        if rows.iter().any(Option::is_none) {
            return Err(StudyError::Interrupted { finished: Box::new(self.runs_table()), most_runs: self.most_runs });
        }
        Ok(rows.into_iter().flatten().map(Result::ok).collect())
    }

    /// Makes the runs of `round` and adds their rows; those that are kept are taken over.
    ///
    /// # Errors
    /// The study was interrupted, the store cannot be used, or runs are missing that are made elsewhere.
    pub fn make(&mut self, round: &[RunInputs]) -> Result<(), StudyError> {
        let (pool, RunOptions { progress, run_subset, provider, stop, .. }) = (&self.pool, *self.options);
        progress.stage(Stage::Runs);
        let begin = self.table.len();
        let before = self.lists.finished_runs() + begin;
        let mut open = OpenRound { runs_before: before, runs: round.len(), made: 0, missing: BTreeMap::new() };
        let mut done = before;
        let mut pilot = if begin == 0 { self.make_pilot(round)? } else { BTreeMap::new() };
        for (number, batch) in round.chunks(RUNS_PER_BATCH).enumerate() {
            let first = begin + number * RUNS_PER_BATCH;
            let mut kept = self.list.find(first, batch)?;
            for (index, row) in kept.iter_mut().enumerate() {
                *row = row.take().or_else(|| pilot.remove(&(number * RUNS_PER_BATCH + index)));
            }
            let is_waiting: Vec<bool> = (kept.iter().zip(first as u64..))
                .map(|(kept, place)| kept.is_none() && run_subset.makes(place, round.len()))
                .collect();
            let known = kept.iter().flatten().count();
            let making = is_waiting.iter().filter(|is_waiting| **is_waiting).count();
            // What the pilot has made of later batches is finished too.
            let finished = AtomicUsize::new(done + known + pilot.len());
            let note = |index: usize, row: &RunOutcome| self.note(first + index, &batch[index], row, &finished);
            let is_stopped = || self.is_stopped();
            let work = Work { batch, is_waiting: &is_waiting, response: self.response, stop };
            let outcomes = match provider {
                None => pool.install(|| evaluate(&work, kept, &is_stopped, &note)),
                Some(provider) => {
                    let made = provided_rows(provider, &work, kept, self.loosened, &is_stopped, &note);
                    // What came back before something went wrong is kept.
                    made.or_else(|error| self.list.flush().and(Err(error)))?
                }
            };
            if self.list.is_broken() {
                self.list.flush()?;
            }
            let made =
                outcomes.iter().zip(&is_waiting).filter(|(row, is_waiting)| **is_waiting && row.is_some()).count();
            for ((inputs, outcome), place) in batch.iter().zip(&outcomes).zip(first as u64..) {
                match outcome {
                    // Rows behind one that is missing are in the store, and wait there.
                    Some(outcome) if open.missing.is_empty() || made < making => {
                        self.table.push(inputs.clone(), outcome.as_deref().map_err(|&failure| failure))?;
                    }
                    Some(_) => {}
                    None => {
                        let shard = Shard::index_for_run(place, run_subset.shards().unwrap_or(1));
                        *open.missing.entry(shard).or_default() += 1;
                    }
                }
            }
            if made < making {
                self.list.flush()?;
                for (place, row) in std::mem::take(&mut pilot) {
                    self.table.push(round[place].clone(), row.as_deref().map_err(|&failure| failure))?;
                }
                let finished = Box::new(self.runs_table());
                return Err(StudyError::Interrupted { finished, most_runs: self.most_runs });
            }
            open.made += made;
            done += known + made;
            progress.runs(done + pilot.len(), self.most_runs);
        }
        if open.missing.is_empty() {
            return Ok(());
        }
        self.list.flush()?;
        Err(StudyError::RoundOpen(open))
    }
}
