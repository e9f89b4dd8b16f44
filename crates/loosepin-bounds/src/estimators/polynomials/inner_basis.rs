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
//! has no bias whatever p_r is (Y. Nakatsukasa, "Approximate and integrate: variance reduction in Monte Carlo integration via function
//! approximation", arXiv 1806.05492 (2018), there without the splitting). The runs are those of the plan: none is added, and where the
//! response is not smooth nothing is done.
//!
//! Two p_r share most of their runs, so the R estimates depend on each other, and their spread alone is too small an error. The estimate is
//! linear in the values, Σ w_i y_i, with weights that the points alone determine:
//!
//! ```text
//! w_i = 1/N + 1/R Σ_(r not of i) d_r·G_r⁻¹ φ_i,   d_r = e_0 - mean over replicate r of φ,   G_r: Gram matrix of all replicates but r
//! ```
//!
//! φ the terms at a point. With ε_i the residual of run i against p_r of its own replicate, √(Σ w_i² ε_i²) is the standard error where residuals
//! are independent of one another.
//!
//! Both see residuals at the runs alone. Beyond the outermost runs the terms that the polynomial lacks are largest, and no run is there. The
//! next two degrees tell what such terms may be worth: twice the distance of their estimates is an error too. The largest of the three counts.
//! A degree is for use where N Σ w² is at most 2: its estimate hangs on few runs otherwise.

use std::sync::{Arc, OnceLock};

use super::basis::Basis;
use super::orthogonal::Axis;
use super::preintegration::{Conditional, Rest};
use loosepin_math::dense::{Cholesky, dot, gram};
use loosepin_math::with_vector_instructions;

/// Highest degree of a polynomial.
const MAX_DEGREE: usize = 12;
/// Runs of the other replicates for each coefficient, at least: of polynomials for use, and of those that others are compared with.
const RUNS_PER_COEFFICIENT: f64 = 3.0;
const COMPARED_RUNS_PER_COEFFICIENT: f64 = 1.5;
/// N Σ w² of polynomials for use, at most; 1 is that of counting.
const MAX_INFLATION: f64 = 2.0;
/// So many higher degrees are compared with.
const COMPARED_DEGREES: usize = 2;
/// Entries of the matrix of terms at the inner points, at most: 8 MiB.
const MAX_ENTRIES: usize = 1 << 20;

/// The points of the inner loop, and the polynomials on them that are for use.
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
    /// w of every run.
    weights: Vec<f64>,
    /// The next degrees, two at most.
    higher: Vec<Arc<Self>>,
    /// Nodes over all axes but one, computed on first use.
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
    /// Polynomials on `points` of the unit cube, replicate by replicate; `None` if the runs are too few for any.
    pub fn new(axes: &[Axis], points: &[Vec<f64>], replicates: usize) -> Option<Self> {
        let coordinates: Vec<Vec<f64>> = points
            .iter()
            .map(|point| point.iter().zip(axes).map(|(&omega, axis)| axis.coordinate(omega)).collect())
            .collect();
        let all: Vec<DesignMatrix> =
            (1..=MAX_DEGREE).map_while(|degree| DesignMatrix::new(axes, degree, &coordinates, replicates)).collect();
        let mut designs: Vec<Arc<DesignMatrix>> = Vec::new();
        for mut design in all.into_iter().rev() {
            design.higher = designs.iter().rev().take(COMPARED_DEGREES).cloned().collect();
            designs.push(Arc::new(design));
        }
        designs.reverse();
        designs.retain(|design| design.is_for_use());
        (!designs.is_empty()).then_some(Self { designs })
    }

    /// From the lowest degree to the highest.
    pub fn designs(&self) -> &[Arc<DesignMatrix>] {
        &self.designs
    }
}

impl DesignMatrix {
    /// Polynomials up to `degree` at `coordinates`, replicate by replicate; `None` if the runs are too few.
    pub fn new(axes: &[Axis], degree: usize, coordinates: &[Vec<f64>], replicates: usize) -> Option<Self> {
        let count = coordinates.len();
        let basis = Basis::try_new(axes, degree)?;
        let size = basis.terms.len();
        let per_replicate = count / replicates;
        let of_others = (count - per_replicate) as f64;
        if COMPARED_RUNS_PER_COEFFICIENT * size as f64 > of_others || size * count > MAX_ENTRIES {
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
        // The first column of a Gram matrix has the sums of the terms, since the first term is 1.
        let mean = |gram: &Vec<f64>| gram.chunks(size).map(|row| row[0] / per_replicate as f64).collect();
        let means: Vec<Vec<f64>> = grams.iter().map(mean).collect();
        let mut design =
            Self { basis, per_replicate, rows, without: without?, weights: Vec::new(), higher: Vec::new(), rest };
        design.weights = design.weights_of_runs(&means);
        Some(design)
    }

    /// Whether there are runs enough for the estimates of these polynomials not to hang on a few of them.
    fn is_for_use(&self) -> bool {
        let runs = self.weights.len() as f64;
        let has_runs = RUNS_PER_COEFFICIENT * self.basis.terms.len() as f64 <= runs - self.per_replicate as f64;
        has_runs && runs * self.weights.iter().map(|weight| weight * weight).sum::<f64>() <= MAX_INFLATION
    }

    /// w of every run; `means`: those of the terms over each replicate.
    fn weights_of_runs(&self, means: &[Vec<f64>]) -> Vec<f64> {
        let (replicates, runs) = (means.len() as f64, (means.len() * self.per_replicate) as f64);
        let gradients = means.iter().map(|means| {
            let mut gradient: Vec<f64> = means.iter().map(|mean| -mean / replicates).collect();
            gradient[0] += 1.0 / replicates;
            gradient
        });
        self.sensitivities(gradients).into_iter().map(|sensitivity| 1.0 / runs + sensitivity).collect()
    }

    /// Fits `values`, one for each inner point.
    pub fn fit(&self, values: &[f64]) -> CrossFit {
        let size = self.basis.terms.len();
        let centre = values.iter().sum::<f64>() / values.len() as f64;
        let block = size * self.per_replicate;
        let rights: Vec<Vec<f64>> = self.sums_with(values, centre).collect();
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

    /// Derivative of Σ_r g_r·c_r by the value of each run, c_r the coefficients that were fitted without replicate r: Σ_(r not of i)
    /// g_r·G_r⁻¹ φ_i, φ_i the terms at run i; `gradients`: g_r.
    pub fn sensitivities(&self, gradients: impl Iterator<Item = Vec<f64>>) -> Vec<f64> {
        let size = self.basis.terms.len();
        let solved: Vec<Vec<f64>> = gradients
            .zip(&self.without)
            .map(|(mut gradient, without)| {
                without.solve(&mut gradient);
                gradient
            })
            .collect();
        let sum: Vec<f64> = (0..size).map(|term| solved.iter().map(|own| own[term]).sum()).collect();
        let mut all = Vec::with_capacity(self.rows.len() / size);
        for (rows, own) in self.rows.chunks(size * self.per_replicate).zip(&solved) {
            let others: Vec<f64> = sum.iter().zip(own).map(|(sum, own)| sum - own).collect();
            all.extend(rows.chunks(size).map(|row| dot(row, &others)));
        }
        all
    }

    /// Weights w of all runs in the estimate of a mean.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The estimate of the mean of these values, Σ w y.
    pub fn mean(&self, values: &[f64]) -> f64 {
        // Of numbers that are all large little is left otherwise; the weights add up to 1.
        let centre = values[0];
        centre + self.weights.iter().zip(values).map(|(weight, value)| weight * (value - centre)).sum::<f64>()
    }

    /// The next degrees, two at most.
    pub fn higher(&self) -> &[Arc<Self>] {
        &self.higher
    }

    /// Sums over each replicate of the terms times how far `values`, one for each run, are above `centre`.
    pub fn sums_with<'s>(&'s self, values: &'s [f64], centre: f64) -> impl Iterator<Item = Vec<f64>> + 's {
        let size = self.basis.terms.len();
        self.rows.chunks(size * self.per_replicate).zip(values.chunks(self.per_replicate)).map(move |(rows, values)| {
            let mut sums = vec![0.0; size];
            with_vector_instructions(
                #[inline(always)]
                || {
                    for (row, value) in rows.chunks(size).zip(values) {
                        let value = value - centre;
                        for (entry, term) in sums.iter_mut().zip(row) {
                            *entry += term * value;
                        }
                    }
                },
            );
            sums
        })
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

#[cfg(test)]
mod tests {
    use super::InnerBasis;
    use crate::estimators::polynomials::orthogonal::Axis;
    use loosepin_uncertainty::{ScrambledSobol, hash, uniform};

    const REPLICATES: usize = 4;

    fn basis() -> InnerBasis {
        let sobol = ScrambledSobol::try_new(3, 2).unwrap();
        let points = (0..REPLICATES as u32).flat_map(|replicate| (0..32).map(move |index| (replicate, index)));
        let points = points.map(|(replicate, index)| {
            let mut point = vec![0.0; 2];
            sobol.write_point(replicate, index, &mut point);
            point
        });
        InnerBasis::new(&[Axis::Hermite, Axis::Legendre], &points.collect::<Vec<_>>(), REPLICATES).unwrap()
    }

    #[test]
    fn identity_the_weighted_sum_is_the_mean_that_the_replicates_see() {
        const ROUND_OFF: f64 = 1e-12;
        let values: Vec<f64> = (0..128).map(|run| 7.0 + uniform(hash(5, run), 0)).collect();
        for design in basis().designs() {
            let fit = design.fit(&values);
            let residuals = fit.residuals.chunks(design.per_replicate());
            let means = fit.coefficients.iter().zip(residuals);
            let means = means.map(|(c, left)| c[0] + left.iter().sum::<f64>() / left.len() as f64);
            let mean = means.sum::<f64>() / REPLICATES as f64;
            assert!((design.mean(&values) - mean).abs() < ROUND_OFF, "{} {mean}", design.mean(&values));
            assert!((design.weights().iter().sum::<f64>() - 1.0).abs() < ROUND_OFF);
        }
    }

    #[test]
    fn analytic_degrees_for_use_are_those_whose_estimates_hang_on_no_few_runs() {
        for design in basis().designs() {
            let inflation = 128.0 * design.weights().iter().map(|weight| weight * weight).sum::<f64>();
            // Weights that add up to 1 have a sum of squares of 1/N at least.
            assert!((1.0..=2.0).contains(&inflation), "degree {}: {inflation}", design.basis.degree);
        }
        // A line is followed by a quadratic and a cubic; these are compared with even where they are not for use.
        assert_eq!(basis().designs()[0].higher().iter().map(|higher| higher.basis.degree).collect::<Vec<_>>(), [2, 3]);
    }
}
