//! The bordered equations of the loops at one position: [`super::slices`] solves them where the loops alone are singular.

use super::enclosure::inverse_of;
use loosepin_math::Real;

/// The least way that slices go, rad or m: what moves less to first order may move more to second.
const LEAST_REACH: f64 = 1e-9;

/// The bordered equations at one position.
pub(super) struct Bordered<'b> {
    pub q0: &'b [f64],
    pub driven: &'b [f64],
    /// w.
    pub motion: Vec<f64>,
    /// y.
    pub opening: Vec<f64>,
    /// That of the derivatives of the loop equations by q.
    pub inverse: Vec<f64>,
}

impl<'b> Bordered<'b> {
    /// `of_residuals` are the derivatives of the loop equations by (q, v) at `q0`; `None` if they are singular there.
    pub fn new(of_residuals: &[f64], q0: &'b [f64], driven: &'b [f64], nv: usize) -> Option<Self> {
        /// Steps of an inverse iteration: near a dead centre one direction stands out by far.
        const ITERATIONS: usize = 20;
        let n = q0.len();
        let inverse = inverse_of(of_residuals, n, n + nv)?;
        let times = |vector: &[f64], is_transposed: bool| -> Vec<f64> {
            let entry = |row: usize, k: usize| inverse[if is_transposed { k * n + row } else { row * n + k }];
            normalised((0..n).map(|row| (0..n).map(|k| entry(row, k) * vector[k]).sum()).collect())
        };
        // No start repeats itself in its numbers, so that it lies across no direction.
        let mut motion = normalised((0..n).map(|k| 1.0 + (0.618_033_988_749_895 * k as f64).fract()).collect());
        let mut opening = motion.clone();
        for _ in 0..ITERATIONS {
            opening = times(&motion, true);
            motion = times(&opening, false);
        }
        let is_known = motion.iter().chain(&opening).all(|entry| entry.is_finite());
        (n > 0 && is_known).then_some(Self { q0, driven, motion, opening, inverse })
    }

    /// The coordinate that moves most where the loops give way.
    pub fn weakest(&self) -> usize {
        (0..self.motion.len()).max_by(|a, b| self.motion[*a].abs().total_cmp(&self.motion[*b].abs())).unwrap_or(0)
    }

    /// How far the numbers v take a to first order.
    pub fn reach(&self, of_residuals: &[f64], nv: usize) -> f64 {
        let n = self.q0.len();
        let by = |column: usize| -> f64 {
            let moved = |row: usize| {
                (0..n).map(|k| self.inverse[row * n + k] * of_residuals[k * (n + nv) + column]).sum::<f64>()
            };
            (0..n).map(|row| self.motion[row] * moved(row)).sum::<f64>().abs()
        };
        (n..n + nv).map(by).sum::<f64>().max(LEAST_REACH)
    }

    /// F, where Φ is `open` at x = (q, κ).
    pub fn residuals<T: Real>(&self, open: Vec<T>, x: &[T], a: f64) -> Vec<T> {
        let n = self.q0.len();
        let border =
            (0..n).fold(-T::from_f64(a), |sum, k| sum + T::from_f64(self.motion[k]) * (x[k] - T::from_f64(self.q0[k])));
        let rows = open.into_iter().zip(&self.opening).map(|(open, opening)| open - x[n] * T::from_f64(*opening));
        rows.chain(std::iter::once(border)).collect()
    }

    /// dF/d(q, κ, a, v), row by row.
    pub fn matrix<T: Real>(&self, of_residuals: &[T], nv: usize) -> Vec<T> {
        let n = self.q0.len();
        let mut matrix = Vec::with_capacity((n + 1) * (n + 2 + nv));
        for (row, of_residual) in of_residuals.chunks(n + nv).enumerate() {
            matrix.extend_from_slice(&of_residual[..n]);
            matrix.extend([-T::from_f64(self.opening[row]), T::zero()]);
            matrix.extend_from_slice(&of_residual[n..]);
        }
        matrix.extend(self.motion.iter().map(|entry| T::from_f64(*entry)));
        matrix.extend([T::zero(), -T::one()]);
        matrix.extend(std::iter::repeat_n(T::zero(), nv));
        matrix
    }
}

fn normalised(vector: Vec<f64>) -> Vec<f64> {
    let length = vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    vector.into_iter().map(|entry| entry / length).collect()
}
