//! The normal distribution cut to an interval.

use super::{Family, LEAST_SHARE_KEPT, Tails, finite, ordered, positive};
use crate::distribution::DistributionError;
use crate::normal::{normal_cdf, normal_quantile};

/// Mean and standard deviation before the cut to `lower` .. `upper`.
#[derive(Debug)]
pub struct TruncatedNormal {
    mean: f64,
    standard_deviation: f64,
    lower: f64,
    upper: f64,
    /// Φ at the lower end, 1 - Φ at the upper end, and what lies between.
    below: f64,
    above: f64,
    share: f64,
}

impl TruncatedNormal {
    pub fn try_new(mean: f64, standard_deviation: f64, lower: f64, upper: f64) -> Result<Self, DistributionError> {
        finite("mean", mean)?;
        positive("standard deviation", standard_deviation)?;
        ordered(lower, upper)?;
        let (a, b) = ((lower - mean) / standard_deviation, (upper - mean) / standard_deviation);
        let (below, above) = (normal_cdf(a), normal_cdf(-b));
        // The difference is taken where both numbers are small.
        let share = if a > 0.0 { normal_cdf(-a) - above } else { normal_cdf(b) - below };
        if share < LEAST_SHARE_KEPT {
            return Err(DistributionError::NothingKept { mean, standard_deviation, lower, upper, share });
        }
        Ok(Self { mean, standard_deviation, lower, upper, below, above, share })
    }

    /// Mean and variance of a truncated standard normal variable: with φ the density, a and b the ends and Z the share,
    /// m = (φ(a) - φ(b))/Z, v = 1 + (a φ(a) - b φ(b))/Z - m².
    fn moments(&self) -> (f64, f64) {
        let density = |x: f64| libm::exp(-0.5 * x * x) / (2.0 * core::f64::consts::PI).sqrt();
        let [a, b] = [self.lower, self.upper].map(|end| (end - self.mean) / self.standard_deviation);
        let first = (density(a) - density(b)) / self.share;
        (first, 1.0 + (a * density(a) - b * density(b)) / self.share - first * first)
    }
}

impl Family for TruncatedNormal {
    fn mean(&self) -> f64 {
        self.mean + self.standard_deviation * self.moments().0
    }

    fn standard_deviation(&self) -> f64 {
        self.standard_deviation * self.moments().1.max(0.0).sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        if x <= self.lower {
            return Tails { below: 0.0, above: 1.0 };
        }
        if x >= self.upper {
            return Tails { below: 1.0, above: 0.0 };
        }
        let standard = (x - self.mean) / self.standard_deviation;
        if standard < 0.0 {
            Tails::at(((normal_cdf(standard) - self.below) / self.share).clamp(0.0, 1.0))
        } else {
            let above = ((normal_cdf(-standard) - self.above) / self.share).clamp(0.0, 1.0);
            Tails { below: 1.0 - above, above }
        }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let from_below = self.below + at.below * self.share;
        let standard = if from_below < 0.5 {
            normal_quantile(from_below)
        } else {
            -normal_quantile(self.above + at.above * self.share)
        };
        (self.mean + self.standard_deviation * standard).clamp(self.lower, self.upper)
    }
}
