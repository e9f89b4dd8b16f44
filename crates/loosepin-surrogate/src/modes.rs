//! Curves as a mean curve and a few modes, by principal components.

use loosepin_math::dense::{Precision, SymmetricEigen, dot};
use serde::{Deserialize, Serialize};

/// y(t) ~ m(t) + Σ_k a_k φ_k(t), the φ orthonormal; a single number is a curve of one place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Modes {
    /// m
    pub mean: Vec<f64>,
    /// φ_k, the one with the largest variance first.
    pub shapes: Vec<Vec<f64>>,
    /// Variance over the runs that the modes leave out, at each place.
    pub left_out: Vec<f64>,
}

impl Modes {
    /// The modes of `curves`, one row a run: as few as leave no more than the share `left_share` of the variance, at most
    /// `most`.
    pub(super) fn new(curves: &[&[f64]], left_share: f64, most: usize) -> Self {
        let (count, length) = (curves.len(), curves[0].len());
        if length == 1 {
            return Self { mean: vec![0.0], shapes: vec![vec![1.0]], left_out: vec![0.0] };
        }
        let mean: Vec<f64> = (0..length).map(|t| curves.iter().map(|y| y[t]).sum::<f64>() / count as f64).collect();
        let rest: Vec<Vec<f64>> = curves.iter().map(|y| y.iter().zip(&mean).map(|(y, m)| y - m).collect()).collect();
        // Of the two Gram matrices, over runs and over places, the smaller one has the same eigenvalues.
        let by_place: Vec<Vec<f64>> = (0..length).map(|t| rest.iter().map(|row| row[t]).collect()).collect();
        let rows = if count <= length { &rest } else { &by_place };
        let order = rows.len();
        let gram = (0..order * order).map(|k| dot(&rows[k / order], &rows[k % order])).collect();
        let SymmetricEigen { values, vectors } = SymmetricEigen::new(gram, order, Precision::OfLargest).descending();
        let total: f64 = values.iter().map(|value| value.max(0.0)).sum();
        let mut shapes = Vec::new();
        let mut left = total;
        for (value, vector) in values.iter().zip(vectors) {
            if shapes.len() >= most || left <= left_share * total || *value <= 1e-14 * total {
                break;
            }
            left -= value;
            let shape = if count <= length {
                let scale = 1.0 / value.sqrt();
                (0..length).map(|t| scale * dot(&by_place[t], &vector)).collect()
            } else {
                vector
            };
            shapes.push(shape);
        }
        let mut modes = Self { mean, shapes, left_out: vec![0.0; length] };
        for y in curves {
            let kept = modes.curve(&modes.scores(y));
            for ((sum, y), kept) in modes.left_out.iter_mut().zip(*y).zip(kept) {
                *sum += (y - kept) * (y - kept) / count as f64;
            }
        }
        modes
    }

    /// a_k of a curve.
    pub(super) fn scores(&self, curve: &[f64]) -> Vec<f64> {
        let rest: Vec<f64> = curve.iter().zip(&self.mean).map(|(y, m)| y - m).collect();
        self.shapes.iter().map(|shape| dot(shape, &rest)).collect()
    }

    /// The curve with these a_k.
    pub(super) fn curve(&self, scores: &[f64]) -> Vec<f64> {
        let mut curve = self.mean.clone();
        for (shape, score) in self.shapes.iter().zip(scores) {
            for (y, value) in curve.iter_mut().zip(shape) {
                *y += score * value;
            }
        }
        curve
    }

    /// The variance at each place where the a_k have these standard deviations, with what the modes leave out.
    pub(super) fn variance(&self, deviations: &[f64]) -> Vec<f64> {
        let mut variance = self.left_out.clone();
        for (shape, deviation) in self.shapes.iter().zip(deviations) {
            for (sum, value) in variance.iter_mut().zip(shape) {
                *sum += deviation * deviation * value * value;
            }
        }
        variance
    }
}

#[cfg(test)]
mod tests {
    use super::Modes;

    #[test]
    fn analytic_curves_of_two_shapes_need_two_modes() {
        const TOLERANCE: f64 = 1e-12; // round-off
        for count in [7, 90] {
            let curves: Vec<Vec<f64>> = (0..count)
                .map(|i| (libm::sin(1.3 * f64::from(i)), libm::cos(0.7 * f64::from(i) + 0.2)))
                .map(|(a, b)| {
                    (0..31)
                        .map(|t| 0.1 * f64::from(t))
                        .map(|t| 2.5 + a * libm::sin(t) + 0.2 * b * libm::exp(-t))
                        .collect()
                })
                .collect();
            let rows: Vec<&[f64]> = curves.iter().map(Vec::as_slice).collect();
            let modes = Modes::new(&rows, 1e-9, 20);
            assert_eq!(modes.shapes.len(), 2);
            for curve in &curves {
                let back = modes.curve(&modes.scores(curve));
                assert!(back.iter().zip(curve).all(|(a, b)| (a - b).abs() < TOLERANCE));
            }
            // One mode leaves what it says it leaves.
            let one = Modes::new(&rows, 0.5, 20);
            assert_eq!(one.shapes.len(), 1);
            let square: f64 = curves.iter().map(|curve| (one.curve(&one.scores(curve))[3] - curve[3]).powi(2)).sum();
            assert!((one.left_out[3] - square / f64::from(count)).abs() < TOLERANCE);
        }
    }
}
