//! How rough a statistic is: what its values have between the points beside a smooth part and sampling noise.
//!
//! A model passes beside value i by e_i = (P y)_i/√P_ii, with variance σ² where its nugget is the same everywhere. Where likelihood says so
//! the variance depends on u:
//!
//! ```text
//! e_i² ~ σ² v(u_i) χ²₁,   ln v(u) = a + bᵀ(u - ū)
//! nugget(u) = |τ P y|²/(τ tr P) · v(u)/mean v(u_i)
//! ω²(u) = nugget(u) - Σ_k nugget of (replicate k - mean)/(R (R - 1))
//! ```
//!
//! a and b by maximum likelihood, as if the errors were independent: iterated least squares of a gamma model with the logarithm as link. Source: P. McCullagh and
//! J. A. Nelder, "Generalized linear models" (1989), chapters 8 and 10.

use crate::search::models::gaussian_process::Model;
use crate::search::models::prediction::Roughness;
use loosepin_math::dense::{Cholesky, gram, multiply};
use loosepin_math::{FourRows, exponentials, interleaved};

/// Gain by chance of a further parameter in -2 ln likelihood (H. Akaike, "A new look at the statistical model identification", IEEE
/// Transactions on Automatic Control 19 (1974) 716-723).
pub(in crate::search) const GAIN_OF_A_PARAMETER: f64 = 2.0;

/// Fewer points for each parameter do not show how a variance depends on u.
const MIN_POINTS_OF_A_PARAMETER: usize = 4;

/// Normal deviations of a one-sided interval of 95 %.
const ONE_SIDED: f64 = 1.645;

/// Steps of the iteration, and halvings of each, at most.
const MAX_STEPS: usize = 50;
const MAX_HALVINGS: usize = 8;
const MIN_GAIN: f64 = 1e-9;

/// Standardised errors of predicting each estimate from the others may go up to this before a model is mistrusted.
const EXPECTED_SURPRISE: f64 = 2.5;

/// Replicates that are computed side by side.
const REPLICATES_AT_ONCE: usize = 8;

/// How the errors of a model at the points are scattered.
#[derive(Debug, Clone)]
pub(in crate::search) struct Scatter {
    /// Slopes, if their variance depends on u.
    slopes: Option<Slopes>,
    /// Factor of the standard deviation where the model predicts some estimate worse than it should.
    pub distrust: f64,
    /// The same for what lies below a prediction, and above it.
    sided: [f64; 2],
    /// Penalty of all parameters in -2 ln likelihood.
    pub price: f64,
}

/// ln v(u)
#[derive(Debug, Clone)]
struct Slopes {
    centre: Vec<f64>,
    /// a, b
    coefficients: Vec<f64>,
    /// (XᵀX)⁻¹; the covariance of a and b is 2 (n/ν) (XᵀX)⁻¹.
    covariance: Vec<f64>,
    /// Mean v(u_i)
    mean: f64,
}

/// The likeliest slopes.
struct Fitted {
    slopes: Slopes,
    /// v(u) at the points.
    variances: Vec<f64>,
    /// What they gain in -2 ln likelihood against the same variance everywhere.
    gain: f64,
}

/// Regressors of ln v(u) for one set of points.
pub(in crate::search) struct Regressors {
    /// ū
    centre: Vec<f64>,
    /// 1, u - ū of each point, and the same for products with vectors.
    by_point: Vec<f64>,
    rows: FourRows,
    /// (XᵀX)⁻¹; `None` if the points are too few or all alike.
    covariance: Option<Vec<f64>>,
}

impl Regressors {
    /// The regressors of `seen` points.
    pub fn new(seen: &[Vec<f64>]) -> Self {
        let count = seen.len() as f64;
        let dimensions = seen.first().map_or(0, Vec::len);
        let centre: Vec<f64> =
            (0..dimensions).map(|axis| seen.iter().map(|point| point[axis]).sum::<f64>() / count).collect();
        let by_point: Vec<f64> = seen.iter().flat_map(|point| row(point, &centre)).collect();
        let size = dimensions + 1;
        let is_enough = seen.len() >= MIN_POINTS_OF_A_PARAMETER * size;
        let factor = is_enough.then(|| Cholesky::new(gram(&by_point, size), size)).flatten();
        let rows = FourRows::new(&by_point, size);
        Self { centre, by_point, rows, covariance: factor.map(|factor| factor.inverse()) }
    }
}

/// The rough part of a statistic over the box.
#[derive(Debug, Clone)]
pub(in crate::search) struct RoughPart {
    scatter: Scatter,
    /// What the values have, and what sampling has of it, with their degrees of freedom.
    nugget: f64,
    freedom: f64,
    of_noise: f64,
    freedom_of_noise: f64,
    /// Number of points.
    points: f64,
}

impl Scatter {
    /// Constant roughness of `errors`, in standard deviations, whose sum of squares has `freedom` degrees of freedom.
    pub fn even(errors: &[f64], freedom: f64) -> Self {
        Self::with(None, errors, freedom, 0.0)
    }

    /// As [`Scatter::even`], with a variance that depends on u where likelihood says so; `seen` are the points.
    pub fn new(seen: &[Vec<f64>], regressors: &Regressors, errors: &[f64], freedom: f64) -> Self {
        let even = Self::even(errors, freedom);
        let Some(Fitted { slopes, variances, gain }) = Slopes::fit(seen, regressors, &squares(errors)) else {
            return even;
        };
        // n errors of a model that has been fitted to them tell as much as ν independent ones.
        let gain = gain * freedom / errors.len() as f64;
        let parameters = (slopes.coefficients.len() - 1) as f64;
        let own: Vec<f64> = errors.iter().zip(variances).map(|(error, variance)| error / variance.sqrt()).collect();
        let uneven = Self::with(Some(slopes), &own, freedom, GAIN_OF_A_PARAMETER * parameters - gain);
        if uneven.price < even.price { uneven } else { even }
    }

    fn with(slopes: Option<Slopes>, errors: &[f64], freedom: f64, price_of_slopes: f64) -> Self {
        let furthest = |sign: f64| errors.iter().fold(0.0_f64, |most, error| most.max(sign * error));
        let sided = [-1.0, 1.0].map(|sign| (furthest(sign) / EXPECTED_SURPRISE).max(1.0));
        let distrust = sided[0].max(sided[1]);
        Self { slopes, distrust, sided, price: freedom * price(distrust) + price_of_slopes }
    }
}

impl Slopes {
    /// The likeliest ones.
    fn fit(seen: &[Vec<f64>], regressors: &Regressors, ratios: &[f64]) -> Option<Fitted> {
        let Regressors { centre, by_point, rows, covariance } = regressors;
        let covariance = covariance.as_ref()?;
        let (count, size) = (ratios.len() as f64, centre.len() + 1);
        // Also 1/v at every point, which the slopes of the misfit need where a step is taken.
        let misfit = |coefficients: &[f64], reciprocals: &mut [f64]| -> f64 {
            let mut negated = rows.multiply(coefficients);
            negated.iter_mut().for_each(|ln_variance| *ln_variance = -*ln_variance);
            exponentials(&negated, reciprocals);
            let each = negated.iter().zip(ratios).zip(reciprocals);
            each.map(|((negated, ratio), reciprocal)| -negated + ratio * *reciprocal).sum()
        };
        let mean = ratios.iter().sum::<f64>() / count;
        if !(mean > 0.0 && mean.is_finite()) {
            return None;
        }
        let mut coefficients = vec![0.0; size];
        coefficients[0] = libm::log(mean);
        let (mut reciprocals, mut of_trial) = (vec![0.0; ratios.len()], vec![0.0; ratios.len()]);
        let even = misfit(&coefficients, &mut reciprocals);
        let mut least = even;
        for _ in 0..MAX_STEPS {
            let mut slope = vec![0.0; size];
            for ((row, ratio), reciprocal) in by_point.chunks(size).zip(ratios).zip(&reciprocals) {
                let excess = ratio * reciprocal - 1.0;
                for (slope, entry) in slope.iter_mut().zip(row) {
                    *slope += entry * excess;
                }
            }
            let step = multiply(covariance, &slope);
            let mut trials = (0..MAX_HALVINGS).map(|halvings| {
                let share = 0.5_f64.powi(halvings as i32);
                let trial: Vec<f64> = coefficients.iter().zip(&step).map(|(own, step)| own + share * step).collect();
                (misfit(&trial, &mut of_trial), trial)
            });
            let Some((found, trial)) = trials.find(|(found, _)| *found < least) else { break };
            drop(trials);
            core::mem::swap(&mut reciprocals, &mut of_trial);
            let gain = least - found;
            (least, coefficients) = (found, trial);
            if gain < MIN_GAIN {
                break;
            }
        }
        let (centre, covariance) = (centre.clone(), covariance.clone());
        let mut slopes = Self { centre, coefficients, covariance, mean: 1.0 };
        let variances = slopes.variances(seen);
        slopes.mean = variances.iter().sum::<f64>() / count;
        slopes.mean.is_finite().then_some(Fitted { slopes, variances, gain: even - least })
    }

    /// ln v(u)
    fn ln_variance(&self, point: &[f64]) -> f64 {
        let [constant, slopes @ ..] = &self.coefficients[..] else { return 0.0 };
        let sloped = slopes.iter().zip(point).zip(&self.centre).map(|((slope, x), centre)| slope * (x - centre));
        constant + sloped.sum::<f64>()
    }

    /// v(u) at many places.
    fn variances(&self, places: &[Vec<f64>]) -> Vec<f64> {
        let exponents: Vec<f64> = places.iter().map(|place| self.ln_variance(place)).collect();
        let mut variances = vec![0.0; exponents.len()];
        exponentials(&exponents, &mut variances);
        variances
    }

    /// xᵀ(XᵀX)⁻¹x; without a list of its own, for it is asked for at thousands of places.
    fn leverage(&self, point: &[f64]) -> f64 {
        let size = self.coefficients.len();
        let entry = |k: usize| if k == 0 { 1.0 } else { point[k - 1] - self.centre[k - 1] };
        let of_row = |k: usize| (0..size).map(|other| self.covariance[k * size + other] * entry(other)).sum::<f64>();
        (0..size).map(|k| entry(k) * of_row(k)).sum()
    }
}

impl RoughPart {
    /// What `residual` has beside `model`, less what the replicates of the sampling noise have, which `replicates` differ by from their mean.
    pub fn new(model: &Model, residual: &[f64], replicates: &[Vec<f64>], scatter: Scatter) -> Self {
        let count = replicates.len() as f64;
        let freedom = model.nugget_degrees_of_freedom().max(1.0);
        let of_noise = if count < 2.0 {
            0.0
        } else {
            let of_each = |own: &[Vec<f64>]| {
                let own: Vec<&[f64]> = own.iter().map(Vec::as_slice).collect();
                model.nuggets_of_each::<REPLICATES_AT_ONCE>(&interleaved(&own)).into_iter().take(own.len())
            };
            replicates.chunks(REPLICATES_AT_ONCE).flat_map(of_each).sum::<f64>() / (count * (count - 1.0))
        };
        let freedom_of_noise = freedom * (count - 1.0).max(1.0);
        let points = residual.len() as f64;
        Self { scatter, nugget: model.nugget(residual), freedom, of_noise, freedom_of_noise, points }
    }

    /// Variance of the sampling noise between the points.
    pub fn noise_variance(&self) -> f64 {
        self.of_noise.min(self.nugget)
    }

    /// The share of sampling noise in what the values have between the points, over the whole box.
    pub fn noise_share(&self) -> f64 {
        if self.nugget > 0.0 { self.noise_variance() / self.nugget } else { 1.0 }
    }

    /// At a place in the coordinates of the models: ω, and how far it may be larger:
    ///
    /// ```text
    /// var ω² = 2 nugget² h + 2 noise²/ν_noise,   h = 1/ν, or (n/ν) xᵀ(XᵀX)⁻¹x, x = 1, u - ū, where it depends on u
    /// ```
    ///
    /// The factor n/ν: n errors of a model that has been fitted to them tell as much as ν independent ones.
    pub fn at(&self, place: &[f64]) -> Roughness {
        let slopes = self.scatter.slopes.as_ref();
        let sloped = slopes.map(|slopes| (slopes, libm::exp(slopes.ln_variance(place)), place));
        self.roughness(sloped)
    }

    /// [`Self::at`] all of `places`.
    pub fn at_places(&self, places: &[Vec<f64>]) -> Vec<Roughness> {
        let Some(slopes) = &self.scatter.slopes else { return vec![self.roughness(None); places.len()] };
        let variances = slopes.variances(places).into_iter();
        places.iter().zip(variances).map(|(place, variance)| self.roughness(Some((slopes, variance, place)))).collect()
    }

    /// [`Self::at`] a place where the scatter has this v(u); the same everywhere where it has no slopes.
    fn roughness(&self, sloped: Option<(&Slopes, f64, &[f64])>) -> Roughness {
        if self.nugget == 0.0 {
            return Roughness::default();
        }
        let (share, leverage) = match sloped {
            None => (1.0, 1.0 / self.freedom),
            Some((slopes, variance, place)) => {
                let leverage = self.points / self.freedom * slopes.leverage(place);
                (variance / slopes.mean, leverage)
            }
        };
        let nugget = share * self.nugget;
        let variance = (nugget - self.of_noise).max(0.0);
        let of_variance =
            (2.0 * (nugget * nugget * leverage + self.of_noise * self.of_noise / self.freedom_of_noise)).sqrt();
        let error = (variance + ONE_SIDED * of_variance).sqrt() - variance.sqrt();
        Roughness { deviation: variance.sqrt(), error, distrust: self.scatter.sided }
    }
}

/// 1, u - ū
fn row(point: &[f64], centre: &[f64]) -> Vec<f64> {
    core::iter::once(1.0).chain(point.iter().zip(centre).map(|(x, centre)| x - centre)).collect()
}

/// Squares of numbers.
fn squares(errors: &[f64]) -> Vec<f64> {
    errors.iter().map(|error| error * error).collect()
}

/// What an enlarged standard deviation adds to -2 ln likelihood for each degree of freedom.
fn price(distrust: f64) -> f64 {
    2.0 * libm::log(distrust) + 1.0 / (distrust * distrust) - 1.0
}

#[cfg(test)]
mod tests {
    use super::{Fitted, GAIN_OF_A_PARAMETER, Regressors, Scatter, Slopes, squares};
    use crate::search::design::first_points;
    use loosepin_uncertainty::{hash, normal_quantile};

    /// Normal numbers with variance `of(u)` at points of a square.
    fn errors(seed: u64, of: impl Fn(&[f64]) -> f64) -> (Vec<Vec<f64>>, Vec<f64>) {
        let points = first_points(5, 2, 64).unwrap();
        let number = |i: usize| normal_quantile(((hash(seed, i as u64) >> 11) as f64 + 0.5) / (1_u64 << 53) as f64);
        let errors = points.iter().enumerate().map(|(i, u)| of(u).sqrt() * number(i)).collect();
        (points, errors)
    }

    #[test]
    fn analytic_the_slopes_of_a_variance_are_found_within_their_errors() {
        // Standard deviation of a slope from 64 points of a uniform square: √(2 · 12/64) = 0.6.
        const TOLERANCE: f64 = 0.6;
        let (mut found, seeds) = ([0.0; 2], 20);
        for seed in 0..seeds {
            let (points, errors) = errors(seed, |u| (3.0 * (u[0] - 0.5)).exp());
            let Fitted { slopes, gain, .. } =
                Slopes::fit(&points, &Regressors::new(&points), &squares(&errors)).unwrap();
            assert!(gain > 0.0, "{gain}");
            for (sum, own) in found.iter_mut().zip(&slopes.coefficients[1..]) {
                *sum += own / seeds as f64;
            }
        }
        let tolerance = 3.0 * TOLERANCE / (seeds as f64).sqrt();
        assert!((found[0] - 3.0).abs() < tolerance && found[1].abs() < tolerance, "{found:?}");
    }

    #[test]
    fn analytic_an_even_scatter_is_seldom_taken_for_one_with_slopes() {
        // Two slopes gain more than 4 by chance with probability exp(-2) = 0.135.
        let seeds = 200;
        let taken = (0..seeds).filter(|&seed| {
            let (points, errors) = errors(seed, |_| 1.0);
            Slopes::fit(&points, &Regressors::new(&points), &squares(&errors)).unwrap().gain > 2.0 * GAIN_OF_A_PARAMETER
        });
        let share = taken.count() as f64 / seeds as f64;
        assert!((share - 0.135).abs() < 3.0 * (0.135 * 0.865 / seeds as f64).sqrt(), "{share}");
    }

    #[test]
    fn identity_where_the_scatter_is_uneven_the_model_is_less_mistrusted() {
        let (points, errors) = errors(3, |u| (5.0 * (u[0] - 0.5)).exp());
        let (even, own) =
            (Scatter::even(&errors, 58.0), Scatter::new(&points, &Regressors::new(&points), &errors, 58.0));
        assert!(own.slopes.is_some() && own.distrust < even.distrust && own.price < even.price, "{even:?} {own:?}");
    }
}
