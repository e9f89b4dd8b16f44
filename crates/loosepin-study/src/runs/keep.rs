//! Finished runs of a study in a store, to be found again.

use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

use crate::error::StudyError;
use crate::runs::evaluate::RunOutcome;
use loosepin_bounds::{Failure, RunInputs};
use loosepin_store::{InputsKey, RunStore, StoreError, StoredRun};

/// The lists of runs of a study: where they are kept, how many have been begun, and the runs of those that are finished.
pub(crate) struct RunLists<'s> {
    store: Option<&'s RunStore>,
    begun: AtomicU32,
    finished_runs: AtomicUsize,
}

/// One list of runs: that of the study itself, or of a direct study of the inverse question. They are begun in the same order
/// whenever the study is run.
#[derive(Clone, Copy)]
pub(crate) struct StoredRuns<'s> {
    store: Option<&'s RunStore>,
    list: u32,
}

impl<'s> RunLists<'s> {
    /// No list yet, kept in `store`, or nowhere; `before` runs were made before them.
    pub fn new(store: Option<&'s RunStore>, before: usize) -> Self {
        Self { store, begun: AtomicU32::new(0), finished_runs: AtomicUsize::new(before) }
    }

    /// The next list.
    pub fn begin(&self) -> StoredRuns<'s> {
        StoredRuns { store: self.store, list: self.begun.fetch_add(1, Ordering::Relaxed) }
    }

    /// A list is finished with `runs` runs.
    pub fn close(&self, runs: usize) {
        self.finished_runs.fetch_add(runs, Ordering::Relaxed);
    }

    /// Runs of the lists that are finished.
    pub fn finished_runs(&self) -> usize {
        self.finished_runs.load(Ordering::Relaxed)
    }
}

impl StoredRuns<'_> {
    /// The rows of `batch`, whose first run stands at `first` in the list, where they are known.
    ///
    /// # Errors
    /// The store cannot be read, or holds runs with other inputs at these places.
    pub fn find(&self, first: usize, batch: &[RunInputs]) -> Result<Vec<Option<RunOutcome>>, StudyError> {
        let Some(store) = self.store else { return Ok(vec![None; batch.len()]) };
        let found = store.find(self.list, first as u64..(first + batch.len()) as u64)?;
        let rows = found.into_iter().zip(batch).enumerate().map(|(offset, (kept, inputs))| match kept {
            Some(kept) if kept.inputs != key(inputs) => Err(StoreError::Damaged {
                path: store.path().to_owned(),
                reason: format!(
                    "run {} of list {} has other inputs than the study gives it",
                    first + offset,
                    self.list
                ),
            }),
            Some(kept) => Ok(Some(kept.outcome.map_err(Failure))),
            None => Ok(None),
        });
        Ok(rows.collect::<Result<_, _>>()?)
    }

    /// Keeps the run at `place`.
    pub fn keep(&self, place: usize, inputs: &RunInputs, row: &RunOutcome) {
        if let Some(store) = self.store {
            let outcome = row.clone().map_err(|failure| failure.0);
            store.keep(self.list, place as u64, StoredRun { inputs: key(inputs), outcome });
        }
    }

    /// Whether finished runs can no longer be stored.
    pub fn is_broken(&self) -> bool {
        self.store.is_some_and(RunStore::is_broken)
    }

    /// Waits until everything is on disk; gives the number of runs there.
    ///
    /// # Errors
    /// Why something is not.
    pub fn flush(&self) -> Result<(), StudyError> {
        if let Some(store) = self.store {
            store.flush()?;
        }
        Ok(())
    }
}

/// Everything that a run depends on besides the study, and its place in the plan.
fn key(inputs: &RunInputs) -> InputsKey {
    let RunInputs { round, purpose, point, replicate, index, random, epistemic } = inputs;
    let mut bytes: Vec<u8> = format!("{} ", purpose.word()).into_bytes();
    bytes.extend([*round, *point, *replicate, *index, random.len() as u32].map(u32::to_le_bytes).concat());
    bytes.extend(random.iter().chain(epistemic).flat_map(|value| value.to_bits().to_le_bytes()));
    InputsKey::of(&bytes)
}
