//! A few values with their probabilities.

use super::{Family, Tails, finite, positive};
use crate::variables::distribution::DistributionError;
use loosepin_math::sort_by_number;

/// How far probabilities may sum up to something else than 1: a few more digits than people write.
const SUM_TOLERANCE: f64 = 1e-9;

/// Values in increasing order, and the shares on both sides of each.
#[derive(Debug)]
pub struct Discrete {
    atoms: Vec<(f64, f64)>,
    /// P(X <= value) and P(X > value), each summed up from its own end.
    tails: Vec<Tails>,
}

impl Discrete {
    /// These values with these probabilities, in any order.
    pub fn try_new(values: &[f64], probabilities: &[f64]) -> Result<Self, DistributionError> {
        if values.len() != probabilities.len() || values.is_empty() {
            let (values, probabilities) = (values.len(), probabilities.len());
            return Err(DistributionError::UnequalLists { values, probabilities });
        }
        for (&value, &probability) in values.iter().zip(probabilities) {
            finite("value", value)?;
            positive("probability", probability)?;
        }
        let sum: f64 = probabilities.iter().sum();
        if (sum - 1.0).abs() > SUM_TOLERANCE {
            return Err(DistributionError::SumNotOne { sum });
        }
        let mut atoms: Vec<(f64, f64)> = values.iter().copied().zip(probabilities.iter().copied()).collect();
        sort_by_number(&mut atoms, |a| a.0);
        if let Some(pair) = atoms.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(DistributionError::ValueTwice { value: pair[0].0 });
        }
        Ok(Self::of_atoms(atoms))
    }

    /// The distribution with these atoms: values in increasing order with their weights, which need not sum up to 1.
    pub fn of_atoms(atoms: Vec<(f64, f64)>) -> Self {
        let sum: f64 = atoms.iter().map(|atom| atom.1).sum();
        let mut below = 0.0;
        let from_below: Vec<f64> = atoms
            .iter()
            .map(|atom| {
                below += atom.1;
                below / sum
            })
            .collect();
        let mut above = 0.0;
        let mut from_above: Vec<f64> = atoms
            .iter()
            .rev()
            .map(|atom| {
                let before = above;
                above += atom.1;
                before / sum
            })
            .collect();
        from_above.reverse();
        let tails = from_below.into_iter().zip(from_above).map(|(below, above)| Tails { below, above }).collect();
        Self { atoms: atoms.into_iter().map(|(value, weight)| (value, weight / sum)).collect(), tails }
    }
}

impl Family for Discrete {
    fn mean(&self) -> f64 {
        self.atoms.iter().map(|(value, probability)| value * probability).sum()
    }

    fn standard_deviation(&self) -> f64 {
        let mean = self.mean();
        let squares = self.atoms.iter().map(|(value, probability)| probability * (value - mean) * (value - mean));
        squares.sum::<f64>().sqrt()
    }

    fn tails(&self, x: f64) -> Tails {
        match self.atoms.partition_point(|atom| atom.0 <= x) {
            0 => Tails { below: 0.0, above: 1.0 },
            count => self.tails[count - 1],
        }
    }

    fn quantile(&self, at: Tails) -> f64 {
        let passed = if at.below <= 0.5 {
            self.tails.partition_point(|tails| tails.below < at.below)
        } else {
            self.tails.partition_point(|tails| tails.above > at.above)
        };
        self.atoms[passed.min(self.atoms.len() - 1)].0
    }

    fn atoms(&self) -> Option<Vec<(f64, f64)>> {
        Some(self.atoms.clone())
    }
}
