//! Covariance of a Gaussian process between two points.

use crate::gaussian::gaussian_process::matern_five_halves;
use serde::{Deserialize, Serialize};

/// How alike the outputs at two points are, by r² = Σ (x_k - x'_k)²/ℓ_k² with one length scale an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Kernel {
    /// (1 + s + s²/3) exp(-s), s = √5 r: Matérn's with ν = 5/2; functions with two derivatives.
    Matern52,
    /// exp(-r²/2): functions with all derivatives.
    SquaredExponential,
}

impl Kernel {
    /// The correlation at r², and ρ with ∂correlation/∂ln ℓ_k = ρ (x_k - x'_k)²/ℓ_k².
    pub(crate) fn correlation_and_slope(self, square: f64) -> (f64, f64) {
        match self {
            Self::Matern52 => {
                let s = (5.0 * square).sqrt();
                let (correlation, decay) = matern_five_halves(s);
                (correlation, 5.0 / 3.0 * (1.0 + s) * decay)
            }
            Self::SquaredExponential => {
                let value = libm::exp(-0.5 * square);
                (value, value)
            }
        }
    }
}
