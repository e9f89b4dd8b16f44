//! Statistics of a scalar response.

/// A statistic of a response Y for fixed epistemic inputs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Statistic {
    /// E(Y).
    Mean,
    /// Standard deviation of Y.
    StandardDeviation,
    /// The whole distribution function.
    Cdf,
    /// The value that Y stays below with this probability, in (0, 1).
    Quantile(f64),
    /// P(Y > limit).
    ProbabilityAbove(f64),
    /// P(Y < limit).
    ProbabilityBelow(f64),
    /// P(|Y| > limit), limit >= 0.
    ProbabilityBeyond(f64),
}

impl Statistic {
    /// Whether it is a probability.
    pub fn is_probability(self) -> bool {
        matches!(self, Self::ProbabilityAbove(_) | Self::ProbabilityBelow(_) | Self::ProbabilityBeyond(_))
    }
}
