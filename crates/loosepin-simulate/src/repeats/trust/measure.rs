//! How long a recorded run can be trusted.

use std::sync::atomic::AtomicBool;

use super::horizon::{SHARE, horizon, lengths_m};
use super::positions::PositionHistory;
use super::second_run::{compare_positions, second_settings};
use crate::failure::RunFailure;
use crate::recording::report::RunReport;
use crate::resume::MotionState;
use crate::settings::{Settings, Window};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_result::simulation::{MeasuredTrust, Trust};

/// Evaluations of a second run over those of the first, at most: in a mechanism whose contacts last, order five takes three times as many.
const MAX_WORK: u64 = 10;
/// Evaluations that it may have in any case.
const MIN_EVALUATIONS: u64 = 1_000_000;
/// Differences that are kept, at most.
const MAX_DIFFERENCES: usize = 720;

/// Measures how long the positions of `first`, which come from a run of `sample` with `settings` over `window`, can be trusted. A turn takes
/// `turn_s`; `report` is that of the run, and `start` the state that it began from, if that was the end of another one.
///
/// # Errors
/// It was stopped by `stop`.
pub fn measure_trust(
    (mechanism, sample): (&Mechanism, &Sample<f64>),
    (window, turn_s): (&Window, f64),
    settings: &Settings,
    (start, first, report): (Option<&MotionState>, &PositionHistory, &RunReport),
    stop: &AtomicBool,
) -> Result<Trust, RunFailure> {
    if mechanism.is_ideal() {
        return Ok(Trust::Solved);
    }
    let clearances = sample.plays.iter().map(|play| play.clearance_m).filter(|&clearance_m| clearance_m > 0.0);
    let lengths_m = lengths_m(clearances.min_by(f64::total_cmp), mechanism.size_m);
    let parted_m = SHARE * lengths_m[0];
    let work = (MAX_WORK * report.counters.evaluations).max(MIN_EVALUATIONS);
    let mut second = second_settings(settings);
    second.largest_evaluations = work.min(settings.largest_evaluations);
    let found = compare_positions((mechanism, sample), (window, &second), (start, first), parted_m, stop)?;
    let times_s = &first.times_s()[..found.differences_m.len()];
    let is_whole = times_s.len() == first.times_s().len();
    let largest_m = found.differences_m.iter().copied().fold(0.0, f64::max);
    let whole_m = (is_whole && largest_m <= parted_m).then(|| (largest_m / SHARE).max(settings.tolerance_m));
    let (time_s, difference_m) = thinned(times_s, &found.differences_m);
    Ok(Trust::Measured(MeasuredTrust {
        tolerance_m: second.tolerance_m,
        method: second.method_name(),
        evaluations: found.evaluations,
        share: SHARE,
        horizons: lengths_m
            .iter()
            .map(|&length_m| horizon(length_m, times_s, &found.differences_m, is_whole, turn_s))
            .collect(),
        whole_m,
        failure: found.failure.map(|failure| failure.to_string()),
        time_s,
        difference_m,
    }))
}

/// The largest differences of spans of equal length, and the instants at which these end.
fn thinned(times_s: &[f64], differences_m: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let span = times_s.len().div_ceil(MAX_DIFFERENCES).max(1);
    let times_s = times_s.chunks(span).filter_map(|span| span.last().copied());
    let differences_m = differences_m.chunks(span).map(|span| span.iter().copied().fold(0.0, f64::max));
    (times_s.collect(), differences_m.collect())
}
