//! Probability distributions of a scalar random input, as a person states them.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A distribution, parameters in the unit of the variable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Distribution {
    /// Normal.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation, > 0.
        standard_deviation: f64,
    },
    /// Normal, cut to an interval and rescaled. Mean and standard deviation are those before the cut.
    TruncatedNormal {
        /// Mean before the cut.
        mean: f64,
        /// Standard deviation before the cut, > 0.
        standard_deviation: f64,
        /// Lower end.
        lower: f64,
        /// Upper end, > lower.
        upper: f64,
    },
    /// Uniform.
    Uniform {
        /// Lower end.
        lower: f64,
        /// Upper end, > lower.
        upper: f64,
    },
    /// Lognormal, by the mean and standard deviation of the variable itself.
    Lognormal {
        /// Mean, > 0.
        mean: f64,
        /// Standard deviation, > 0.
        standard_deviation: f64,
    },
    /// Triangular.
    Triangular {
        /// Lower end.
        lower: f64,
        /// Most likely value, within the ends.
        mode: f64,
        /// Upper end, > lower.
        upper: f64,
    },
    /// Beta with four parameters.
    Beta {
        /// First shape, > 0.
        alpha: f64,
        /// Second shape, > 0.
        beta: f64,
        /// Lower end.
        lower: f64,
        /// Upper end, > lower.
        upper: f64,
    },
    /// Weibull, for largest loads and for lives.
    Weibull {
        /// Shape, > 0.
        shape: f64,
        /// Scale, > 0: 63.2 % lie less than this above the lower end.
        scale: f64,
        /// Lower end.
        lower: f64,
    },
    /// Gamma.
    Gamma {
        /// Shape, > 0.
        shape: f64,
        /// Scale, > 0; the mean lies shape times scale above the lower end.
        scale: f64,
        /// Lower end.
        lower: f64,
    },
    /// Gumbel, of largest values.
    Gumbel {
        /// Most likely value.
        mode: f64,
        /// Scale, > 0.
        scale: f64,
    },
    /// Exponential.
    Exponential {
        /// Mean of the variable itself, > lower.
        mean: f64,
        /// Lower end.
        lower: f64,
    },
    /// A few values with their probabilities.
    Discrete {
        /// The values, each once, in any order.
        values: Vec<f64>,
        /// Probabilities of the values, > 0, as many, with the sum 1.
        probabilities: Vec<f64>,
    },
    /// A sample taken as it is: every value with the same probability.
    Empirical {
        /// The sample in increasing order, at least two different values.
        values: Arc<[f64]>,
    },
    /// Another distribution, cut to an interval and rescaled; its parameters are those before the cut.
    Truncated {
        /// The distribution before the cut.
        of: Box<Distribution>,
        /// Lower end, or minus infinity.
        #[serde(with = "crate::variables::open_end::lower")]
        lower: f64,
        /// Upper end, > lower, or infinity.
        #[serde(with = "crate::variables::open_end::upper")]
        upper: f64,
    },
}

/// Why a distribution is none.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum DistributionError {
    #[error("{parameter} {value}; must be finite")]
    NotFinite { parameter: &'static str, value: f64 },
    #[error("{parameter} {value}; must be > 0")]
    NotPositive { parameter: &'static str, value: f64 },
    #[error("lower end {lower}, upper end {upper}; the lower end must be below the upper end")]
    TurnedRound { lower: f64, upper: f64 },
    #[error("mode {mode}; must be between the ends {lower} and {upper}")]
    ModeOutside { mode: f64, lower: f64, upper: f64 },
    /// A truncation keeps nothing that arithmetic could resolve.
    #[error(
        "truncation to [{lower}, {upper}] keeps the share {share} of a normal distribution with mean {mean} and standard \
         deviation {standard_deviation}; the share must be at least 1e-100\n\
         hint: truncate nearer to the mean, or use a uniform distribution"
    )]
    NothingKept {
        mean: f64,
        standard_deviation: f64,
        lower: f64,
        upper: f64,
        /// Share of the distribution between the ends.
        share: f64,
    },
    #[error(
        "truncation to [{lower}, {upper}] keeps the share {share} of a {family} distribution; the share must be at least \
         1e-100\nhint: truncate nearer to the mean, or use a uniform distribution"
    )]
    NothingLeft {
        family: &'static str,
        lower: f64,
        upper: f64,
        /// Share of the distribution between the ends.
        share: f64,
    },
    #[error("mean {mean}; must be above the lower end {lower}")]
    MeanBelowEnd { mean: f64, lower: f64 },
    #[error("{values} values, {probabilities} probabilities; each value needs one")]
    UnequalLists { values: usize, probabilities: usize },
    #[error("the probabilities sum up to {sum}; must be 1 within 1e-9")]
    SumNotOne { sum: f64 },
    #[error("the value {value} is there twice")]
    ValueTwice { value: f64 },
    #[error("a sample of {count} without two different values; it says nothing of scatter")]
    NoScatter { count: usize },
}

impl Distribution {
    /// Name of the family in messages and reports.
    pub fn family(&self) -> &'static str {
        match self {
            Self::Normal { .. } => "normal",
            Self::TruncatedNormal { .. } => "truncated normal",
            Self::Uniform { .. } => "uniform",
            Self::Lognormal { .. } => "lognormal",
            Self::Triangular { .. } => "triangular",
            Self::Beta { .. } => "beta",
            Self::Weibull { .. } => "Weibull",
            Self::Gamma { .. } => "gamma",
            Self::Gumbel { .. } => "Gumbel",
            Self::Exponential { .. } => "exponential",
            Self::Discrete { .. } => "discrete",
            Self::Empirical { .. } => "empirical",
            Self::Truncated { .. } => "truncated",
        }
    }
}
