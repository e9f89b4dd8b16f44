//! A Gaussian process with a polynomial mean, for one choice of its correlation and noise.
//!
//! Everything is whitened with W = L⁻¹, V = L Lᵀ the correlation of the estimates: B = WF, and with G = (BᵀB)⁻¹
//!
//! ```text
//! P = Wᵀ(1 - B G Bᵀ)W                            σ² = yᵀP y/(n - p)
//! at a place: c = Wk, r = f - Bᵀc                mean = (c + B G r)ᵀ W y,   variance = σ² (1 - cᵀc + rᵀG r)
//! ```
//!
//! V itself is never inverted: its condition number is up to 1e13, that of L the square root of it.

use std::sync::OnceLock;

use super::trend::{Trend, gram};
use loosepin_math::dense::{Cholesky, LowerTriangle, dot, multiply};

/// How often the process can be differentiated: Matérn 3/2, 5/2, 9/2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Smoothness {
    Once,
    Twice,
    FourTimes,
}

/// The correlation of the process between two places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kernel {
    pub smoothness: Smoothness,
    pub length_scale: f64,
}

impl Kernel {
    fn correlation(&self, a: &[f64], b: &[f64]) -> f64 {
        let square: f64 = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum();
        let r = square.sqrt() / self.length_scale;
        match self.smoothness {
            Smoothness::Once => {
                let s = 3.0_f64.sqrt() * r;
                (1.0 + s) * libm::exp(-s)
            }
            Smoothness::Twice => {
                let s = 5.0_f64.sqrt() * r;
                (1.0 + s + s * s / 3.0) * libm::exp(-s)
            }
            Smoothness::FourTimes => {
                let s = 3.0 * r;
                (1.0 + s * (1.0 + s * (3.0 / 7.0 + s * (2.0 / 21.0 + s / 105.0)))) * libm::exp(-s)
            }
        }
    }
}

/// What points, correlation and noise fix, whatever the estimates are.
pub(super) struct Model {
    points: Vec<Vec<f64>>,
    trend: Trend,
    kernel: Kernel,
    noise_ratio: f64,
    /// W
    whitening: LowerTriangle,
    /// B, column by column.
    white_terms: Vec<f64>,
    /// G
    trend_covariance: Vec<f64>,
    /// P_ii
    projection_diagonal: Vec<f64>,
    /// ln det V + ln det FᵀV⁻¹F
    ln_determinants: f64,
    at_places: OnceLock<Vec<Prediction>>,
}

/// What a place has to do with the points.
struct Prediction {
    /// c = W k
    correlations: Vec<f64>,
    /// r = f - Bᵀc
    rest: Vec<f64>,
    /// For σ = 1.
    variance: f64,
}

impl Prediction {
    fn mean_and_variance(&self, white: &[f64], of_trend: &[f64]) -> (f64, f64) {
        (dot(&self.correlations, white) + dot(&self.rest, of_trend), self.variance)
    }
}

impl Model {
    /// A model on `points`, whose polynomial has these `terms` there (row by row); nothing where V is singular to round-off.
    pub fn try_new(points: &[Vec<f64>], trend: Trend, terms: &[f64], kernel: Kernel, noise_ratio: f64) -> Option<Self> {
        let count = points.len();
        let size = terms.len() / count;
        let mut covariance = Vec::with_capacity(count * count);
        for (i, point) in points.iter().enumerate() {
            covariance.extend(points.iter().map(|other| kernel.correlation(point, other)));
            covariance[i * count + i] += noise_ratio;
        }
        let cholesky = Cholesky::new(covariance, count)?;
        let whitening = cholesky.inverse_factor();
        let mut white_terms = Vec::with_capacity(size * count);
        for column in 0..size {
            let values: Vec<f64> = terms.chunks(size).map(|row| row[column]).collect();
            white_terms.extend(whitening.multiply(&values));
        }
        let by_point: Vec<f64> =
            (0..count).flat_map(|i| (0..size).map(move |k| (k, i))).map(|(k, i)| white_terms[k * count + i]).collect();
        let information = Cholesky::new(gram(&by_point, size), size)?;
        let trend_covariance = information.inverse();
        // Rows of WᵀB give the part of P_ii that the polynomial takes away.
        let projected: Vec<Vec<f64>> =
            white_terms.chunks(count).map(|column| whitening.multiply_transposed(column)).collect();
        let mut projection_diagonal = whitening.column_squares();
        for (i, entry) in projection_diagonal.iter_mut().enumerate() {
            let row: Vec<f64> = projected.iter().map(|column| column[i]).collect();
            *entry -= dot(&row, &multiply(&trend_covariance, &row));
        }
        Some(Self {
            points: points.to_vec(),
            trend,
            kernel,
            noise_ratio,
            whitening,
            white_terms,
            trend_covariance,
            projection_diagonal,
            ln_determinants: cholesky.ln_determinant() + information.ln_determinant(),
            at_places: OnceLock::new(),
        })
    }

    /// How often the process can be differentiated.
    pub fn smoothness(&self) -> Smoothness {
        self.kernel.smoothness
    }

    /// τ
    pub fn noise_ratio(&self) -> f64 {
        self.noise_ratio
    }

    /// ln det V + ln det FᵀV⁻¹F
    pub fn ln_determinants(&self) -> f64 {
        self.ln_determinants
    }

    /// yᵀP y
    pub fn misfit(&self, values: &[f64]) -> f64 {
        let rest = self.whitened_rest(values);
        dot(&rest, &rest)
    }

    /// The largest error of predicting an estimate from all the others, divided by its standard deviation for σ = 1:
    /// max |(P y)_i|/√P_ii. S. Sundararajan and S. S. Keerthi, "Predictive approaches for choosing hyperparameters in
    /// Gaussian processes", Neural Computation 13 (2001) 1103-1118. A function that is rougher in one place than in others
    /// shows itself here.
    pub fn largest_error(&self, values: &[f64]) -> f64 {
        let errors = self.whitening.multiply_transposed(&self.whitened_rest(values));
        errors.iter().zip(&self.projection_diagonal).fold(0.0, |largest, (error, diagonal)| {
            if *diagonal > 0.0 { largest.max(error.abs() / diagonal.sqrt()) } else { largest }
        })
    }

    /// (1 - B G Bᵀ) W y
    fn whitened_rest(&self, values: &[f64]) -> Vec<f64> {
        let count = values.len();
        let mut rest = self.whitening.multiply(values);
        let shares = multiply(&self.trend_covariance, &multiply(&self.white_terms, &rest));
        for (share, column) in shares.iter().zip(self.white_terms.chunks(count)) {
            for (entry, value) in rest.iter_mut().zip(column) {
                *entry -= share * value;
            }
        }
        rest
    }

    /// W y, and G Bᵀ W y: what the mean at any place takes of `values`.
    pub fn whitened(&self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let white = self.whitening.multiply(values);
        let of_trend = multiply(&self.trend_covariance, &multiply(&self.white_terms, &white));
        (white, of_trend)
    }

    /// Mean, and variance for σ = 1, of the process at `place`, from [`Self::whitened`] estimates.
    pub fn mean_and_variance(&self, place: &[f64], (white, of_trend): (&[f64], &[f64])) -> (f64, f64) {
        self.predict(place).mean_and_variance(white, of_trend)
    }

    fn predict(&self, place: &[f64]) -> Prediction {
        let correlations: Vec<f64> = self.points.iter().map(|point| self.kernel.correlation(point, place)).collect();
        let correlations = self.whitening.multiply(&correlations);
        let explained = multiply(&self.white_terms, &correlations);
        let rest: Vec<f64> = self.trend.terms(place).iter().zip(explained).map(|(term, known)| term - known).collect();
        let variance = 1.0 - dot(&correlations, &correlations) + dot(&rest, &multiply(&self.trend_covariance, &rest));
        Prediction { correlations, rest, variance: variance.max(0.0) }
    }

    /// Mean, and variance for σ = 1, at all of `places` in their order; what the estimates have no part in is worked out once, so the
    /// places must not change.
    pub fn at_places(
        &self,
        places: &[Vec<f64>],
        (white, of_trend): (&[f64], &[f64]),
    ) -> impl Iterator<Item = (f64, f64)> {
        let predictions =
            self.at_places.get_or_init(|| places.iter().map(|place| self.predict(place)).collect::<Vec<Prediction>>());
        predictions.iter().map(move |prediction| prediction.mean_and_variance(white, of_trend))
    }
}
