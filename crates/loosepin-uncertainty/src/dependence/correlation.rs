//! Dependence of random inputs: a Gaussian copula.

use core::f64::consts::PI;

use loosepin_math::dense::{Cholesky, Precision, SymmetricEigen};
use thiserror::Error;

use crate::functions::normal::normal_quantile;
use crate::variables::random_variable::{QuantileLevel, RandomVariable};

/// Correlated standard normal variables behind the random inputs: z = L w, w independent, L Lᵀ = R, X_i = F_i⁻¹(Φ(z_i)).
///
/// The distributions of the inputs one by one stay what they are. Inputs that no pair names are drawn as without the copula.
#[derive(Debug, Clone, PartialEq)]
pub struct GaussianCopula {
    pairs: Vec<Pair>,
    /// Row i of L, up to its diagonal; empty for an input that depends on none before it.
    rows: Vec<Vec<f64>>,
}

/// Two inputs and the correlation of the normal variables behind them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// One input, counted from 0.
    pub first: usize,
    /// The other one.
    pub second: usize,
    /// Correlation of the normal variables, between -1 and 1.
    pub normal: f64,
}

/// Errors of a copula.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum CopulaError {
    #[error("a correlation of inputs {first} and {second} of {inputs}, counted from 0; must be two different ones")]
    NoSuchPair { first: usize, second: usize, inputs: usize },
    #[error("a second correlation of inputs {first} and {second}")]
    PairTwice { first: usize, second: usize },
    /// A correlation that leaves no freedom, or is none.
    #[error("correlation {normal} of the normal variables; must lie between -1 and 1, both excluded")]
    OutOfRange { normal: f64 },
    #[error(
        "the correlations contradict each other: the least eigenvalue of their matrix is {least_eigenvalue}; must be > 0"
    )]
    NotPositiveDefinite {
        /// The inputs whose correlations do so, in increasing order.
        inputs: Vec<usize>,
        /// Least eigenvalue of the matrix of all their correlations.
        least_eigenvalue: f64,
    },
}

/// What a least eigenvalue must exceed: the round-off of a Cholesky decomposition.
const MIN_EIGENVALUE: f64 = 1e-12;

impl GaussianCopula {
    /// The copula of `inputs` random inputs with these correlations of the normal variables behind them; those of pairs that are
    /// not named are 0.
    ///
    /// # Errors
    ///
    /// [`CopulaError`] where a pair is none, or the whole matrix is not positive definite.
    pub fn try_new(inputs: usize, pairs: Vec<Pair>) -> Result<Self, CopulaError> {
        for (index, &Pair { first, second, normal }) in pairs.iter().enumerate() {
            if first >= inputs || second >= inputs || first == second {
                return Err(CopulaError::NoSuchPair { first, second, inputs });
            }
            let is_same = |other: &Pair| {
                (other.first, other.second) == (first, second) || (other.first, other.second) == (second, first)
            };
            if pairs[..index].iter().any(is_same) {
                return Err(CopulaError::PairTwice { first, second });
            }
            if !(normal.abs() < 1.0) {
                return Err(CopulaError::OutOfRange { normal });
            }
        }
        let mut rows = vec![Vec::new(); inputs];
        for group in groups(inputs, &pairs) {
            let matrix = matrix_of(&group, &pairs);
            let eigen = SymmetricEigen::new(matrix.clone(), group.len(), Precision::OfLargest);
            let least_eigenvalue = eigen.values.into_iter().fold(f64::INFINITY, f64::min);
            let factor = Cholesky::new(matrix, group.len()).filter(|_| least_eigenvalue > MIN_EIGENVALUE);
            let Some(factor) = factor else {
                return Err(CopulaError::NotPositiveDefinite { inputs: group, least_eigenvalue });
            };
            for (place, &input) in group.iter().enumerate().skip(1) {
                let mut whole = vec![0.0; input + 1];
                for (&member, value) in group.iter().zip(factor.row(place)) {
                    whole[member] = *value;
                }
                rows[input] = whole;
            }
        }
        Ok(Self { pairs, rows })
    }

    /// How many random inputs it belongs to.
    pub fn inputs(&self) -> usize {
        self.rows.len()
    }

    /// Whether this input is correlated with another one.
    pub fn is_correlated(&self, input: usize) -> bool {
        self.pairs.iter().any(|pair| pair.first == input || pair.second == input)
    }

    /// Which part of its distribution each input takes at a point of the unit cube.
    pub fn levels(&self, point: &[f64]) -> Vec<QuantileLevel> {
        let is_used = |input: usize| self.is_correlated(input);
        let normal: Vec<f64> = point
            .iter()
            .enumerate()
            .map(|(input, &at)| if is_used(input) { normal_quantile(at) } else { 0.0 })
            .collect();
        let level = |(input, &at): (usize, &f64)| match self.rows.get(input) {
            Some(row) if !row.is_empty() => {
                QuantileLevel::StandardNormal(row.iter().zip(&normal).fold(0.0, |sum, (factor, z)| sum + factor * z))
            }
            _ => QuantileLevel::Probability(at),
        };
        point.iter().enumerate().map(level).collect()
    }

    /// Values of `variables` at a point of the unit cube.
    pub fn sample(&self, variables: &[RandomVariable], point: &[f64]) -> Vec<f64> {
        variables.iter().zip(self.levels(point)).map(|(variable, level)| variable.at(level)).collect()
    }
}

/// The correlation of normal variables whose ranks have the correlation `rank` (Spearman): 2 sin(π ρ/6), exact for any
/// continuous distributions (K. Pearson 1907; W. H. Kruskal, "Ordinal measures of association", 1958).
pub fn normal_of_rank(rank: f64) -> f64 {
    2.0 * libm::sin(PI * rank / 6.0)
}

/// The inverse of [`normal_of_rank`].
pub fn rank_of_normal(normal: f64) -> f64 {
    6.0 / PI * libm::asin(0.5 * normal)
}

/// Inputs that depend on each other, directly or through others, in increasing order.
fn groups(inputs: usize, pairs: &[Pair]) -> Vec<Vec<usize>> {
    let mut label: Vec<usize> = (0..inputs).collect();
    for pair in pairs {
        let (keep, drop) = (label[pair.first].min(label[pair.second]), label[pair.first].max(label[pair.second]));
        label.iter_mut().filter(|each| **each == drop).for_each(|each| *each = keep);
    }
    let members = |group: usize| (0..inputs).filter(|&input| label[input] == group).collect::<Vec<usize>>();
    (0..inputs).map(members).filter(|group| group.len() > 1).collect()
}

/// Correlations of the inputs of a group, row by row.
fn matrix_of(group: &[usize], pairs: &[Pair]) -> Vec<f64> {
    let entry = |a: usize, b: usize| {
        if a == b {
            return 1.0;
        }
        let is_it = |pair: &&Pair| (pair.first, pair.second) == (a, b) || (pair.first, pair.second) == (b, a);
        pairs.iter().find(is_it).map_or(0.0, |pair| pair.normal)
    };
    group.iter().flat_map(|&a| group.iter().map(move |&b| entry(a, b))).collect()
}

#[cfg(test)]
mod tests;
