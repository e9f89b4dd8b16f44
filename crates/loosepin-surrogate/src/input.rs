//! An input of a surrogate, and the standard coordinates in which the surrogates see it.

use crate::chaos::polynomial::Family;
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, normal_quantile};
use serde::{Deserialize, Serialize};

/// Probabilities are kept this far from 0 and 1 before they become standard normal variables, ±8.2.
const MIN_PROBABILITY: f64 = 1e-16;

/// One input: a random variable, or a number known to lie in an interval.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Input {
    /// Random, with its distribution.
    Random(RandomVariable),
    /// Epistemic.
    Epistemic(Interval),
}

impl Input {
    /// The possible values of the input; infinite on a side without limit.
    pub fn support(&self) -> (f64, f64) {
        match self {
            Self::Epistemic(interval) => (interval.lower(), interval.upper()),
            Self::Random(variable) => (variable.quantile(0.0), variable.quantile(1.0)),
        }
    }

    /// `value` moved and scaled so that a random input has mean 0 and standard deviation 1, and an interval the ends ±√3;
    /// 0 where the interval is a single point.
    pub fn scaled(&self, value: f64) -> f64 {
        match self {
            Self::Random(variable) => (value - variable.mean()) / variable.standard_deviation(),
            Self::Epistemic(interval) => 3.0_f64.sqrt() * middle_fraction(interval, value),
        }
    }

    /// c and f of [`Self::scaled`] as (value - c) f.
    pub(super) fn centre_and_factor(&self) -> (f64, f64) {
        match self {
            Self::Random(variable) => (variable.mean(), 1.0 / variable.standard_deviation()),
            Self::Epistemic(interval) => {
                let (lower, upper) = (interval.lower(), interval.upper());
                (0.5 * (lower + upper), if lower < upper { 12.0_f64.sqrt() / (upper - lower) } else { 0.0 })
            }
        }
    }

    /// The polynomials that are orthonormal under this input.
    pub fn family(&self) -> Family {
        match self {
            Self::Epistemic(_) => Family::CHEBYSHEV,
            Self::Random(variable) => match *variable.distribution() {
                Distribution::Normal { .. }
                | Distribution::Lognormal { .. }
                | Distribution::Weibull { .. }
                | Distribution::Gamma { .. }
                | Distribution::Gumbel { .. }
                | Distribution::Exponential { .. } => Family::Hermite,
                Distribution::Beta { alpha, beta, .. } => Family::Jacobi { a: beta - 1.0, b: alpha - 1.0 },
                Distribution::Uniform { .. }
                | Distribution::Triangular { .. }
                | Distribution::TruncatedNormal { .. }
                | Distribution::Truncated { .. }
                | Distribution::Discrete { .. }
                | Distribution::Empirical { .. } => Family::LEGENDRE,
            },
        }
    }

    /// The standard variable ξ of [`Self::family`] that belongs to `value`: linear for normal, uniform and beta variables
    /// and intervals; by equal probability, F(x) = F_ξ(ξ), for all others.
    pub fn germ(&self, value: f64) -> f64 {
        match self {
            Self::Epistemic(interval) => middle_fraction(interval, value),
            Self::Random(variable) => match *variable.distribution() {
                Distribution::Normal { mean, standard_deviation } => (value - mean) / standard_deviation,
                Distribution::Lognormal { .. }
                | Distribution::Weibull { .. }
                | Distribution::Gamma { .. }
                | Distribution::Gumbel { .. }
                | Distribution::Exponential { .. } => {
                    normal_quantile(variable.cdf(value).clamp(MIN_PROBABILITY, 1.0 - MIN_PROBABILITY))
                }
                Distribution::Uniform { lower, upper } | Distribution::Beta { lower, upper, .. } => {
                    (2.0 * value - lower - upper) / (upper - lower)
                }
                Distribution::Triangular { .. }
                | Distribution::TruncatedNormal { .. }
                | Distribution::Truncated { .. } => 2.0 * variable.cdf(value) - 1.0,
                // A distribution function that jumps would take values that lie far apart for neighbours in probability.
                Distribution::Discrete { .. } | Distribution::Empirical { .. } => {
                    let (lower, upper) = self.support();
                    (2.0 * value - lower - upper) / (upper - lower)
                }
            },
        }
    }
}

/// -1 at the lower end, 1 at the upper end, 0 everywhere in an interval that is a single point.
fn middle_fraction(interval: &Interval, value: f64) -> f64 {
    let width = interval.upper() - interval.lower();
    if width > 0.0 { (2.0 * value - interval.lower() - interval.upper()) / width } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::Input;
    use loosepin_uncertainty::{Distribution, Interval, RandomVariable, normal_cdf};

    #[test]
    fn identity_a_germ_has_the_probability_of_its_value() {
        const TOLERANCE: f64 = 1e-12; // round-off of a quantile and its inverse
        let lognormal = Distribution::Lognormal { mean: 2.5, standard_deviation: 0.7 };
        let triangular = Distribution::Triangular { lower: 0.3, mode: 0.5, upper: 1.7 };
        for (distribution, value) in [(lognormal, 3.1), (triangular, 0.9)] {
            let is_normal = matches!(distribution, Distribution::Lognormal { .. });
            let variable = RandomVariable::try_new(distribution).unwrap();
            let germ = Input::Random(variable.clone()).germ(value);
            let probability = if is_normal { normal_cdf(germ) } else { 0.5 * (germ + 1.0) };
            assert!((probability - variable.cdf(value)).abs() < TOLERANCE);
        }
    }

    #[test]
    fn analytic_ends_of_an_interval_are_one_standard_range_apart() {
        const TOLERANCE: f64 = 1e-14; // round-off
        let input = Input::Epistemic(Interval::try_new(0.2, 0.5).unwrap());
        assert!((input.germ(0.2) + 1.0).abs() < TOLERANCE && (input.germ(0.5) - 1.0).abs() < TOLERANCE);
        assert!((input.scaled(0.5) - 3.0_f64.sqrt()).abs() < TOLERANCE);
        let point = Input::Epistemic(Interval::try_new(0.3, 0.3).unwrap());
        assert_eq!((point.germ(0.3), point.scaled(0.3)), (0.0, 0.0));
    }
}
