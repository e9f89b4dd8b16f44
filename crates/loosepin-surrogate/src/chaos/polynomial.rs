//! Polynomials that are orthonormal under a distribution.

use loosepin_math::orthonormal_values;
use serde::{Deserialize, Serialize};

/// A family of orthonormal polynomials p_0 = 1, p_1, ... of a standard variable ξ: E\[p_m(ξ) p_n(ξ)\] is 1 for m = n and 0
/// otherwise.
///
/// Source: W. Gautschi, "Orthogonal Polynomials: Computation and Approximation", Oxford 2004, table 1.1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Family {
    /// Of Hermite: ξ is standard normal.
    Hermite,
    /// Of Jacobi: ξ in \[-1, 1\] with a density proportional to (1 - ξ)^a (1 + ξ)^b. Legendre's (uniform) are a = b = 0,
    /// Chebyshev's (an interval, without a distribution of its own) a = b = -1/2.
    Jacobi {
        /// Exponent of 1 - ξ, > -1.
        a: f64,
        /// Exponent of 1 + ξ, > -1.
        b: f64,
    },
}

impl Family {
    /// Legendre's polynomials.
    pub const LEGENDRE: Self = Self::Jacobi { a: 0.0, b: 0.0 };
    /// Chebyshev's polynomials of the first kind.
    pub const CHEBYSHEV: Self = Self::Jacobi { a: -0.5, b: -0.5 };

    /// p_0 to p_degree at ξ.
    pub fn values(self, standard: f64, degree: usize) -> Vec<f64> {
        orthonormal_values(standard, degree, &|n| {
            let (shift, square) = self.recurrence(n);
            (shift, square.sqrt())
        })
    }

    /// a_n and b_(n+1).
    fn recurrence(self, n: usize) -> (f64, f64) {
        let order = n as f64;
        match self {
            Self::Hermite => (0.0, order + 1.0),
            Self::Jacobi { a, b } => {
                let sum = a + b;
                let shift = if n == 0 {
                    (b - a) / (sum + 2.0)
                } else {
                    (b - a) * sum / ((2.0 * order + sum) * (2.0 * order + sum + 2.0))
                };
                let k = order + 1.0;
                // The general formula divides 0 by 0 at k = 1 where a + b = -1.
                let square = if n == 0 {
                    4.0 * (1.0 + a) * (1.0 + b) / ((2.0 + sum) * (2.0 + sum) * (3.0 + sum))
                } else {
                    let middle = 2.0 * k + sum;
                    4.0 * k * (k + a) * (k + b) * (k + sum) / (middle * middle * (middle + 1.0) * (middle - 1.0))
                };
                (shift, square)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Family;

    #[test]
    fn analytic_the_first_polynomials_are_those_of_the_tables() {
        const TOLERANCE: f64 = 1e-14; // round-off of a few operations
        let x = 0.37_f64;
        let expected = [
            (Family::Hermite, (x.powi(3) - 3.0 * x) / 6.0_f64.sqrt()),
            (Family::LEGENDRE, 7.0_f64.sqrt() * (5.0 * x.powi(3) - 3.0 * x) / 2.0),
            (Family::CHEBYSHEV, 2.0_f64.sqrt() * (4.0 * x.powi(3) - 3.0 * x)),
        ];
        for (family, third) in expected {
            assert!((family.values(x, 3)[3] - third).abs() < TOLERANCE, "{family:?}");
        }
    }

    type Quantile = fn(f64) -> f64;

    /// Means over the quantiles at midpoints, or for a normal variable the trapezoidal rule on its density.
    fn mean_products(family: Family, quantile: Option<Quantile>) -> [[f64; 5]; 5] {
        let count = 20_000_u32;
        let mut means = [[0.0; 5]; 5];
        for i in 0..count {
            let share = (f64::from(i) + 0.5) / f64::from(count);
            let normal = 24.0 * (share - 0.5);
            let density = libm::exp(-0.5 * normal * normal) / (2.0 * core::f64::consts::PI).sqrt();
            let (at, weight) = quantile.map_or((normal, 24.0 * density), |quantile| (quantile(share), 1.0));
            let values = family.values(at, 4);
            for m in 0..5 {
                for n in 0..5 {
                    means[m][n] += weight * values[m] * values[n] / f64::from(count);
                }
            }
        }
        means
    }

    #[test]
    fn identity_polynomials_are_orthonormal_under_their_distribution() {
        // The width of a cell, 5e-5, squared, times the second derivative of a polynomial of degree eight, below 1e4.
        const TOLERANCE: f64 = 1e-4;
        // Beta(2, 1) has the density 2x on [0, 1], so a = 0, b = 1 and x = √p.
        let cases: [(Family, Option<Quantile>); 4] = [
            (Family::Hermite, None),
            (Family::LEGENDRE, Some(|p| 2.0 * p - 1.0)),
            (Family::CHEBYSHEV, Some(|p| -libm::cos(core::f64::consts::PI * p))),
            (Family::Jacobi { a: 0.0, b: 1.0 }, Some(|p| 2.0 * p.sqrt() - 1.0)),
        ];
        for (family, quantile) in cases {
            for (m, row) in mean_products(family, quantile).iter().enumerate() {
                for (n, mean) in row.iter().enumerate() {
                    let expected = f64::from(u8::from(m == n));
                    assert!((mean - expected).abs() < TOLERANCE, "{family:?}: <{m}, {n}> = {mean}");
                }
            }
        }
    }
}
