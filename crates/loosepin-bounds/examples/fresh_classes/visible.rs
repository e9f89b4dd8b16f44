//! Which problems are visible: frozen on 2026-11-28, before the first run of these classes.
//!
//! Of each end of each statistic: where it goes more than half of the way from its median over the box to that end, the part of the box is at least
//! 4.6/1024, so that one of the 1024 runs of the mixture lies in it in 99 %. This is the rule of `fresh-bounds` for features that stand out of the scatter of a
//! run. So must what happens in some of the mechanisms. Features that are no higher than that scatter, but than a quarter of it, need 4.6/32; lower ones are hidden.

use super::problem::Problem;
use loosepin_uncertainty::{hash, uniform};

/// Points of the box at which the mean and the deviation are looked at.
const POINTS: u64 = 4096;
const OF_RUNS: f64 = 4.6 / 1024.0;
const OF_FIRST_POINTS: f64 = 4.6 / 32.0;

/// Whether every end of the location is visible, and what happens in few mechanisms only.
pub fn is_visible(problem: &Problem) -> bool {
    if problem.rarest < OF_RUNS {
        return false;
    }
    let at = |point: u64| -> Vec<f64> {
        let ends = problem.case.intervals.iter().enumerate();
        ends.map(|(axis, [low, high])| low + (high - low) * uniform(hash(0x7669_7369, point), axis as u64)).collect()
    };
    let mut values: Vec<f64> = (0..POINTS).map(|point| (problem.location)(&at(point))).collect();
    values.sort_by(f64::total_cmp);
    let median = values[values.len() / 2];
    let [low, high] = problem.location_ends;
    let share = |is_beyond: &dyn Fn(f64) -> bool| {
        values.iter().filter(|value| is_beyond(**value)).count() as f64 / POINTS as f64
    };
    [(low, -1.0), (high, 1.0)].into_iter().all(|(end, sign)| {
        let height = sign * (end - median);
        let least = match height / problem.scatter {
            high if high > 1.0 => OF_RUNS,
            low if low > 0.25 => OF_FIRST_POINTS,
            _ => f64::INFINITY,
        };
        height <= 0.0 || share(&|value| sign * (value - median) > 0.5 * height) >= least
    })
}
