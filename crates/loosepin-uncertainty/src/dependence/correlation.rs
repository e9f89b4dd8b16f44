//! Dependence of random inputs: a Gaussian copula.

use core::f64::consts::PI;

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
            let least_eigenvalue = least_eigenvalue(matrix.clone());
            let factor = cholesky(&matrix).filter(|_| least_eigenvalue > MIN_EIGENVALUE);
            let Some(factor) = factor else {
                return Err(CopulaError::NotPositiveDefinite { inputs: group, least_eigenvalue });
            };
            for (place, row) in factor.into_iter().enumerate().skip(1) {
                let mut whole = vec![0.0; group[place] + 1];
                for (&member, value) in group.iter().zip(row) {
                    whole[member] = value;
                }
                rows[group[place]] = whole;
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

fn matrix_of(group: &[usize], pairs: &[Pair]) -> Vec<Vec<f64>> {
    let entry = |a: usize, b: usize| {
        if a == b {
            return 1.0;
        }
        let is_it = |pair: &&Pair| (pair.first, pair.second) == (a, b) || (pair.first, pair.second) == (b, a);
        pairs.iter().find(is_it).map_or(0.0, |pair| pair.normal)
    };
    group.iter().map(|&a| group.iter().map(|&b| entry(a, b)).collect()).collect()
}

/// Rows of the lower triangle L with L Lᵀ = `matrix`; `None` if there is none.
fn cholesky(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(matrix.len());
    for (i, given) in matrix.iter().enumerate() {
        let mut row: Vec<f64> = Vec::with_capacity(i + 1);
        for j in 0..=i {
            let known = if j < i { &rows[j] } else { &row };
            let rest = row.iter().zip(known).fold(given[j], |rest, (a, b)| rest - a * b);
            let value = if j < i { rest / rows[j][j] } else { rest.sqrt() };
            if !(j < i || rest > 0.0) {
                return None;
            }
            row.push(value);
        }
        rows.push(row);
    }
    Some(rows)
}

/// The least eigenvalue of a symmetric matrix, by Jacobi's rotations (C. G. J. Jacobi 1846; cyclic sweeps).
fn least_eigenvalue(mut a: Vec<Vec<f64>>) -> f64 {
    const MAX_SWEEPS: usize = 60;
    const SMALL: f64 = 1e-30;
    let n = a.len();
    for _ in 0..MAX_SWEEPS {
        let off: f64 = (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        if off < SMALL {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q] == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let sign = if theta < 0.0 { -1.0 } else { 1.0 };
                let t = sign / (theta.abs() + (theta * theta + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (above, below) = a.split_at_mut(q);
                for (x, y) in above[p].iter_mut().zip(&mut below[0]) {
                    (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                }
            }
        }
    }
    (0..n).map(|i| a[i][i]).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
