//! The lognormal distribution.

use super::{Family, Tails, positive};
use crate::variables::distribution::DistributionError;

/// By mean m and standard deviation s of the variable itself; ln X is normal with σ² = ln(1 + s²/m²), μ = ln m - σ²/2.
#[derive(Debug)]
pub struct Lognormal {
    mean: f64,
    standard_deviation: f64,
    location: f64,
    scale: f64,
}

impl Lognormal {
    pub fn try_new(mean: f64, standard_deviation: f64) -> Result<Self, DistributionError> {
        positive("mean", mean)?;
        positive("standard deviation", standard_deviation)?;
        let ratio = standard_deviation / mean;
        let variance = libm::log1p(ratio * ratio);
        let (location, scale) = (libm::log(mean) - 0.5 * variance, variance.sqrt());
        Ok(Self { mean, standard_deviation, location, scale })
    }
}

impl Family for Lognormal {
    fn mean(&self) -> f64 {
        self.mean
    }

    fn standard_deviation(&self) -> f64 {
        self.standard_deviation
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= 0.0 {
            return Tails { below: 0.0, above: 1.0 };
        }
        Tails::of_standard_normal((libm::log(x) - self.location) / self.scale)
    }

    fn quantile(&self, at: Tails) -> f64 {
        libm::exp(self.location + self.scale * at.standard_normal())
    }
}
