//! A statistic as a function of u, from its estimates at a few points: smoothed, interpolated, with an error.
//!
//! ```text
//! S(u) = f(u)ᵀβ + Z(u),   estimate_i = S(u_i) + noise_i
//! Z: Gaussian process, variance σ², correlation by the distance r = |u - u'|/ℓ:
//!    (1 + s) exp(-s), s = √3 r,                                  Matérn 3/2: one derivative,
//!    (1 + s + s²/3) exp(-s), s = √5 r,                           Matérn 5/2: two derivatives, or
//!    (1 + s + 3s²/7 + 2s³/21 + s⁴/105) exp(-s), s = 3r,          Matérn 9/2: four derivatives
//! f: polynomial of degree 2, 1 or 0;   noise: independent, variance τσ²
//! an angle over a whole turn enters f and r as a point on a circle
//! ```
//!
//! β and σ² are estimated, smoothness, ℓ and τ chosen from a grid by restricted maximum likelihood, τσ² never above the sampling
//! variance that the replicates show. With common random numbers the error of a smooth response is itself a smooth
//! function of u, the likelihood takes τ = 0, and an extreme is located as precisely as the points allow; where the response
//! is chaotic it takes τ > 0, and one lucky estimate is not taken for an extreme.
//!
//! Everything is linear in the estimates once (ℓ, τ) is fixed, so that hundreds of statistics share the matrices. Source:
//! C. E. Rasmussen and C. K. I. Williams, "Gaussian processes for machine learning" (2006), sections 2.2, 2.7, 4.2.

use rayon::prelude::*;

use super::gaussian_process::{Kernel, Model, Smoothness};
use super::search_box::Axes;
use super::trend::Trend;
use loosepin_math::dense::{Cholesky, dot};

/// Points of a smoother, at most: it factorises matrices of this order.
pub(crate) const MOST_POINTS: usize = 512;

/// Length scales ℓ of the grid, in units of the diagonal of the box.
const LENGTH_SCALES: [f64; 6] = [0.08, 0.16, 0.32, 0.64, 1.28, 2.56];

/// Noise ratios τ of the grid. The first stands for none, and keeps the matrices positive definite.
const NOISE_RATIOS: [f64; 6] = [1e-11, 1e-4, 1e-2, 0.3, 5.0, 100.0];

/// A deviation σ below this share of the range of the estimates is round-off.
const LEAST_DEVIATION: f64 = 1e-12;

/// Of the models whose misfit, -2 ln likelihood, exceeds the least one by no more than this, those with the most noise are
/// preferred; of them the likeliest, or without noise the roughest one with the shortest ℓ. What cannot be told apart is
/// taken the cautious way: rather noise than an extreme, rather rough than smooth.
const TOLERATED_MISFIT: f64 = 4.0;

/// Where every model with some noise is worse than one with less by this, those with more noise are not tried.
const HOPELESS_MISFIT: f64 = 50.0;

/// Standardised errors of predicting each estimate from the others may go up to this before the model is mistrusted.
const EXPECTED_SURPRISE: f64 = 2.5;

/// The models of one set of points, shared by all statistics that are known there.
pub(crate) struct Smoother {
    /// Where predictions are wanted: candidates, then the points themselves.
    places: Vec<Vec<f64>>,
    /// The places in the coordinates of the models, and how the axes close.
    seen_places: Vec<Vec<f64>>,
    axes: Axes,
    /// Terms of the polynomial at the points, row by row, and the factor of its normal equations.
    terms: Vec<f64>,
    normal_equations: Cholesky,
    /// Models of the same noise ratio together, from little to much noise; the first is never empty.
    levels: Vec<Vec<Model>>,
}

/// A statistic fitted on a smoother's points.
pub(crate) struct Fit<'a> {
    smoother: &'a Smoother,
    model: &'a Model,
    /// The whitened values, by which the mean is taken at any place.
    whitened: (Vec<f64>, Vec<f64>),
    centre: f64,
    deviation: f64,
    noise_variance: f64,
    /// -2 ln likelihood for each degree of freedom.
    misfit: f64,
}

impl Smoother {
    /// Prepares all of the grid for `points` of the unit box; predictions are wanted at `candidates` and at the points
    /// themselves. Models with noise are prepared where `has_noise`. Nothing where there are too few points for any model.
    pub fn try_new(points: Vec<Vec<f64>>, candidates: &[Vec<f64>], has_noise: bool, axes: &Axes) -> Option<Self> {
        let seen: Vec<Vec<f64>> = points.iter().map(|point| axes.seen(point)).collect();
        let (trend, terms, normal_equations) = Trend::for_points(&seen, axes.circles())?;
        let diagonal = (points.first()?.len() as f64).sqrt();
        let scales =
            |smoothness| LENGTH_SCALES.iter().map(move |scale| Kernel { smoothness, length_scale: scale * diagonal });
        let prepare = |kernels: Vec<Kernel>, noise_ratio: f64| -> Vec<Model> {
            let kernels = kernels.into_par_iter();
            kernels.filter_map(|kernel| Model::try_new(&seen, trend, &terms, kernel, noise_ratio)).collect()
        };
        // Noise hides how smooth a function is.
        let middling = || scales(Smoothness::Twice).collect();
        let from_rough_to_smooth = [Smoothness::Once, Smoothness::Twice, Smoothness::FourTimes];
        let without_noise = prepare(from_rough_to_smooth.into_iter().flat_map(scales).collect(), NOISE_RATIOS[0]);
        if without_noise.is_empty() {
            return None;
        }
        let noise_ratios = if has_noise { &NOISE_RATIOS[1..] } else { &[] };
        let with_noise = noise_ratios.iter().map(|&noise_ratio| prepare(middling(), noise_ratio));
        let levels = std::iter::once(without_noise).chain(with_noise).collect();
        let places: Vec<Vec<f64>> = candidates.iter().cloned().chain(points).collect();
        let seen_places = places.iter().map(|place| axes.seen(place)).collect();
        Some(Self { places, seen_places, axes: axes.clone(), terms, normal_equations, levels })
    }

    /// Fits `values` (one for each point) whose mean sampling variance is `noise_variance`.
    pub fn fit(&self, values: &[f64], noise_variance: f64) -> Fit<'_> {
        let count = values.len();
        let centre = values.iter().sum::<f64>() / count as f64;
        let values: Vec<f64> = values.iter().map(|value| value - centre).collect();
        let range = values.iter().fold(0.0_f64, |range, value| range.max(value.abs()));
        let residual = self.residual(&values);
        let freedom = (count - self.terms.len() / count) as f64;
        let floor = (LEAST_DEVIATION * range).powi(2);
        let mut assessed: Vec<(&Model, f64, f64)> = Vec::new();
        let mut least = f64::INFINITY;
        for level in &self.levels {
            let mut least_of_level = f64::INFINITY;
            for model in level {
                let is_noisy = model.noise_ratio() > NOISE_RATIOS[0];
                if is_noisy && noise_variance <= floor {
                    continue;
                }
                let variance = (model.misfit(&residual) / freedom).max(floor);
                let ln_variance = if variance > 0.0 { libm::log(variance) } else { 0.0 };
                let misfit = freedom * ln_variance + model.ln_determinants();
                least_of_level = least_of_level.min(misfit);
                if !is_noisy || model.noise_ratio() * variance <= noise_variance {
                    assessed.push((model, variance, misfit));
                }
            }
            least = least.min(least_of_level);
            if least_of_level > least + HOPELESS_MISFIT {
                break;
            }
        }
        let least = assessed.iter().fold(f64::INFINITY, |least, (_, _, misfit)| least.min(*misfit));
        assessed.retain(|(_, _, misfit)| *misfit <= least + TOLERATED_MISFIT);
        let noisiest = assessed.iter().fold(0.0_f64, |most, (model, ..)| most.max(model.noise_ratio()));
        assessed.retain(|(model, ..)| model.noise_ratio() == noisiest);
        let chosen = if noisiest > NOISE_RATIOS[0] {
            assessed.iter().min_by(|a, b| a.2.total_cmp(&b.2))
        } else {
            assessed.first()
        };
        // Models without noise are always allowed: where none is chosen, no misfit is a number.
        let (model, variance, misfit) = chosen.copied().unwrap_or((&self.levels[0][0], f64::INFINITY, f64::INFINITY));
        let surprise = if variance > 0.0 { model.largest_error(&residual) / variance.sqrt() } else { 0.0 };
        let distrust = (surprise / EXPECTED_SURPRISE).max(1.0);
        let deviation = variance.sqrt() * distrust;
        // With the variance that is stated in the place of the likeliest one.
        let misfit = misfit / freedom + 2.0 * libm::log(distrust) + 1.0 / (distrust * distrust);
        let is_noisy = model.noise_ratio() > NOISE_RATIOS[0];
        let noise_variance = if is_noisy { model.noise_ratio() * variance } else { 0.0 };
        let whitened = model.whitened(&values);
        Fit { smoother: self, model, whitened, centre, deviation, noise_variance, misfit }
    }

    /// Residuals of the polynomial alone, by ordinary least squares: the models see the same misfit with less round-off.
    fn residual(&self, values: &[f64]) -> Vec<f64> {
        let size = self.terms.len() / values.len();
        let mut coefficients = vec![0.0; size];
        for (row, value) in self.terms.chunks(size).zip(values) {
            for (coefficient, entry) in coefficients.iter_mut().zip(row) {
                *coefficient += entry * value;
            }
        }
        self.normal_equations.solve(&mut coefficients);
        self.terms.chunks(size).zip(values).map(|(row, value)| value - dot(row, &coefficients)).collect()
    }
}

impl Fit<'_> {
    /// Variance of the noise, 0 where the fit passes through the estimates.
    pub fn noise_variance(&self) -> f64 {
        self.noise_variance
    }

    /// Whether it passes through the values and they are those of something as smooth as the smoothest processes.
    pub fn is_smoothest(&self) -> bool {
        self.noise_variance == 0.0 && self.model.smoothness() == Smoothness::FourTimes
    }

    /// -2 ln likelihood of the values for each degree of freedom: what models of the same values in other scales are compared by, each
    /// with twice the mean logarithm of the slope of its scale.
    pub fn misfit(&self) -> f64 {
        self.misfit
    }

    /// Places of [`Fit::at_places`].
    pub fn places(&self) -> &[Vec<f64>] {
        &self.smoother.places
    }

    /// Mean and standard deviation of S at every place: first the candidates, then the points.
    pub fn at_places(&self) -> impl Iterator<Item = (f64, f64)> {
        let found = self.model.at_places(&self.smoother.seen_places, (&self.whitened.0, &self.whitened.1));
        found.map(|(mean, variance)| (self.centre + mean, self.deviation * variance.sqrt()))
    }

    /// Mean and standard deviation of S at `place`.
    pub fn at(&self, place: &[f64]) -> (f64, f64) {
        let seen = self.smoother.axes.seen(place);
        let (mean, variance) = self.model.mean_and_variance(&seen, (&self.whitened.0, &self.whitened.1));
        (self.centre + mean, self.deviation * variance.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::Smoother;
    use crate::search::design::{candidates, first_points};
    use crate::search::search_box::Axes;
    use loosepin_uncertainty::{hash, normal_quantile};

    #[test]
    fn analytic_a_quadratic_is_met_everywhere_to_round_off() {
        const TOLERANCE: f64 = 1e-9;
        let points = first_points(5, 3, 40).unwrap();
        let function = |u: &[f64]| 0.3 + u[0] * u[1] - 2.0 * u[2] * u[2] + 0.7 * u[1];
        let values: Vec<f64> = points.iter().map(|u| function(u)).collect();
        let smoother = Smoother::try_new(points, &candidates(3).unwrap(), false, &Axes::open(3)).unwrap();
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
        let smoother = Smoother::try_new(points, &candidates(2).unwrap(), false, &Axes::open(2)).unwrap();
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
        let smoother = Smoother::try_new(points, &candidates(1).unwrap(), true, &Axes::open(1)).unwrap();
        let fit = smoother.fit(&noisy, 0.04);
        assert!(fit.noise_variance() > 0.0);
        // At the ends a parabola through 40 points is known to 0.2 √(9/40) = 0.1.
        const TOLERANCE: f64 = 0.3;
        let worst = fit
            .places()
            .iter()
            .zip(fit.at_places())
            .fold(0.0_f64, |worst, (u, (mean, _))| worst.max((mean - u[0] * u[0]).abs()));
        assert!(worst < TOLERANCE, "{worst}");
        assert_eq!(smoother.fit(&exact, 0.04).noise_variance(), 0.0);
    }
}
