//! Number of standard deviations σ by which the surrogate is taken to err where errors average out.
//!
//! A quantile or a probability moves furthest where every run errs as much as the worst one, to the same side: by the k of the group.
//! A mean moves by the mean of the error over X, and a deviation by that of the error at most; direct runs at the witnesses
//! show both, and how much of the error is the same at all X, so that it does not average out at any other u either.
//!
//! The distance from the bound on ŝ to that on the band grows at least in proportion to k (the end of a mean is the greatest of straight
//! lines in k, one for each u; that of a deviation moves by k times the largest σ̄), so that for a smaller k the same share of it is enough.

use super::confirm::Confirmed;
use super::plan::SurrogatePlan;
use loosepin_terms::{ErrorEffect, Estimation, Statistic};

/// k is at least so many times the largest error that direct runs have shown, in σ.
pub(crate) const MARGIN: f64 = 1.5;
/// Least error of the surrogate in a mean, in units of its largest σ over X, and in a deviation, in units of σ̄, whatever direct runs have
/// shown.
const MIN_REACH_OF_MEAN: f64 = 1.0;
const MIN_REACH_OF_DEVIATION: f64 = 2.0;

/// The k of statistics over that of their group: 1 at most.
pub(crate) struct SharesOfReach {
    of_mean: f64,
    of_deviation: f64,
}

impl SharesOfReach {
    /// Shares by the direct runs `confirmed`, where the group has `places` and the k `reach`. As `reach` itself, it is told by the worst place of a curve;
    /// all is 1 where what belongs to one u says nothing of a statistic.
    pub fn new(plan: &SurrogatePlan, confirmed: &[Confirmed], places: usize, reach: f64) -> Self {
        if !plan.is_at_single_values() || confirmed.is_empty() || !reach.is_finite() {
            return Self { of_mean: 1.0, of_deviation: 1.0 };
        }
        let worst = |of_place: &dyn Fn(usize) -> f64| (0..places).map(of_place).fold(0.0, f64::max);
        let largest = |shift: &dyn Fn(&Confirmed, usize) -> f64| {
            MARGIN * worst(&|place| confirmed.iter().map(|at| shift(at, place)).fold(0.0, f64::max))
        };
        let mean = largest(&|at, place| at.shift_of_mean(place, &plan.direct.setup.confidence));
        let deviation = largest(&|at, place| at.shift_of_deviation(place));
        let at_all_x = reach * worst(&|place| share_at_all_x(confirmed, place));
        Self {
            of_mean: (MIN_REACH_OF_MEAN.max(mean).max(at_all_x) / reach).min(1.0),
            of_deviation: (MIN_REACH_OF_DEVIATION.max(deviation) / reach).min(1.0),
        }
    }

    /// The reach of `statistic`.
    pub fn of(&self, statistic: Statistic) -> f64 {
        match (statistic.estimation(), statistic.effect_of_errors()) {
            (Some(Estimation::Mean), _) => self.of_mean,
            (_, ErrorEffect::RootMeanSquare) => self.of_deviation,
            _ => 1.0,
        }
    }
}

/// Share of the root mean square error at `place` that is the same at all X, over all witnesses: √(Σ E(g - ŝ)²/Σ E((g - ŝ)²)). All of it
/// where runs are missing.
fn share_at_all_x(confirmed: &[Confirmed], place: usize) -> f64 {
    let squares: Option<Vec<[f64; 2]>> = confirmed.iter().map(|at| at.squares(place)).collect();
    let sum = |squares: &[[f64; 2]], of: usize| squares.iter().map(|both| both[of]).sum::<f64>();
    squares.map_or(1.0, |squares| match sum(&squares, 1) {
        all if all > 0.0 => (sum(&squares, 0) / all).sqrt(),
        _ => 0.0,
    })
}
