//! The normal distribution.

use super::{Family, Tails, finite, positive};
use crate::functions::normal::normal_cdf;
use crate::variables::distribution::DistributionError;

/// Mean μ and standard deviation σ; F(x) = Φ((x - μ)/σ).
#[derive(Debug)]
pub struct Normal {
    mean: f64,
    standard_deviation: f64,
}

impl Normal {
    pub fn try_new(mean: f64, standard_deviation: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        positive("standard deviation", standard_deviation)?;
        Ok(Self { mean, standard_deviation })
    }
}

impl Family for Normal {
    fn mean(&self) -> f64 {
        self.mean
    }

    fn standard_deviation(&self) -> f64 {
        self.standard_deviation
    }

    fn tails(&self, x: f64) -> Tails {
        let standard = (x - self.mean) / self.standard_deviation;
        Tails { below: normal_cdf(standard), above: normal_cdf(-standard) }
    }

    fn quantile(&self, at: Tails) -> f64 {
        self.mean + self.standard_deviation * at.standard_normal()
    }
}
