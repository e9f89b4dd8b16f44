//! The Gumbel distribution of largest values.

use super::{Family, Tails, finite, positive};
use crate::variables::distribution::DistributionError;

/// Euler's constant γ = -ψ(1).
const EULER: f64 = 0.577_215_664_901_532_9;

/// Mode m and scale s: P(X <= x) = exp(-exp(-(x - m)/s)).
#[derive(Debug)]
pub struct Gumbel {
    mode: f64,
    scale: f64,
}

impl Gumbel {
    pub fn try_new(mode: f64, scale: f64) -> Result<Self, DistributionError> {
        finite("mode", mode)?;
        positive("scale", scale)?;
        Ok(Self { mode, scale })
    }
}

impl Family for Gumbel {
    fn mean(&self) -> f64 {
        self.mode + EULER * self.scale
    }

    fn standard_deviation(&self) -> f64 {
        core::f64::consts::PI * self.scale / 6.0_f64.sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        let rate = libm::exp(-(x - self.mode) / self.scale);
        Tails { below: libm::exp(-rate), above: -libm::expm1(-rate) }
    }

    fn quantile(&self, at: Tails) -> f64 {
        // -ln P(X <= x), from the smaller of both tails.
        let rate = if at.below <= 0.5 { -libm::log(at.below) } else { -libm::log1p(-at.above) };
        self.mode - self.scale * libm::log(rate)
    }
}
