//! Runs of a study that another process conducts.

use crate::error::StudyError;
use crate::file::Study;
use crate::question::with_loosened;
use crate::response::study_response::StudyResponse;
use crate::runs::evaluate::{RunOutcome, Work, evaluate};
use loosepin_bounds::{Failure, Purpose, RunInputs};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Mechanisms that are held ready, at most: that of the study, and those with inputs that are loosened at the moment.
const MAX_READY: usize = 4;

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
    /// Makes runs of `study` on `threads` threads.
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
    /// [`RequestedRuns::loosened`](crate::runs::external_runs::RequestedRuns::loosened).
    ///
    /// # Errors
    /// Inputs cannot be loosened so.
    pub fn make(
        &self,
        loosened: &[(usize, f64)],
        inputs: impl IntoIterator<Item = [Vec<f64>; 2]>,
    ) -> Result<Vec<Result<Vec<f64>, Failure>>, StudyError> {
        self.make_until(loosened, inputs, &|| true)
    }

    /// As [`Self::make`]; `finished` is called for every run that ends, and returns whether others are to begin: rows of runs that did not
    /// begin are left out.
    ///
    /// # Errors
    /// Inputs cannot be loosened so.
    pub fn make_until(
        &self,
        loosened: &[(usize, f64)],
        inputs: impl IntoIterator<Item = [Vec<f64>; 2]>,
        finished: &(dyn Fn() -> bool + Sync),
    ) -> Result<Vec<Result<Vec<f64>, Failure>>, StudyError> {
        let response = self.response(loosened)?;
        let run = |[random, epistemic]: [Vec<f64>; 2]| {
            let [round, point, replicate, index] = [0; 4];
            RunInputs { round, purpose: Purpose::DoubleLoop, point, replicate, index, random, epistemic }
        };
        let batch: Vec<RunInputs> = inputs.into_iter().map(run).collect();
        let (is_waiting, stop) = (vec![true; batch.len()], AtomicBool::new(false));
        let is_stopped = || stop.load(Ordering::Relaxed);
        let heard = |_: usize, _: &RunOutcome| {
            if !finished() {
                stop.store(true, Ordering::Relaxed);
            }
        };
        let work = Work { batch: &batch, is_waiting: &is_waiting, response: &response, stop: &stop };
        let rows = self.pool.install(|| evaluate(&work, vec![None; batch.len()], &is_stopped, &heard));
        Ok(rows.into_iter().flatten().collect())
    }

    /// Columns of each ask in a row, in the order of the asks.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn asked_columns(&self) -> Result<Vec<Vec<usize>>, StudyError> {
        let response = self.response(&[])?;
        Ok(response.plan().asks.iter().map(|ask| ask.columns.clone()).collect())
    }

    /// Contacts that began in the recorded turns of the run of `row`, for each joint with play.
    ///
    /// # Errors
    /// The study cannot begin.
    pub fn contacts(&self, row: &[f64]) -> Result<Vec<f64>, StudyError> {
        let extras = self.response(&[])?.extras(row);
        Ok(extras.joints.iter().map(|joint| joint.contacts).collect())
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
        if ready.len() == MAX_READY {
            ready.remove(0);
        }
        ready.push(Ready { loosened: loosened.to_vec(), response: Arc::clone(&response) });
        Ok(response)
    }
}
