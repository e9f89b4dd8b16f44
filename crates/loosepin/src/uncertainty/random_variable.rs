//! A checked distribution: the only type that can be sampled.

use super::distribution::{Distribution, DistributionError};
use super::incomplete_beta::{incomplete_beta, inverse_incomplete_beta};
use super::normal::{normal_cdf, normal_quantile};
use serde::{Deserialize, Serialize};

/// The least share of a normal distribution that a truncation may keep: below it Φ loses digits.
const LEAST_SHARE_KEPT: f64 = 1e-100;

/// A distribution whose parameters have been checked, with what its quantile function needs worked out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Distribution", into = "Distribution")]
pub struct RandomVariable {
    distribution: Distribution,
    prepared: Prepared,
}

#[derive(Debug, Clone, PartialEq)]
enum Prepared {
    Nothing,
    /// Mean and standard deviation of ln X.
    Lognormal {
        location: f64,
        scale: f64,
    },
    /// Φ at the lower end, 1 - Φ at the upper end, and what lies between.
    Truncated {
        below: f64,
        above: f64,
        share: f64,
    },
}

impl RandomVariable {
    /// Checks the parameters of `distribution`.
    ///
    /// # Errors
    ///
    /// [`DistributionError`] with the parameter, its value and the rule that it breaks.
    pub fn try_new(distribution: Distribution) -> Result<Self, DistributionError> {
        let prepared = match distribution {
            Distribution::Normal { mean, standard_deviation } => {
                finite("mean", mean)?;
                positive("standard deviation", standard_deviation)?;
                Prepared::Nothing
            }
            Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => {
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
                Prepared::Truncated { below, above, share }
            }
            Distribution::Uniform { lower, upper } => {
                ordered(lower, upper)?;
                Prepared::Nothing
            }
            Distribution::Lognormal { mean, standard_deviation } => {
                positive("mean", mean)?;
                positive("standard deviation", standard_deviation)?;
                // σ² = ln(1 + s²/m²), μ = ln m - σ²/2
                let ratio = standard_deviation / mean;
                let variance = libm::log1p(ratio * ratio);
                Prepared::Lognormal { location: libm::log(mean) - 0.5 * variance, scale: variance.sqrt() }
            }
            Distribution::Triangular { lower, mode, upper } => {
                ordered(lower, upper)?;
                finite("mode", mode)?;
                if mode < lower || mode > upper {
                    return Err(DistributionError::ModeOutside { mode, lower, upper });
                }
                Prepared::Nothing
            }
            Distribution::Beta { alpha, beta, lower, upper } => {
                positive("alpha", alpha)?;
                positive("beta", beta)?;
                ordered(lower, upper)?;
                Prepared::Nothing
            }
        };
        Ok(Self { distribution, prepared })
    }

    /// The distribution as it was stated.
    pub fn distribution(&self) -> &Distribution {
        &self.distribution
    }

    /// E\[X\].
    pub fn mean(&self) -> f64 {
        match self.distribution {
            Distribution::Normal { mean, .. } | Distribution::Lognormal { mean, .. } => mean,
            Distribution::TruncatedNormal { mean, standard_deviation, .. } => {
                mean + standard_deviation * self.truncated_moments().0
            }
            Distribution::Uniform { lower, upper } => 0.5 * (lower + upper),
            Distribution::Triangular { lower, mode, upper } => (lower + mode + upper) / 3.0,
            Distribution::Beta { alpha, beta, lower, upper } => lower + (upper - lower) * alpha / (alpha + beta),
        }
    }

    /// The standard deviation of X.
    pub fn standard_deviation(&self) -> f64 {
        match self.distribution {
            Distribution::Normal { standard_deviation, .. } | Distribution::Lognormal { standard_deviation, .. } => {
                standard_deviation
            }
            Distribution::TruncatedNormal { standard_deviation, .. } => {
                standard_deviation * self.truncated_moments().1.max(0.0).sqrt()
            }
            Distribution::Uniform { lower, upper } => (upper - lower) / 12.0_f64.sqrt(),
            Distribution::Triangular { lower, mode, upper } => {
                let (left, right) = (mode - lower, upper - mode);
                ((left * left + left * right + right * right) / 18.0).sqrt()
            }
            Distribution::Beta { alpha, beta, lower, upper } => {
                let sum = alpha + beta;
                (upper - lower) * (alpha * beta / (sum + 1.0)).sqrt() / sum
            }
        }
    }

    /// P(X <= x).
    pub fn cdf(&self, x: f64) -> f64 {
        match self.distribution {
            Distribution::Normal { mean, standard_deviation } => normal_cdf((x - mean) / standard_deviation),
            Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => {
                if x <= lower {
                    return 0.0;
                }
                if x >= upper {
                    return 1.0;
                }
                let Prepared::Truncated { below, above, share } = self.prepared else { return f64::NAN };
                let standard = (x - mean) / standard_deviation;
                let value = if standard < 0.0 {
                    (normal_cdf(standard) - below) / share
                } else {
                    1.0 - (normal_cdf(-standard) - above) / share
                };
                value.clamp(0.0, 1.0)
            }
            Distribution::Uniform { lower, upper } => ((x - lower) / (upper - lower)).clamp(0.0, 1.0),
            Distribution::Lognormal { .. } => {
                let Prepared::Lognormal { location, scale } = self.prepared else { return f64::NAN };
                if x <= 0.0 { 0.0 } else { normal_cdf((libm::log(x) - location) / scale) }
            }
            Distribution::Triangular { lower, mode, upper } => {
                if x <= lower {
                    0.0
                } else if x >= upper {
                    1.0
                } else if x < mode {
                    (x - lower) * (x - lower) / ((upper - lower) * (mode - lower))
                } else {
                    1.0 - (upper - x) * (upper - x) / ((upper - lower) * (upper - mode))
                }
            }
            Distribution::Beta { alpha, beta, lower, upper } => {
                let width = upper - lower;
                incomplete_beta(
                    alpha,
                    beta,
                    ((x - lower) / width).clamp(0.0, 1.0),
                    ((upper - x) / width).clamp(0.0, 1.0),
                )
            }
        }
    }

    /// The x with P(X <= x) = `probability`: increasing, accurate in both tails; the ends of the support at 0 and 1, not
    /// a number outside \[0, 1\].
    pub fn quantile(&self, probability: f64) -> f64 {
        if !(0.0..=1.0).contains(&probability) {
            return f64::NAN;
        }
        let complement = 1.0 - probability;
        match self.distribution {
            Distribution::Normal { mean, standard_deviation } => {
                mean + standard_deviation * normal_quantile(probability)
            }
            Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => {
                let Prepared::Truncated { below, above, share } = self.prepared else { return f64::NAN };
                let from_below = below + probability * share;
                let standard = if from_below < 0.5 {
                    normal_quantile(from_below)
                } else {
                    -normal_quantile(above + complement * share)
                };
                (mean + standard_deviation * standard).clamp(lower, upper)
            }
            Distribution::Uniform { lower, upper } => {
                if probability < 0.5 {
                    lower + probability * (upper - lower)
                } else {
                    upper - complement * (upper - lower)
                }
            }
            Distribution::Lognormal { .. } => {
                let Prepared::Lognormal { location, scale } = self.prepared else { return f64::NAN };
                libm::exp(location + scale * normal_quantile(probability))
            }
            Distribution::Triangular { lower, mode, upper } => {
                let width = upper - lower;
                if probability * width < mode - lower {
                    lower + (probability * width * (mode - lower)).sqrt()
                } else {
                    upper - (complement * width * (upper - mode)).sqrt()
                }
            }
            Distribution::Beta { alpha, beta, lower, upper } => {
                let (x, rest) = inverse_incomplete_beta(alpha, beta, probability, complement);
                if x < 0.5 { lower + x * (upper - lower) } else { upper - rest * (upper - lower) }
            }
        }
    }

    /// Mean and variance of a truncated standard normal variable: with φ the density, a and b the ends and Z the share,
    /// m = (φ(a) - φ(b))/Z, v = 1 + (a φ(a) - b φ(b))/Z - m².
    fn truncated_moments(&self) -> (f64, f64) {
        let Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } = self.distribution else {
            return (f64::NAN, f64::NAN);
        };
        let Prepared::Truncated { share, .. } = self.prepared else { return (f64::NAN, f64::NAN) };
        let density = |x: f64| libm::exp(-0.5 * x * x) / (2.0 * core::f64::consts::PI).sqrt();
        let (a, b) = ((lower - mean) / standard_deviation, (upper - mean) / standard_deviation);
        let first = (density(a) - density(b)) / share;
        (first, 1.0 + (a * density(a) - b * density(b)) / share - first * first)
    }
}

impl TryFrom<Distribution> for RandomVariable {
    type Error = DistributionError;

    fn try_from(distribution: Distribution) -> Result<Self, DistributionError> {
        Self::try_new(distribution)
    }
}

impl From<RandomVariable> for Distribution {
    fn from(variable: RandomVariable) -> Self {
        variable.distribution
    }
}

fn finite(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    if value.is_finite() { Ok(()) } else { Err(DistributionError::NotFinite { parameter, value }) }
}

fn positive(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    finite(parameter, value)?;
    if value > 0.0 { Ok(()) } else { Err(DistributionError::NotPositive { parameter, value }) }
}

fn ordered(lower: f64, upper: f64) -> Result<(), DistributionError> {
    finite("lower end", lower)?;
    finite("upper end", upper)?;
    if lower < upper { Ok(()) } else { Err(DistributionError::TurnedRound { lower, upper }) }
}

#[cfg(test)]
mod tests;
