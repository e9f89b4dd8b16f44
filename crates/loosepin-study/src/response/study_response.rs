//! A study as a function from uncertain inputs to numbers: what the uncertainty wing sees. What is asked of it is [`KindOfResponse`]; which one
//! a model has is decided here alone.

use crate::file::Study;
use crate::model::StudyModel;
use crate::response::kind::{KindOfResponse, WaitingRun};
use crate::response::planar_response::PlanarResponse;
use crate::response::problem::PrepareError;
use crate::response::spatial_response::SpatialResponse;
use loosepin_bounds::{Failure, Response};
use loosepin_simulate::{Execution, RunFailure};
use loosepin_text::numbers::QuantityId;
use std::ops::{Deref, DerefMut};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// A prepared study.
#[derive(Debug)]
pub struct StudyResponse(Box<dyn KindOfResponse>);

impl Deref for StudyResponse {
    type Target = dyn KindOfResponse;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

impl DerefMut for StudyResponse {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut *self.0
    }
}

impl StudyResponse {
    /// Prepares `study`.
    ///
    /// # Errors
    /// The nominal mechanism has no ideal motion over the recorded part.
    pub fn new(study: &Study) -> Result<Self, PrepareError> {
        Self::with_plays(study, &[])
    }

    /// As [`Self::new`], with the joints with play that the values `at` of inputs give. All else is that of the nominal mechanism: what
    /// deviations are measured against, and the columns.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub(crate) fn with_plays(study: &Study, at: &[(QuantityId, f64)]) -> Result<Self, PrepareError> {
        match &study.model {
            StudyModel::Planar(model) => PlanarResponse::with_plays(study, model, at).map(Self::of),
            StudyModel::Spatial(model) => SpatialResponse::new(study, model).map(Self::of),
        }
    }

    /// The response that `own` is.
    pub(crate) fn of(own: impl KindOfResponse + 'static) -> Self {
        Self(Box::new(own))
    }

    /// Runs on this thread until `next` gives no more inputs, all of them of the kind `variant`; `finished` gets the rows, or the one reason
    /// why a run failed, under the index that came with the inputs. A row has the same bits whatever the thread. Once `stop` is set, a life of
    /// wear ends as [`RunFailure::Stopped`]. Returns how long the preparation of each run took, where that is another thing than the run.
    pub fn run_all_until<'i>(
        &self,
        variant: usize,
        execution: Execution,
        stop: &AtomicBool,
        mut next: impl FnMut() -> Option<WaitingRun<'i>>,
        mut finished: impl FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration> {
        self.0.run_waiting(variant, execution, stop, &mut next, &mut finished)
    }
}

impl Response for StudyResponse {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        self.run(random, epistemic, columns).map_err(|failure| Failure(failure.number()))
    }
}
