//! Kriging: a Gaussian process through the runs.
//!
//! ```text
//! y(x) = f(x)ᵀβ + Z(x),   cov(Z(x), Z(x')) = σ² k(x, x'; ℓ),   nugget τ² and known noise on top
//! ```
//!
//! f is constant or linear. ℓ (one an input), σ² and τ² have the largest restricted likelihood, times a weak prior on ℓ
//! without which some of many length scales would be chance: ln ℓ is normal about ln(2√d), d inputs, with standard deviation
//! 1.5. Kernel and trend are those with the least leave-one-out error. Source: C. E. Rasmussen and C. K. I. Williams, "Gaussian
//! Processes for Machine Learning", MIT Press 2006; leave-one-out in closed form after O. Dubrule, Mathematical Geology 15
//! (1983) 687-699. Departure: the prior.

use crate::gaussian::kernel::Kernel;
use crate::gaussian::likelihood::{Observations, Solved, square_distance};
use loosepin_math::dense::dot;
use loosepin_math::descent::{Minimum, minimise};
use serde::{Deserialize, Serialize};

/// Standard deviation of the prior of ln ℓ.
const PRIOR_DEVIATION: f64 = 1.5;
/// Bounds of ln ℓ, ln σ² and ln τ²; outputs and inputs have the standard deviation 1.
const LENGTH_BOUNDS: (f64, f64) = (-4.6, 7.0);
const VARIANCE_BOUNDS: (f64, f64) = (-7.0, 14.0);
const NUGGET_BOUNDS: (f64, f64) = (-18.5, 1.0);
/// First length scales, in units of √d.
const STARTS: [f64; 3] = [0.4, 1.2, 4.0];
/// Steps before the best start continues alone, and steps of that one.
const SCREENING_STEPS: usize = 12;
const STEPS: usize = 80;
/// Gain of -2 ln L below which a search ends.
const TOLERANCE: f64 = 2e-3;
/// Runs for each coefficient of a linear trend that must be there before it is tried.
const RUNS_PER_COEFFICIENT: usize = 2;

/// A fitted process of an output that was scaled to mean 0 and standard deviation 1.
#[derive(Clone, Serialize, Deserialize)]
#[serde(try_from = "Stored", into = "Stored")]
pub struct Kriging {
    stored: Stored,
    solved: Solved,
}

/// Definition of a process; the factors are computed again when one is loaded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Stored {
    kernel: Kernel,
    is_trend_linear: bool,
    /// ln ℓ_k, ln σ², ln τ²
    parameters: Vec<f64>,
    points: Vec<Vec<f64>>,
    values: Vec<f64>,
    noise: Vec<f64>,
}

impl Stored {
    fn observations(&self) -> Observations<'_> {
        observations(&self.points, &self.values, &self.noise, self.is_trend_linear)
    }
}

/// Whether there are enough runs for a linear trend.
fn allows_linear(points: &[Vec<f64>]) -> bool {
    points.len() >= RUNS_PER_COEFFICIENT * (points[0].len() + 1)
}

fn observations<'a>(points: &'a [Vec<f64>], values: &'a [f64], noise: &'a [f64], is_linear: bool) -> Observations<'a> {
    let mut trend = vec![vec![1.0; points.len()]];
    if is_linear {
        trend.extend((0..points[0].len()).map(|k| points.iter().map(|point| point[k]).collect()));
    }
    Observations { points, values, noise, trend }
}

impl Kriging {
    /// Fits `values`, with their known variances `noise`, at `points`; from the parameters of `like` alone where that is
    /// given. `None` if no covariance could be factorised.
    pub(crate) fn fit(points: &[Vec<f64>], values: &[f64], noise: &[f64], like: Option<&Self>) -> Option<Self> {
        if let Some(like) = like {
            let is_linear = like.stored.is_trend_linear && allows_linear(points);
            let observations = observations(points, values, noise, is_linear);
            let found = search(&observations, like.stored.kernel, &like.stored.parameters, STEPS)?;
            return Self::with(points, values, noise, is_linear, like.stored.kernel, found.place);
        }
        let inputs = points[0].len();
        let constant = observations(points, values, noise, false);
        let mut best: Option<(f64, Self)> = None;
        let mut consider = |candidate: Option<Self>| {
            let Some(candidate) = candidate else { return };
            let error = candidate.leave_one_out_square();
            if best.as_ref().is_none_or(|(least, _)| error < *least) {
                best = Some((error, candidate));
            }
        };
        let mut screened: Option<Minimum> = None;
        for start in STARTS {
            let length = libm::log(start * (inputs as f64).sqrt());
            let mut parameters = vec![length; inputs];
            parameters.extend([0.5, -7.0]);
            let found = search(&constant, Kernel::Matern52, &parameters, SCREENING_STEPS);
            if let Some(found) = found
                && screened.as_ref().is_none_or(|best| found.value < best.value)
            {
                screened = Some(found);
            }
        }
        let start = screened?.place;
        let matern = search(&constant, Kernel::Matern52, &start, STEPS)?;
        consider(Self::with(points, values, noise, false, Kernel::Matern52, matern.place.clone()));
        let smooth = search(&constant, Kernel::SquaredExponential, &matern.place, STEPS);
        let mut kernels = vec![(Kernel::Matern52, matern)];
        if let Some(smooth) = smooth {
            consider(Self::with(points, values, noise, false, Kernel::SquaredExponential, smooth.place.clone()));
            kernels.push((Kernel::SquaredExponential, smooth));
        }
        if allows_linear(points) {
            let linear = observations(points, values, noise, true);
            for (kernel, found) in kernels {
                if let Some(found) = search(&linear, kernel, &found.place, STEPS) {
                    consider(Self::with(points, values, noise, true, kernel, found.place));
                }
            }
        }
        best.map(|(_, process)| process)
    }

    /// A process with given parameters.
    pub(crate) fn with(
        points: &[Vec<f64>],
        values: &[f64],
        noise: &[f64],
        is_trend_linear: bool,
        kernel: Kernel,
        parameters: Vec<f64>,
    ) -> Option<Self> {
        let (points, values, noise) = (points.to_vec(), values.to_vec(), noise.to_vec());
        Self::try_from(Stored { kernel, is_trend_linear, parameters, points, values, noise }).ok()
    }

    /// Mean square of the leave-one-out errors, at these parameters.
    pub(crate) fn leave_one_out_square(&self) -> f64 {
        let (errors, _) = self.solved.leave_one_out();
        dot(&errors, &errors) / errors.len() as f64
    }

    /// Value, and standard deviation of the process without nugget and noise.
    pub(crate) fn predict(&self, point: &[f64]) -> (f64, f64) {
        let inputs = point.len();
        let variance = libm::exp(self.stored.parameters[inputs]);
        let inverse: Vec<f64> = self.stored.parameters[..inputs].iter().map(|length| libm::exp(-length)).collect();
        let scale = |x: &[f64]| -> Vec<f64> { x.iter().zip(&inverse).map(|(x, factor)| x * factor).collect() };
        let place = scale(point);
        let covariances: Vec<f64> = self
            .stored
            .points
            .iter()
            .map(|known| variance * self.stored.kernel.correlation_and_slope(square_distance(&scale(known), &place)).0)
            .collect();
        let mut terms = vec![1.0];
        if self.stored.is_trend_linear {
            terms.extend(point);
        }
        let value = dot(&terms, &self.solved.coefficients) + dot(&covariances, &self.solved.weights);
        let (white, rest) = self.solved.whitened.at_place(&covariances, &terms);
        let mut gain = rest.clone();
        self.solved.information.solve(&mut gain);
        let square = variance - dot(&white, &white) + dot(&rest, &gain);
        (value, square.max(0.0).sqrt())
    }
}

impl TryFrom<Stored> for Kriging {
    type Error = &'static str;

    fn try_from(stored: Stored) -> Result<Self, Self::Error> {
        let (count, inputs) = (stored.points.len(), stored.parameters.len().saturating_sub(2));
        let is_whole = count > 0
            && stored.values.len() == count
            && stored.noise.len() == count
            && inputs > 0
            && stored.points.iter().all(|point| point.len() == inputs);
        if !is_whole {
            return Err("a Gaussian process whose points, values and parameters do not belong together");
        }
        let solved = stored.observations().solve(stored.kernel, &stored.parameters);
        let solved = solved.ok_or("a Gaussian process whose covariance is singular")?;
        Ok(Self { stored, solved })
    }
}

impl From<Kriging> for Stored {
    fn from(process: Kriging) -> Self {
        process.stored
    }
}

/// The least -2 ln(L prior) from `start`.
fn search(observations: &Observations, kernel: Kernel, start: &[f64], steps: usize) -> Option<Minimum> {
    let inputs = observations.points[0].len();
    let middle = libm::log(2.0 * (inputs as f64).sqrt());
    let mut bounds = vec![LENGTH_BOUNDS; inputs];
    bounds.extend([VARIANCE_BOUNDS, NUGGET_BOUNDS]);
    let function = |parameters: &[f64]| {
        let (mut value, mut gradient) = observations.deviance(kernel, parameters)?;
        for k in 0..inputs {
            let standard = (parameters[k] - middle) / PRIOR_DEVIATION;
            value += standard * standard;
            gradient[k] += 2.0 * standard / PRIOR_DEVIATION;
        }
        Some((value, gradient))
    };
    minimise(function, start, &bounds, steps, TOLERANCE)
}
