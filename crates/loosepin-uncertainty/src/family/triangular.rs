//! The triangular distribution.

use super::{Family, Tails, finite, ordered};
use crate::variables::distribution::DistributionError;

/// Between two ends, most likely at the mode.
#[derive(Debug)]
pub struct Triangular {
    lower: f64,
    mode: f64,
    upper: f64,
}

impl Triangular {
    pub fn try_new(lower: f64, mode: f64, upper: f64) -> Result<Self, DistributionError> {
        ordered(lower, upper)?;
        finite("mode", mode)?;
        if mode < lower || mode > upper {
            return Err(DistributionError::ModeOutside { mode, lower, upper });
        }
        Ok(Self { lower, mode, upper })
    }
}

impl Family for Triangular {
    fn mean(&self) -> f64 {
        (self.lower + self.mode + self.upper) / 3.0
    }

    fn standard_deviation(&self) -> f64 {
        let (left, right) = (self.mode - self.lower, self.upper - self.mode);
        ((left * left + left * right + right * right) / 18.0).sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        let Self { lower, mode, upper } = *self;
        if x <= lower {
            Tails { below: 0.0, above: 1.0 }
        } else if x >= upper {
            Tails { below: 1.0, above: 0.0 }
        } else if x < mode {
            Tails::at((x - lower) * (x - lower) / ((upper - lower) * (mode - lower)))
        } else {
            let above = (upper - x) * (upper - x) / ((upper - lower) * (upper - mode));
            Tails { below: 1.0 - above, above }
        }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let Self { lower, mode, upper } = *self;
        let width = upper - lower;
        if at.below * width < mode - lower {
            lower + (at.below * width * (mode - lower)).sqrt()
        } else {
            upper - (at.above * width * (upper - mode)).sqrt()
        }
    }
}
