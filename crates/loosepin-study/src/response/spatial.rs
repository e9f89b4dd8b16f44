//! What the response of a mechanism in space says of itself: its positions are closed, without dynamics.

use crate::file::Study;
use crate::response::columns::ColumnPlan;
use crate::response::kind::{KindOfResponse, WaitingRun};
use crate::response::linear_scatter::LinearScatter;
use crate::response::spatial_response::SpatialResponse;
use loosepin_simulate::{Execution, RunFailure};
use loosepin_text::numbers::{QuantityError, Values};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

impl KindOfResponse for SpatialResponse {
    fn plan(&self) -> &ColumnPlan {
        &self.plan
    }

    fn nominal(&self) -> &Values {
        &self.nominal
    }

    fn nominal_at_pose(&self) -> &[f64] {
        &self.nominal_at_pose
    }

    fn recorded_turns(&self) -> f64 {
        self.recorded_turns
    }

    fn values(&self, random: &[f64], epistemic: &[f64]) -> Result<Values, QuantityError> {
        SpatialResponse::values(self, random, epistemic)
    }

    fn run(&self, random: &[f64], epistemic: &[f64], row: &mut [f64]) -> Result<(), RunFailure> {
        self.row(random, epistemic).map(|own| row.copy_from_slice(&own))
    }

    fn run_waiting<'i>(
        &self,
        _variant: usize,
        _execution: Execution,
        _stop: &AtomicBool,
        next: &mut dyn FnMut() -> Option<WaitingRun<'i>>,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, RunFailure>),
    ) -> Vec<Duration> {
        while let Some((index, random, epistemic)) = next() {
            finished(index, self.row(random, epistemic));
        }
        Vec::new()
    }

    fn linear_scatter(&self, study: &Study) -> Option<LinearScatter> {
        // Places of journals that are drawn add a variance that is no part of this.
        if study.journals.is_some() { None } else { SpatialResponse::linear_scatter(self, study) }
    }

    fn variances(&self, scatter: &LinearScatter, column: usize) -> Vec<f64> {
        SpatialResponse::variances(self, scatter, column)
    }

    fn without_scatter(&self, epistemic: &[f64]) -> Option<Vec<f64>> {
        SpatialResponse::without_scatter(self, epistemic).ok()
    }
}
