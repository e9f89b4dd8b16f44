//! Distribution of the unknowns over the box, from ln p(y | u) at the tested values.
//!
//! Within the cell of a tested value ln p(y | u) is a parabola along each unknown through the values beside it, so that a normal
//! likelihood is met exactly where values lie evenly.

use super::grid::{Axis, Grid, TestedCell, place};
use loosepin_math::{solve_square, sort_by_number};

/// Largest rise of a parabola above the values that it goes through, in ln p: that of a normal distribution whose values are 2 standard
/// deviations apart.
const MAX_RISE: f64 = 0.5;
/// Cells in which the distribution is summed: along an unknown at least, for each cell of the grid there at least, of all together at most.
const CELLS_ALONG: usize = 256;
const PARTS_OF_CELL: usize = 4;
const MAX_CELLS: usize = 1 << 18;

/// A tested value with its likelihood.
#[derive(Debug, Clone)]
pub(super) struct WeightedValue {
    pub cell: TestedCell,
    /// ln p(y | u); -∞ where no run ended.
    pub log_likelihood: f64,
    /// Runs that ended.
    pub ended: usize,
    /// Share of the runs that failed.
    pub failed: f64,
}

/// A distribution of the unknowns as shares of the box.
#[derive(Debug, Clone)]
pub(super) struct Distribution {
    /// Probabilities of equal cells, or of members, for each unknown.
    pub marginals: Vec<Vec<f64>>,
    /// Probability that each tested value stands for.
    pub weights: Vec<f64>,
}

impl Distribution {
    /// `None` if no tested value has a likelihood.
    pub fn new(grid: &Grid, values: &[WeightedValue]) -> Option<Self> {
        let pieces: Vec<Option<LocalQuadratic>> =
            values.iter().map(|value| LocalQuadratic::new(grid, values, value)).collect();
        let counts = fine_counts(&grid.axes, &grid.counts);
        let cells: usize = counts.iter().product();
        let mut marginals: Vec<Vec<f64>> = counts.iter().map(|count| vec![0.0; *count]).collect();
        let mut weights = vec![0.0; values.len()];
        // Of each cell the tested value that it belongs to, and its likelihood.
        let weighed = |cell: usize| {
            let at = place(&counts, cell);
            let test = grid.tests[grid.index_of(&at, &counts)];
            let Some(piece) = &pieces[test] else { return (test, f64::NEG_INFINITY) };
            let middle: Vec<f64> = at
                .iter()
                .zip(&counts)
                .zip(&grid.axes)
                .map(|((at, count), axis)| match axis {
                    Axis::Continuous => (*at as f64 + 0.5) / *count as f64,
                    Axis::Members(_) => *at as f64,
                })
                .collect();
            (test, piece.log_likelihood(&values[test], &middle))
        };
        let logs: Vec<(usize, f64)> = (0..cells).map(weighed).collect();
        // Of the cells alone: a value all of whose cells others have taken over may be far more probable than any that is left.
        let most = logs.iter().map(|(_, log)| *log).fold(f64::NEG_INFINITY, f64::max);
        if most == f64::NEG_INFINITY {
            return None;
        }
        for (cell, (test, log)) in logs.iter().enumerate() {
            let weight = (log - most).exp();
            weights[*test] += weight;
            for (marginal, at) in marginals.iter_mut().zip(place(&counts, cell)) {
                marginal[at] += weight;
            }
        }
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= sum);
        marginals.iter_mut().flatten().for_each(|weight| *weight /= sum);
        Some(Self { marginals, weights })
    }

    /// Equally probable values that would carry as much as the tested ones do.
    pub fn effective_values(&self) -> f64 {
        1.0 / self.weights.iter().map(|weight| weight * weight).sum::<f64>()
    }

    /// Equally probable values along an unknown that would carry as much as the tested ones do.
    pub fn effective_along(&self, unknown: usize, values: &[WeightedValue]) -> f64 {
        let slices = self.slices(unknown, values);
        let weight = |slice: &Vec<usize>| slice.iter().map(|value| self.weights[*value]).sum::<f64>();
        1.0 / slices.iter().map(|slice| weight(slice).powi(2)).sum::<f64>()
    }

    /// Tested values with the same place along an unknown, in the order of their places.
    pub fn slices(&self, unknown: usize, values: &[WeightedValue]) -> Vec<Vec<usize>> {
        let at = |value: usize| values[value].cell.at[unknown];
        let mut order: Vec<usize> = (0..values.len()).collect();
        sort_by_number(&mut order, |&value| at(value));
        order.chunk_by(|a, b| at(*a) == at(*b)).map(<[usize]>::to_vec).collect()
    }
}

/// Cells along each unknown in which the distribution is summed: those of the grid, halved.
fn fine_counts(axes: &[Axis], grid: &[usize]) -> Vec<usize> {
    let mut counts = grid.to_vec();
    loop {
        let is_coarse = |unknown: &usize| {
            axes[*unknown] == Axis::Continuous && counts[*unknown] < CELLS_ALONG.max(PARTS_OF_CELL * grid[*unknown])
        };
        let coarsest = (0..axes.len()).filter(is_coarse).min_by_key(|unknown| counts[*unknown]);
        let Some(coarsest) = coarsest.filter(|_| 2 * counts.iter().product::<usize>() <= MAX_CELLS) else {
            return counts;
        };
        counts[coarsest] *= 2;
    }
}

/// ln p(y | u) about a tested value: slope and half the curvature along each unknown.
struct LocalQuadratic {
    slopes: Vec<f64>,
    curvatures: Vec<f64>,
    /// Largest value that it may take.
    most: f64,
}

impl LocalQuadratic {
    /// `None` if the likelihood is below the smallest number.
    fn new(grid: &Grid, values: &[WeightedValue], value: &WeightedValue) -> Option<Self> {
        if value.log_likelihood == f64::NEG_INFINITY {
            return None;
        }
        let unknowns = grid.axes.len();
        // Tested values on either side along each unknown.
        let beside = |unknown: usize, side: f64| -> Option<&WeightedValue> {
            let mut at = value.cell.at.clone();
            at[unknown] += side * value.cell.widths[unknown];
            let is_inside = (0.0..1.0).contains(&at[unknown]);
            let other = &values[grid.tests[grid.cell_at(&at).filter(|_| is_inside)?]];
            let is_known = other.log_likelihood > f64::NEG_INFINITY && other.cell.at[unknown] != value.cell.at[unknown];
            is_known.then_some(other)
        };
        let mut rows: Vec<(&WeightedValue, usize)> = Vec::new();
        let mut is_curved = vec![false; unknowns];
        for unknown in (0..unknowns).filter(|unknown| grid.axes[*unknown] == Axis::Continuous) {
            // At an end of the box, and beside values without a likelihood, both lie on the other side.
            let mut both: Vec<&WeightedValue> =
                [-1.0, 1.0].into_iter().filter_map(|side| beside(unknown, side)).collect();
            let further = [-2.0, 2.0].into_iter().filter_map(|side| beside(unknown, side));
            for other in further {
                let is_new = both.iter().all(|known| known.cell.at[unknown] != other.cell.at[unknown]);
                if both.len() == 1 && is_new {
                    both.push(other);
                }
            }
            is_curved[unknown] = both.len() == 2;
            rows.extend(both.into_iter().map(|other| (other, unknown)));
        }
        // One equation for each of them: slopes of all unknowns on whose sides a value is known, curvatures where both are.
        let mut sloped: Vec<usize> = rows.iter().map(|(_, unknown)| *unknown).collect();
        sloped.dedup();
        let curved: Vec<usize> = (0..unknowns).filter(|unknown| is_curved[*unknown]).collect();
        let size = rows.len();
        let mut matrix = Vec::with_capacity(size * size);
        let mut right = Vec::with_capacity(size);
        for (other, _) in &rows {
            let off = |unknown: &usize| other.cell.at[*unknown] - value.cell.at[*unknown];
            matrix.extend(sloped.iter().map(off));
            matrix.extend(curved.iter().map(|unknown| off(unknown).powi(2)));
            right.push(other.log_likelihood - value.log_likelihood);
        }
        let mut piece = Self {
            slopes: vec![0.0; unknowns],
            curvatures: vec![0.0; unknowns],
            most: value.log_likelihood + MAX_RISE,
        };
        if size > 0 && solve_square(&mut matrix, size, &mut right) > f64::EPSILON {
            for (unknown, slope) in sloped.iter().zip(&right) {
                piece.slopes[*unknown] = *slope;
            }
            for (unknown, curvature) in curved.iter().zip(&right[sloped.len()..]) {
                piece.curvatures[*unknown] = *curvature;
            }
        }
        let highest = rows.iter().map(|(other, _)| other.log_likelihood).fold(value.log_likelihood, f64::max);
        piece.most = highest + MAX_RISE;
        Some(piece)
    }

    fn log_likelihood(&self, value: &WeightedValue, at: &[f64]) -> f64 {
        let mut log = value.log_likelihood;
        for (unknown, at) in at.iter().enumerate() {
            let off = at - value.cell.at[unknown];
            log += off * (self.slopes[unknown] + off * self.curvatures[unknown]);
        }
        log.min(self.most)
    }
}

/// Level of a distribution in equal cells, as a share of its axis.
pub(super) fn quantile(cells: &[f64], probability: f64) -> f64 {
    let mut below = 0.0;
    for (cell, share) in cells.iter().enumerate() {
        if *share > 0.0 && below + share >= probability {
            return (cell as f64 + ((probability - below) / share).clamp(0.0, 1.0)) / cells.len() as f64;
        }
        below += share;
    }
    1.0
}

/// Mean and standard deviation of a distribution in equal cells, as shares of its axis.
pub(super) fn moments(cells: &[f64]) -> [f64; 2] {
    let width = 1.0 / cells.len() as f64;
    let middle = |cell: usize| (cell as f64 + 0.5) * width;
    let mean: f64 = cells.iter().enumerate().map(|(cell, share)| share * middle(cell)).sum();
    let square: f64 = cells.iter().enumerate().map(|(cell, share)| share * (middle(cell) - mean).powi(2)).sum();
    [mean, (square + width * width / 12.0).sqrt()]
}
