//! Residual of the runs, and whether more runs would make it smaller.
//!
//! The held-out errors of fits to a quarter, a half and all of the runs that may be learned from, at the same held-out runs:
//! where the step from half to all does not make them smaller, or the three errors continue to a limit that is not far below
//! the last of them, more runs will not help, and what is left is a property of the response. Then it belongs to the surrogate, with a scale that may depend on the inputs.

use loosepin_terms::SurrogateVerdict;
use serde::{Deserialize, Serialize};

/// Shares of the runs at which the error is measured.
pub const SHARES: [f64; 3] = [0.25, 0.5, 1.0];
/// From half to all of the runs the mean square must fall below this share for the error to be called falling.
const FALLING_RATIO: f64 = 0.8;
/// Standard errors by which the paired difference must exceed zero.
const FALLING_SIGNIFICANCE: f64 = 1.0;
/// Least share of the mean square that must be going to fall when it is continued to any number of runs.
const FALLING_SHARE: f64 = 0.5;
/// Mean square, over the variance of the output, below which nothing is left.
const RESOLVED: f64 = 1e-8;
/// Below this Q² nothing was learned.
const LEARNED: f64 = 0.1;
/// Kurtosis of the held-out errors, and largest one over the range of the output, from which on a few of them are those of a
/// jump: near it a smooth surrogate errs by a good part of it, elsewhere by little.
const JUMP_KURTOSIS: f64 = 6.0;
const JUMP_SHARE: f64 = 0.3;
/// Fewest runs on which the test is made.
const FEWEST: usize = 20;
/// Factor between the squares that a coefficient of the scale must explain: t value.
const SCALE_SIGNIFICANCE: f64 = 3.0;

/// The rest as part of a surrogate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// Verdict of the errors.
    pub verdict: SurrogateVerdict,
    /// Learned runs and held-out root mean square error, for each of [`SHARES`]; empty where too few runs.
    pub learning: Vec<(usize, f64)>,
    /// Held-out errors over their scale, one row a run; empty where the rest falls.
    pub errors: Vec<Vec<f64>>,
    /// c_k of the scale s(x) = exp(Σ c_k z_k), z the inputs in standard ranges about the mean of the runs; all 0 where the
    /// errors do not tell that they depend on them.
    pub scale: Vec<f64>,
    /// Mean of z over the runs.
    pub centre: Vec<f64>,
}

impl Residual {
    /// s(x) at scaled inputs z.
    pub(super) fn scale_at(&self, scaled: &[f64]) -> f64 {
        let parts = self.scale.iter().zip(scaled).zip(&self.centre);
        libm::exp(parts.map(|((c, z), m)| c * (z - m)).sum())
    }

    /// The error of the run that `share` in \[0, 1) of the runs lie before, at the scale of z; `None` if the rest falls.
    pub(super) fn draw(&self, scaled: &[f64], share: f64) -> Option<Vec<f64>> {
        if self.errors.is_empty() {
            return None;
        }
        let row = ((share * self.errors.len() as f64) as usize).min(self.errors.len() - 1);
        let scale = self.scale_at(scaled);
        Some(self.errors[row].iter().map(|error| scale * error).collect())
    }

    /// Judges held-out errors (one row a run) at scaled inputs. `learning` holds the learned runs and the squared errors of
    /// every run for each of [`SHARES`].
    pub(super) fn new(
        scaled: &[Vec<f64>],
        errors: &[&[f64]],
        range: f64,
        variance: f64,
        q2: Option<f64>,
        learning: &[(usize, Vec<f64>)],
    ) -> Self {
        let verdict = judge(errors, range, variance, q2, learning);
        let (count, inputs) = (errors.len(), scaled[0].len());
        let centre: Vec<f64> = (0..inputs).map(|k| scaled.iter().map(|z| z[k]).sum::<f64>() / count as f64).collect();
        let mut residual = Self {
            verdict,
            learning: learning
                .iter()
                .map(|(runs, squares)| (*runs, (mean(squares) / errors[0].len() as f64).sqrt()))
                .collect(),
            errors: Vec::new(),
            scale: vec![0.0; inputs],
            centre,
        };
        if verdict.keeps_residual() {
            residual.scale = scale_coefficients(scaled, errors, &residual.centre);
            residual.errors = scaled
                .iter()
                .zip(errors)
                .map(|(z, error)| (residual.scale_at(z), error))
                .map(|(scale, error)| error.iter().map(|e| e / scale).collect())
                .collect();
        }
        residual
    }
}

fn judge(
    errors: &[&[f64]],
    range: f64,
    variance: f64,
    q2: Option<f64>,
    learning: &[(usize, Vec<f64>)],
) -> SurrogateVerdict {
    let Some(q2) = q2 else { return SurrogateVerdict::Constant };
    let squares: Vec<f64> = errors.iter().map(|row| row.iter().map(|e| e * e).sum()).collect();
    let places = errors[0].len() as f64;
    if mean(&squares) <= RESOLVED * variance * places {
        return SurrogateVerdict::Resolved;
    }
    if errors.len() < FEWEST || learning.len() < SHARES.len() {
        return SurrogateVerdict::Unknown;
    }
    let (half, all) = (&learning[1].1, &learning[2].1);
    let gains: Vec<f64> = half.iter().zip(all).map(|(half, all)| half - all).collect();
    let gain = mean(&gains);
    let deviation = (gains.iter().map(|g| (g - gain) * (g - gain)).sum::<f64>() / gains.len() as f64).sqrt();
    let is_significant = gain > FALLING_SIGNIFICANCE * deviation / (gains.len() as f64).sqrt();
    let floor = limit(mean(&learning[0].1), mean(half), mean(all));
    let falls = mean(all) < FALLING_RATIO * mean(half) && is_significant && floor < FALLING_SHARE * mean(all);
    let fourth = squares.iter().map(|square| square * square).sum::<f64>() / squares.len() as f64;
    let kurtosis = fourth / (mean(&squares) * mean(&squares));
    let largest = squares.iter().fold(0.0_f64, |largest, square| largest.max(*square)).sqrt();
    if errors[0].len() == 1 && kurtosis > JUMP_KURTOSIS && largest > JUMP_SHARE * range && q2 > LEARNED {
        return SurrogateVerdict::Jump;
    }
    if falls {
        SurrogateVerdict::Falling
    } else if q2 < LEARNED {
        SurrogateVerdict::Nothing
    } else {
        SurrogateVerdict::Floor
    }
}

/// The mean square that is left after any number of runs, from those at m, 2m and 4m runs: exact where it is a constant and a
/// power of m (A. C. Aitken's extrapolation); 0 where it falls faster and faster.
fn limit(quarter: f64, half: f64, all: f64) -> f64 {
    let (first, second) = (quarter - half, half - all);
    if first > second && second > 0.0 { (all - second * second / (first - second)).max(0.0) } else { 0.0 }
}

/// Least squares of ln|error| on each input by itself; only those whose slope is several times its standard error.
fn scale_coefficients(scaled: &[Vec<f64>], errors: &[&[f64]], centre: &[f64]) -> Vec<f64> {
    let count = errors.len() as f64;
    let sizes: Vec<f64> =
        errors.iter().map(|row| (row.iter().map(|e| e * e).sum::<f64>() / row.len() as f64).sqrt()).collect();
    // A run that is met by chance would otherwise have the logarithm of nearly nothing.
    let floor = 0.1 * (sizes.iter().map(|s| s * s).sum::<f64>() / count).sqrt();
    let logarithms: Vec<f64> = sizes.iter().map(|size| libm::log(size.max(floor))).collect();
    let middle = mean(&logarithms);
    (0..centre.len())
        .map(|k| {
            let z: Vec<f64> = scaled.iter().map(|row| row[k] - centre[k]).collect();
            let square: f64 = z.iter().map(|z| z * z).sum();
            if !(square > 0.0) || errors.len() < FEWEST {
                return 0.0;
            }
            let slope = z.iter().zip(&logarithms).map(|(z, y)| z * (y - middle)).sum::<f64>() / square;
            let rest: f64 = z.iter().zip(&logarithms).map(|(z, y)| (y - middle - slope * z).powi(2)).sum();
            let deviation = (rest / (count - 2.0) / square).sqrt();
            if slope.abs() > SCALE_SIGNIFICANCE * deviation { slope } else { 0.0 }
        })
        .collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[cfg(test)]
mod tests {
    use super::limit;

    #[test]
    fn analytic_a_constant_and_a_power_are_told_apart() {
        const TOLERANCE: f64 = 1e-12; // round-off
        let error = |runs: f64| 0.3 + 2.7 / libm::pow(runs, 0.8);
        assert!((limit(error(20.0), error(40.0), error(80.0)) - 0.3).abs() < TOLERANCE);
        assert_eq!(limit(0.9, 0.8, 0.4), 0.0);
    }
}
