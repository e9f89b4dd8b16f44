//! Probability distributions of a scalar random input, as a person states them.

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
}

/// Why a distribution is none.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum DistributionError {
    /// A parameter is infinite or not a number.
    #[error("{parameter} {value}; must be finite")]
    NotFinite {
        /// Name of the parameter.
        parameter: &'static str,
        /// Its value.
        value: f64,
    },
    /// A parameter that must be positive is not.
    #[error("{parameter} {value}; must be > 0")]
    NotPositive {
        /// Name of the parameter.
        parameter: &'static str,
        /// Its value.
        value: f64,
    },
    /// The ends coincide or are the wrong way round.
    #[error("lower end {lower}, upper end {upper}; the lower end must be below the upper end")]
    TurnedRound {
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// The most likely value lies outside the ends.
    #[error("mode {mode}; must lie between the ends {lower} and {upper}")]
    ModeOutside {
        /// Most likely value.
        mode: f64,
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
    },
    /// A truncation keeps nothing that arithmetic could resolve.
    #[error(
        "truncation to [{lower}, {upper}] keeps the share {share} of a normal distribution with mean {mean} and standard \
         deviation {standard_deviation}; the share must be at least 1e-100\n\
         hint: cut nearer to the mean, or state a uniform distribution"
    )]
    NothingKept {
        /// Mean before the cut.
        mean: f64,
        /// Standard deviation before the cut.
        standard_deviation: f64,
        /// Lower end.
        lower: f64,
        /// Upper end.
        upper: f64,
        /// Share of the distribution between the ends.
        share: f64,
    },
}

impl Distribution {
    /// The family in words, as in messages and reports.
    pub fn family(&self) -> &'static str {
        match self {
            Self::Normal { .. } => "normal",
            Self::TruncatedNormal { .. } => "truncated normal",
            Self::Uniform { .. } => "uniform",
            Self::Lognormal { .. } => "lognormal",
            Self::Triangular { .. } => "triangular",
            Self::Beta { .. } => "beta",
        }
    }
}
