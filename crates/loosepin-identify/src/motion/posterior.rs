//! Posterior distribution of the unknowns from the likelihood at the tested values: prior uniform over the box, each member of a list as
//! probable as any other.
//!
//! Where so few values carry the probability that they do not show its shape, those that carry nearly all of it are halved within the
//! consistent set, and both halves are tested.

use super::distribution::{Distribution, WeightedValue, moments, quantile};
use super::grid::{Axis, Grid, TestedCell};
use super::joint_test::Verdict;
use super::likelihood::{RUNS_A_FEATURE, log_likelihood};
use super::run_cache::Runs;
use super::scatter::Observation;
use super::unknowns::value;
use loosepin_math::sort_by_number;
use loosepin_result::motion_identification::{Marginal, MarginalSummary, MotionPosterior, Posterior, PosteriorRefusal};
use loosepin_study::Study;

/// Equally probable values along an unknown, at least: of a normal distribution there are 3.5 for values one standard deviation apart. Of
/// skewed distributions quantiles were off by 0.04 standard deviations with 4 to 5, by up to 0.14 with 3 to 4, by up to 0.8 with fewer.
const MIN_VALUES: f64 = 4.0;
/// Share of the probability whose values are halved together: what the others carry is a tenth of a tail beyond a credible interval of 99 %.
const HALVED: f64 = 0.9995;
/// Share of failed runs among those that carry the weight, at most.
const MAX_FAILED: f64 = 0.05;

/// The question that the distribution answers.
pub(crate) struct Question<'q> {
    pub study: &'q Study,
    pub seen: &'q Observation,
    /// Credible intervals have the probability 1 - `alpha`.
    pub alpha: f64,
}

/// Tests values, as shares of the box: of each what the test says, and its runs.
pub(crate) type TestValues<'t, E> = dyn FnMut(Vec<Vec<f64>>) -> Result<Vec<(Verdict, Runs)>, E> + 't;

/// The posterior distribution by the runs at the tested values of `grid`, in the order in which they were tested, and at `points` further
/// ones at most.
///
/// # Errors
/// Those of `test`.
pub(crate) fn posterior<E>(
    question: &Question<'_>,
    grid: Grid,
    tested: Vec<(TestedCell, Runs)>,
    points: usize,
    test: &mut TestValues<'_, E>,
) -> Result<MotionPosterior, E> {
    let count = tested.first().map_or(0, |(_, runs)| runs.len());
    if grid.consistent().next().is_none() {
        return Ok(MotionPosterior::Refused(PosteriorRefusal::Misfit));
    }
    if count <= 1 {
        return Ok(MotionPosterior::Refused(PosteriorRefusal::NothingScatters));
    }
    let weighed = |(cell, runs): (TestedCell, Runs)| {
        let ended = runs.iter().filter(|run| run.iter().all(|value| value.is_finite())).count();
        WeightedValue {
            cell,
            log_likelihood: log_likelihood(&runs, question.seen).unwrap_or(f64::NEG_INFINITY),
            ended,
            failed: (runs.len() - ended) as f64 / runs.len() as f64,
        }
    };
    let values = tested.into_iter().map(weighed).collect();
    let least_runs = RUNS_A_FEATURE * question.seen.values_si.len();
    let found = shown(grid, values, least_runs, points, &mut |cells: Vec<TestedCell>| {
        let all = test(cells.iter().map(|cell| cell.at.clone()).collect())?;
        Ok(cells.into_iter().zip(all).map(|(cell, (verdict, runs))| (verdict, weighed((cell, runs)))).collect())
    })?;
    Ok(match found {
        Ok((grid, found)) => MotionPosterior::Given(question.summary(&grid, &found, count)),
        Err(refusal) => MotionPosterior::Refused(refusal),
    })
}

/// Tests cells at their middles: of each what the test says, and its likelihood.
type TestCells<'t, E> = dyn FnMut(Vec<TestedCell>) -> Result<Vec<(Verdict, WeightedValue)>, E> + 't;

/// The distribution with enough values to show its shape, at most `points` further ones, with its cells.
///
/// # Errors
/// Those of `test`.
fn shown<E>(
    mut grid: Grid,
    mut values: Vec<WeightedValue>,
    least_runs: usize,
    mut points: usize,
    test: &mut TestCells<'_, E>,
) -> Result<Result<(Grid, Distribution), PosteriorRefusal>, E> {
    loop {
        let found = match carried(&grid, &values, least_runs) {
            Ok(found) => found,
            Err(refusal) => return Ok(Err(refusal)),
        };
        let few = (0..grid.axes.len()).find_map(|unknown| {
            let effective = found.effective_along(unknown, &values);
            // What is no number is no reason to go on.
            (grid.axes[unknown] == Axis::Continuous && !(effective >= MIN_VALUES)).then_some((unknown, effective))
        });
        let Some((unknown, effective)) = few else { return Ok(Ok((grid, found))) };
        let carrying = carrying(&grid, &values, &found, unknown);
        let points_are_spent = 2 * carrying.len() > points;
        if carrying.is_empty() || points_are_spent {
            return Ok(Err(PosteriorRefusal::FewValues { unknown, effective, least: MIN_VALUES, points_are_spent }));
        }
        let cells: Vec<(usize, &TestedCell)> = carrying.iter().map(|value| (*value, &values[*value].cell)).collect();
        let halves = grid.halved(&cells, unknown);
        points -= halves.len();
        for (half, (verdict, value)) in halves.iter().zip(test(halves.iter().map(|half| half.cell.clone()).collect())?)
        {
            grid.decide_half(half, verdict);
            values.push(value);
        }
    }
}

/// The distribution, where the runs say enough.
///
/// # Errors
/// Too few runs ended at a value, or too many of those failed that carry the weight.
fn carried(grid: &Grid, values: &[WeightedValue], least: usize) -> Result<Distribution, PosteriorRefusal> {
    // The set keeps a value whose runs failed. Runs that did not end say nothing of how probable it is.
    let fewest = grid.consistent().map(|cell| values[grid.tests[cell]].ended).min();
    if let Some(runs) = fewest.filter(|ended| *ended < least) {
        return Err(PosteriorRefusal::FewRuns { runs, least });
    }
    let failed = |share: f64| PosteriorRefusal::Failed { share, most: MAX_FAILED };
    let found = Distribution::new(grid, values).ok_or_else(|| failed(1.0))?;
    let share: f64 = found.weights.iter().zip(values).map(|(weight, value)| weight * value.failed).sum();
    if share <= MAX_FAILED { Ok(found) } else { Err(failed(share)) }
}

/// The values that carry nearly all of the probability, as far as they belong to the set and can be halved along an unknown; empty if the
/// others carry too much for halving to help.
fn carrying(grid: &Grid, values: &[WeightedValue], found: &Distribution, unknown: usize) -> Vec<usize> {
    let mut is_kept = vec![false; values.len()];
    grid.consistent().for_each(|cell| is_kept[grid.tests[cell]] = true);
    let can_be_split_along = |value: usize| is_kept[value] && values[value].cell.can_be_split_along(unknown);
    let rest = |slice: &Vec<usize>| -> f64 {
        slice.iter().filter(|value| !can_be_split_along(**value)).map(|value| found.weights[*value]).sum()
    };
    if found.slices(unknown, values).iter().map(|slice| rest(slice).powi(2)).sum::<f64>() * MIN_VALUES > 1.0 {
        return Vec::new();
    }
    let mut order: Vec<usize> = (0..values.len()).collect();
    sort_by_number(&mut order, |&value| -found.weights[value]);
    let mut sum = 0.0;
    order.retain(|value| {
        let is_carrying = sum < HALVED;
        sum += found.weights[*value];
        is_carrying && can_be_split_along(*value)
    });
    order
}

impl Question<'_> {
    /// Numbers of a distribution with `runs` runs at each value.
    fn summary(&self, grid: &Grid, found: &Distribution, runs: usize) -> Posterior {
        let tail = 0.5 * self.alpha;
        let marginal = |(k, shares): (usize, &Vec<f64>)| {
            let input = &self.study.epistemic[k];
            let [lower, upper] = input.variable.ends();
            let summary = (grid.axes[k] == Axis::Continuous).then(|| {
                let [mean, deviation] = moments(shares);
                MarginalSummary {
                    mean_si: value(input, mean),
                    standard_deviation_si: deviation * (upper - lower),
                    credible_si: [tail, 1.0 - tail].map(|level| value(input, quantile(shares, level))),
                }
            });
            Marginal { shares: shares.clone(), summary }
        };
        let effective_values = found.effective_values();
        Posterior {
            probability: 1.0 - self.alpha,
            effective_values,
            effective_runs: effective_values * runs as f64,
            marginals: found.marginals.iter().enumerate().map(marginal).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::shown;
    use crate::motion::distribution::{Distribution, WeightedValue, moments, quantile};
    use crate::motion::grid::{Axis, Grid, TestedCell};
    use crate::motion::joint_test::Verdict;
    use loosepin_result::motion_identification::PosteriorRefusal;
    use loosepin_uncertainty::{normal_cdf, normal_quantile};
    use std::convert::Infallible;

    fn weighed(cell: TestedCell, log_likelihood: f64, failed: f64) -> WeightedValue {
        WeightedValue { cell, log_likelihood, ended: 100, failed }
    }

    /// Refines as an identification does where the set is that of the log-likelihoods above `least`, and returns the distribution, for
    /// which this number of further values may be tested.
    fn distribution(
        axes: &[Axis],
        least: f64,
        points: usize,
        of: impl Fn(&[f64]) -> f64,
    ) -> Result<Distribution, PosteriorRefusal> {
        let verdict = |log: f64| {
            let distance = (log / least).sqrt();
            Verdict { is_consistent: distance <= 1.0, distance }
        };
        let mut values: Vec<WeightedValue> = Vec::new();
        let (grid, _) = Grid::refined(axes, 100_000, true, &mut |grid: &mut Grid, waiting: &[usize]| {
            for cell in waiting {
                let at = grid.middle(*cell);
                let log = of(&at);
                grid.decide(*cell, verdict(log));
                values.push(weighed(TestedCell { at, widths: grid.widths() }, log, 0.0));
            }
            Ok::<(), Infallible>(())
        })
        .unwrap_or_else(|never| match never {});
        let mut test = |cells: Vec<TestedCell>| {
            let value = |cell: TestedCell| {
                let log = of(&cell.at);
                (verdict(log), weighed(cell, log, 0.0))
            };
            Ok::<_, Infallible>(cells.into_iter().map(value).collect())
        };
        let found = shown(grid, values, 10, points, &mut test).unwrap_or_else(|never| match never {});
        found.map(|(_, distribution)| distribution)
    }

    /// A value that is met exactly, by the middle of one cell, and of which its halves know nothing: either there are too few values, or numbers.
    #[test]
    fn analytic_a_summit_that_only_a_value_whose_halves_took_over_has_seen() {
        let mut refused = 0;
        for summit in
            (1..128).step_by(2).map(|number| f64::from(number) / 128.0).chain([0.5, 0.25, 0.375, 0.4375, 0.46875])
        {
            for points in [2, 4, 8, 16] {
                let log = |at: &[f64]| -0.5 * ((at[0] - summit) / 1e-5).powi(2);
                match distribution(&[Axis::Continuous], -1e12, points, log) {
                    Err(PosteriorRefusal::FewValues { .. }) => refused += 1,
                    Err(why) => panic!("{summit} {points}: {why:?}"),
                    Ok(found) => assert!(found.weights.iter().all(|weight| weight.is_finite()), "{summit} {points}"),
                }
            }
        }
        assert!(refused > 0);
    }

    #[test]
    fn analytic_a_normal_likelihood_gives_a_normal_distribution_cut_to_the_box() {
        for (mean, deviation) in [(0.47, 0.06), (0.31, 0.13), (0.02, 0.09), (0.6, 0.4)] {
            // Kept within 2.6 standard deviations.
            let log = |at: &[f64]| -0.5 * ((at[0] - mean) / deviation).powi(2);
            let found =
                distribution(&[Axis::Continuous], -0.5 * 2.6 * 2.6, 0, log).unwrap_or_else(|why| panic!("{why:?}"));
            let [low, high] = [0.0, 1.0].map(|end| normal_cdf((end - mean) / deviation));
            for level in [0.005, 0.1, 0.5, 0.9, 0.995] {
                let expected = mean + deviation * normal_quantile(low + level * (high - low));
                let found = quantile(&found.marginals[0], level);
                // A cell of the sum is 1/256 of the box; within it the distribution is even.
                assert!((found - expected).abs() < 2e-3, "{mean} {deviation} {level}: {found} {expected}");
            }
        }
    }

    /// ln p of a Gumbel distribution, whose slopes on both sides differ: e^(-z - e^-z) about its mode.
    fn gumbel(at: f64, mode: f64, scale: f64) -> f64 {
        let z = (at - mode) / scale;
        1.0 - z - (-z).exp()
    }

    /// Of 200 of them, wide ones and narrow ones, modes anywhere, also at the ends of the box, where the set is that above `least`: those that
    /// are given where `points` further values may be tested, and the largest error of a quantile in standard deviations.
    fn errors_of_gumbel(least: f64, points: usize) -> (usize, f64) {
        let (mut given, mut largest) = (0, 0.0_f64);
        for trial in 0..200 {
            let mode = 0.05 + 0.9 * f64::from(trial % 20) / 19.0;
            let scale = 0.02 * 1.3_f64.powi(trial / 20);
            let log = |at: &[f64]| gumbel(at[0], mode, scale);
            let found = match distribution(&[Axis::Continuous], least, points, log) {
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
        println!("{least} {points}: {given} given, quantiles off by up to {largest:.3} standard deviations");
        (given, largest)
    }

    #[test]
    fn peer_skewed_likelihoods_of_any_width_as_by_a_sum_over_a_fine_lattice() {
        let (given, largest) = errors_of_gumbel(-3.4, 0);
        assert!(given > 150 && largest < 0.05, "{given} {largest}");
    }

    #[test]
    fn peer_likelihoods_narrower_than_their_set_as_by_a_sum_over_a_fine_lattice() {
        // Sets that hold far more than the distribution: without further values few or none are given.
        for least in [-12.0, -20.0] {
            let (without, _) = errors_of_gumbel(least, 0);
            let (given, largest) = errors_of_gumbel(least, 60);
            assert!(without < 150 && given == 200 && largest < 0.05, "{least}: {without} {given} {largest}");
        }
    }

    #[test]
    fn further_values_end_where_points_or_cells_end() {
        // Narrower than the finest cells, which are 1/512 of the box, and a set as wide as the box.
        let narrow = |at: &[f64]| -0.5 * ((at[0] - 0.53) / 4e-4).powi(2);
        for (points, spent) in [(0, true), (1, true), (9, true), (60, false)] {
            let refused = distribution(&[Axis::Continuous], -1e9, points, narrow).expect_err("one value carries all");
            let PosteriorRefusal::FewValues { points_are_spent, effective, .. } = refused else {
                panic!("{refused:?}");
            };
            assert_eq!(points_are_spent, spent, "{points}");
            assert!(effective < 4.0, "{effective}");
        }
    }

    #[test]
    fn peer_two_unknowns_that_go_together_as_by_a_sum_over_a_fine_lattice() {
        // A bent ridge: no normal distribution, and no unknown apart from the other.
        let log = |at: &[f64]| {
            let [a, b] = [(at[0] - 0.45) / 0.12, (at[1] - 0.3 - 0.5 * at[0] * at[0]) / 0.08];
            -0.5 * (a * a + b * b)
        };
        let found = distribution(&[Axis::Continuous; 2], -0.5 * 9.2, 0, log).unwrap_or_else(|why| panic!("{why:?}"));
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
            distribution(&[Axis::Members(2), Axis::Continuous], -4.0, 0, log).unwrap_or_else(|why| panic!("{why:?}"));
        assert_eq!(found.marginals[0].len(), 2);
        assert!((found.marginals[0][0] - 0.8).abs() < 2e-3, "{:?}", found.marginals[0]);
    }

    fn without_further(grid: Grid, values: Vec<WeightedValue>) -> Result<Distribution, PosteriorRefusal> {
        let mut test = |_: Vec<TestedCell>| Ok::<_, Infallible>(Vec::new());
        let found = shown(grid, values, 10, 0, &mut test).unwrap_or_else(|never| match never {});
        found.map(|(_, distribution)| distribution)
    }

    #[test]
    fn a_distribution_narrower_than_the_cells_and_one_of_failed_runs_are_refused() {
        // 16 cells, of which one holds nearly all.
        let narrow = |at: &[f64]| -0.5 * ((at[0] - 0.53) / 0.004).powi(2);
        let refused = {
            let mut grid = Grid::untested(&[Axis::Continuous], vec![16]);
            let cells: Vec<TestedCell> =
                (0..16).map(|cell| TestedCell { at: grid.middle(cell), widths: grid.widths() }).collect();
            (0..16).for_each(|cell| grid.decide(cell, Verdict { is_consistent: cell == 8, distance: 1.0 }));
            let values = cells.into_iter().map(|cell| {
                let log = narrow(&cell.at);
                weighed(cell, log, 0.0)
            });
            without_further(grid, values.collect()).expect_err("one value carries all")
        };
        assert!(
            matches!(refused, PosteriorRefusal::FewValues { unknown: 0, effective, .. } if effective < 2.0),
            "{refused:?}"
        );
        let mut grid = Grid::untested(&[Axis::Continuous], vec![4]);
        let cells: Vec<TestedCell> =
            (0..4).map(|cell| TestedCell { at: grid.middle(cell), widths: grid.widths() }).collect();
        (0..4).for_each(|cell| grid.decide(cell, Verdict { is_consistent: true, distance: 0.5 }));
        // A fifth of the runs of one of four equally probable values: exactly the share that is allowed, and a little more.
        for (failed, is_given) in [(0.19, true), (0.21, false)] {
            let values = cells
                .iter()
                .enumerate()
                .map(|(k, cell)| weighed(cell.clone(), -1.0, if k == 2 { failed } else { 0.0 }))
                .collect();
            let found = without_further(grid.clone(), values);
            assert_eq!(found.is_ok(), is_given, "{found:?}");
            if let Ok(found) = found {
                assert!((found.effective_values() - 4.0).abs() < 1e-9);
            }
        }
    }
}
