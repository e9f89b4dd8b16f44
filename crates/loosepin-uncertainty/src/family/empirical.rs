//! The empirical distribution of a sample.

use std::sync::Arc;

use super::{Family, Tails, finite};
use crate::variables::distribution::DistributionError;

/// Every one of n measured values with probability 1/n.
///
/// The quantile is the inverse of the empirical distribution function, x_(⌈n p⌉) of the ordered sample (R. J. Hyndman and Y.
/// Fan, "Sample quantiles in statistical packages", The American Statistician 50 (1996) 361-365, definition 1): no value is
/// drawn that was not measured, so nothing beyond the least and the greatest one.
#[derive(Debug)]
pub struct Empirical {
    /// In increasing order.
    values: Arc<[f64]>,
}

impl Empirical {
    /// A sample in increasing order.
    pub fn try_new(values: &Arc<[f64]>) -> Result<Self, DistributionError> {
        for &value in values.iter() {
            finite("value", value)?;
        }
        if values.len() < 2 || values[0] == values[values.len() - 1] {
            return Err(DistributionError::NoScatter { count: values.len() });
        }
        if let Some(pair) = values.windows(2).find(|pair| pair[0] > pair[1]) {
            return Err(DistributionError::TurnedRound { lower: pair[0], upper: pair[1] });
        }
        Ok(Self { values: Arc::clone(values) })
    }

    fn count(&self) -> f64 {
        self.values.len() as f64
    }
}

impl Family for Empirical {
    fn mean(&self) -> f64 {
        // About the first value, so that a small scatter far from zero keeps its digits.
        let first = self.values[0];
        first + self.values.iter().map(|value| value - first).sum::<f64>() / self.count()
    }

    /// With n, not n - 1: that of the distribution which is drawn from.
    fn standard_deviation(&self) -> f64 {
        let mean = self.mean();
        (self.values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / self.count()).sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        let passed = self.values.partition_point(|&value| value <= x) as f64;
        Tails { below: passed / self.count(), above: (self.count() - passed) / self.count() }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let last = self.values.len() - 1;
        let place = if at.below <= 0.5 {
            ((at.below * self.count()).ceil() as usize).saturating_sub(1)
        } else {
            last.saturating_sub((at.above * self.count()).floor() as usize)
        };
        self.values[place.min(last)]
    }

    fn atoms(&self) -> Option<Vec<(f64, f64)>> {
        let share = 1.0 / self.count();
        Some(self.values.iter().map(|&value| (value, share)).collect())
    }
}
