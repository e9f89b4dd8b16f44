//! Single runs, made for something else than a sample, against what the polynomials of samples let expect of them.
//!
//! ```text
//! y contradicts where |y - Σ w_k p_k(t)| > 4 E(t) + ε √K(t) + round-off,   K(t) = Σ_|j| <= d + 4 p_j(t)²
//! ```
//!
//! with p_k the polynomial of degree d at outer point k, t the random inputs of the run, and weights w that carry what is linear in u from the
//! outer points to the u of the run. E(t) is the largest error of the same rule where it says p_k(t) at every outer point k from the others:
//! what lies between outer points is no further off. ε is the largest residual of any of the polynomials. A remainder whose mean square is ε² and
//! whose terms are of degree d + 4 at most is nowhere larger than ε √K(t) (Cauchy and Schwarz).
//!
//! Polynomials that are contradicted by more than 1 % of the standard deviation are not used. Else what they leave at single runs is a residual
//! like those of the sample. Either way the rare event enters the errors of mean and variance ([`super::super::unsampled_events`]).

use std::sync::Arc;

use super::inner_basis::DesignMatrix;
use super::orthogonal::Axis;
use super::smooth::{ROUND_OFF, largest_magnitude};
use crate::data::table::SampleTable;
use crate::estimators::sample::Sample;
use crate::estimators::unsampled_events::UnsampledEvents;
use crate::parallel;
use loosepin_math::dense::dot;

/// Errors between the outer points are this many times those at the outer points, at most.
const BETWEEN_POINTS: f64 = 4.0;
/// Degrees of the remainder of a polynomial beyond its own.
const DEGREES_BEYOND: usize = 4;
/// Polynomials that single runs contradict by no more than this share of the largest standard deviation are for use.
const SMALL: f64 = 1e-2;
/// Weights carry what is linear in u to this share of its range.
const WEIGHT_ROUND_OFF: f64 = 1e-6;

/// Weights of outer points that give a quantity at some u: point and weight.
pub(crate) type Weights = Vec<(usize, f64)>;

/// One run.
#[derive(Debug)]
pub(crate) struct SingleRun {
    /// Row in the table.
    pub row: usize,
    /// Coordinates t of its random inputs.
    pub coordinates: Vec<f64>,
    /// Weights of the outer points that predict the value at its u.
    pub weights: Weights,
}

/// All runs that say something.
#[derive(Debug)]
pub(crate) struct SingleRuns {
    pub runs: Vec<SingleRun>,
    /// Outer points that follow from others, each with the weights of these.
    pub left_out: Vec<(usize, Weights)>,
}

/// Events that single runs show and the samples of a column do not.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contradiction {
    pub unseen: UnsampledEvents,
    /// Whether the polynomials are good enough nevertheless: they leave this too.
    pub is_small: bool,
}

/// Polynomials of one design at all single runs, which many columns share.
struct AtRuns {
    design: Arc<DesignMatrix>,
    /// Values of the terms, run by run.
    terms: Vec<f64>,
    /// √K of every run.
    remainders: Vec<f64>,
}

impl SingleRuns {
    /// For each of `columns`, its column in `table` and its samples at all outer points: how far single runs lie from what its polynomials let
    /// expect, where one contradicts them; `None` if none does, or there are no polynomials.
    pub fn against(&self, columns: &[(usize, Vec<&Sample>)], table: &SampleTable) -> Vec<Option<Contradiction>> {
        let mut designs: Vec<AtRuns> = Vec::new();
        for design in columns.iter().filter_map(|(_, samples)| Some(samples.first()?.smooth()?.design())) {
            if !designs.iter().any(|known| Arc::ptr_eq(&known.design, design)) {
                designs.push(AtRuns::new(design, &self.runs));
            }
        }
        let of_column = |(column, samples): &(usize, Vec<&Sample>)| {
            let design = samples.first()?.smooth()?.design();
            let at = designs.iter().find(|known| Arc::ptr_eq(&known.design, design))?;
            let unseen = self.of_column(at, samples, |row| table.values(row)[*column])?;
            let deviation = samples.iter().map(|sample| sample.sums().deviation()).fold(0.0, f64::max);
            Some(Contradiction { unseen, is_small: unseen.largest() <= SMALL * deviation })
        };
        parallel::map(columns, of_column).into_iter().collect()
    }

    fn of_column(&self, at: &AtRuns, samples: &[&Sample], value: impl Fn(usize) -> f64) -> Option<UnsampledEvents> {
        let smooth: Vec<_> = samples.iter().map(|sample| sample.smooth()).collect::<Option<_>>()?;
        let coefficients: Vec<Vec<f64>> = smooth.iter().map(|smooth| smooth.coefficients()).collect();
        let residual = smooth.iter().map(|smooth| smooth.largest_residual()).fold(0.0, f64::max);
        let magnitude = samples.iter().fold(0.0_f64, |most, sample| most.max(largest_magnitude(sample.values())));
        let residual = residual + ROUND_OFF * magnitude;
        let size = at.design.basis.terms.len();
        let mut unseen: Option<UnsampledEvents> = None;
        for (place, run) in self.runs.iter().enumerate() {
            let y = value(run.row);
            if !y.is_finite() {
                continue;
            }
            let terms = &at.terms[place * size..(place + 1) * size];
            let expected: Vec<f64> = coefficients.iter().map(|own| dot(own, terms)).collect();
            let (low, high) = expected
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)));
            let jump = y - weighted(&run.weights, &expected);
            let least = residual * at.remainders[place] + WEIGHT_ROUND_OFF * (high - low);
            if jump.abs() <= least {
                continue;
            }
            let error = |(point, weights): &(usize, Weights)| (expected[*point] - weighted(weights, &expected)).abs();
            if jump.abs() > BETWEEN_POINTS * self.left_out.iter().map(error).fold(0.0, f64::max) + least {
                let known = unseen.unwrap_or(UnsampledEvents { below: 0.0, above: 0.0 });
                unseen = Some(UnsampledEvents { below: known.below.max(-jump), above: known.above.max(jump) });
            }
        }
        unseen
    }
}

impl AtRuns {
    fn new(design: &Arc<DesignMatrix>, runs: &[SingleRun]) -> Self {
        let basis = &design.basis;
        let terms = runs.iter().flat_map(|run| basis.values(&run.coordinates)).collect();
        let remainder = |run: &SingleRun| kernel(&basis.axes, &run.coordinates, basis.degree + DEGREES_BEYOND).sqrt();
        Self { design: design.clone(), terms, remainders: runs.iter().map(remainder).collect() }
    }
}

fn weighted(weights: &Weights, values: &[f64]) -> f64 {
    weights.iter().map(|&(point, weight)| weight * values[point]).sum()
}

/// K: the sum of the squares of all terms up to `degree`, axis by axis.
fn kernel(axes: &[Axis], coordinates: &[f64], degree: usize) -> f64 {
    let mut of_degrees = vec![0.0; degree + 1];
    of_degrees[0] = 1.0;
    for (axis, &t) in axes.iter().zip(coordinates) {
        let squares: Vec<f64> = axis.values(t, degree).into_iter().map(|value| value * value).collect();
        of_degrees = (0..=degree).map(|sum| (0..=sum).map(|own| squares[own] * of_degrees[sum - own]).sum()).collect();
    }
    of_degrees.iter().sum()
}

#[cfg(test)]
mod tests {
    use super::kernel;
    use crate::estimators::polynomials::basis::Basis;
    use crate::estimators::polynomials::orthogonal::Axis;

    #[test]
    fn identity_the_kernel_is_the_sum_of_the_squares_of_all_terms() {
        let (axes, point) = ([Axis::Hermite, Axis::Legendre, Axis::Hermite], [2.7, -0.3, -1.1]);
        let basis = Basis::try_new(&axes, 5).unwrap();
        let sum: f64 = basis.values(&point).map(|value| value * value).sum();
        assert!((kernel(&axes, &point, 5) / sum - 1.0).abs() < 1e-12);
    }
}
