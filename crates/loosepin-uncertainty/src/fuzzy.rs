//! Fuzzy numbers: nested intervals, one for each degree of possibility.

use thiserror::Error;

use super::interval::Interval;

/// Degrees at which a fuzzy number is cut where nothing else is said.
pub const USUAL_CUTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// A fuzzy number by its α-cuts: the values possible to at least the degree α. Higher cuts lie within lower ones.
///
/// L. A. Zadeh, "Fuzzy sets as a basis for a theory of possibility", Fuzzy Sets and Systems 1 (1978) 3-28.
#[derive(Debug, Clone, PartialEq)]
pub struct FuzzyNumber {
    cuts: Vec<(f64, Interval)>,
}

/// Errors of a fuzzy number.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum FuzzyError {
    #[error("a fuzzy number without a cut; give at least one")]
    Empty,
    #[error("cut at {alpha}; must lie between 0 and 1")]
    Degree { alpha: f64 },
    /// What is possible at all is not among the cuts.
    #[error("the first degree is {alpha}; must be 0, the values that are possible at all")]
    NoSupport { alpha: f64 },
    #[error("cut at {second} after {first}; the degrees must increase")]
    DegreesNotIncreasing { first: f64, second: f64 },
    #[error(
        "the cut [{lower}, {upper}] at {alpha} is not within [{outer_lower}, {outer_upper}] at {outer_alpha}; cuts must be nested"
    )]
    NotNested {
        alpha: f64,
        lower: f64,
        upper: f64,
        /// Degree of the outer cut.
        outer_alpha: f64,
        outer_lower: f64,
        outer_upper: f64,
    },
    #[error("corners {first} and {second}; each must not lie below the one before")]
    Corners { first: f64, second: f64 },
}

impl FuzzyNumber {
    /// The fuzzy number of these cuts, degrees increasing from 0: what is possible at all.
    ///
    /// # Errors
    ///
    /// [`FuzzyError`] where degrees do not begin at 0 and increase within \[0, 1\] or a cut is not within the one before.
    pub fn try_new(cuts: Vec<(f64, Interval)>) -> Result<Self, FuzzyError> {
        if cuts.is_empty() {
            return Err(FuzzyError::Empty);
        }
        for &(alpha, _) in &cuts {
            if !(0.0..=1.0).contains(&alpha) {
                return Err(FuzzyError::Degree { alpha });
            }
        }
        if cuts[0].0 > 0.0 {
            return Err(FuzzyError::NoSupport { alpha: cuts[0].0 });
        }
        for pair in cuts.windows(2) {
            let [(outer_alpha, outer), (alpha, inner)] = [pair[0], pair[1]];
            if alpha <= outer_alpha {
                return Err(FuzzyError::DegreesNotIncreasing { first: outer_alpha, second: alpha });
            }
            if inner.lower() < outer.lower() || inner.upper() > outer.upper() {
                return Err(FuzzyError::NotNested {
                    alpha,
                    lower: inner.lower(),
                    upper: inner.upper(),
                    outer_alpha,
                    outer_lower: outer.lower(),
                    outer_upper: outer.upper(),
                });
            }
        }
        Ok(Self { cuts })
    }

    /// The cuts at `degrees` of the trapezoid that rises from `corners[0]` to `corners[1]` and falls from `corners[2]` to
    /// `corners[3]`; a triangle has both in the middle equal.
    ///
    /// # Errors
    ///
    /// [`FuzzyError`] where corners or degrees do not increase.
    pub fn trapezoidal(corners: [f64; 4], degrees: &[f64]) -> Result<Self, FuzzyError> {
        for pair in corners.windows(2) {
            // What is not a number is no corner either.
            if !(pair[0] <= pair[1]) {
                return Err(FuzzyError::Corners { first: pair[0], second: pair[1] });
            }
        }
        let [a, b, c, d] = corners;
        let cut = |alpha: f64| -> Result<(f64, Interval), FuzzyError> {
            let lower = if alpha < 1.0 { a + alpha * (b - a) } else { b };
            let upper = if alpha < 1.0 { d - alpha * (d - c) } else { c };
            let interval =
                Interval::try_new(lower, upper).map_err(|_| FuzzyError::Corners { first: lower, second: upper })?;
            Ok((alpha, interval))
        };
        Self::try_new(degrees.iter().map(|&alpha| cut(alpha)).collect::<Result<_, _>>()?)
    }

    /// The cuts, degrees increasing, each within the one before.
    pub fn cuts(&self) -> &[(f64, Interval)] {
        &self.cuts
    }

    /// The widest cut.
    pub fn support(&self) -> Interval {
        self.cuts[0].1
    }

    /// The values possible to at least the degree `alpha`, from the cut at or next below it: never narrower than they are.
    pub fn cut(&self, alpha: f64) -> Interval {
        self.cuts.iter().rev().find(|cut| cut.0 <= alpha).unwrap_or(&self.cuts[0]).1
    }

    /// The value at `fraction` in \[0, 1\] when the middle of each pair of cuts is taken by the difference of their degrees and its values as
    /// uniform: the distribution that a possibility stands for when ignorance is spread evenly (D. Dubois, H. Prade and S. Sandri,
    /// "On possibility/probability transformations", 1993), by its cuts.
    pub fn at(&self, fraction: f64) -> f64 {
        let mut rest = fraction * self.cuts.last().map_or(0.0, |cut| cut.0);
        let mut below = 0.0;
        for (alpha, interval) in &self.cuts {
            let share = alpha - below;
            if share > 0.0 && rest <= share {
                return interval.at(rest / share);
            }
            rest -= share;
            below = *alpha;
        }
        // A single cut at 0, or round-off at the end.
        self.cuts.last().map_or(f64::NAN, |cut| cut.1.at(fraction))
    }
}

#[cfg(test)]
mod tests {
    use super::{FuzzyNumber, USUAL_CUTS};
    use crate::Interval;

    #[test]
    fn analytic_cuts_of_a_trapezoid() {
        let fuzzy = FuzzyNumber::trapezoidal([1.5, 2.5, 3.0, 5.0], &USUAL_CUTS).unwrap();
        let ends: Vec<(f64, f64)> = fuzzy.cuts().iter().map(|(_, cut)| (cut.lower(), cut.upper())).collect();
        assert_eq!(ends, [(1.5, 5.0), (1.75, 4.5), (2.0, 4.0), (2.25, 3.5), (2.5, 3.0)]);
        assert_eq!(fuzzy.cut(0.6), Interval::try_new(2.0, 4.0).unwrap());
    }

    #[test]
    fn what_is_not_nested_is_refused_with_its_numbers() {
        let interval = |lower, upper| Interval::try_new(lower, upper).unwrap();
        let refused = |cuts: Vec<(f64, Interval)>| FuzzyNumber::try_new(cuts).unwrap_err().to_string();
        assert_eq!(
            refused(vec![(0.0, interval(2.0, 3.0)), (0.75, interval(2.5, 3.5))]),
            "the cut [2.5, 3.5] at 0.75 is not within [2, 3] at 0; cuts must be nested"
        );
        assert_eq!(
            refused(vec![(0.0, interval(2.0, 3.0)), (0.0, interval(2.0, 3.0))]),
            "cut at 0 after 0; the degrees must increase"
        );
        assert_eq!(
            refused(vec![(0.25, interval(2.0, 3.0)), (1.0, interval(2.5, 2.75))]),
            "the first degree is 0.25; must be 0, the values that are possible at all"
        );
        assert_eq!(
            FuzzyNumber::trapezoidal([2.5, 1.5, 3.0, 5.0], &USUAL_CUTS).unwrap_err().to_string(),
            "corners 2.5 and 1.5; each must not lie below the one before"
        );
    }

    #[test]
    fn identity_as_probability_every_value_lies_in_the_support_and_half_of_a_symmetric_one_below_its_middle() {
        let fuzzy = FuzzyNumber::trapezoidal([1.5, 2.5, 2.5, 3.5], &USUAL_CUTS).unwrap();
        let values: Vec<f64> = (0..400).map(|step| fuzzy.at((f64::from(step) + 0.5) / 400.0)).collect();
        assert!(values.iter().all(|value| (1.5..=3.5).contains(value)));
        let below = values.iter().filter(|&&value| value < 2.5).count();
        // The cut at 1 is a point, the middle itself: a quarter of the mass.
        assert!((below as f64 - 150.0).abs() < 3.0, "{below}");
    }
}
