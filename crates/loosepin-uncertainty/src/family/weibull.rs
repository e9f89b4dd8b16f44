//! The Weibull distribution.

use super::{Family, Tails, finite, positive};
use crate::variables::distribution::DistributionError;

/// Shape k, scale λ, from a lower end x0 on: P(X > x) = exp(-((x - x0)/λ)^k).
#[derive(Debug)]
pub struct Weibull {
    shape: f64,
    scale: f64,
    lower: f64,
}

impl Weibull {
    pub fn try_new(shape: f64, scale: f64, lower: f64) -> Result<Self, DistributionError> {
        positive("shape", shape)?;
        positive("scale", scale)?;
        finite("lower end", lower)?;
        Ok(Self { shape, scale, lower })
    }
}

impl Family for Weibull {
    /// x0 + λ Γ(1 + 1/k).
    fn mean(&self) -> f64 {
        self.lower + self.scale * libm::tgamma(1.0 + 1.0 / self.shape)
    }

    /// λ √(Γ(1 + 2/k) - Γ(1 + 1/k)²), by logarithms so that nothing cancels where k is large.
    fn standard_deviation(&self) -> f64 {
        let [first, second] = [1.0, 2.0].map(|order| libm::lgamma(1.0 + order / self.shape));
        self.scale * libm::exp(first) * libm::expm1(second - 2.0 * first).sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= self.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        let hazard = libm::pow((x - self.lower) / self.scale, self.shape);
        Tails { below: -libm::expm1(-hazard), above: libm::exp(-hazard) }
    }

    fn quantile(&self, at: Tails) -> f64 {
        self.lower + self.scale * libm::pow(hazard(at), 1.0 / self.shape)
    }
}

/// -ln P(X > x), from the smaller of both tails.
pub fn hazard(at: Tails) -> f64 {
    if at.below <= 0.5 { -libm::log1p(-at.below) } else { -libm::log(at.above) }
}
