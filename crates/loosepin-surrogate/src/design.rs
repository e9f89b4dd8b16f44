//! Points of runs in standard coordinates, and how they are split to hold some out.

use super::input::Input;
use crate::chaos::polynomial::Family;
use loosepin_uncertainty::hash;

/// Points at which something was evaluated, as the surrogates see them.
#[derive(Debug, Clone)]
pub(super) struct Design {
    /// Mean 0, standard deviation 1: one row a point.
    pub scaled: Vec<Vec<f64>>,
    /// Standard variables of the polynomials: one row a point.
    pub germs: Vec<Vec<f64>>,
    /// The polynomials: one an input.
    pub families: Vec<Family>,
}

impl Design {
    pub fn new(inputs: &[Input], points: &[Vec<f64>]) -> Self {
        let rows = |map: fn(&Input, f64) -> f64| -> Vec<Vec<f64>> {
            points.iter().map(|point| inputs.iter().zip(point).map(|(input, x)| map(input, *x)).collect()).collect()
        };
        Self {
            scaled: rows(Input::scaled),
            germs: rows(Input::germ),
            families: inputs.iter().map(Input::family).collect(),
        }
    }

    pub fn count(&self) -> usize {
        self.scaled.len()
    }

    pub fn inputs(&self) -> usize {
        self.families.len()
    }

    /// Only some of the points.
    pub fn subset(&self, rows: &[usize]) -> Self {
        Self {
            scaled: rows.iter().map(|&row| self.scaled[row].clone()).collect(),
            germs: rows.iter().map(|&row| self.germs[row].clone()).collect(),
            families: self.families.clone(),
        }
    }

    /// For each point, the first point that equals it; the point itself if there is no other.
    pub fn first_equals(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.count()).collect();
        let compare = |&a: &usize, &b: &usize| {
            let pairs = self.scaled[a].iter().zip(&self.scaled[b]);
            pairs.map(|(x, y)| x.total_cmp(y)).find(|order| order.is_ne()).unwrap_or(a.cmp(&b))
        };
        order.sort_by(compare);
        let mut first: Vec<usize> = (0..self.count()).collect();
        for pair in order.windows(2) {
            if self.scaled[pair[0]] == self.scaled[pair[1]] {
                first[pair[1]] = first[pair[0]];
            }
        }
        first
    }

    /// The fold, 0 to `folds` - 1, in which each point is held out: points in random order dealt in turn, equal points
    /// together, since a point that was also trained on is not held out.
    pub fn folds(&self, folds: usize, seed: u64) -> Vec<usize> {
        let first = self.first_equals();
        let mut order: Vec<usize> = (0..self.count()).filter(|&i| first[i] == i).collect();
        order.sort_by_key(|&i| (hash(seed, i as u64), i));
        let mut fold = vec![0; self.count()];
        for (place, &i) in order.iter().enumerate() {
            fold[i] = place % folds;
        }
        (0..self.count()).map(|i| fold[first[i]]).collect()
    }
}

/// Mean and standard deviation (over N); the deviation is 0 where all values are equal, also when their mean is rounded.
pub(super) fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    if values.iter().all(|value| *value == values[0]) {
        return (values[0], 0.0);
    }
    let square = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count;
    (mean, square.sqrt())
}
