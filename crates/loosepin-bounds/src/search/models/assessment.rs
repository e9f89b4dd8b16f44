//! Models of one set of points compared with values: the likelihood of each model, and the selected one.

use crate::search::models::gaussian_process::Model;
use crate::search::rough::roughness::Scatter;
use loosepin_math::sort_by_number;

/// Noise ratios τ of the grid. The first stands for none, and keeps the matrices positive definite.
pub(in crate::search) const NOISE_RATIOS: [f64; 6] = [1e-11, 1e-4, 1e-2, 0.3, 5.0, 100.0];

/// Of the models whose misfit, -2 ln likelihood, exceeds the least one by no more than this, those with the most noise are
/// preferred; of them the likeliest, or without noise the least differentiable one with the shortest ℓ. What cannot be told apart is
/// taken the cautious way: rather noise than an extreme, rather few derivatives than many.
const TOLERATED_MISFIT: f64 = 4.0;

/// Misfit by which every model with some noise must be worse than one with less before those with more noise are not tried.
const HOPELESS_MISFIT: f64 = 50.0;

/// The models that are worth it, held against the same values one after the other, from those of little to those of much noise.
pub(in crate::search) struct Assessment<'m> {
    pub assessed: Vec<Assessed<'m>>,
    freedom: f64,
    /// Least variance that is no round-off.
    floor: f64,
    /// Noise ratios that are tried, at most.
    levels: usize,
    level: usize,
    /// Least misfits, so far and of the present noise ratio.
    least: f64,
    least_of_level: f64,
}

impl<'m> Assessment<'m> {
    /// An empty assessment for `levels` noise ratios and values with `freedom` degrees of freedom; no variance lies below `floor`.
    pub fn new(levels: usize, freedom: f64, floor: f64) -> Self {
        let (least, least_of_level) = (f64::INFINITY, f64::INFINITY);
        Self { assessed: Vec::new(), freedom, floor, levels, level: 0, least, least_of_level }
    }

    /// The noise ratio whose models come next; `None` if no others are worth it.
    pub fn next_level(&self) -> Option<usize> {
        (self.level < self.levels).then_some(self.level)
    }

    /// Takes a model of this noise ratio, of which `square` is what it leaves of the values: yᵀP y.
    pub fn take(&mut self, model: &'m Model, square: f64) {
        let variance = (square / self.freedom).max(self.floor);
        let ln_variance = if variance > 0.0 { libm::log(variance) } else { 0.0 };
        let misfit = self.freedom * ln_variance + model.ln_determinants();
        self.least_of_level = self.least_of_level.min(misfit);
        self.assessed.push(Assessed { model, variance, misfit });
    }

    /// All models of this noise ratio have been added.
    pub fn end_level(&mut self) {
        self.least = self.least.min(self.least_of_level);
        let is_hopeless = self.least_of_level > self.least + HOPELESS_MISFIT;
        self.level = if is_hopeless { self.levels } else { self.level + 1 };
        self.least_of_level = f64::INFINITY;
    }
}

/// A model held against values. What it leaves of them is worked out again for the few that are asked for it: to keep it for all takes
/// longer.
#[derive(Clone, Copy)]
pub(in crate::search) struct Assessed<'m> {
    pub model: &'m Model,
    /// σ²
    pub variance: f64,
    /// -2 ln likelihood
    pub misfit: f64,
}

impl Assessed<'_> {
    pub fn is_noisy(&self) -> bool {
        self.model.noise_ratio() > NOISE_RATIOS[0]
    }

    /// τσ²
    pub fn nugget(&self) -> f64 {
        self.model.noise_ratio() * self.variance
    }

    /// The errors of predicting each estimate from the others, in standard deviations; `residual`: the values, less the polynomial.
    pub fn errors(&self, residual: &[f64]) -> Vec<f64> {
        let of = |error: f64| if self.variance > 0.0 { error / self.variance.sqrt() } else { 0.0 };
        self.model.errors(&self.model.whitened_rest(residual)).into_iter().map(of).collect()
    }
}

/// A model with the variance that must be stated for it.
pub(in crate::search) struct Honest {
    /// Its place among those that were assessed.
    pub index: usize,
    pub errors: Vec<f64>,
    /// -2 ln likelihood with that variance.
    pub misfit: f64,
}

/// The model that is likeliest with the variance that must be stated for it.
pub(in crate::search) fn least_honest(assessed: &[Assessed<'_>], residual: &[f64], freedom: f64) -> Option<Honest> {
    let misfit = |index: usize| assessed[index].misfit;
    let mut by_misfit: Vec<usize> = (0..assessed.len()).filter(|&index| !misfit(index).is_nan()).collect();
    sort_by_number(&mut by_misfit, |&index| misfit(index));
    let mut least: Option<Honest> = None;
    for index in by_misfit {
        // What must be stated is never likelier than what is likeliest.
        if least.as_ref().is_some_and(|least| misfit(index) >= least.misfit) {
            break;
        }
        let errors = assessed[index].errors(residual);
        let misfit = misfit(index) + Scatter::even(&errors, freedom).price;
        if least.as_ref().is_none_or(|least| misfit < least.misfit) {
            least = Some(Honest { index, errors, misfit });
        }
    }
    least
}

/// The most cautious of the models that are equally likely.
pub(in crate::search) fn cautious(mut assessed: Vec<Assessed<'_>>) -> Option<Assessed<'_>> {
    let least = assessed.iter().fold(f64::INFINITY, |least, own| least.min(own.misfit));
    assessed.retain(|own| own.misfit <= least + TOLERATED_MISFIT);
    let noisiest = assessed.iter().fold(0.0_f64, |most, own| most.max(own.model.noise_ratio()));
    assessed.retain(|own| own.model.noise_ratio() == noisiest);
    if noisiest > NOISE_RATIOS[0] {
        assessed.into_iter().min_by(|a, b| a.misfit.total_cmp(&b.misfit))
    } else {
        assessed.into_iter().next()
    }
}
