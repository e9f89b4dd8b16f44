//! The standard deviation that goes with a prediction.

use serde::{Deserialize, Serialize};

/// Shares of the form's own spread that are tried.
const SHARES: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.0];

/// Variance of a prediction: share · factor · v + (1 - share) · (held-out mean square), v being what the form itself says.
///
/// Either part has the mean of the held-out squared errors; the share is the one under which these errors, taken as normal,
/// are most likely. So the spread is right on average, whatever the form believes of itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    share: f64,
    factor: f64,
}

impl Spread {
    /// From squared held-out errors and the form's variances, one pair a run.
    pub(super) fn new(pairs: &[(f64, f64)]) -> Self {
        let count = pairs.len() as f64;
        let square = pairs.iter().map(|(square, _)| square).sum::<f64>() / count;
        let variance = pairs.iter().map(|(_, variance)| variance).sum::<f64>() / count;
        if !(variance > 0.0 && square > 0.0) {
            return Self { share: 0.0, factor: 0.0 };
        }
        let factor = square / variance;
        let mut best = (f64::INFINITY, Self { share: 0.0, factor });
        for share in SHARES {
            let spread = Self { share, factor };
            let deviance: f64 = pairs
                .iter()
                .map(|(error, variance)| {
                    let mixed = spread.variance(*variance, square).max(1e-12 * square);
                    libm::log(mixed) + error / mixed
                })
                .sum();
            if deviance < best.0 {
                best = (deviance, spread);
            }
        }
        best.1
    }

    /// The variance where the form says `variance` and the held-out mean square is `square`.
    pub(super) fn variance(self, variance: f64, square: f64) -> f64 {
        self.share * self.factor * variance + (1.0 - self.share) * square
    }
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn identity_the_mean_variance_is_the_mean_square_of_the_errors() {
        const TOLERANCE: f64 = 1e-12; // round-off
        let pairs: Vec<(f64, f64)> =
            (0..40).map(f64::from).map(|i| (0.3 + libm::sin(i) * libm::sin(i), 0.02 + 0.001 * i)).collect();
        let spread = Spread::new(&pairs);
        let square = pairs.iter().map(|pair| pair.0).sum::<f64>() / 40.0;
        let mean = pairs.iter().map(|pair| spread.variance(pair.1, square)).sum::<f64>() / 40.0;
        assert!((mean - square).abs() < TOLERANCE);
    }

    #[test]
    fn analytic_a_form_that_knows_its_errors_is_believed() {
        let pairs: Vec<(f64, f64)> = (1..60).map(f64::from).map(|i| (0.01 * i * i, 0.003 * i * i)).collect();
        assert_eq!(Spread::new(&pairs).share, 1.0);
        let blind: Vec<(f64, f64)> = (1..60).map(f64::from).map(|i| (0.01 * i * i, 3.0 / (i * i))).collect();
        assert!(Spread::new(&blind).share < 0.3);
    }
}
