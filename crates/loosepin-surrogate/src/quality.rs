//! Prediction error of a surrogate for runs that were not used for the fit.

use super::fitted::Kind;
use serde::{Deserialize, Serialize};

/// Held-out error of one output. It is measured at the runs, so it holds where further points come from the same region.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Quality {
    /// Runs that it was fitted to.
    pub runs: usize,
    /// Runs without this output.
    pub missing: usize,
    /// Parts that were held out in turn; as many as different points where each was held out alone.
    pub folds: usize,
    /// Root mean square of the held-out errors, over runs and places, in the unit of the output.
    pub rms: f64,
    /// 1 - Σ error²/Σ (y - mean)² over runs and places; `None` for a constant output.
    pub q2: Option<f64>,
    /// Root mean square of the held-out errors at each place.
    pub rms_along: Vec<f64>,
    /// 1 - Σ error²/Σ (y - mean)² at each place; empty if the output is constant.
    pub q2_along: Vec<Option<f64>>,
    /// For each mode, the held-out root mean square error of each kind that was tried, in the unit of the output over all
    /// places: √Σ_t error²(t).
    pub tried: Vec<Vec<(Kind, f64)>>,
}

impl Quality {
    /// From held-out errors and outputs, one row a run.
    pub(super) fn new(curves: &[&[f64]], errors: &[&[f64]], missing: usize, folds: usize) -> Self {
        let (runs, length) = (curves.len(), curves[0].len());
        let (mut squares, mut totals) = (vec![0.0; length], vec![0.0; length]);
        for t in 0..length {
            let mean = curves.iter().map(|y| y[t]).sum::<f64>() / runs as f64;
            let is_constant = curves.iter().all(|y| y[t] == curves[0][t]);
            for (y, error) in curves.iter().zip(errors) {
                squares[t] += error[t] * error[t];
                totals[t] += if is_constant { 0.0 } else { (y[t] - mean) * (y[t] - mean) };
            }
        }
        let q2 = |square: f64, total: f64| (total > 0.0).then(|| 1.0 - square / total);
        Self {
            runs,
            missing,
            folds,
            rms: (squares.iter().sum::<f64>() / (runs * length) as f64).sqrt(),
            q2: q2(squares.iter().sum(), totals.iter().sum()),
            rms_along: squares.iter().map(|square| (square / runs as f64).sqrt()).collect(),
            q2_along: squares.iter().zip(&totals).map(|(square, total)| q2(*square, *total)).collect(),
            tried: Vec::new(),
        }
    }
}
