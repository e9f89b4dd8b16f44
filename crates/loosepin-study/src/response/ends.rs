//! The ends between which play lets a number be, and those of numbers of a curve of such numbers.

use crate::file::Reduction;
use loosepin_result::study::{Course, CourseEnds};

/// The ends between which play lets a number be.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ends {
    /// The smallest value.
    pub lower: f64,
    /// The largest value.
    pub upper: f64,
}

impl Ends {
    /// A number that play does not change.
    pub fn of(value: f64) -> Self {
        Self { lower: value, upper: value }
    }

    /// The number at a place `play` from -1, the lower end, to 1, the upper one:
    ///
    /// ```text
    /// lower + (upper - lower) (1 + play)/2
    /// ```
    pub fn at(&self, play: f64) -> f64 {
        self.lower + (self.upper - self.lower) * (0.5 * (1.0 + play))
    }
}

/// A number of the curve, each position anywhere between its ends; with the weight of each position in means.
pub(crate) fn reduced(reduction: Reduction, all: impl Iterator<Item = (Ends, f64)> + Clone) -> Ends {
    let weights: f64 = all.clone().map(|(_, weight)| weight).sum();
    let of = |value: fn(Ends) -> f64| {
        let values = || all.clone().map(|(ends, weight)| (value(ends), weight));
        Course {
            largest: values().map(|(value, _)| value).fold(f64::NEG_INFINITY, f64::max),
            smallest: values().map(|(value, _)| value).fold(f64::INFINITY, f64::min),
            mean: values().map(|(value, weight)| weight * value).sum::<f64>() / weights,
            mean_square: values().map(|(value, weight)| weight * value.powi(2)).sum::<f64>() / weights,
        }
    };
    let [lower, upper] = reduction.ends(&CourseEnds {
        lower: of(|ends| ends.lower),
        upper: of(|ends| ends.upper),
        near: of(|ends| ends.lower.max(-ends.upper).max(0.0)),
        far: of(|ends| ends.upper.max(-ends.lower)),
    });
    Ends { lower, upper }
}
