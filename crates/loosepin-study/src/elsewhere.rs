//! Runs of a study that are made outside of this process: who asks for them here, who makes them there.
//!
//! Only runs travel. The rounds, the store and the bounds stay with whoever conducts the study, and a run has the same bits
//! wherever it is made: so have the results.

use std::sync::{Arc, Mutex, PoisonError};

use super::allow::with_loosened;
use super::conduct::StudyError;
use super::file::Study;
use super::response::StudyResponse;
use super::runner::{Row, Work, evaluate};
use loosepin_bounds::{Failure, Purpose, RunInputs};

/// Mechanisms that are held ready, at most: that of the study, and those with inputs that are loosened at the moment.
const MOST_READY: usize = 4;

/// Runs that are asked for.
#[derive(Debug, Clone, Copy)]
pub struct AskedRuns<'r> {
    /// Inputs that the inverse question has loosened: place in [`Study::allowances`], value in SI. None of them: the study as it stands.
    pub loosened: &'r [(usize, f64)],
    /// The inputs of each run.
    pub runs: &'r [&'r RunInputs],
}

/// Makes runs outside of this process.
pub trait RunMaker: Sync {
    /// Makes what is asked for, in any order, and hands every run to `finished` by its place as soon as it is known. Returns before
    /// all are made where `is_stopped` says so.
    ///
    /// # Errors
    /// In words, why they cannot be made.
    fn make(
        &self,
        asked: &AskedRuns<'_>,
        is_stopped: &dyn Fn() -> bool,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, Failure>),
    ) -> Result<(), String>;
}

/// The rows of a batch made by `maker`, those that are `kept` as they are; nothing for runs that are not to be made, or that a stop
/// has kept from being made.
pub(super) fn made_elsewhere(
    maker: &dyn RunMaker,
    work: &Work<'_>,
    kept: Vec<Option<Row>>,
    loosened: &[(usize, f64)],
    is_stopped: &dyn Fn() -> bool,
    finished: &dyn Fn(usize, &Row),
) -> Result<Vec<Option<Row>>, StudyError> {
    let mut rows = kept;
    let places: Vec<usize> = (0..rows.len()).filter(|&index| work.is_waiting[index]).collect();
    let runs: Vec<&RunInputs> = places.iter().map(|&index| &work.batch[index]).collect();
    if runs.is_empty() {
        return Ok(rows);
    }
    let due = work.response.row_length();
    let mut strange = None;
    let mut take = |place: usize, row: Row| {
        let length = row.as_ref().map_or(due, Vec::len);
        match places.get(place) {
            Some(&index) if length == due => {
                finished(index, &row);
                rows[index] = Some(row);
            }
            _ => strange = Some(format!("run {place} came back with {length} numbers; there are {due} in a row")),
        }
    };
    let made = maker.make(&AskedRuns { loosened, runs: &runs }, is_stopped, &mut take);
    match made.err().or(strange) {
        Some(reason) => Err(StudyError::NotMade { reason }),
        None => Ok(rows),
    }
}

/// Makes runs of a study for somebody else.
pub struct RunRows {
    study: Study,
    pool: rayon::ThreadPool,
    ready: Mutex<Vec<Ready>>,
}

/// A compiled study with some inputs loosened.
#[derive(Clone)]
struct Ready {
    loosened: Vec<(usize, f64)>,
    response: Arc<StudyResponse>,
}

impl RunRows {
    /// Makes runs of `study` on so many threads.
    ///
    /// # Errors
    /// The study cannot begin, or the threads could not be started.
    pub fn new(study: Study, threads: usize) -> Result<Self, StudyError> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let rows = Self { study, pool, ready: Mutex::new(Vec::new()) };
        rows.response(&[])?;
        Ok(rows)
    }

    /// Random inputs of a run, and epistemic ones.
    pub fn inputs(&self) -> [usize; 2] {
        [self.study.random.len(), self.study.epistemic.len()]
    }

    /// The row of each run, or why it gave nothing: `inputs` are the values of its random and its epistemic inputs, `loosened` as in
    /// [`AskedRuns::loosened`].
    ///
    /// # Errors
    /// Inputs cannot be loosened so.
    pub fn make(
        &self,
        loosened: &[(usize, f64)],
        inputs: impl IntoIterator<Item = [Vec<f64>; 2]>,
    ) -> Result<Vec<Result<Vec<f64>, Failure>>, StudyError> {
        let response = self.response(loosened)?;
        let run = |[random, epistemic]: [Vec<f64>; 2]| {
            let [round, point, replicate, index] = [0; 4];
            RunInputs { round, purpose: Purpose::DoubleLoop, point, replicate, index, random, epistemic }
        };
        let batch: Vec<RunInputs> = inputs.into_iter().map(run).collect();
        let work = Work { batch: &batch, is_waiting: &vec![true; batch.len()], response: &response };
        let rows = self.pool.install(|| evaluate(&work, vec![None; batch.len()], &|| false, &|_, _| {}));
        Ok(rows.into_iter().flatten().collect())
    }

    /// The compiled study with these inputs loosened.
    fn response(&self, loosened: &[(usize, f64)]) -> Result<Arc<StudyResponse>, StudyError> {
        let find = |ready: &[Ready]| {
            ready.iter().find(|known| known.loosened == loosened).map(|known| Arc::clone(&known.response))
        };
        let lock = || self.ready.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = find(&lock()) {
            return Ok(known);
        }
        let response = Arc::new(match loosened {
            [] => StudyResponse::new(&self.study)?,
            _ => StudyResponse::new(&with_loosened(&self.study, loosened)?)?,
        });
        let mut ready = lock();
        if ready.len() == MOST_READY {
            ready.remove(0);
        }
        ready.push(Ready { loosened: loosened.to_vec(), response: Arc::clone(&response) });
        Ok(response)
    }
}
