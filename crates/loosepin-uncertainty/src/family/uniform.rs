//! The uniform distribution.

use super::{Family, Tails, ordered};
use crate::variables::distribution::DistributionError;

/// Between two ends.
#[derive(Debug)]
pub struct Uniform {
    lower: f64,
    upper: f64,
}

impl Uniform {
    pub fn try_new(lower: f64, upper: f64) -> Result<Self, DistributionError> {
        ordered(lower, upper)?;
        Ok(Self { lower, upper })
    }
}

impl Family for Uniform {
    fn mean(&self) -> f64 {
        0.5 * (self.lower + self.upper)
    }

    fn standard_deviation(&self) -> f64 {
        (self.upper - self.lower) / 12.0_f64.sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        let width = self.upper - self.lower;
        Tails { below: ((x - self.lower) / width).clamp(0.0, 1.0), above: ((self.upper - x) / width).clamp(0.0, 1.0) }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let width = self.upper - self.lower;
        if at.below < 0.5 { self.lower + at.below * width } else { self.upper - at.above * width }
    }
}
