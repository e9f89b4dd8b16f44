//! Curves over the recorded turns as one number.

use serde::{Deserialize, Serialize};

/// How a curve over the recorded turns becomes one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reduction {
    /// The largest value, located between the samples.
    Maximum,
    /// The smallest value, located between the samples.
    Minimum,
    /// The largest magnitude, located between the samples.
    MaximumAbsolute,
    /// The root of the mean square.
    #[serde(rename = "rms")]
    RootMeanSquare,
    /// The mean over time.
    Mean,
    /// Maximum minus minimum.
    Range,
}

impl Reduction {
    /// Every reduction, in the order in which study files name them.
    pub const ALL: [Self; 6] =
        [Self::Maximum, Self::Minimum, Self::MaximumAbsolute, Self::RootMeanSquare, Self::Mean, Self::Range];

    /// The word used in study files and in results.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Maximum => "maximum",
            Self::Minimum => "minimum",
            Self::MaximumAbsolute => "maximum_absolute",
            Self::RootMeanSquare => "rms",
            Self::Mean => "mean",
            Self::Range => "range",
        }
    }

    /// Whether no curve gives a larger number than by `other`: min <= mean <= max <= max|.|, and mean <= rms <= max|.| by the inequality of
    /// Cauchy and Schwarz.
    pub const fn never_exceeds(self, other: Self) -> bool {
        matches!(
            (self, other),
            (Self::Minimum, Self::Mean | Self::Maximum | Self::RootMeanSquare | Self::MaximumAbsolute)
                | (Self::Mean, Self::Maximum | Self::RootMeanSquare | Self::MaximumAbsolute)
                | (Self::Maximum | Self::RootMeanSquare, Self::MaximumAbsolute)
        )
    }

    /// How far a point of a curve between these ends may take the number, in its direction: the point that can take it furthest decides it.
    /// `None` of numbers that all points make.
    pub fn reach(self, [lower, upper]: [f64; 2]) -> Option<f64> {
        match self {
            Self::Maximum => Some(upper),
            Self::Minimum => Some(-lower),
            Self::MaximumAbsolute => Some(upper.max(-lower)),
            Self::RootMeanSquare | Self::Mean | Self::Range => None,
        }
    }

    /// Whether no curve gives a negative number.
    pub const fn is_never_negative(self) -> bool {
        matches!(self, Self::MaximumAbsolute | Self::RootMeanSquare | Self::Range)
    }
}

#[cfg(test)]
mod tests {
    use super::Reduction;

    #[test]
    fn analytic_an_extreme_is_decided_by_the_end_that_it_is_about() {
        let reach = |reduction: Reduction| reduction.reach([-3.0, 2.0]);
        let reaches = Reduction::ALL.map(reach);
        assert_eq!(reaches, [Some(2.0), Some(3.0), Some(3.0), None, None, None]);
    }

    #[test]
    fn analytic_reductions_of_curves_are_in_the_order_that_is_stated() {
        let curves = [vec![-3.0, 0.5, 2.0], vec![-4.0, -3.5, -0.25], vec![0.75, 1.5, 6.0], vec![-2.5, -2.5, -2.5]];
        for curve in curves {
            let reduced = |reduction| match reduction {
                Reduction::Maximum => curve.iter().copied().fold(f64::NEG_INFINITY, f64::max),
                Reduction::Minimum => curve.iter().copied().fold(f64::INFINITY, f64::min),
                Reduction::MaximumAbsolute => curve.iter().copied().map(f64::abs).fold(0.0, f64::max),
                Reduction::RootMeanSquare => (curve.iter().map(|y| y * y).sum::<f64>() / curve.len() as f64).sqrt(),
                Reduction::Mean => curve.iter().sum::<f64>() / curve.len() as f64,
                Reduction::Range => f64::NAN,
            };
            for (a, b) in Reduction::ALL.into_iter().flat_map(|a| Reduction::ALL.into_iter().map(move |b| (a, b))) {
                assert!(!a.never_exceeds(b) || reduced(a) <= reduced(b), "{a:?} {b:?} {curve:?}");
            }
        }
    }
}
