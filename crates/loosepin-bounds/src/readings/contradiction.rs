//! Polynomials that no run of the study contradicts: those of the mixture and of the extremes are read against them.

use super::setup::Setup;
use crate::data::points::mixture_points;
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::estimators::polynomials::orthogonal::Axis;
use crate::estimators::polynomials::single_runs::{SingleRun, SingleRuns, Weights};
use crate::estimators::pool::Pool;
use crate::search::search_box::BoxPoint;
use loosepin_math::dense::{Cholesky, dot, gram};
use loosepin_math::sort_by_number;

/// So many runs of the mixture are read, at most.
const MAX_MIXTURE_RUNS: usize = 1024;
/// A quantity at some u follows from the nearest outer points, so many for each of its coefficients if it is linear.
const POINTS_PER_COEFFICIENT: usize = 2;
/// Further out than this many standard deviations polynomials of what has a kink anywhere say little.
const FURTHEST: f64 = 3.0 + 1e-6;
/// Weights that carry what is linear worse than this are not for use.
const MAX_WEIGHT_ERROR: f64 = 1e-9;

impl Setup {
    /// `pool`, the double loop of `table`, with polynomials where the response is smooth in the random inputs and no single run contradicts them. Rounds
    /// that search do without: where polynomials lead them is as good a place as any.
    pub fn with_polynomials(&self, pool: Pool, table: &SampleTable) -> Pool {
        let pool = pool.with_polynomials(self.inner_basis());
        if !(self.has_mixture() || self.has_extremes()) || !pool.has_polynomials() {
            return pool;
        }
        let runs = self.single_runs(&pool, table);
        pool.without_contradicted(&runs, table)
    }

    fn single_runs(&self, pool: &Pool, table: &SampleTable) -> SingleRuns {
        let places = self.outer_places(pool);
        let axes = self.epistemic_box.axes();
        let seen: Vec<Vec<f64>> = places.iter().map(|place| axes.embed(&place.at)).collect();
        let mixture: Vec<Vec<f64>> = if self.has_mixture() {
            let points = mixture_points(&self.problem.sampling, &self.mixture).take(MAX_MIXTURE_RUNS);
            points.map(|(_, _, point)| point).collect()
        } else {
            Vec::new()
        };
        let each = self.problem.sampling.mixture / self.problem.sampling.replicates;
        let coordinates = |inputs: &RunInputs| match inputs.purpose {
            Purpose::Mixture => {
                let point = mixture.get(inputs.replicate as usize * each + inputs.index as usize)?;
                Some(point.iter().zip(self.random_axes()).map(|(&omega, axis)| axis.coordinate(omega)).collect())
            }
            Purpose::Extreme => self.coordinates_of_values(inputs),
            _ => None,
        };
        let single = |(row, inputs): (usize, &RunInputs)| {
            let coordinates: Vec<f64> = coordinates(inputs)?;
            if !coordinates.iter().all(|t| t.abs() <= FURTHEST) {
                return None;
            }
            let place = self.epistemic_box.place_of(&inputs.epistemic);
            let weights = weights(&places, &seen, &place, &axes.embed(&place.at), None)?;
            Some(SingleRun { row, coordinates, weights })
        };
        let left_out =
            |point: usize| Some((point, weights(&places, &seen, &places[point], &seen[point], Some(point))?));
        SingleRuns {
            runs: table.inputs().iter().enumerate().filter_map(single).collect(),
            left_out: (0..places.len()).filter_map(left_out).collect(),
        }
    }

    /// Coordinates of the random inputs of a run by their values; `None` if they depend on each other.
    fn coordinates_of_values(&self, inputs: &RunInputs) -> Option<Vec<f64>> {
        if self.problem.copula.is_some() {
            return None;
        }
        let of_input = |(input, axis): (usize, Axis)| {
            let (variable, x) = (self.problem.variable_at(input, &inputs.epistemic)?, inputs.random[input]);
            Some(match axis {
                Axis::Legendre => axis.coordinate(variable.cdf(x)),
                Axis::Hermite => variable.standard_normal_at(x),
            })
        };
        self.random_axes().enumerate().map(of_input).collect()
    }
}

/// Weights of the nearest of `places` but `left_out`, by which what is linear in the coordinates `seen` comes out at `at`, and all else as by
/// least squares; `None` if they lie in too few directions.
fn weights(
    places: &[BoxPoint],
    seen: &[Vec<f64>],
    place: &BoxPoint,
    at: &[f64],
    left_out: Option<usize>,
) -> Option<Weights> {
    let square = |point: usize| -> f64 { seen[point].iter().zip(at).map(|(x, y)| (x - y) * (x - y)).sum() };
    let is_own = |&point: &usize| places[point].combination == place.combination && Some(point) != left_out;
    let mut nearest: Vec<usize> = (0..places.len()).filter(is_own).collect();
    sort_by_number(&mut nearest, |&point| square(point));
    let order = at.len() + 1;
    nearest.truncate(POINTS_PER_COEFFICIENT * order);
    if nearest.len() < order {
        return None;
    }
    let row = |&point: &usize| std::iter::once(1.0).chain(seen[point].iter().zip(at).map(|(x, y)| x - y));
    let rows: Vec<f64> = nearest.iter().flat_map(row).collect();
    let mut first = vec![0.0; order];
    first[0] = 1.0;
    Cholesky::new(gram(&rows, order), order)?.solve(&mut first);
    let of_rows = nearest.iter().zip(rows.chunks(order));
    let found: Weights = of_rows.map(|(&point, row)| (point, dot(row, &first))).collect();
    let moment =
        |k: usize| -> f64 { found.iter().zip(rows.chunks(order)).map(|((_, weight), row)| weight * row[k]).sum() };
    let is_exact = (0..order).all(|k| (moment(k) - if k == 0 { 1.0 } else { 0.0 }).abs() < MAX_WEIGHT_ERROR);
    is_exact.then_some(found)
}

#[cfg(test)]
mod tests {
    use super::weights;
    use crate::search::search_box::BoxPoint;

    #[test]
    fn analytic_what_is_linear_is_carried_to_any_place() {
        let at = |x: f64, y: f64| BoxPoint { combination: 0, at: vec![x, y] };
        let places = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(1.0, 1.0), at(0.3, 0.6), at(0.8, 0.2)];
        let seen: Vec<Vec<f64>> = places.iter().map(|place| place.at.clone()).collect();
        let linear = |at: &[f64]| 3.0 - 2.0 * at[0] + 0.5 * at[1];
        let place = at(0.45, 0.9);
        let found = weights(&places, &seen, &place, &place.at, None).unwrap();
        let sum: f64 = found.iter().map(|&(point, weight)| weight * linear(&seen[point])).sum();
        assert!((sum - linear(&place.at)).abs() < 1e-12, "{sum}");
        let left_out = weights(&places, &seen, &places[2], &seen[2], Some(2)).unwrap();
        assert!(left_out.iter().all(|&(point, _)| point != 2));
        // Points on one line tell nothing beside it.
        assert!(weights(&places[..2], &seen[..2], &place, &place.at, None).is_none());
        let other = BoxPoint { combination: 1, at: vec![0.5, 0.5] };
        assert!(weights(&places, &seen, &other, &other.at, None).is_none());
    }
}
