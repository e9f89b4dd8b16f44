//! The gamma distribution.

use super::{Family, Tails, finite, positive};
use crate::functions::incomplete_gamma::{incomplete_gamma, inverse_incomplete_gamma};
use crate::variables::distribution::DistributionError;

/// Shape k, scale θ, from a lower end x0 on: P(X <= x) = P(k, (x - x0)/θ), the regularised incomplete gamma function.
#[derive(Debug)]
pub struct Gamma {
    shape: f64,
    scale: f64,
    lower: f64,
}

impl Gamma {
    pub fn try_new(shape: f64, scale: f64, lower: f64) -> Result<Self, DistributionError> {
        positive("shape", shape)?;
        positive("scale", scale)?;
        finite("lower end", lower)?;
        Ok(Self { shape, scale, lower })
    }
}

impl Family for Gamma {
    fn mean(&self) -> f64 {
        self.lower + self.shape * self.scale
    }

    fn standard_deviation(&self) -> f64 {
        self.shape.sqrt() * self.scale
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= self.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        let [below, above] = incomplete_gamma(self.shape, (x - self.lower) / self.scale);
        Tails { below, above }
    }

    fn quantile(&self, at: Tails) -> f64 {
        self.lower + self.scale * inverse_incomplete_gamma(self.shape, at.below, at.above)
    }
}
