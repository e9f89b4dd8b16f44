//! Runs that wait for a lane.

use crate::failure::RunFailure;
use crate::follow::FollowedRun;
use crate::observer::Observer;
use crate::recording::report::RunReport;
use crate::resume::MotionState;
use crate::settings::Window;
use loosepin_mechanics::mechanism::{Arms, Sample};

/// A run that waits for a lane.
pub struct Run<O> {
    /// All its numbers.
    pub sample: Sample<f64>,
    /// Positions of its points in their bodies: for the followed outputs.
    pub arms: Arms,
    /// The recorded part.
    pub window: Window,
    /// Who looks at it.
    pub observer: O,
    /// Its references, and its instants of reading.
    pub followed: FollowedRun,
    /// State from which it resumes; without, it starts at time zero in the ideal position.
    pub resume: Option<MotionState>,
}

/// Runs that wait for a lane, and where they go when they are over.
pub trait Queue {
    /// Who looks at a run.
    type Observer: Observer;

    /// The next run, if any is left.
    fn next(&mut self) -> Option<Run<Self::Observer>>;
    /// Takes back the observer of a run that is over.
    fn finished(&mut self, observer: Self::Observer, outcome: Result<RunReport, RunFailure>);
}
