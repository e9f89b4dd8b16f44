//! A checked distribution: the only type that can be sampled.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::family::{
    Beta, Discrete, Empirical, Exponential, Family, Gamma, Gumbel, Lognormal, Normal, Tails, Triangular, Truncated,
    TruncatedNormal, Uniform, Weibull,
};
use crate::variables::distribution::{Distribution, DistributionError};

/// A distribution with checked parameters, and the constants of its quantile function.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Distribution", into = "Distribution")]
pub struct RandomVariable {
    distribution: Distribution,
    family: Arc<dyn Family>,
}

/// Quantile level: the place of a value in a distribution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum QuantileLevel {
    /// The share that lies below.
    Probability(f64),
    /// The value of a standard normal variable below which the same share lies; it keeps the digits of both tails.
    StandardNormal(f64),
}

/// Variables of the same distribution are the same.
impl PartialEq for RandomVariable {
    fn eq(&self, other: &Self) -> bool {
        self.distribution == other.distribution
    }
}

impl RandomVariable {
    /// Checks the parameters of `distribution`.
    ///
    /// # Errors
    ///
    /// [`DistributionError`] with the parameter, its value and the rule that it breaks.
    pub fn try_new(distribution: Distribution) -> Result<Self, DistributionError> {
        Ok(Self { family: family(&distribution)?, distribution })
    }

    /// The distribution as it was stated.
    pub fn distribution(&self) -> &Distribution {
        &self.distribution
    }

    /// E\[X\].
    pub fn mean(&self) -> f64 {
        self.family.mean()
    }

    /// The standard deviation of X.
    pub fn standard_deviation(&self) -> f64 {
        self.family.standard_deviation()
    }

    /// P(X <= x).
    pub fn cdf(&self, x: f64) -> f64 {
        self.family.tails(x).below
    }

    /// P(X > x), with digits of its own where it is small.
    pub fn survival(&self, x: f64) -> f64 {
        self.family.tails(x).above
    }

    /// The x with P(X <= x) = `probability`: increasing, accurate in both tails; the ends of the support at 0 and 1, NaN outside \[0, 1\].
    pub fn quantile(&self, probability: f64) -> f64 {
        if !(0.0..=1.0).contains(&probability) {
            return f64::NAN;
        }
        self.family.quantile(Tails::at(probability))
    }

    /// The value at a quantile level.
    pub fn at(&self, level: QuantileLevel) -> f64 {
        match level {
            QuantileLevel::Probability(probability) => self.quantile(probability),
            QuantileLevel::StandardNormal(z) => self.at_standard_normal(z),
        }
    }

    /// The x with P(X <= x) = Φ(`z`), both tails with digits of their own.
    pub fn at_standard_normal(&self, z: f64) -> f64 {
        self.family.quantile(Tails::of_standard_normal(z))
    }

    /// The z with P(X <= `x`) = Φ(z), taken from the smaller tail.
    pub fn standard_normal_at(&self, x: f64) -> f64 {
        self.family.tails(x).standard_normal()
    }

    /// Whether the distribution is discrete: it consists of atoms.
    pub fn has_atoms(&self) -> bool {
        self.atoms().is_some()
    }

    /// Atoms of a discrete distribution: values with positive probability, in increasing order with their probabilities; `None` if other values are
    /// possible.
    pub(crate) fn atoms(&self) -> Option<Vec<(f64, f64)>> {
        self.family.atoms()
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

fn family(distribution: &Distribution) -> Result<Arc<dyn Family>, DistributionError> {
    Ok(match *distribution {
        Distribution::Normal { mean, standard_deviation } => Arc::new(Normal::try_new(mean, standard_deviation)?),
        Distribution::TruncatedNormal { mean, standard_deviation, lower, upper } => {
            Arc::new(TruncatedNormal::try_new(mean, standard_deviation, lower, upper)?)
        }
        Distribution::Uniform { lower, upper } => Arc::new(Uniform::try_new(lower, upper)?),
        Distribution::Lognormal { mean, standard_deviation } => Arc::new(Lognormal::try_new(mean, standard_deviation)?),
        Distribution::Triangular { lower, mode, upper } => Arc::new(Triangular::try_new(lower, mode, upper)?),
        Distribution::Beta { alpha, beta, lower, upper } => Arc::new(Beta::try_new(alpha, beta, lower, upper)?),
        Distribution::Weibull { shape, scale, lower } => Arc::new(Weibull::try_new(shape, scale, lower)?),
        Distribution::Gamma { shape, scale, lower } => Arc::new(Gamma::try_new(shape, scale, lower)?),
        Distribution::Gumbel { mode, scale } => Arc::new(Gumbel::try_new(mode, scale)?),
        Distribution::Exponential { mean, lower } => Arc::new(Exponential::try_new(mean, lower)?),
        Distribution::Discrete { ref values, ref probabilities } => Arc::new(Discrete::try_new(values, probabilities)?),
        Distribution::Empirical { ref values } => Arc::new(Empirical::try_new(values)?),
        Distribution::Truncated { ref of, lower, upper } => Truncated::try_new(family(of)?, of.family(), lower, upper)?,
    })
}

#[cfg(test)]
mod tests;
