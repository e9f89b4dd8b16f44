//! One column at one u: the finished values, replicate by replicate.

use super::in_order::in_order;
use super::smooth::Smooth;

/// The values of one column that belong together, in the order of the plan.
#[derive(Debug, Clone)]
pub(crate) struct Sample {
    values: Vec<f64>,
    replicate_ends: Vec<usize>,
    failed: usize,
    smooth: Option<Smooth>,
}

impl Sample {
    /// Takes values replicate by replicate; those that are not finite count as failed.
    pub fn new(replicates: impl Iterator<Item = impl Iterator<Item = f64>>) -> Self {
        let (mut values, mut replicate_ends, mut failed) = (Vec::new(), Vec::new(), 0);
        for replicate in replicates {
            for value in replicate {
                if value.is_finite() {
                    values.push(value);
                } else {
                    failed += 1;
                }
            }
            replicate_ends.push(values.len());
        }
        values.shrink_to_fit();
        Self { values, replicate_ends, failed, smooth: None }
    }

    /// A sample of these runs with another value each, a smooth function of the old one; finished ones stay finished where `change` is finite.
    pub fn mapped(&self, change: impl Fn(f64) -> f64) -> Self {
        let values: Vec<f64> = self.values.iter().map(|&value| change(value)).collect();
        let smooth = self.smooth.as_ref().map(|smooth| smooth.refitted(&values));
        Self { values, replicate_ends: self.replicate_ends.clone(), failed: self.failed, smooth }
    }

    /// A value from each pair of this and `other`, which belong to the same runs and have failed in the same ones.
    pub fn joined(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        let pairs = self.values.iter().zip(&other.values);
        let values = pairs.map(|(&a, &b)| of(a, b)).collect();
        Self { values, replicate_ends: self.replicate_ends.clone(), failed: self.failed, smooth: None }
    }

    /// Its polynomials where the response is smooth in the random inputs.
    pub fn smooth(&self) -> Option<&Smooth> {
        self.smooth.as_ref()
    }

    /// Tells that the response is smooth in the random inputs.
    pub fn set_smooth(&mut self, smooth: Smooth) {
        self.smooth = Some(smooth);
    }

    /// Finished values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Number of failed runs.
    pub fn failed(&self) -> usize {
        self.failed
    }

    /// Finished and failed runs.
    pub fn runs(&self) -> usize {
        self.values.len() + self.failed
    }

    /// Finished values in increasing order. Sorted anew each time: to keep a second copy of every column costs more than it
    /// saves.
    pub fn sorted(&self) -> Vec<f64> {
        in_order(self.values.iter().copied())
    }

    /// The least and the greatest finished value.
    pub fn ends(&self) -> Option<(f64, f64)> {
        let first = *self.values.first()?;
        Some(self.values.iter().fold((first, first), |(low, high), &value| (low.min(value), high.max(value))))
    }

    /// The finished values of each replicate that has any.
    pub fn replicates(&self) -> impl Iterator<Item = &[f64]> {
        self.replicate_ends
            .iter()
            .enumerate()
            .map(|(replicate, &end)| {
                &self.values[if replicate == 0 { 0 } else { self.replicate_ends[replicate - 1] }..end]
            })
            .filter(|values| !values.is_empty())
    }

    /// Number of replicates in the plan, those without a finished value included.
    pub fn planned_replicates(&self) -> usize {
        self.replicate_ends.len()
    }

    /// How many of the finished values do not exceed `limit`.
    pub fn count_up_to(&self, limit: f64) -> usize {
        self.values.iter().filter(|&&value| value <= limit).count()
    }
}
