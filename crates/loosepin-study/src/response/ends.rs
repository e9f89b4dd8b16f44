//! The ends between which play lets a number be, and those of numbers of a curve of such numbers.

use crate::file::Reduction;

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
    let (no_less, no_more) = (f64::NEG_INFINITY, f64::INFINITY);
    let highest = |of: fn(Ends) -> f64| all.clone().map(|(ends, _)| of(ends)).fold(no_less, f64::max);
    let lowest = |of: fn(Ends) -> f64| all.clone().map(|(ends, _)| of(ends)).fold(no_more, f64::min);
    let weights: f64 = all.clone().map(|(_, weight)| weight).sum();
    let mean = |of: fn(Ends) -> f64| all.clone().map(|(ends, weight)| weight * of(ends)).sum::<f64>() / weights;
    let mean_square =
        |of: fn(Ends) -> f64| all.clone().map(|(ends, weight)| weight * of(ends).powi(2)).sum::<f64>() / weights;
    // Nearest to zero, and farthest from it.
    let near: fn(Ends) -> f64 = |ends| ends.lower.max(-ends.upper).max(0.0);
    let far: fn(Ends) -> f64 = |ends| ends.upper.max(-ends.lower);
    let lower: fn(Ends) -> f64 = |ends| ends.lower;
    let upper: fn(Ends) -> f64 = |ends| ends.upper;
    match reduction {
        Reduction::Maximum => Ends { lower: highest(lower), upper: highest(upper) },
        Reduction::Minimum => Ends { lower: lowest(lower), upper: lowest(upper) },
        Reduction::MaximumAbsolute => Ends { lower: highest(near), upper: highest(far) },
        Reduction::RootMeanSquare => Ends { lower: mean_square(near).sqrt(), upper: mean_square(far).sqrt() },
        Reduction::Mean => Ends { lower: mean(lower), upper: mean(upper) },
        Reduction::Range => {
            Ends { lower: (highest(lower) - lowest(upper)).max(0.0), upper: highest(upper) - lowest(lower) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Ends, reduced};
    use crate::file::Reduction;

    /// Two positions, each anywhere in its interval: every reduction against a grid of all places.
    #[test]
    fn analytic_reductions_of_intervals_are_those_of_all_curves() {
        let all = [Ends { lower: -0.4, upper: 0.1 }, Ends { lower: 0.2, upper: 0.5 }, Ends { lower: -0.1, upper: 0.3 }];
        const STEPS: usize = 20;
        let place = |ends: &Ends, k: usize| ends.lower + (ends.upper - ends.lower) * k as f64 / STEPS as f64;
        for reduction in Reduction::ALL {
            let mut found = [f64::INFINITY, f64::NEG_INFINITY];
            for k in 0..(STEPS + 1).pow(3) {
                let steps = [k % (STEPS + 1), k / (STEPS + 1) % (STEPS + 1), k / (STEPS + 1).pow(2)];
                let curve: Vec<f64> = all.iter().zip(steps).map(|(ends, k)| place(ends, k)).collect();
                let max = curve.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let min = curve.iter().copied().fold(f64::INFINITY, f64::min);
                let value = match reduction {
                    Reduction::Maximum => max,
                    Reduction::Minimum => min,
                    Reduction::MaximumAbsolute => max.max(-min),
                    Reduction::RootMeanSquare => (curve.iter().map(|y| y * y).sum::<f64>() / 3.0).sqrt(),
                    Reduction::Mean => curve.iter().sum::<f64>() / 3.0,
                    Reduction::Range => max - min,
                };
                found = [found[0].min(value), found[1].max(value)];
            }
            let ends = reduced(reduction, all.into_iter().map(|ends| (ends, 1.0)));
            let is_near = |a: f64, b: f64| (a - b).abs() < 0.02;
            assert!(is_near(ends.lower, found[0]) && is_near(ends.upper, found[1]), "{reduction:?} {ends:?} {found:?}");
        }
    }
}
