//! A parameter of a distribution with a distribution of its own: second-order probability.

use crate::functions::normal::normal_cdf;
use crate::interval::{Interval, IntervalError};
use crate::variables::random_variable::RandomVariable;

/// A parameter whose distribution has no two ends is looked at between its quantiles at Φ(-3) and Φ(3).
const STANDARD_DEVIATIONS: f64 = 3.0;

/// A quantity that has one value, of which it is known how probable each is.
#[derive(Debug, Clone, PartialEq)]
pub struct SecondOrder {
    variable: RandomVariable,
    range: Interval,
}

impl SecondOrder {
    /// The quantity with the distribution `variable`.
    ///
    /// # Errors
    ///
    /// [`IntervalError`] where its quantiles are no interval.
    pub fn try_new(variable: RandomVariable) -> Result<Self, IntervalError> {
        let ends = |tail: f64| Interval::try_new(variable.quantile(tail), variable.quantile(1.0 - tail));
        let range = ends(0.0).or_else(|_| ends(normal_cdf(-STANDARD_DEVIATIONS)))?;
        Ok(Self { variable, range })
    }

    /// Its distribution.
    pub fn variable(&self) -> &RandomVariable {
        &self.variable
    }

    /// Examined range: its support if that has two ends, else between the quantiles at Φ(-3) and Φ(3), outside of which it lies with a
    /// probability of 0.27 %.
    pub fn range(&self) -> Interval {
        self.range
    }

    /// Its quantile at `probability`; `None` if that lies outside of the range.
    pub fn quantile_in_range(&self, probability: f64) -> Option<f64> {
        let value = self.variable.quantile(probability);
        (value >= self.range.lower() && value <= self.range.upper()).then_some(value)
    }

    /// Its quantile at `probability`, moved to the nearer end of the range where it lies outside.
    pub fn at(&self, probability: f64) -> f64 {
        self.variable.quantile(probability).max(self.range.lower()).min(self.range.upper())
    }
}

#[cfg(test)]
mod tests {
    use super::SecondOrder;
    use crate::{Distribution, RandomVariable};

    #[test]
    fn analytic_ranges_with_and_without_ends() {
        const TOLERANCE: f64 = 1e-12; // of numbers about 1
        let of = |distribution| SecondOrder::try_new(RandomVariable::try_new(distribution).unwrap()).unwrap();
        let normal = of(Distribution::Normal { mean: 2.0, standard_deviation: 0.25 });
        assert!((normal.range().lower() - 1.25).abs() < TOLERANCE && (normal.range().upper() - 2.75).abs() < TOLERANCE);
        assert_eq!((normal.quantile_in_range(0.5), normal.quantile_in_range(0.001)), (Some(2.0), None));
        assert_eq!((normal.at(0.0), normal.at(1.0)), (normal.range().lower(), normal.range().upper()));
        let uniform = of(Distribution::Uniform { lower: -0.5, upper: 1.5 });
        assert_eq!((uniform.range().lower(), uniform.range().upper()), (-0.5, 1.5));
        assert!((uniform.at(0.25) - 0.0).abs() < TOLERANCE);
    }
}
