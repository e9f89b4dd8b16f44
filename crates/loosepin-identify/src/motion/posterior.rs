//! Posterior distribution of the unknowns from the likelihood at the tested values: prior uniform over the box, each member of a list as
//! probable as any other.
//!
//! Within the cell of a tested value ln p(y | u) is a parabola along each unknown through the values beside it, so that a normal
//! likelihood is met exactly where values lie evenly.

use super::bank::Runs;
use super::grid::{Axis, Grid, place};
use super::likelihood::{RUNS_A_FEATURE, log_likelihood};
use super::scatter::Observation;
use super::unknowns::value;
use loosepin_math::solve_square;
use loosepin_result::motion_identification::{Marginal, MarginalSummary, Posterior, PosteriorRefusal};
use loosepin_study::Study;

/// Equally probable values along an unknown, at least: of a normal distribution there are 3.5 for values one standard deviation apart. Of
/// skewed distributions quantiles were off by 0.04 standard deviations with 4 to 5, by up to 0.14 with 3 to 4, by up to 0.8 with fewer.
const LEAST_VALUES: f64 = 4.0;
/// Share of failed runs among those that carry the weight, at most.
const MOST_FAILED: f64 = 0.05;
/// A parabola may rise above the values that it goes through by so much of ln p: that of a normal distribution whose values are 2 standard
/// deviations apart.
const MOST_RISE: f64 = 0.5;
/// Cells in which the distribution is summed: along an unknown at least, of all together at most.
const CELLS_ALONG: usize = 256;
const MOST_CELLS: usize = 1 << 18;

/// The cell whose middle was tested.
#[derive(Debug, Clone)]
pub(crate) struct TestedCell {
    /// Its middle, as shares of the box; of a member its place.
    pub at: Vec<f64>,
    /// Its width along each unknown, as a share of the box.
    pub widths: Vec<f64>,
}

/// A tested value with its likelihood.
#[derive(Debug, Clone)]
struct Weighed<'c> {
    cell: &'c TestedCell,
    /// ln p(y | u); -∞ where no run ended.
    log_likelihood: f64,
    /// Share of the runs that failed.
    failed: f64,
}

/// The posterior distribution by the runs at the tested values, in the order in which they were tested, with credible intervals of
/// probability 1 - `alpha`.
pub(crate) fn posterior(
    study: &Study,
    seen: &Observation,
    grid: &Grid,
    cells: &[TestedCell],
    runs: &[Runs],
    alpha: f64,
) -> Result<Posterior, PosteriorRefusal> {
    let (count, least) = (runs.first().map_or(0, |runs| runs.len()), RUNS_A_FEATURE * seen.values_si.len());
    if grid.consistent().next().is_none() {
        return Err(PosteriorRefusal::Misfit);
    }
    if count <= 1 {
        return Err(PosteriorRefusal::NothingScatters);
    }
    let has_failed = |run: &&Vec<f64>| run.iter().any(|value| !value.is_finite());
    // The set keeps a value whose runs failed. Runs that did not end say nothing of how probable it is.
    let ended = |test: usize| runs[test].iter().filter(|run| !has_failed(run)).count();
    let fewest = grid.consistent().map(|cell| ended(grid.tests[cell])).min();
    if let Some(runs) = fewest.filter(|ended| *ended < least) {
        return Err(PosteriorRefusal::FewRuns { runs, least });
    }
    let weighed = |(cell, runs)| {
        let runs: &Runs = runs;
        Weighed {
            cell,
            log_likelihood: log_likelihood(runs, seen).unwrap_or(f64::NEG_INFINITY),
            failed: runs.iter().filter(has_failed).count() as f64 / runs.len() as f64,
        }
    };
    let values: Vec<Weighed<'_>> = cells.iter().zip(runs).map(weighed).collect();
    let Distribution { marginals, effective_values } = Distribution::new(grid, &values)?;
    let tail = 0.5 * alpha;
    let marginal = |(k, shares): (usize, Vec<f64>)| {
        let input = &study.epistemic[k];
        let [lower, upper] = input.variable.ends();
        let summary = (grid.axes[k] == Axis::Continuous).then(|| {
            let [mean, deviation] = moments(&shares);
            MarginalSummary {
                mean_si: value(input, mean),
                standard_deviation_si: deviation * (upper - lower),
                credible_si: [tail, 1.0 - tail].map(|level| value(input, quantile(&shares, level))),
            }
        });
        Marginal { shares, summary }
    };
    Ok(Posterior {
        probability: 1.0 - alpha,
        effective_values,
        effective_runs: effective_values * count as f64,
        marginals: marginals.into_iter().enumerate().map(marginal).collect(),
    })
}

/// A posterior distribution as shares of the box.
#[derive(Debug, Clone)]
struct Distribution {
    /// Of each unknown the probabilities of equal cells, or of members.
    marginals: Vec<Vec<f64>>,
    /// Equally probable values that would carry as much.
    effective_values: f64,
}

impl Distribution {
    /// # Errors
    /// Too few values carry the weight, or too many of their runs failed.
    fn new(grid: &Grid, values: &[Weighed<'_>]) -> Result<Self, PosteriorRefusal> {
        let most = values.iter().map(|value| value.log_likelihood).fold(f64::NEG_INFINITY, f64::max);
        if most == f64::NEG_INFINITY {
            return Err(PosteriorRefusal::Failed { share: 1.0, most: MOST_FAILED });
        }
        let pieces: Vec<Option<Piece>> = values.iter().map(|value| Piece::new(grid, values, value)).collect();
        let counts = fine_counts(&grid.axes, &grid.counts);
        let cells: usize = counts.iter().product();
        let mut marginals: Vec<Vec<f64>> = counts.iter().map(|count| vec![0.0; *count]).collect();
        let mut weights = vec![0.0; values.len()];
        for cell in 0..cells {
            let at = place(&counts, cell);
            let test = grid.tests[grid.index_of(&at, &counts)];
            let Some(piece) = &pieces[test] else { continue };
            let middle: Vec<f64> = at
                .iter()
                .zip(&counts)
                .zip(&grid.axes)
                .map(|((at, count), axis)| match axis {
                    Axis::Continuous => (*at as f64 + 0.5) / *count as f64,
                    Axis::Members(_) => *at as f64,
                })
                .collect();
            let weight = (piece.log_likelihood(&values[test], &middle) - most).exp();
            weights[test] += weight;
            for (marginal, at) in marginals.iter_mut().zip(&at) {
                marginal[*at] += weight;
            }
        }
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= sum);
        marginals.iter_mut().flatten().for_each(|weight| *weight /= sum);
        let failed: f64 = weights.iter().zip(values).map(|(weight, value)| weight * value.failed).sum();
        if failed > MOST_FAILED {
            return Err(PosteriorRefusal::Failed { share: failed, most: MOST_FAILED });
        }
        for (unknown, axis) in grid.axes.iter().enumerate() {
            let effective = effective_along(unknown, &weights, values);
            if *axis == Axis::Continuous && effective < LEAST_VALUES {
                return Err(PosteriorRefusal::FewValues { unknown, effective, least: LEAST_VALUES });
            }
        }
        let effective_values = 1.0 / weights.iter().map(|weight| weight * weight).sum::<f64>();
        Ok(Self { marginals, effective_values })
    }
}

/// Equally probable values along an unknown that would carry as much as the tested ones do.
fn effective_along(unknown: usize, weights: &[f64], values: &[Weighed<'_>]) -> f64 {
    let mut along: Vec<(f64, f64)> =
        values.iter().zip(weights).map(|(value, weight)| (value.cell.at[unknown], *weight)).collect();
    along.sort_by(|a, b| a.0.total_cmp(&b.0));
    let squares: f64 = along
        .chunk_by(|a, b| a.0 == b.0)
        .map(|alike| alike.iter().map(|(_, weight)| weight).sum::<f64>().powi(2))
        .sum();
    1.0 / squares
}

/// Cells along each unknown in which the distribution is summed: those of the grid, halved.
fn fine_counts(axes: &[Axis], counts: &[usize]) -> Vec<usize> {
    let mut counts = counts.to_vec();
    let is_continuous = |unknown: &usize| axes[*unknown] == Axis::Continuous;
    while let Some(coarsest) = (0..axes.len()).filter(is_continuous).min_by_key(|unknown| counts[*unknown]) {
        if counts[coarsest] >= CELLS_ALONG || 2 * counts.iter().product::<usize>() > MOST_CELLS {
            break;
        }
        counts[coarsest] *= 2;
    }
    counts
}

/// ln p(y | u) about a tested value: slope and half the curvature along each unknown.
struct Piece {
    slopes: Vec<f64>,
    curvatures: Vec<f64>,
    /// Largest value that it may take.
    most: f64,
}

impl Piece {
    /// Nothing where the likelihood is below the smallest number.
    fn new(grid: &Grid, values: &[Weighed<'_>], value: &Weighed<'_>) -> Option<Self> {
        if value.log_likelihood == f64::NEG_INFINITY {
            return None;
        }
        let unknowns = grid.axes.len();
        // Tested values on either side along each unknown.
        let beside = |unknown: usize, side: f64| -> Option<&Weighed<'_>> {
            let mut at = value.cell.at.clone();
            at[unknown] += side * value.cell.widths[unknown];
            let is_inside = (0.0..1.0).contains(&at[unknown]);
            let other = &values[grid.tests[grid.cell_at(&at).filter(|_| is_inside)?]];
            let is_known = other.log_likelihood > f64::NEG_INFINITY && other.cell.at[unknown] != value.cell.at[unknown];
            is_known.then_some(other)
        };
        let mut rows: Vec<(&Weighed<'_>, usize)> = Vec::new();
        let mut is_curved = vec![false; unknowns];
        for unknown in (0..unknowns).filter(|unknown| grid.axes[*unknown] == Axis::Continuous) {
            // At an end of the box, and beside values without a likelihood, both lie on the other side.
            let mut both: Vec<&Weighed<'_>> =
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
            most: value.log_likelihood + MOST_RISE,
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
        piece.most = highest + MOST_RISE;
        Some(piece)
    }

    fn log_likelihood(&self, value: &Weighed<'_>, at: &[f64]) -> f64 {
        let mut log = value.log_likelihood;
        for (unknown, at) in at.iter().enumerate() {
            let off = at - value.cell.at[unknown];
            log += off * (self.slopes[unknown] + off * self.curvatures[unknown]);
        }
        log.min(self.most)
    }
}

/// Level of a distribution in equal cells, as a share of its axis.
fn quantile(cells: &[f64], probability: f64) -> f64 {
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
fn moments(cells: &[f64]) -> [f64; 2] {
    let width = 1.0 / cells.len() as f64;
    let middle = |cell: usize| (cell as f64 + 0.5) * width;
    let mean: f64 = cells.iter().enumerate().map(|(cell, share)| share * middle(cell)).sum();
    let square: f64 = cells.iter().enumerate().map(|(cell, share)| share * (middle(cell) - mean).powi(2)).sum();
    [mean, (square + width * width / 12.0).sqrt()]
}

#[cfg(test)]
mod tests {
    use super::{Distribution, TestedCell, Weighed, moments, quantile};
    use crate::motion::grid::{Axis, Grid};
    use crate::motion::joint_test::Verdict;
    use loosepin_result::motion_identification::PosteriorRefusal;
    use loosepin_uncertainty::{normal_cdf, normal_quantile};
    use std::convert::Infallible;

    /// Refines as an identification does where the set is that of the log-likelihoods above `least`, and gives the distribution.
    fn distribution(axes: &[Axis], least: f64, of: impl Fn(&[f64]) -> f64) -> Result<Distribution, PosteriorRefusal> {
        let mut tested: Vec<(TestedCell, f64)> = Vec::new();
        let (grid, _) = Grid::refined(axes, 100_000, true, &mut |grid: &mut Grid, waiting: &[usize]| {
            for cell in waiting {
                let at = grid.middle(*cell);
                let log = of(&at);
                let distance = (log / least).sqrt();
                grid.settle(*cell, Verdict { is_consistent: distance <= 1.0, distance });
                tested.push((TestedCell { at, widths: grid.widths() }, log));
            }
            Ok::<(), Infallible>(())
        })
        .unwrap_or_else(|never| match never {});
        let weighed = |(cell, log): &(TestedCell, f64)| (cell.clone(), *log);
        let all: Vec<(TestedCell, f64)> = tested.iter().map(weighed).collect();
        let values: Vec<Weighed<'_>> =
            all.iter().map(|(cell, log)| Weighed { cell, log_likelihood: *log, failed: 0.0 }).collect();
        Distribution::new(&grid, &values)
    }

    #[test]
    fn analytic_a_normal_likelihood_gives_a_normal_distribution_cut_to_the_box() {
        for (mean, deviation) in [(0.47, 0.06), (0.31, 0.13), (0.02, 0.09), (0.6, 0.4)] {
            // Kept within 2.6 standard deviations.
            let log = |at: &[f64]| -0.5 * ((at[0] - mean) / deviation).powi(2);
            let found =
                distribution(&[Axis::Continuous], -0.5 * 2.6 * 2.6, log).unwrap_or_else(|why| panic!("{why:?}"));
            let [low, high] = [0.0, 1.0].map(|end| normal_cdf((end - mean) / deviation));
            for level in [0.005, 0.1, 0.5, 0.9, 0.995] {
                let expected = mean + deviation * normal_quantile(low + level * (high - low));
                let found = quantile(&found.marginals[0], level);
                // A cell of the sum is 1/256 of the box; within it the distribution is even.
                assert!((found - expected).abs() < 2e-3, "{mean} {deviation} {level}: {found} {expected}");
            }
        }
    }

    #[test]
    fn peer_skewed_likelihoods_of_any_width_as_by_a_sum_over_a_fine_lattice() {
        // ln p of a Gumbel distribution, whose slopes on both sides differ: e^(-z - e^-z) about its mode. Wide ones and narrow ones, as far
        // as their cells carry them; modes anywhere, also at the ends of the box.
        let (mut given, mut largest) = (0, 0.0_f64);
        for trial in 0..200 {
            let mode = 0.05 + 0.9 * f64::from(trial % 20) / 19.0;
            let scale = 0.02 * 1.3_f64.powi(trial / 20);
            let log = |at: &[f64]| {
                let z = (at[0] - mode) / scale;
                1.0 - z - (-z).exp()
            };
            let found = match distribution(&[Axis::Continuous], -3.4, log) {
                Ok(found) => found,
                Err(PosteriorRefusal::FewValues { .. }) => continue,
                Err(other) => panic!("{other:?}"),
            };
            given += 1;
            let count = 20_000;
            let mut exact: Vec<f64> = (0..count).map(|k| log(&[(k as f64 + 0.5) / f64::from(count)]).exp()).collect();
            let sum: f64 = exact.iter().sum();
            exact.iter_mut().for_each(|share| *share /= sum);
            let [_, deviation] = moments(&exact);
            for level in [0.005, 0.05, 0.5, 0.95, 0.995] {
                let off = (quantile(&found.marginals[0], level) - quantile(&exact, level)).abs();
                largest = largest.max(off / deviation);
            }
        }
        println!("{given} given, quantiles off by up to {largest:.3} standard deviations");
        assert!(given > 150 && largest < 0.05, "{given} {largest}");
    }

    #[test]
    fn peer_two_unknowns_that_go_together_as_by_a_sum_over_a_fine_lattice() {
        // A bent ridge: no normal distribution, and no unknown apart from the other.
        let log = |at: &[f64]| {
            let [a, b] = [(at[0] - 0.45) / 0.12, (at[1] - 0.3 - 0.5 * at[0] * at[0]) / 0.08];
            -0.5 * (a * a + b * b)
        };
        let found = distribution(&[Axis::Continuous; 2], -0.5 * 9.2, log).unwrap_or_else(|why| panic!("{why:?}"));
        let count = 1500;
        let at = |k: usize| (k as f64 + 0.5) / count as f64;
        let (mut sums, mut total) = ([[0.0; 2]; 2], 0.0);
        for i in 0..count {
            for j in 0..count {
                let weight = log(&[at(i), at(j)]).exp();
                total += weight;
                for (sum, value) in sums.iter_mut().zip([at(i), at(j)]) {
                    sum[0] += weight * value;
                    sum[1] += weight * value * value;
                }
            }
        }
        for (unknown, [first, second]) in sums.into_iter().enumerate() {
            let mean = first / total;
            let deviation = (second / total - mean * mean).sqrt();
            let found = moments(&found.marginals[unknown]);
            assert!((found[0] - mean).abs() < 0.02 * deviation, "{unknown}: {found:?} {mean}");
            assert!((found[1] / deviation - 1.0).abs() < 0.03, "{unknown}: {found:?} {deviation}");
        }
    }

    #[test]
    fn analytic_members_have_the_shares_of_their_likelihoods() {
        // Of two members the second has half the likelihood, and a distribution half as wide.
        let log = |at: &[f64]| {
            let is_second = at[0] == 1.0;
            let deviation = if is_second { 0.07 } else { 0.14 };
            -0.5 * ((at[1] - 0.5) / deviation).powi(2) + if is_second { 0.5_f64.ln() } else { 0.0 }
        };
        let found =
            distribution(&[Axis::Members(2), Axis::Continuous], -4.0, log).unwrap_or_else(|why| panic!("{why:?}"));
        assert_eq!(found.marginals[0].len(), 2);
        assert!((found.marginals[0][0] - 0.8).abs() < 2e-3, "{:?}", found.marginals[0]);
    }

    #[test]
    fn a_distribution_narrower_than_the_cells_and_one_of_failed_runs_are_refused() {
        // 16 cells, of which one holds nearly all.
        let narrow = |at: &[f64]| -0.5 * ((at[0] - 0.53) / 0.004).powi(2);
        let refused = {
            let mut grid = Grid::untested(&[Axis::Continuous], vec![16]);
            let cells: Vec<TestedCell> =
                (0..16).map(|cell| TestedCell { at: grid.middle(cell), widths: grid.widths() }).collect();
            (0..16).for_each(|cell| grid.settle(cell, Verdict { is_consistent: cell == 8, distance: 1.0 }));
            let values: Vec<Weighed<'_>> =
                cells.iter().map(|cell| Weighed { cell, log_likelihood: narrow(&cell.at), failed: 0.0 }).collect();
            Distribution::new(&grid, &values).expect_err("one value carries all")
        };
        assert!(
            matches!(refused, PosteriorRefusal::FewValues { unknown: 0, effective, .. } if effective < 2.0),
            "{refused:?}"
        );
        let mut grid = Grid::untested(&[Axis::Continuous], vec![4]);
        let cells: Vec<TestedCell> =
            (0..4).map(|cell| TestedCell { at: grid.middle(cell), widths: grid.widths() }).collect();
        (0..4).for_each(|cell| grid.settle(cell, Verdict { is_consistent: true, distance: 0.5 }));
        // A fifth of the runs of one of four equally probable values: exactly the share that is allowed, and a little more.
        for (failed, is_given) in [(0.19, true), (0.21, false)] {
            let values: Vec<Weighed<'_>> = cells
                .iter()
                .enumerate()
                .map(|(k, cell)| Weighed { cell, log_likelihood: -1.0, failed: if k == 2 { failed } else { 0.0 } })
                .collect();
            let found = Distribution::new(&grid, &values);
            assert_eq!(found.is_ok(), is_given, "{found:?}");
            if let Ok(found) = found {
                assert!((found.effective_values - 4.0).abs() < 1e-9);
            }
        }
    }
}
