//! An epistemic input: a number known to lie between two ends, and nothing else.

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A closed interval, in the unit of the variable.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "(f64, f64)", into = "(f64, f64)")]
pub struct Interval {
    lower: f64,
    upper: f64,
}

/// Errors of an interval.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum IntervalError {
    #[error("interval [{lower}, {upper}]; both ends must be finite")]
    NotFinite { lower: f64, upper: f64 },
    #[error("interval [{lower}, {upper}]; the lower end must not exceed the upper end")]
    TurnedRound { lower: f64, upper: f64 },
}

impl Interval {
    /// The interval from `lower` to `upper`; a single point is allowed.
    ///
    /// # Errors
    ///
    /// [`IntervalError`] where an end is not finite or `lower > upper`.
    pub fn try_new(lower: f64, upper: f64) -> Result<Self, IntervalError> {
        if !lower.is_finite() || !upper.is_finite() {
            return Err(IntervalError::NotFinite { lower, upper });
        }
        if lower > upper {
            return Err(IntervalError::TurnedRound { lower, upper });
        }
        Ok(Self { lower, upper })
    }

    /// The least interval that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    /// The lower end.
    pub fn lower(&self) -> f64 {
        self.lower
    }

    /// The upper end.
    pub fn upper(&self) -> f64 {
        self.upper
    }

    /// The value at `fraction` in \[0, 1\] of the way from the lower end to the upper end; both ends are met exactly.
    pub fn at(&self, fraction: f64) -> f64 {
        if fraction >= 1.0 {
            self.upper
        } else {
            (self.lower + fraction * (self.upper - self.lower)).clamp(self.lower, self.upper)
        }
    }

    /// The fraction of the way from the lower end at which `value` lies, 1/2 where the interval is a single point.
    pub fn fraction_of(&self, value: f64) -> f64 {
        let width = self.upper - self.lower;
        if width > 0.0 { ((value - self.lower) / width).clamp(0.0, 1.0) } else { 0.5 }
    }
}

impl TryFrom<(f64, f64)> for Interval {
    type Error = IntervalError;

    fn try_from((lower, upper): (f64, f64)) -> Result<Self, IntervalError> {
        Self::try_new(lower, upper)
    }
}

impl From<Interval> for (f64, f64) {
    fn from(interval: Interval) -> Self {
        (interval.lower, interval.upper)
    }
}

#[cfg(test)]
mod tests {
    use super::Interval;

    #[test]
    fn a_turned_interval_is_refused_with_both_numbers() {
        let error = Interval::try_new(0.5, 0.1).unwrap_err();
        assert_eq!(error.to_string(), "interval [0.5, 0.1]; the lower end must not exceed the upper end");
        let error = Interval::try_new(f64::NAN, 0.1).unwrap_err();
        assert_eq!(error.to_string(), "interval [NaN, 0.1]; both ends must be finite");
    }

    #[test]
    fn identity_both_ends_are_met_exactly() {
        let interval = Interval::try_new(1.0e-4, 5.0e-4).unwrap();
        assert_eq!((interval.at(0.0), interval.at(1.0)), (1.0e-4, 5.0e-4));
        assert_eq!((interval.fraction_of(1.0e-4), interval.fraction_of(5.0e-4)), (0.0, 1.0));
    }
}
