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
pub(crate) fn reduced(reduction: Reduction, all: impl Iterator<Item = (Ends, f64)>) -> Ends {
    let all: Vec<(Ends, f64)> = all.collect();
    let weights: f64 = all.iter().map(|(_, weight)| weight).sum();
    let of = |value: fn(Ends) -> f64| {
        let (mut largest, mut smallest, mut sum, mut square) = (f64::NEG_INFINITY, f64::INFINITY, 0.0, 0.0);
        for (ends, weight) in &all {
            let value = value(*ends);
            (largest, smallest) = (f64::max(largest, value), f64::min(smallest, value));
            sum += weight * value;
            square += weight * value.powi(2);
        }
        Course { largest, smallest, mean: sum / weights, mean_square: square / weights }
    };
    let [lower, upper] = reduction.ends(&CourseEnds {
        lower: of(|ends| ends.lower),
        upper: of(|ends| ends.upper),
        near: of(|ends| ends.lower.max(-ends.upper).max(0.0)),
        far: of(|ends| ends.upper.max(-ends.lower)),
    });
    Ends { lower, upper }
}

#[cfg(test)]
mod tests {
    use super::{Ends, reduced};
    use crate::file::Reduction;

    #[test]
    fn analytic_weights_count_in_means_and_magnitudes_end_at_zero() {
        let all = || [(Ends { lower: -2.0, upper: 1.0 }, 1.0), (Ends { lower: 3.0, upper: 4.0 }, 3.0)].into_iter();
        for (reduction, lower, upper) in [
            (Reduction::Maximum, 3.0, 4.0),
            (Reduction::Minimum, -2.0, 1.0),
            (Reduction::MaximumAbsolute, 3.0, 4.0),
            (Reduction::RootMeanSquare, (27.0_f64 / 4.0).sqrt(), 13.0_f64.sqrt()),
            (Reduction::Mean, 7.0 / 4.0, 13.0 / 4.0),
            (Reduction::Range, 2.0, 6.0),
        ] {
            let found = reduced(reduction, all());
            assert_eq!((found.lower, found.upper), (lower, upper), "{reduction:?}");
        }
    }
}
