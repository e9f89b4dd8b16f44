//! The run that a run is compared with.

use std::sync::atomic::{AtomicBool, Ordering};

use super::positions::PositionHistory;
use crate::engine::run_from;
use crate::failure::RunFailure;
use crate::lanes::batch::CompiledCodeCache;
use crate::observer::{Observer, Step};
use crate::resume::MotionState;
use crate::settings::{Settings, Window};
use loosepin_math::integrate::TSITOURAS_5;
use loosepin_mechanics::mechanism::{Mechanism, Sample};

/// Tolerance of the second run over that of the first.
const TOLERANCE_SHARE: f64 = 0.1;
/// No tolerance below this, m: steps of order five drown in round-off.
const MIN_TOLERANCE_M: f64 = 1e-12;

/// Settings of the run that one with `settings` is compared with: a tenth of the tolerance, and a method of another order, so that both do not err
/// alike. Implicit steps stay implicit: what asks for them cannot be followed by others.
pub(super) fn second_settings(settings: &Settings) -> Settings {
    let tolerance_m = (TOLERANCE_SHARE * settings.tolerance_m).max(MIN_TOLERANCE_M.min(settings.tolerance_m));
    Settings { tolerance_m, method: &TSITOURAS_5, ..*settings }
}

/// How a second run went.
#[derive(Debug, Clone)]
pub struct SecondRun {
    /// Largest distances from the first run at its instants, m, as far as the second came.
    pub differences_m: Vec<f64>,
    /// Why it came to no end; `None` if it did, or parted from the first run.
    pub failure: Option<RunFailure>,
    /// Evaluations of the equations of motion, where it came to its end.
    pub evaluations: Option<u64>,
}

/// Runs `sample` again with `settings`, from `start` or from its initial state, beside the positions of `first`, until a distance exceeds `parted_m`.
///
/// # Errors
/// It was stopped by `stop`.
pub fn compare_positions(
    (mechanism, sample): (&Mechanism, &Sample<f64>),
    (window, settings): (&Window, &Settings),
    (start, first): (Option<&MotionState>, &PositionHistory),
    parted_m: f64,
    stop: &AtomicBool,
) -> Result<SecondRun, RunFailure> {
    let mut beside = Beside { first, parted_m, stop, differences_m: Vec::new(), read_m: Vec::new() };
    let mut code = CompiledCodeCache::default();
    let outcome = run_from(mechanism, sample, (window, settings), start.cloned(), &mut code, &mut beside);
    let has_parted = beside.has_parted();
    match outcome {
        Err(failure @ RunFailure::Stopped { .. }) if !has_parted => Err(failure),
        Err(failure) => Ok(SecondRun {
            differences_m: beside.differences_m,
            failure: Some(failure).filter(|_| !has_parted),
            evaluations: None,
        }),
        Ok(report) => Ok(SecondRun {
            differences_m: beside.differences_m,
            failure: None,
            evaluations: Some(report.counters.evaluations),
        }),
    }
}

/// Compares each step with another run.
struct Beside<'a> {
    first: &'a PositionHistory,
    parted_m: f64,
    stop: &'a AtomicBool,
    differences_m: Vec<f64>,
    read_m: Vec<f64>,
}

impl Beside<'_> {
    fn has_parted(&self) -> bool {
        self.differences_m.last().is_some_and(|&difference_m| difference_m > self.parted_m)
    }
}

impl Observer for Beside<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        while !self.has_parted()
            && self.first.times_s().get(self.differences_m.len()).is_some_and(|&time_s| time_s <= step.end_s)
        {
            let Some(difference_m) = self.first.difference_m(self.differences_m.len(), step, &mut self.read_m) else {
                return;
            };
            self.differences_m.push(difference_m);
        }
    }

    fn awaits_s(&self) -> f64 {
        self.first.times_s().get(self.differences_m.len()).copied().unwrap_or(f64::INFINITY)
    }

    fn is_stopped(&self) -> bool {
        self.has_parted() || self.stop.load(Ordering::Relaxed)
    }
}
