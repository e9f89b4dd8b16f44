//! The beta distribution with four parameters.

use super::{Family, Tails, ordered, positive};
use crate::functions::incomplete_beta::{incomplete_beta, inverse_incomplete_beta};
use crate::variables::distribution::DistributionError;

/// Shapes α and β, between two ends; F = I_x(α, β) of the share x of the way.
#[derive(Debug)]
pub struct Beta {
    alpha: f64,
    beta: f64,
    lower: f64,
    upper: f64,
}

impl Beta {
    pub fn try_new(alpha: f64, beta: f64, lower: f64, upper: f64) -> Result<Self, DistributionError> {
        positive("alpha", alpha)?;
        positive("beta", beta)?;
        ordered(lower, upper)?;
        Ok(Self { alpha, beta, lower, upper })
    }
}

impl Family for Beta {
    fn mean(&self) -> f64 {
        self.lower + (self.upper - self.lower) * self.alpha / (self.alpha + self.beta)
    }

    fn standard_deviation(&self) -> f64 {
        let sum = self.alpha + self.beta;
        (self.upper - self.lower) * (self.alpha * self.beta / (sum + 1.0)).sqrt() / sum
    }

    fn tails(&self, x: f64) -> Tails {
        let width = self.upper - self.lower;
        let share = ((x - self.lower) / width).clamp(0.0, 1.0);
        let rest = ((self.upper - x) / width).clamp(0.0, 1.0);
        Tails {
            below: incomplete_beta(self.alpha, self.beta, share, rest),
            above: incomplete_beta(self.beta, self.alpha, rest, share),
        }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let width = self.upper - self.lower;
        let (x, rest) = inverse_incomplete_beta(self.alpha, self.beta, at.below, at.above);
        if x < 0.5 { self.lower + x * width } else { self.upper - rest * width }
    }
}
