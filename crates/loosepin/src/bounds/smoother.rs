//! A statistic as a function of u, from its estimates at a few points: smoothed, interpolated, with an error.
//!
//! ```text
//! S(u) = f(u)ᵀβ + Z(u),   estimate_i = S(u_i) + noise_i
//! Z: Gaussian process, variance σ², correlation (1 + √5 r + 5r²/3) exp(-√5 r), r = |u - u'|/ℓ     (Matérn 5/2)
//! f: polynomial of degree 2, 1 or 0;   noise: independent, variance τσ²
//! ```
//!
//! β and σ² are estimated, ℓ and τ chosen from a grid by restricted maximum likelihood, τσ² never above the sampling
//! variance that the replicates show. With common random numbers the error of a smooth response is itself a smooth
//! function of u, the likelihood takes τ = 0, and an extreme is located as precisely as the points allow; where the response
//! is chaotic it takes τ > 0, and one lucky estimate is not taken for an extreme.
//!
//! Everything is linear in the estimates once (ℓ, τ) is fixed, so that hundreds of statistics share the matrices. Source:
//! C. E. Rasmussen and C. K. I. Williams, "Gaussian processes for machine learning" (2006), sections 2.2, 2.7, 4.2.

use std::sync::OnceLock;

use rayon::prelude::*;

use super::dense::{Cholesky, dot, multiply};

/// Length scales ℓ of the grid, in units of the diagonal of the box.
const LENGTH_SCALES: [f64; 6] = [0.08, 0.16, 0.32, 0.64, 1.28, 2.56];

/// Noise ratios τ of the grid. The first stands for none, and keeps the matrices positive definite.
const NOISE_RATIOS: [f64; 8] = [1e-10, 1e-6, 1e-4, 1e-2, 0.1, 1.0, 10.0, 100.0];

/// A deviation σ below this share of the range of the estimates is round-off.
const LEAST_DEVIATION: f64 = 1e-12;

/// Of the models whose misfit, -2 ln likelihood, exceeds the least one by no more than this, those with the most noise are
/// preferred; of them the likeliest, or without noise the one with the shortest ℓ. What cannot be told apart is taken the
/// cautious way: rather noise than an extreme, rather rough than smooth.
const TOLERATED_MISFIT: f64 = 4.0;

/// Standardised errors of predicting each estimate from the others may go up to this before the model is mistrusted.
const EXPECTED_SURPRISE: f64 = 2.5;

/// The matrices of one set of points, shared by all statistics that are known there.
pub(super) struct Smoother {
    points: Vec<Vec<f64>>,
    places: Vec<Vec<f64>>,
    trend: Trend,
    /// Polynomial at the points, row by row, and the factor of its normal equations.
    basis: Vec<f64>,
    normal_equations: Cholesky,
    models: Vec<Model>,
}

/// What (ℓ, τ) fixes.
struct Model {
    length_scale: f64,
    noise_ratio: f64,
    /// V⁻¹, V = correlation + τ.
    inverse: Vec<f64>,
    /// P = V⁻¹ - V⁻¹F (FᵀV⁻¹F)⁻¹ FᵀV⁻¹
    projection: Vec<f64>,
    /// V⁻¹F, column by column.
    weighted_basis: Vec<f64>,
    /// (FᵀV⁻¹F)⁻¹
    trend_covariance: Vec<f64>,
    /// ln det V + ln det FᵀV⁻¹F
    ln_determinants: f64,
    at_places: OnceLock<Prediction>,
}

/// Weights of the estimates (row by row) and variances in units of σ², at all places.
struct Prediction {
    weights: Vec<f64>,
    variances: Vec<f64>,
}

/// A statistic fitted on a smoother's points.
pub(super) struct Fit<'a> {
    smoother: &'a Smoother,
    model: &'a Model,
    values: Vec<f64>,
    centre: f64,
    deviation: f64,
}

impl Smoother {
    /// Prepares all of the grid for `points` of the unit box; predictions are wanted at `places` and at the points
    /// themselves. Models with noise are prepared where `has_noise`. Nothing where there are too few points for any model.
    pub fn try_new(points: Vec<Vec<f64>>, candidates: &[Vec<f64>], has_noise: bool) -> Option<Self> {
        let dimensions = points.first()?.len();
        let (trend, basis, normal_equations) = Trend::for_points(&points)?;
        let noise_ratios = if has_noise { &NOISE_RATIOS[..] } else { &NOISE_RATIOS[..1] };
        let grid: Vec<(f64, f64)> = noise_ratios
            .iter()
            .flat_map(|&noise_ratio| LENGTH_SCALES.iter().map(move |&length_scale| (length_scale, noise_ratio)))
            .collect();
        let diagonal = (dimensions as f64).sqrt();
        let models: Vec<Model> = grid
            .into_par_iter()
            .filter_map(|(scale, noise_ratio)| Model::try_new(&points, &basis, scale * diagonal, noise_ratio))
            .collect();
        if models.is_empty() {
            return None;
        }
        let places = candidates.iter().chain(&points).cloned().collect();
        Some(Self { points, places, trend, basis, normal_equations, models })
    }

    /// Fits `values` (one for each point) whose mean sampling variance is `noise_variance`.
    pub fn fit(&self, values: &[f64], noise_variance: f64) -> Fit<'_> {
        let count = values.len();
        let centre = values.iter().sum::<f64>() / count as f64;
        let values: Vec<f64> = values.iter().map(|value| value - centre).collect();
        let range = values.iter().fold(0.0_f64, |range, value| range.max(value.abs()));
        let residual = self.residual(&values);
        let freedom = count - self.basis.len() / count;
        let floor = (LEAST_DEVIATION * range).powi(2);
        let mut assessed: Vec<(&Model, f64, f64)> = Vec::new();
        for model in &self.models {
            let is_noisy = model.noise_ratio > NOISE_RATIOS[0];
            if is_noisy && noise_variance <= floor {
                continue;
            }
            let variance = (dot(&residual, &multiply(&model.projection, &residual)) / freedom as f64).max(floor);
            if !is_noisy || model.noise_ratio * variance <= noise_variance {
                let ln_variance = if variance > 0.0 { libm::log(variance) } else { 0.0 };
                assessed.push((model, variance, freedom as f64 * ln_variance + model.ln_determinants));
            }
        }
        // Where no model without noise could be factorised and none with noise is allowed, the first is what there is.
        let least = assessed.iter().fold(f64::INFINITY, |least, (_, _, misfit)| least.min(*misfit));
        assessed.retain(|(_, _, misfit)| *misfit <= least + TOLERATED_MISFIT);
        let noisiest = assessed.iter().fold(0.0_f64, |most, (model, ..)| most.max(model.noise_ratio));
        assessed.retain(|(model, ..)| model.noise_ratio == noisiest);
        let chosen = if noisiest > NOISE_RATIOS[0] {
            assessed.iter().min_by(|a, b| a.2.total_cmp(&b.2))
        } else {
            assessed.first()
        };
        // Where no model without noise could be factorised and none with noise is allowed, the first is what there is.
        let (model, variance, _) = chosen.copied().unwrap_or((&self.models[0], noise_variance.max(floor), 0.0));
        let deviation = variance.sqrt() * surprise(model, &residual, variance);
        Fit { smoother: self, model, values, centre, deviation }
    }

    /// What the polynomial alone, by ordinary least squares, leaves: the models see the same misfit with less round-off.
    fn residual(&self, values: &[f64]) -> Vec<f64> {
        let size = self.basis.len() / values.len();
        let mut coefficients = vec![0.0; size];
        for (row, value) in self.basis.chunks(size).zip(values) {
            for (coefficient, entry) in coefficients.iter_mut().zip(row) {
                *coefficient += entry * value;
            }
        }
        self.normal_equations.solve(&mut coefficients);
        self.basis.chunks(size).zip(values).map(|(row, value)| value - dot(row, &coefficients)).collect()
    }
}

/// The factor >= 1 by which the error bars of `model` are too short for its worst prediction of an estimate from all the
/// others: (P y)_i/(σ √P_ii) is that error in its standard deviation (S. Sundararajan and S. S. Keerthi, "Predictive
/// approaches for choosing hyperparameters in Gaussian processes", Neural Computation 13 (2001) 1103-1118). A function
/// that is rougher in one place than in others shows itself here.
fn surprise(model: &Model, residual: &[f64], variance: f64) -> f64 {
    if variance <= 0.0 {
        return 1.0;
    }
    let count = residual.len();
    let errors = multiply(&model.projection, residual);
    let worst = errors.iter().enumerate().fold(0.0_f64, |worst, (i, error)| {
        let scale = variance * model.projection[i * count + i];
        if scale > 0.0 { worst.max(error.abs() / scale.sqrt()) } else { worst }
    });
    (worst / EXPECTED_SURPRISE).max(1.0)
}

impl Fit<'_> {
    /// Whether the fit passes beside the estimates rather than through them.
    pub fn is_smoothed(&self) -> bool {
        self.model.noise_ratio > NOISE_RATIOS[0]
    }

    /// Places of [`Fit::at_places`].
    pub fn places(&self) -> &[Vec<f64>] {
        &self.smoother.places
    }

    /// Mean and standard deviation of S at every place: first the candidates, then the points.
    pub fn at_places(&self) -> impl Iterator<Item = (f64, f64)> {
        let prediction = self.model.at_places.get_or_init(|| {
            let (weights, variances): (Vec<_>, Vec<_>) =
                self.smoother.places.iter().map(|place| self.model.predict(self.smoother, place)).unzip();
            Prediction { weights: weights.concat(), variances }
        });
        prediction
            .weights
            .chunks(self.values.len())
            .zip(&prediction.variances)
            .map(|(weights, variance)| (self.centre + dot(weights, &self.values), self.deviation * variance.sqrt()))
    }

    /// Mean and standard deviation of S at `place`.
    pub fn at(&self, place: &[f64]) -> (f64, f64) {
        let (weights, variance) = self.model.predict(self.smoother, place);
        (self.centre + dot(&weights, &self.values), self.deviation * variance.sqrt())
    }
}

impl Model {
    fn try_new(points: &[Vec<f64>], basis: &[f64], length_scale: f64, noise_ratio: f64) -> Option<Self> {
        let count = points.len();
        let size = basis.len() / count;
        let mut covariance = vec![0.0; count * count];
        for (row, point) in covariance.chunks_mut(count).zip(points) {
            for (entry, other) in row.iter_mut().zip(points) {
                *entry = correlation(point, other, length_scale);
            }
        }
        for i in 0..count {
            covariance[i * count + i] += noise_ratio;
        }
        let cholesky = Cholesky::new(covariance, count)?;
        let inverse = cholesky.inverse();
        let mut weighted_basis = vec![0.0; size * count];
        for (column, weighted) in weighted_basis.chunks_mut(count).enumerate() {
            let values: Vec<f64> = basis.chunks(size).map(|row| row[column]).collect();
            weighted.copy_from_slice(&multiply(&inverse, &values));
        }
        let mut information = vec![0.0; size * size];
        for i in 0..size {
            for (point, row) in basis.chunks(size).enumerate() {
                for j in 0..size {
                    information[i * size + j] += weighted_basis[i * count + point] * row[j];
                }
            }
        }
        let information = Cholesky::new(information, size)?;
        let trend_covariance = information.inverse();
        let mut projection = inverse.clone();
        for i in 0..count {
            let row: Vec<f64> = (0..size).map(|k| weighted_basis[k * count + i]).collect();
            let row = multiply(&trend_covariance, &row);
            for (k, factor) in row.into_iter().enumerate() {
                let weighted = &weighted_basis[k * count..(k + 1) * count];
                for (entry, value) in projection[i * count..(i + 1) * count].iter_mut().zip(weighted) {
                    *entry -= factor * value;
                }
            }
        }
        let ln_determinants = cholesky.ln_determinant() + information.ln_determinant();
        Some(Self {
            length_scale,
            noise_ratio,
            inverse,
            projection,
            weighted_basis,
            trend_covariance,
            ln_determinants,
            at_places: OnceLock::new(),
        })
    }

    /// Weights of the estimates and variance (in units of σ²) of S at `place`:
    /// a = V⁻¹k, r = f - Fᵀa, w = a + V⁻¹F G r, v = 1 - kᵀa + rᵀG r, G = (FᵀV⁻¹F)⁻¹.
    fn predict(&self, smoother: &Smoother, place: &[f64]) -> (Vec<f64>, f64) {
        let count = smoother.points.len();
        let correlations: Vec<f64> =
            smoother.points.iter().map(|point| correlation(point, place, self.length_scale)).collect();
        let mut weights = multiply(&self.inverse, &correlations);
        let mut rest = smoother.trend.at(place);
        for (row, weight) in smoother.basis.chunks(rest.len()).zip(&weights) {
            for (entry, value) in rest.iter_mut().zip(row) {
                *entry -= weight * value;
            }
        }
        let gain = multiply(&self.trend_covariance, &rest);
        let variance = 1.0 - dot(&correlations, &weights) + dot(&rest, &gain);
        for (factor, weighted) in gain.iter().zip(self.weighted_basis.chunks(count)) {
            for (weight, value) in weights.iter_mut().zip(weighted) {
                *weight += factor * value;
            }
        }
        (weights, variance.max(0.0))
    }
}

/// Degree of the polynomial f.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Trend {
    Constant,
    Linear,
    Quadratic,
}

impl Trend {
    /// The highest degree with at least two points for each coefficient that the points determine, with its terms at the
    /// points (row by row) and the factor of its normal equations.
    fn for_points(points: &[Vec<f64>]) -> Option<(Self, Vec<f64>, Cholesky)> {
        let dimensions = points.first()?.len();
        [Self::Quadratic, Self::Linear, Self::Constant].into_iter().find_map(|trend| {
            let size = trend.size(dimensions);
            if 2 * size > points.len() {
                return None;
            }
            let basis: Vec<f64> = points.iter().flat_map(|point| trend.at(point)).collect();
            let normal_equations = Cholesky::new(gram(&basis, size), size)?;
            Some((trend, basis, normal_equations))
        })
    }

    fn size(self, dimensions: usize) -> usize {
        match self {
            Self::Constant => 1,
            Self::Linear => 1 + dimensions,
            Self::Quadratic => (dimensions + 1) * (dimensions + 2) / 2,
        }
    }

    /// 1, t_i, t_i t_j with t = 2u - 1.
    fn at(self, point: &[f64]) -> Vec<f64> {
        let mut terms = vec![1.0];
        if self != Self::Constant {
            terms.extend(point.iter().map(|x| 2.0 * x - 1.0));
        }
        if self == Self::Quadratic {
            for (i, x) in point.iter().enumerate() {
                terms.extend(point[i..].iter().map(|y| (2.0 * x - 1.0) * (2.0 * y - 1.0)));
            }
        }
        terms
    }
}

/// FᵀF of a basis given row by row.
fn gram(basis: &[f64], size: usize) -> Vec<f64> {
    let mut gram = vec![0.0; size * size];
    for row in basis.chunks(size) {
        for i in 0..size {
            for j in 0..size {
                gram[i * size + j] += row[i] * row[j];
            }
        }
    }
    gram
}

fn correlation(a: &[f64], b: &[f64], length_scale: f64) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum();
    let r = (5.0 * square).sqrt() / length_scale;
    (1.0 + r + r * r / 3.0) * libm::exp(-r)
}

#[cfg(test)]
mod tests {
    use super::Smoother;
    use crate::bounds::points::{candidates, first_points};
    use crate::uncertainty::{hash, normal_quantile};

    #[test]
    fn analytic_a_quadratic_is_met_everywhere_to_round_off() {
        const TOLERANCE: f64 = 1e-9;
        let points = first_points(5, 3, 40).unwrap();
        let function = |u: &[f64]| 0.3 + u[0] * u[1] - 2.0 * u[2] * u[2] + 0.7 * u[1];
        let values: Vec<f64> = points.iter().map(|u| function(u)).collect();
        let smoother = Smoother::try_new(points, &candidates(3).unwrap(), false).unwrap();
        let fit = smoother.fit(&values, 0.0);
        for (place, (mean, deviation)) in fit.places().iter().zip(fit.at_places()) {
            assert!((mean - function(place)).abs() < TOLERANCE && deviation < TOLERANCE, "{mean} {deviation}");
        }
    }

    #[test]
    fn identity_a_smooth_function_lies_within_the_stated_deviation() {
        // Share of places within two deviations; a Gaussian process would have 0.95, chosen grid and all.
        const LEAST_SHARE: f64 = 0.9;
        const LARGEST_DEVIATION: f64 = 0.05; // of a function with range 2.6
        let points = first_points(7, 2, 32).unwrap();
        let function = |u: &[f64]| (4.0 * u[0]).sin() + 0.6 * (3.0 * u[1] + u[0]).cos();
        let values: Vec<f64> = points.iter().map(|u| function(u)).collect();
        let smoother = Smoother::try_new(points, &candidates(2).unwrap(), false).unwrap();
        let fit = smoother.fit(&values, 0.0);
        let places = fit.places().len() as f64;
        let within = fit
            .places()
            .iter()
            .zip(fit.at_places())
            .filter(|(place, (mean, deviation))| (mean - function(place)).abs() <= 2.0 * deviation + 1e-9)
            .count() as f64;
        assert!(within / places > LEAST_SHARE, "{}", within / places);
        let largest = fit.at_places().fold(0.0_f64, |largest, (_, deviation)| largest.max(deviation));
        assert!(largest < LARGEST_DEVIATION, "{largest}");
    }

    #[test]
    fn identity_noise_is_smoothed_and_the_absence_of_noise_is_not() {
        let points = first_points(9, 1, 40).unwrap();
        let noise = |i: usize| 0.2 * normal_quantile((hash(3, i as u64) >> 11) as f64 / (1_u64 << 53) as f64);
        let noisy: Vec<f64> = points.iter().enumerate().map(|(i, u)| u[0] * u[0] + noise(i)).collect();
        let exact: Vec<f64> = points.iter().map(|u| (5.0 * u[0]).exp()).collect();
        let smoother = Smoother::try_new(points, &candidates(1).unwrap(), true).unwrap();
        let fit = smoother.fit(&noisy, 0.04);
        assert!(fit.is_smoothed());
        // At the ends a parabola through 40 points is known to 0.2 √(9/40) = 0.1.
        const TOLERANCE: f64 = 0.3;
        let worst = fit
            .places()
            .iter()
            .zip(fit.at_places())
            .fold(0.0_f64, |worst, (u, (mean, _))| worst.max((mean - u[0] * u[0]).abs()));
        assert!(worst < TOLERANCE, "{worst}");
        assert!(!smoother.fit(&exact, 0.04).is_smoothed());
    }
}
