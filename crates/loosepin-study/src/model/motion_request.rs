//! What is asked of a motion without dynamics.

use loosepin_mechanics::model::CycleSpan;
use loosepin_simulate::accuracy::{AskedPose, Scatter, ScatterCorrelation};
use std::sync::atomic::{AtomicBool, Ordering};

/// A motion over one turn.
pub struct MotionRequest<'r> {
    /// Steps of the turn, where the file of the model does not say how many.
    pub positions: usize,
    /// Settings `path=value`.
    pub settings: Vec<String>,
    /// Names of further points whose paths are asked for.
    pub paths: &'r [String],
    /// What scatters.
    pub scatter: Vec<Scatter>,
    /// How that goes together.
    pub correlations: Vec<ScatterCorrelation>,
    /// Poses that a study asks about.
    pub asked: Vec<AskedPose>,
    /// What the study counts by: its angle gives these poses.
    pub asked_span: CycleSpan,
    /// Whether worst cases are searched and their ends proven, as far as that can be done.
    pub has_worst_cases: bool,
    /// Set where nobody waits any longer.
    pub stop: &'r AtomicBool,
}

impl MotionRequest<'_> {
    /// Whether nobody waits any longer.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
