//! Dependence of random inputs: a Gaussian copula, or rows of a joint sample.

use crate::dependence::correlation::GaussianCopula;
use crate::variables::random_variable::QuantileLevel;
use loosepin_math::places_in_order;

/// How random inputs go together.
#[derive(Debug, Clone, PartialEq)]
pub enum Copula {
    /// By normal variables behind them.
    Gaussian(GaussianCopula),
    /// By the rows of a joint sample.
    Empirical(EmpiricalCopula),
}

impl Copula {
    /// How many random inputs it belongs to.
    pub fn inputs(&self) -> usize {
        match self {
            Self::Gaussian(copula) => copula.inputs(),
            Self::Empirical(copula) => copula.inputs(),
        }
    }

    /// Which part of its distribution each input takes at a point of the unit cube.
    pub fn levels(&self, point: &[f64]) -> Vec<QuantileLevel> {
        match self {
            Self::Gaussian(copula) => copula.levels(point),
            Self::Empirical(copula) => copula.levels(point),
        }
    }
}

/// The empirical copula of n rows (P. Deheuvels, "La fonction de dépendance empirique et ses propriétés", Bulletin de la Classe des
/// Sciences, Académie royale de Belgique 65 (1979) 274-292): a row is drawn, each with probability 1/n, and every input has its value
/// in this row.
///
/// The distributions of the inputs are the empirical ones of their columns. The first coordinate of a point of the unit cube decides on
/// the row: the i-th of n for [(i - 1)/n, i/n). The others play no part.
#[derive(Debug, Clone, PartialEq)]
pub struct EmpiricalCopula {
    /// Ranks of the values of each row in their columns, from the smallest.
    ranks: Vec<Vec<usize>>,
    inputs: usize,
}

impl EmpiricalCopula {
    /// The copula of `rows`, each with a value for every input; `None` if there is no row, or one of another length.
    pub fn new(rows: &[Vec<f64>]) -> Option<Self> {
        let inputs = rows.first()?.len();
        if inputs == 0 || rows.iter().any(|row| row.len() != inputs) {
            return None;
        }
        let mut ranks = vec![vec![0; inputs]; rows.len()];
        for input in 0..inputs {
            let order = places_in_order(&rows.iter().map(|row| row[input]).collect::<Vec<f64>>());
            for (rank, row) in order.into_iter().enumerate() {
                ranks[row][input] = rank;
            }
        }
        Some(Self { ranks, inputs })
    }

    /// How many random inputs it belongs to.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    fn levels(&self, point: &[f64]) -> Vec<QuantileLevel> {
        let count = self.ranks.len();
        let row = point.first().map_or(0, |at| ((at * count as f64) as usize).min(count - 1));
        // In the middle of its step, where round-off does not reach the next one.
        let level = |rank: &usize| QuantileLevel::Probability((*rank as f64 + 0.5) / count as f64);
        self.ranks[row].iter().map(level).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Copula, EmpiricalCopula};
    use crate::{Distribution, RandomVariable, hash, uniform};

    #[test]
    fn identity_every_row_comes_out_as_it_went_in() {
        // Ties, a column that falls where the other one rises, and a count that is no power of two.
        let count = 997;
        let row = |k: usize| {
            let x = uniform(hash(5, 1), k as u64);
            vec![x, (20.0 * (1.0 - x)).floor(), uniform(hash(5, 2), k as u64) - 7.0]
        };
        let rows: Vec<Vec<f64>> = (0..count).map(row).collect();
        let copula = Copula::Empirical(EmpiricalCopula::new(&rows).expect("rows of one length"));
        let variable = |input: usize| {
            let mut values: Vec<f64> = rows.iter().map(|row| row[input]).collect();
            values.sort_by(f64::total_cmp);
            RandomVariable::try_new(Distribution::Empirical { values: values.into() }).expect("a sample")
        };
        let variables: Vec<RandomVariable> = (0..3).map(variable).collect();
        for (k, row) in rows.iter().enumerate() {
            for within in [0.001, 0.5, 0.999] {
                let point = [(k as f64 + within) / count as f64, 0.3, 0.9];
                let levels = copula.levels(&point);
                assert_eq!(levels.len(), variables.len());
                let drawn: Vec<f64> =
                    variables.iter().zip(levels).map(|(variable, level)| variable.at(level)).collect();
                assert_eq!(&drawn, row);
            }
        }
    }

    #[test]
    fn no_copula_of_rows_that_are_none() {
        assert_eq!(EmpiricalCopula::new(&[]), None);
        assert_eq!(EmpiricalCopula::new(&[Vec::new()]), None);
        assert_eq!(EmpiricalCopula::new(&[vec![1.0, 2.0], vec![1.0]]), None);
    }
}
