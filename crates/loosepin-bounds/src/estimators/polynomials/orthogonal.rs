//! Polynomials in one variable, orthonormal for its distribution, and Gauss rules of them.
//!
//! ```text
//! t p_k = b_(k+1) p_(k+1) + b_k p_(k-1),  p_0 = 1       Hermite, t standard normal: b_k = √k
//!                                                       Legendre, t uniform on [-1, 1]: b_k = k/√(4k² - 1)
//! ```
//!
//! Legendre's b_k is rounded otherwise than by the general formula of [`loosepin_surrogate::Family`], in 8 of the first 32.
//!
//! W. Gautschi, "Orthogonal polynomials: computation and approximation" (2004), section 1.3 and table 1.1.

use core::f64::consts::TAU;
use std::sync::LazyLock;

use loosepin_math::{legendre_coefficient, orthonormal_values, symmetric_gauss_rule};
use loosepin_uncertainty::{normal_cdf, normal_quantile};

/// Beyond this a standard normal variable is not looked at; Φ(-5) = 2.9e-7.
const NORMAL_END: f64 = 5.0;

/// Orders of the polynomials, at most: the longest Gauss rule.
const MAX_ORDER: usize = 32;

/// b_k and 1/b_k of an axis, b_0 = 0.
type Recurrence = [(f64, f64); MAX_ORDER + 1];

/// Of both axes: a root and a quotient cost more than all else of a polynomial.
static RECURRENCES: LazyLock<[Recurrence; 2]> = LazyLock::new(|| {
    let normal = |k: f64| k.sqrt();
    [
        std::array::from_fn(|k| with_reciprocal(normal(k as f64))),
        std::array::from_fn(|k| with_reciprocal(legendre_coefficient(k))),
    ]
});

fn with_reciprocal(b: f64) -> (f64, f64) {
    (b, 1.0 / b)
}

/// Distribution of a coordinate of the random inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    /// t = Φ⁻¹(ω), standard normal.
    Hermite,
    /// t = 2ω - 1, uniform.
    Legendre,
}

impl Axis {
    /// t at a coordinate ω of the unit cube.
    pub fn coordinate(self, omega: f64) -> f64 {
        match self {
            Self::Hermite => normal_quantile(omega),
            Self::Legendre => 2.0 * omega - 1.0,
        }
    }

    /// The range that is examined.
    pub fn ends(self) -> (f64, f64) {
        match self {
            Self::Hermite => (-NORMAL_END, NORMAL_END),
            Self::Legendre => (-1.0, 1.0),
        }
    }

    /// The probability outside that range.
    pub fn outside(self) -> f64 {
        let (low, high) = self.ends();
        self.cdf(low) + 1.0 - self.cdf(high)
    }

    /// P(T <= t).
    pub fn cdf(self, t: f64) -> f64 {
        match self {
            Self::Hermite => normal_cdf(t),
            Self::Legendre => (0.5 * (t + 1.0)).clamp(0.0, 1.0),
        }
    }

    /// The density of T.
    pub fn density(self, t: f64) -> f64 {
        match self {
            Self::Hermite => libm::exp(-0.5 * t * t) / TAU.sqrt(),
            Self::Legendre => 0.5,
        }
    }

    fn recurrence(self) -> &'static Recurrence {
        match self {
            Self::Hermite => &RECURRENCES[0],
            Self::Legendre => &RECURRENCES[1],
        }
    }

    /// p_0 ... p_degree at `t`.
    pub fn values(self, t: f64, degree: usize) -> Vec<f64> {
        let recurrence = self.recurrence();
        orthonormal_values(t, degree, &|n| (0.0, recurrence[n + 1].0))
    }

    /// p_0' ... p_degree' at `t`.
    pub fn slopes(self, t: f64, degree: usize) -> Vec<f64> {
        let of = |order: usize| {
            let coefficients = (0..=degree).map(|own| if own == order { 1.0 } else { 0.0 }).collect();
            Univariate { axis: self, coefficients }.at(t).1
        };
        (0..=degree).map(of).collect()
    }

    /// The n-point Gauss rule: nodes, and weights that add up to 1.
    pub fn gauss_rule(self, n: usize) -> Vec<(f64, f64)> {
        let end = match self {
            Self::Hermite => 2.0 * (n as f64).sqrt() + 1.0,
            Self::Legendre => 1.0,
        };
        let recurrence = self.recurrence();
        symmetric_gauss_rule(n, end, &|k| recurrence[k].0)
    }
}

/// A polynomial in one variable by its coefficients c_k of p_k.
#[derive(Debug, Clone)]
pub(crate) struct Univariate {
    pub axis: Axis,
    pub coefficients: Vec<f64>,
}

impl Univariate {
    /// Value and derivative at `t`.
    pub fn at(&self, t: f64) -> (f64, f64) {
        let (mut before, mut now) = ((0.0, 0.0), (1.0, 0.0));
        let (mut value, mut slope) = (self.coefficients[0], 0.0);
        let steps = self.axis.recurrence().windows(2);
        for (coefficient, step) in self.coefficients[1..].iter().zip(steps) {
            let [(b, _), (_, reciprocal)] = [step[0], step[1]];
            let next = ((t * now.0 - b * before.0) * reciprocal, (now.0 + t * now.1 - b * before.1) * reciprocal);
            value += coefficient * next.0;
            slope += coefficient * next.1;
            (before, now) = (now, next);
        }
        (value, slope)
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Univariate};

    const TOLERANCE: f64 = 1e-12; // round-off of sums of up to 32 terms

    #[test]
    fn analytic_gauss_rules_integrate_moments() {
        let moment = |axis: Axis, n: usize, power: i32| -> f64 {
            axis.gauss_rule(n).iter().map(|(node, weight)| weight * node.powi(power)).sum()
        };
        for n in [5, 8, 24, 32] {
            assert_eq!(Axis::Hermite.gauss_rule(n).len(), n);
            assert_eq!(Axis::Legendre.gauss_rule(n).len(), n);
            for (power, normal, uniform) in [(2, 1.0, 1.0 / 3.0), (4, 3.0, 0.2), (8, 105.0, 1.0 / 9.0)] {
                assert!((moment(Axis::Hermite, n, power) / normal - 1.0).abs() < TOLERANCE, "{n} {power}");
                assert!((moment(Axis::Legendre, n, power) / uniform - 1.0).abs() < TOLERANCE, "{n} {power}");
            }
        }
    }

    #[test]
    fn analytic_the_third_hermite_polynomial_and_its_slope() {
        // (t³ - 3t)/√6
        let cubic = Univariate { axis: Axis::Hermite, coefficients: vec![0.0, 0.0, 0.0, 6.0_f64.sqrt()] };
        let (value, slope) = cubic.at(1.7);
        assert!((value - (1.7_f64.powi(3) - 3.0 * 1.7)).abs() < TOLERANCE);
        assert!((slope - (3.0 * 1.7_f64.powi(2) - 3.0)).abs() < TOLERANCE);
    }
}
