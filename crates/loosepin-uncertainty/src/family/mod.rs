//! Families of distributions: what a distribution must be able to do, one family per file.
//! A checked variable that can be sampled stands in `variables`.

mod beta;
mod discrete;
mod empirical;
mod exponential;
mod gamma;
mod gumbel;
mod lognormal;
mod normal;
mod triangular;
mod truncated;
mod truncated_normal;
mod uniform;
mod weibull;

use std::fmt::Debug;

pub(super) use beta::Beta;
pub(super) use discrete::Discrete;
pub(super) use empirical::Empirical;
pub(super) use exponential::Exponential;
pub(super) use gamma::Gamma;
pub(super) use gumbel::Gumbel;
pub(super) use lognormal::Lognormal;
pub(super) use normal::Normal;
pub(super) use triangular::Triangular;
pub(super) use truncated::Truncated;
pub(super) use truncated_normal::TruncatedNormal;
pub(super) use uniform::Uniform;
pub(super) use weibull::Weibull;

use crate::functions::normal::{normal_cdf, normal_quantile};
use crate::variables::distribution::DistributionError;

/// The least share of a distribution that a truncation may keep: below it the distribution functions lose digits.
pub(super) const MIN_SHARE_KEPT: f64 = 1e-100;

/// The shares of a distribution on both sides of a value, each with its own digits: P(X <= x) and P(X > x).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tails {
    /// P(X <= x).
    pub below: f64,
    /// P(X > x).
    pub above: f64,
}

impl Tails {
    /// The tails at a probability of staying below.
    pub fn at(below: f64) -> Self {
        Self { below, above: 1.0 - below }
    }

    /// The tails of a standard normal variable at `z`.
    pub fn of_standard_normal(z: f64) -> Self {
        Self { below: normal_cdf(z), above: normal_cdf(-z) }
    }

    /// The z of a standard normal variable with these tails, taken from the smaller one.
    pub fn standard_normal(self) -> f64 {
        if self.below <= 0.5 { normal_quantile(self.below) } else { -normal_quantile(self.above) }
    }
}

/// A distribution with checked parameters.
pub(super) trait Family: Debug + Send + Sync {
    /// E\[X\].
    fn mean(&self) -> f64;

    /// The standard deviation of X.
    fn standard_deviation(&self) -> f64;

    /// P(X <= x) and P(X > x).
    fn tails(&self, x: f64) -> Tails;

    /// The least x with P(X <= x) at least `at.below`; accurate in both tails, the ends of the support at 0 and 1.
    fn quantile(&self, at: Tails) -> f64;

    /// Atoms of a discrete distribution: values with positive probability, in increasing order with their probabilities; `None` if other values are
    /// possible.
    fn atoms(&self) -> Option<Vec<(f64, f64)>> {
        None
    }
}

pub(super) fn finite(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    if value.is_finite() { Ok(()) } else { Err(DistributionError::NotFinite { parameter, value }) }
}

pub(super) fn positive(parameter: &'static str, value: f64) -> Result<(), DistributionError> {
    finite(parameter, value)?;
    if value > 0.0 { Ok(()) } else { Err(DistributionError::NotPositive { parameter, value }) }
}

pub(super) fn ordered(lower: f64, upper: f64) -> Result<(), DistributionError> {
    finite("lower end", lower)?;
    finite("upper end", upper)?;
    if lower < upper { Ok(()) } else { Err(DistributionError::TurnedRound { lower, upper }) }
}
