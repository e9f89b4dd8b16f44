//! Sparse polynomial chaos: a sum of products of orthonormal polynomials, few of them chosen from many.
//!
//! ```text
//! y(x) ~ c_0 + sum over k of c_k p_α1(ξ_1) ... p_αd(ξ_d),   α of k in the hyperbolic set (Σ α_i^q)^(1/q) <= p
//! ```
//!
//! Least-angle regression puts the candidates in an order; along it, least squares gives the coefficients and the corrected
//! leave-one-out error, whose least value chooses how many terms, p and q. (Orthogonal matching pursuit, tried beside it, was
//! better on three inputs and far worse on twenty.) Source: G. Blatman and B. Sudret, "Adaptive sparse polynomial chaos expansion based on least angle regression",
//! Journal of Computational Physics 230 (2011) 2345-2367; the correction is eq. (5.5) of O. Chapelle, V. Vapnik and
//! Y. Bengio, "Model selection for small sample regression", Machine Learning 48 (2002) 9-23.

use crate::chaos::index_set::hyperbolic_set;
use crate::chaos::least_angle::angle_order;
use crate::chaos::polynomial::Family;
use crate::chaos::regression::Regression;
use crate::design::Design;
use loosepin_math::dense::dot;
use serde::{Deserialize, Serialize};

/// Highest degree that is tried.
const HIGHEST_DEGREE: usize = 16;
/// Exponents q of the hyperbolic sets: the smaller, the fewer products.
const EXPONENTS: [f64; 3] = [1.0, 0.75, 0.5];
/// Most candidates of one set.
const MAX_CANDIDATES: usize = 1_800;
/// Degrees without a better error after which an exponent is given up.
const PATIENCE: usize = 3;

/// One product of polynomials.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Term {
    /// Input and degree, for each degree that is not 0.
    pub degrees: Vec<(usize, usize)>,
    /// c_k, in units of the output's standard deviation over the runs.
    pub coefficient: f64,
}

/// A fitted expansion of an output that was scaled to mean 0 and standard deviation 1.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Chaos {
    /// Polynomials of each input.
    pub families: Vec<Family>,
    /// c_0
    pub constant: f64,
    /// The other terms.
    pub terms: Vec<Term>,
    /// Corrected leave-one-out error over the variance of the output.
    pub leave_one_out: f64,
    /// (ΨᵀΨ)⁻¹ = U Uᵀ; rows of Uᵀ, the constant first.
    inverse_factor: Vec<Vec<f64>>,
    /// Variance of the rest, with the degrees of freedom that are left.
    rest_variance: f64,
}

impl Chaos {
    /// Fits `values` at the points of `design`.
    pub(crate) fn fit(design: &Design, values: &[f64]) -> Self {
        let table: Vec<Vec<Vec<f64>>> = design
            .germs
            .iter()
            .map(|row| row.iter().zip(&design.families).map(|(x, family)| family.values(*x, HIGHEST_DEGREE)).collect())
            .collect();
        let mut best = SparseBasis { error: f64::INFINITY, sets: Vec::new() };
        let mut tried: Vec<usize> = Vec::new();
        for exponent in EXPONENTS {
            let (mut least, mut worse) = (f64::INFINITY, 0);
            for degree in 1..=HIGHEST_DEGREE {
                let Some(set) = hyperbolic_set(design.inputs(), degree, exponent, MAX_CANDIDATES) else { break };
                // Sets of one degree differ by what they hold, so the same number means the same set.
                if tried.contains(&(set.len() * (HIGHEST_DEGREE + 1) + degree)) {
                    continue;
                }
                tried.push(set.len() * (HIGHEST_DEGREE + 1) + degree);
                let found = best_of(&table, values, &set);
                if found.error < least {
                    (least, worse) = (found.error, 0);
                } else {
                    worse += 1;
                }
                if found.error < best.error {
                    best = found;
                }
                if worse >= PATIENCE {
                    break;
                }
            }
        }
        Self::with_terms(design, &table, values, best)
    }

    fn with_terms(design: &Design, table: &[Vec<Vec<f64>>], values: &[f64], chosen: SparseBasis) -> Self {
        let count = values.len();
        let mut regression = Regression::new(values);
        let mut kept = Vec::new();
        for set in chosen.sets {
            if regression.add(&column(table, &set)) {
                kept.push(set);
            }
        }
        let coefficients = regression.coefficients();
        let freedom = count.saturating_sub(kept.len() + 1).max(1) as f64;
        let terms = kept.into_iter().zip(&coefficients[1..]);
        Self {
            families: design.families.clone(),
            constant: coefficients[0],
            terms: terms.map(|(degrees, &coefficient)| Term { degrees, coefficient }).collect(),
            leave_one_out: regression.corrected_error(),
            rest_variance: regression.rest_square() / freedom,
            inverse_factor: regression.inverse_factor(),
        }
    }

    /// Value and standard deviation, s √(1 + ψᵀ(ΨᵀΨ)⁻¹ψ), at standard variables ξ.
    pub(crate) fn predict(&self, germ: &[f64]) -> (f64, f64) {
        let mut highest = vec![0; germ.len()];
        for (input, degree) in self.terms.iter().flat_map(|term| &term.degrees) {
            highest[*input] = highest[*input].max(*degree);
        }
        let values: Vec<Vec<f64>> = germ
            .iter()
            .zip(&self.families)
            .zip(highest)
            .map(|((x, family), degree)| family.values(*x, degree))
            .collect();
        let mut row = vec![1.0];
        let mut value = self.constant;
        for term in &self.terms {
            let product: f64 = term.degrees.iter().map(|(input, degree)| values[*input][*degree]).product();
            value += term.coefficient * product;
            row.push(product);
        }
        let leverage: f64 = self.inverse_factor.iter().map(|part| dot(part, &row[..part.len()])).map(|x| x * x).sum();
        (value, (self.rest_variance * (1.0 + leverage)).sqrt())
    }
}

/// Terms in the order in which they entered, and their corrected leave-one-out error.
struct SparseBasis {
    error: f64,
    sets: Vec<Vec<(usize, usize)>>,
}

fn best_of(table: &[Vec<Vec<f64>>], values: &[f64], set: &[Vec<(usize, usize)>]) -> SparseBasis {
    let columns: Vec<Vec<f64>> = set.iter().map(|degrees| column(table, degrees)).collect();
    let most = values.len().saturating_sub(2).min(set.len());
    let mut regression = Regression::new(values);
    let mut kept = Vec::new();
    let (mut least, mut length) = (regression.corrected_error(), 0);
    for index in angle_order(&columns, values, most) {
        if !regression.add(&columns[index]) {
            continue;
        }
        kept.push(index);
        let error = regression.corrected_error();
        if error < least {
            (least, length) = (error, kept.len());
        }
    }
    SparseBasis { error: least, sets: kept[..length].iter().map(|&index| set[index].clone()).collect() }
}

fn column(table: &[Vec<Vec<f64>>], degrees: &[(usize, usize)]) -> Vec<f64> {
    table.iter().map(|row| degrees.iter().map(|(input, degree)| row[*input][*degree]).product()).collect()
}
