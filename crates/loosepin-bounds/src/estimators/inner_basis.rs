//! Polynomials of the random inputs, fitted to the runs at one u: where the response is smooth in X they know its mean, its deviation
//! and its distribution far better than counting does.
//!
//! ```text
//! y(X) ≈ p(t) = Σ c_k Π_j p_kj(t_j),   t_j: a standard normal or a uniform coordinate of random input j,   Σ_j k_j <= degree
//! ```
//!
//! with orthonormal polynomials (N. Wiener 1938; D. Xiu and G. E. Karniadakis, "The Wiener-Askey polynomial chaos for stochastic
//! differential equations", SIAM Journal on Scientific Computing 24 (2002) 619-644), fitted by least squares. Each replicate r is
//! compared with the polynomial that was fitted to the *other* replicates: with p_r that polynomial,
//!
//! ```text
//! E y = E p_r + E(y - p_r),   estimated by c_r0 + mean over the runs of replicate r of (y - p_r),
//! ```
//!
//! has no bias whatever p_r is, and the spread of the replicates is its error (Y. Nakatsukasa, "Approximate and integrate: variance
//! reduction in Monte Carlo integration via function approximation", arXiv 1806.05492 (2018), there without the splitting). The
//! runs are those of the plan: none is added, and where the response is not smooth nothing is done.

use std::sync::{Arc, OnceLock};

use super::basis::Basis;
use super::orthogonal::Axis;
use super::preintegration::{Conditional, Rest};
use loosepin_math::dense::{Cholesky, dot, gram};
use loosepin_math::on_vectors;

/// Highest degree of a polynomial.
const MAX_DEGREE: usize = 12;
/// Runs of the other replicates for each coefficient, at least.
const RUNS_PER_COEFFICIENT: usize = 3;
/// Entries of the matrix of terms at the inner points, at most: 8 MiB.
const MAX_ENTRIES: usize = 1 << 20;

/// The points of the inner loop, and the polynomials on them.
#[derive(Debug)]
pub(crate) struct InnerBasis {
    designs: Vec<Arc<DesignMatrix>>,
}

/// The polynomials up to one degree on the inner points.
#[derive(Debug)]
pub(crate) struct DesignMatrix {
    pub basis: Basis,
    /// Runs of one replicate.
    per_replicate: usize,
    /// Terms at the inner points, row by row.
    rows: Vec<f64>,
    /// Normal equations of all replicates but each one.
    without: Vec<Cholesky>,
    /// Nodes over all axes but one, worked out when they are needed.
    rest: Vec<OnceLock<Rest>>,
}

/// Each replicate against the polynomial that was fitted to all others.
#[derive(Debug, Clone)]
pub(crate) struct CrossFit {
    /// Coefficients of the polynomial that was fitted without each replicate.
    pub coefficients: Vec<Vec<f64>>,
    /// Residuals of every value of that replicate.
    pub residuals: Vec<f64>,
}

impl InnerBasis {
    /// Polynomials on `points` of the unit cube, replicate by replicate; nothing where the runs are too few for any.
    pub fn new(axes: &[Axis], points: &[Vec<f64>], replicates: usize) -> Option<Self> {
        let coordinates: Vec<Vec<f64>> = points
            .iter()
            .map(|point| point.iter().zip(axes).map(|(&omega, axis)| axis.coordinate(omega)).collect())
            .collect();
        let designs: Vec<Arc<DesignMatrix>> = (1..=MAX_DEGREE)
            .map_while(|degree| DesignMatrix::new(axes, degree, &coordinates, replicates))
            .map(Arc::new)
            .collect();
        (!designs.is_empty()).then_some(Self { designs })
    }

    /// From the lowest degree to the highest.
    pub fn designs(&self) -> &[Arc<DesignMatrix>] {
        &self.designs
    }
}

impl DesignMatrix {
    /// Polynomials up to `degree` at `coordinates`, replicate by replicate; nothing where the runs are too few.
    pub fn new(axes: &[Axis], degree: usize, coordinates: &[Vec<f64>], replicates: usize) -> Option<Self> {
        let count = coordinates.len();
        let basis = Basis::try_new(axes, degree)?;
        let size = basis.terms.len();
        let per_replicate = count / replicates;
        if RUNS_PER_COEFFICIENT * size > count - per_replicate || size * count > MAX_ENTRIES {
            return None;
        }
        let rows: Vec<f64> = coordinates.iter().flat_map(|point| basis.values(point)).collect();
        let grams: Vec<Vec<f64>> = rows.chunks(size * per_replicate).map(|rows| gram(rows, size)).collect();
        let without: Option<Vec<Cholesky>> = (0..replicates)
            .map(|left_out| {
                let mut sum = vec![0.0; size * size];
                for (_, gram) in grams.iter().enumerate().filter(|(replicate, _)| *replicate != left_out) {
                    for (entry, value) in sum.iter_mut().zip(gram) {
                        *entry += value;
                    }
                }
                Cholesky::new(sum, size)
            })
            .collect();
        let rest = axes.iter().map(|_| OnceLock::new()).collect();
        Some(Self { basis, per_replicate, rows, without: without?, rest })
    }

    /// Fits `values`, one for each inner point.
    pub fn fit(&self, values: &[f64]) -> CrossFit {
        let size = self.basis.terms.len();
        let centre = values.iter().sum::<f64>() / values.len() as f64;
        let block = size * self.per_replicate;
        let right = |(rows, values): (&[f64], &[f64])| {
            let mut right = vec![0.0; size];
            on_vectors(
                #[inline(always)]
                || {
                    for (row, value) in rows.chunks(size).zip(values) {
                        let value = value - centre;
                        for (entry, term) in right.iter_mut().zip(row) {
                            *entry += term * value;
                        }
                    }
                },
            );
            right
        };
        let rights: Vec<Vec<f64>> = self.rows.chunks(block).zip(values.chunks(self.per_replicate)).map(right).collect();
        let mut sum = vec![0.0; size];
        for right in &rights {
            for (entry, value) in sum.iter_mut().zip(right) {
                *entry += value;
            }
        }
        let mut residuals = Vec::with_capacity(values.len());
        let mut coefficients = Vec::with_capacity(rights.len());
        for (replicate, right) in rights.iter().enumerate() {
            let mut own: Vec<f64> = sum.iter().zip(right).map(|(all, own)| all - own).collect();
            self.without[replicate].solve(&mut own);
            let rows = self.rows[replicate * block..(replicate + 1) * block].chunks(size);
            let values = &values[replicate * self.per_replicate..(replicate + 1) * self.per_replicate];
            residuals.extend(rows.zip(values).map(|(row, value)| value - centre - dot(row, &own)));
            own[0] += centre;
            coefficients.push(own);
        }
        CrossFit { coefficients, residuals }
    }

    /// Distribution function of the polynomial with these coefficients.
    pub fn conditional(&self, coefficients: &[f64]) -> Conditional {
        let axis = self.basis.steepest_axis(coefficients);
        let rest = self.rest[axis].get_or_init(|| Rest::new(&self.basis, axis));
        Conditional::new(&self.basis, rest, coefficients)
    }

    /// Runs of one replicate.
    pub fn per_replicate(&self) -> usize {
        self.per_replicate
    }
}
