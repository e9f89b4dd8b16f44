//! Probability distributions of a scalar random input.

/// A distribution, parameters in the unit of the variable.
#[derive(Debug, Clone, PartialEq)]
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
