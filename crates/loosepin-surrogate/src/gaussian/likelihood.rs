//! The likelihood of the parameters of a Gaussian process, and its gradient.
//!
//! ```text
//! V = σ² K(ℓ) + τ² 1 + diag(noise),   P = V⁻¹ - V⁻¹F (FᵀV⁻¹F)⁻¹ FᵀV⁻¹
//! -2 ln L = ln det V + ln det FᵀV⁻¹F + yᵀP y,   ∂/∂θ = tr(P ∂V/∂θ) - (P y)ᵀ ∂V/∂θ (P y)
//! ```
//!
//! L is the restricted likelihood: that of what the trend F β cannot explain. Source: C. E. Rasmussen and C. K. I. Williams,
//! "Gaussian Processes for Machine Learning", MIT Press 2006, sections 2.7 and 5.4.1.

use crate::gaussian::gaussian_process::Whitened;
use crate::gaussian::kernel::Kernel;
use loosepin_math::dense::{Cholesky, dot};

/// Observations that a process is fitted to.
pub(crate) struct Observations<'a> {
    /// One row a point.
    pub points: &'a [Vec<f64>],
    /// Scaled to mean 0 and standard deviation 1.
    pub values: &'a [f64],
    /// Known variance of each value, in the same scale.
    pub noise: &'a [f64],
    /// Columns of F.
    pub trend: Vec<Vec<f64>>,
}

/// V factorised, with what the trend takes away.
#[derive(Clone)]
pub(crate) struct Solved {
    pub whitened: Whitened,
    /// FᵀV⁻¹F
    pub information: Cholesky,
    /// β
    pub coefficients: Vec<f64>,
    /// P y
    pub weights: Vec<f64>,
    /// -2 ln L, without its constant.
    pub deviance: f64,
}

/// Parameters are ln ℓ_k, ln σ² and ln τ².
impl Observations<'_> {
    /// V and σ² ρ of every pair of points, row by row; only the lower triangles are set.
    fn covariance(&self, kernel: Kernel, parameters: &[f64], slopes: Option<&mut Vec<f64>>) -> Vec<f64> {
        let (count, inputs) = (self.points.len(), self.points[0].len());
        let (variance, nugget) = (libm::exp(parameters[inputs]), libm::exp(parameters[inputs + 1]));
        let inverse: Vec<f64> = parameters[..inputs].iter().map(|length| libm::exp(-length)).collect();
        let scaled: Vec<f64> =
            self.points.iter().flat_map(|point| point.iter().zip(&inverse).map(|(x, factor)| x * factor)).collect();
        let mut covariance = vec![0.0; count * count];
        let mut all_slopes = vec![0.0; if slopes.is_some() { count * count } else { 0 }];
        for i in 0..count {
            let point = &scaled[i * inputs..(i + 1) * inputs];
            for j in 0..i {
                let (correlation, slope) =
                    kernel.correlation_and_slope(square_distance(point, &scaled[j * inputs..(j + 1) * inputs]));
                covariance[i * count + j] = variance * correlation;
                if slopes.is_some() {
                    all_slopes[i * count + j] = variance * slope;
                }
            }
            covariance[i * count + i] = variance + nugget + self.noise[i];
        }
        if let Some(slopes) = slopes {
            *slopes = all_slopes;
        }
        covariance
    }

    /// Everything at `parameters`; `None` if V is singular to round-off.
    pub fn solve(&self, kernel: Kernel, parameters: &[f64]) -> Option<Solved> {
        self.solve_covariance(self.covariance(kernel, parameters, None))
    }

    fn solve_covariance(&self, covariance: Vec<f64>) -> Option<Solved> {
        let count = self.points.len();
        let whitened = Whitened::try_new(covariance, &self.trend, count)?;
        let trend = &whitened.trend;
        let size = trend.len();
        let gram = (0..size * size).map(|k| dot(&trend[k / size], &trend[k % size])).collect();
        let information = Cholesky::new(gram, size)?;
        let mut rest = whitened.whitening().multiply(self.values);
        let mut coefficients = whitened.products(&rest);
        information.solve(&mut coefficients);
        whitened.subtract_trend(&mut rest, &coefficients);
        let deviance = whitened.ln_determinant + information.ln_determinant() + dot(&rest, &rest);
        let weights = whitened.whitening().multiply_transposed(&rest);
        deviance.is_finite().then_some(Solved { whitened, information, coefficients, weights, deviance })
    }

    /// -2 ln L and its gradient.
    pub fn deviance(&self, kernel: Kernel, parameters: &[f64]) -> Option<(f64, Vec<f64>)> {
        let (count, inputs) = (self.points.len(), self.points[0].len());
        let mut slopes = Vec::new();
        let covariance = self.covariance(kernel, parameters, Some(&mut slopes));
        let solved = self.solve_covariance(covariance.clone())?;
        let projection = solved.projection();
        let (variance, nugget) = (libm::exp(parameters[inputs]), libm::exp(parameters[inputs + 1]));
        let mut gradient = vec![0.0; inputs + 2];
        let mut squares = vec![0.0; inputs];
        for i in 0..count {
            let row = i * count;
            // W = P - P y yᵀ P; every pair stands twice in the sums.
            for j in 0..i {
                let weight = 2.0 * (projection[row + j] - solved.weights[i] * solved.weights[j]);
                gradient[inputs] += weight * covariance[row + j];
                let slope = weight * slopes[row + j];
                for ((sum, a), b) in squares.iter_mut().zip(&self.points[i]).zip(&self.points[j]) {
                    *sum += slope * (a - b) * (a - b);
                }
            }
            let weight = projection[row + i] - solved.weights[i] * solved.weights[i];
            gradient[inputs] += weight * variance;
            gradient[inputs + 1] += weight * nugget;
        }
        for ((entry, square), length) in gradient.iter_mut().zip(&squares).zip(parameters) {
            *entry = square * libm::exp(-2.0 * length);
        }
        Some((solved.deviance, gradient))
    }
}

impl Solved {
    /// P, row by row, its lower triangle.
    fn projection(&self) -> Vec<f64> {
        let count = self.weights.len();
        let mut projection = self.whitened.whitening().gram();
        for column in self.trend_directions() {
            for i in 0..count {
                let factor = column[i];
                for (entry, value) in projection[i * count..=i * count + i].iter_mut().zip(&column) {
                    *entry -= factor * value;
                }
            }
        }
        projection
    }

    /// Columns D with D Dᵀ = V⁻¹F (FᵀV⁻¹F)⁻¹ FᵀV⁻¹.
    fn trend_directions(&self) -> Vec<Vec<f64>> {
        let size = self.whitened.trend.len();
        let root = self.information.inverse_factor();
        let columns = self.whitened.projected_trend();
        let count = self.weights.len();
        let mut directions = vec![vec![0.0; count]; size];
        for i in 0..count {
            let row: Vec<f64> = columns.iter().map(|column| column[i]).collect();
            for (direction, value) in directions.iter_mut().zip(root.multiply(&row)) {
                direction[i] = value;
            }
        }
        directions
    }

    /// Errors of predicting each value from all the others, (P y)_i/P_ii, and their variances 1/P_ii.
    pub fn leave_one_out(&self) -> (Vec<f64>, Vec<f64>) {
        let mut diagonal = self.whitened.whitening().column_squares();
        for direction in self.trend_directions() {
            for (entry, value) in diagonal.iter_mut().zip(&direction) {
                *entry -= value * value;
            }
        }
        let errors = self.weights.iter().zip(&diagonal).map(|(weight, entry)| weight / entry).collect();
        (errors, diagonal.iter().map(|entry| 1.0 / entry).collect())
    }
}

/// Σ (a_k - b_k)²
pub(crate) fn square_distance(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (a_blocks, b_blocks) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(x, y)| (x - y) * (x - y)).sum();
    for (x, y) in a_blocks.zip(b_blocks) {
        for k in 0..4 {
            sums[k] += (x[k] - y[k]) * (x[k] - y[k]);
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::super::kriging::Kriging;
    use super::{Kernel, Observations};

    fn points() -> Vec<Vec<f64>> {
        (0..14).map(f64::from).map(|i: f64| vec![libm::sin(1.7 * i), libm::cos(2.9 * i + 0.4)]).collect()
    }

    fn observe<'a>(points: &'a [Vec<f64>], values: &'a [f64], noise: &'a [f64]) -> Observations<'a> {
        let column = |k: usize| points.iter().map(|point| point[k]).collect();
        let trend = vec![vec![1.0; points.len()], column(0), column(1)];
        Observations { points, values, noise, trend }
    }

    #[test]
    fn identity_the_gradient_is_the_difference_quotient() {
        // Central differences with a step of 1e-5 leave 1e-9 of truncation and 1e-10 of round-off.
        const TOLERANCE: f64 = 1e-6;
        const STEP: f64 = 1e-5;
        let points = points();
        let values: Vec<f64> = points.iter().map(|x| libm::sin(2.0 * x[0]) + 0.3 * x[1] * x[0]).collect();
        let noise: Vec<f64> = (0..14).map(|i| 0.002 * f64::from(i)).collect();
        let observations = observe(&points, &values, &noise);
        let at = [-0.3, 0.4, 0.2, -4.0];
        for kernel in [Kernel::Matern52, Kernel::SquaredExponential] {
            let (_, gradient) = observations.deviance(kernel, &at).unwrap();
            for k in 0..at.len() {
                let moved = |step: f64| {
                    let mut parameters = at;
                    parameters[k] += step;
                    observations.deviance(kernel, &parameters).unwrap().0
                };
                let quotient = (moved(STEP) - moved(-STEP)) / (2.0 * STEP);
                assert!((gradient[k] - quotient).abs() < TOLERANCE, "{kernel:?} {k}: {} {quotient}", gradient[k]);
            }
        }
    }

    #[test]
    fn identity_leave_one_out_errors_are_those_of_leaving_one_out() {
        const TOLERANCE: f64 = 1e-9; // round-off times the condition number
        let points = points();
        let values: Vec<f64> = points.iter().map(|x| libm::sin(2.0 * x[0]) + 0.3 * x[1] * x[0]).collect();
        let noise = vec![0.0; 14];
        let at = [-0.3, 0.4, 0.2, -4.0];
        let (errors, variances) =
            observe(&points, &values, &noise).solve(Kernel::Matern52, &at).unwrap().leave_one_out();
        for i in 0..points.len() {
            let (mut others, mut rest) = (points.clone(), values.clone());
            others.remove(i);
            rest.remove(i);
            let process = Kriging::with(&others, &rest, &noise[1..], true, Kernel::Matern52, at.to_vec()).unwrap();
            let (value, deviation) = process.predict(&points[i]);
            let variance = deviation * deviation + libm::exp(at[3]);
            assert!((values[i] - value - errors[i]).abs() < TOLERANCE);
            assert!((variance - variances[i]).abs() < TOLERANCE);
        }
    }
}
