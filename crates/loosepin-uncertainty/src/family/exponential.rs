//! The exponential distribution.

use super::weibull::hazard;
use super::{Family, Tails, finite};
use crate::variables::distribution::DistributionError;

/// From a lower end x0 on, with mean m: P(X > x) = exp(-(x - x0)/(m - x0)).
#[derive(Debug)]
pub struct Exponential {
    mean: f64,
    lower: f64,
}

impl Exponential {
    pub fn try_new(mean: f64, lower: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        finite("lower end", lower)?;
        if mean > lower { Ok(Self { mean, lower }) } else { Err(DistributionError::MeanBelowEnd { mean, lower }) }
    }
}

impl Family for Exponential {
    fn mean(&self) -> f64 {
        self.mean
    }

    fn standard_deviation(&self) -> f64 {
        self.mean - self.lower
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= self.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        let hazard = (x - self.lower) / (self.mean - self.lower);
        Tails { below: -libm::expm1(-hazard), above: libm::exp(-hazard) }
    }

    fn quantile(&self, at: Tails) -> f64 {
        self.lower + (self.mean - self.lower) * hazard(at)
    }
}
