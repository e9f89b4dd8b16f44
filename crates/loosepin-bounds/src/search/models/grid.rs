//! The models of one set of points, whatever their values and wherever predictions are wanted.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use crate::parallel;
use crate::search::models::assessment::NOISE_RATIOS;
use crate::search::models::gaussian_process::{Distances, Kernel, MAX_APPENDED_TO, Model, Smoothness};
use crate::search::models::trend::Trend;
use crate::search::rough::roughness::Regressors;
use crate::search::search_box::Axes;
use loosepin_math::dense::{Cholesky, dot};
use loosepin_surrogate::Factor;

/// Length scales ℓ of the grid, in units of the diagonal of the box.
const LENGTH_SCALES: [f64; 6] = [0.08, 0.16, 0.32, 0.64, 1.28, 2.56];

/// Kernels of a noise ratio, at most: three smoothnesses of each length scale.
const MAX_KERNELS: usize = 3 * LENGTH_SCALES.len();

/// Length scale of the model with kinks, in units of the diagonal of the box. Likelihood takes the longest nearly always: a deviation then
/// grows with the root of the distance from the points.
const LENGTH_WITH_KINKS: f64 = 2.56;

/// A model for each length scale, smoothness and noise ratio that is tried.
pub(crate) struct Grid {
    /// Diagonal of the box.
    diagonal: f64,
    /// Terms of the polynomial at the points, row by row, and the factor of its normal equations.
    pub terms: Vec<f64>,
    normal_equations: Cholesky,
    /// The points in the coordinates of the models, by which a variance may differ, and their polynomial.
    pub seen: Vec<Vec<f64>>,
    distances: Distances,
    pub(in crate::search) regressors: Regressors,
    pub trend: Trend,
    /// Correlations of the points by length scale, of the kernels that every noise ratio has.
    covariances: [OnceLock<Vec<f64>>; LENGTH_SCALES.len()],
    /// Factors of the models of an earlier grid, to whose points others have been appended, by their places.
    known: BTreeMap<usize, Arc<Factor>>,
    /// Models of the same noise ratio together, from little to much noise. The first is there from the beginning and never empty, the
    /// others are prepared when they are asked for.
    levels: Vec<OnceLock<Vec<Model>>>,
    /// The model of a process with kinks everywhere, prepared on first use.
    with_kinks: OnceLock<Option<Model>>,
}

impl Grid {
    /// Prepares the models for `points` of the unit box; those that pass beside the values take part where it `may_pass_beside`. `None` if
    /// there are too few points for any model. The factors of an `earlier` grid are taken over where the points begin with its own.
    pub fn try_new(points: &[Vec<f64>], may_pass_beside: bool, axes: &Axes, earlier: &[Arc<Self>]) -> Option<Self> {
        let seen: Vec<Vec<f64>> = points.iter().map(|point| axes.embed(point)).collect();
        let begins_so = |earlier: &&Arc<Self>| seen.starts_with(&earlier.seen);
        let longest = earlier.iter().filter(begins_so).max_by_key(|earlier| earlier.seen.len());
        let known = longest.map_or_else(BTreeMap::new, |earlier| earlier.factors());
        let (trend, terms, normal_equations) = Trend::for_points(&seen, axes.circles())?;
        let ratios = if may_pass_beside { &NOISE_RATIOS[..] } else { &NOISE_RATIOS[..1] };
        let levels = ratios.iter().map(|_| OnceLock::new()).collect();
        let (distances, regressors) = (Distances::new(&seen), Regressors::new(&seen));
        let diagonal = (points[0].len() as f64).sqrt();
        let covariances = Default::default();
        let grid = Self {
            diagonal,
            terms,
            normal_equations,
            seen,
            distances,
            regressors,
            trend,
            covariances,
            known,
            levels,
            with_kinks: OnceLock::new(),
        };
        let kernels: Vec<_> = grid.kernels(0).into_iter().enumerate().collect();
        let without_noise: Vec<Model> = parallel::flat_map(&kernels, |own| grid.model(*own, 0));
        let is_empty = without_noise.is_empty();
        let _ = grid.levels[0].set(without_noise);
        (!is_empty).then_some(grid)
    }

    /// Number of noise ratios.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Number of models, at most: [`Model::place`] is less.
    pub fn most_models(&self) -> usize {
        self.levels.len() * MAX_KERNELS + 1
    }

    /// The model of a process with kinks everywhere, without noise; `None` if its matrix is singular to round-off. Likelihood does not choose it
    /// (`smoother.rs`).
    pub fn with_kinks(&self) -> Option<&Model> {
        let prepare = || {
            let kernel = Kernel { smoothness: Smoothness::Never, length_scale: LENGTH_WITH_KINKS * self.diagonal };
            let (trend, covariance) = ((self.trend, &self.terms[..]), kernel.covariance(&self.distances, 0));
            let place = self.levels.len() * MAX_KERNELS;
            Model::try_new(place, &self.seen, covariance, trend, kernel, NOISE_RATIOS[0], None)
        };
        self.with_kinks.get_or_init(prepare).as_ref()
    }

    /// The models of one noise ratio. One thread prepares them while others may wait: were it to share the work, it could come to wait
    /// for itself.
    pub fn level(&self, level: usize) -> &[Model] {
        let prepare = || self.kernels(level).into_iter().enumerate().filter_map(|own| self.model(own, level)).collect();
        self.levels[level].get_or_init(prepare)
    }

    /// Whether points have been appended to those of an earlier grid.
    #[cfg(test)]
    pub fn is_appended(&self) -> bool {
        !self.known.is_empty()
    }

    /// Whether points may be appended to it.
    pub fn may_be_appended_to(&self) -> bool {
        self.seen.len() <= MAX_APPENDED_TO
    }

    /// Factors of the models that have been prepared, by their places.
    fn factors(&self) -> BTreeMap<usize, Arc<Factor>> {
        let models = self.levels.iter().filter_map(OnceLock::get).flatten();
        models.map(|model| (model.place(), Arc::clone(model.factor()))).collect()
    }

    fn kernels(&self, level: usize) -> Vec<Kernel> {
        let diagonal = self.diagonal;
        // Noise hides how smooth a function is.
        let smoothnesses = match level {
            0 => &[Smoothness::Once, Smoothness::Twice, Smoothness::FourTimes][..],
            _ => &[Smoothness::Twice],
        };
        let scales =
            |&smoothness| LENGTH_SCALES.iter().map(move |scale| Kernel { smoothness, length_scale: scale * diagonal });
        smoothnesses.iter().flat_map(scales).collect()
    }

    fn model(&self, (place, kernel): (usize, Kernel), level: usize) -> Option<Model> {
        let diagonal = self.diagonal;
        let scale = LENGTH_SCALES.iter().position(|scale| scale * diagonal == kernel.length_scale);
        let place = level * MAX_KERNELS + place;
        let known = self.known.get(&place).map(|known| &**known);
        // Where points are appended to a factor, what is known in it is not needed again.
        let first = known.map_or(0, Factor::known);
        let shared = scale.filter(|_| kernel.smoothness == Smoothness::Twice && first == 0);
        let find = || kernel.covariance(&self.distances, first);
        let covariance = shared.map_or_else(find, |scale| self.covariances[scale].get_or_init(find).clone());
        Model::try_new(place, &self.seen, covariance, (self.trend, &self.terms), kernel, NOISE_RATIOS[level], known)
    }

    /// Residuals of the polynomial alone, by ordinary least squares: the models see the same misfit with less round-off.
    pub fn residual(&self, values: &[f64]) -> Vec<f64> {
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
