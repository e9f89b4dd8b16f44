//! Subset simulation: a small probability as a product of larger ones.

use super::{RARE_CONFIDENCE, RareEstimate, RareProbability};
use crate::{hash, normal, normal_quantile};
use loosepin_math::places_in_order;

/// Share of each level that the next one begins from.
const LEVEL_SHARE: usize = 10;
/// Levels, at most: probabilities down to 1e-12.
const MAX_LEVELS: usize = 12;
/// Share of candidates that the chains aim to accept.
const TARGET_ACCEPTANCE: f64 = 0.44;
/// Chains whose acceptance is looked at together, as a share of all: the width of the steps adapts in between.
const ADAPTIONS: usize = 10;
/// Width of the first steps.
const FIRST_WIDTH: f64 = 0.6;
/// The limit state of a run that failed: it is in every level.
const FAILED: f64 = f64::NEG_INFINITY;
/// Separates the stream of random numbers.
const SUBSETS: u64 = 0x7375_6273_6574_7300;

/// How much is sampled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SubsetSimulation {
    /// Points of each level; the next multiple of 100 is taken, at least 200. Default: 3,400, which is under 20,000 runs down to 1e-6.
    pub level: usize,
    /// Seed. Default: 1.
    pub seed: u64,
}

impl Default for SubsetSimulation {
    fn default() -> Self {
        Self { level: 3_400, seed: 1 }
    }
}

impl SubsetSimulation {
    /// Points of each level.
    fn points(&self) -> usize {
        self.level.max(200).next_multiple_of(LEVEL_SHARE * ADAPTIONS)
    }

    /// Evaluations at most: those of every level that there may be.
    pub fn most_runs(&self) -> usize {
        self.points() * MAX_LEVELS
    }
}

/// P(g <= 0) by subset simulation, for events that no design point describes.
///
/// ```text
/// P = 0.1^(levels - 1) · share of the last level with g <= 0;  each level: the tenth with the smallest g of the one before, and
/// chains from them: u' = √(1 - s²) u + s ξ, ξ standard normal, kept where g is not above the level's threshold
/// ```
///
/// The width s adapts to an acceptance of 0.44. The error takes the correlation within chains into account, and the levels as
/// independent; the interval is that of a lognormal estimate. Failed runs are in every level. Sources: S.-K. Au, J. L. Beck, Probabilistic Engineering Mechanics 16
/// (2001) 263-277, eqs. 25 to 29; I. Papaioannou et al., Probabilistic Engineering Mechanics 41 (2015) 89-103, section 3.
///
/// # Errors
/// That of the limit state.
pub fn subset_simulation<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    dimensions: usize,
    settings: &SubsetSimulation,
) -> Result<RareProbability, E> {
    let key = hash(settings.seed, SUBSETS);
    let level = settings.points();
    let chains = level / LEVEL_SHARE;
    let first = hash(key, 0);
    let mut points: Vec<Vec<f64>> = (0..level)
        .map(|index| (0..dimensions).map(|axis| normal(hash(first, index as u64), axis as u64)).collect())
        .collect();
    let mut values = limit_state(&points)?;
    let (mut runs, mut failed) = (level, 0);
    take_failed_as_event(&mut values, &mut failed);
    let mut probability = 1.0;
    let mut squared_variation = 0.0;
    let mut chain_length = 1;
    let mut width = FIRST_WIDTH;
    let mut number = 0;
    loop {
        number += 1;
        let order = places_in_order(&values[..level]);
        let threshold = values[order[chains]].max(0.0);
        let is_event: Vec<bool> = values.iter().map(|&value| value <= threshold).collect();
        let hits = is_event.iter().filter(|hit| **hit).count();
        let share = hits as f64 / level as f64;
        // As many below the threshold of the event as the level needs, or nothing beyond it any more.
        let is_last = threshold <= 0.0 || number == MAX_LEVELS || share == 1.0;
        if is_last {
            // The levels hold all failed runs and all of the event; the last one tells them apart.
            let hits = |is_hit: &dyn Fn(f64) -> bool| values.iter().map(|&value| is_hit(value)).collect::<Vec<bool>>();
            let of = |hits: &[bool]| last_estimate(probability, squared_variation, hits, chain_length);
            let low = of(&hits(&|value| value <= 0.0 && value > FAILED));
            let high = of(&hits(&|value| value <= 0.0));
            return Ok(RareProbability { low, high, runs, failed });
        }
        probability *= share;
        squared_variation += variation(&is_event, chain_length);
        let own = hash(key, number as u64);
        // Seeds in an order that has nothing to do with g, so that the groups that adapt the width are alike.
        let mut seeds: Vec<usize> = (0..level).filter(|&index| is_event[index]).collect();
        seeds.sort_by_key(|&index| hash(hash(own, u64::MAX), index as u64));
        seeds.truncate(chains);
        let (mut next_points, mut next_values) = (Vec::with_capacity(level), Vec::with_capacity(level));
        let mut scale = width;
        for (group, seeds) in seeds.chunks(chains / ADAPTIONS).enumerate() {
            let step = scale.min(1.0);
            let keep = (1.0 - step * step).sqrt();
            let mut at: Vec<Vec<f64>> = seeds.iter().map(|&seed| points[seed].clone()).collect();
            let mut of: Vec<f64> = seeds.iter().map(|&seed| values[seed]).collect();
            let mut history: Vec<Vec<(Vec<f64>, f64)>> =
                at.iter().cloned().zip(of.iter().copied()).map(|s| vec![s]).collect();
            let mut accepted = 0;
            for move_number in 1..LEVEL_SHARE {
                let trials: Vec<Vec<f64>> = at
                    .iter()
                    .enumerate()
                    .map(|(chain, point)| {
                        let index = (group * chains + chain) * LEVEL_SHARE + move_number;
                        let random = hash(own, index as u64);
                        point
                            .iter()
                            .enumerate()
                            .map(|(axis, x)| keep * x + step * normal(random, axis as u64))
                            .collect()
                    })
                    .collect();
                let mut found = limit_state(&trials)?;
                runs += trials.len();
                take_failed_as_event(&mut found, &mut failed);
                for (chain, (trial, value)) in trials.into_iter().zip(found).enumerate() {
                    if value <= threshold {
                        at[chain] = trial;
                        of[chain] = value;
                        accepted += 1;
                    }
                    history[chain].push((at[chain].clone(), of[chain]));
                }
            }
            let share = f64::from(accepted) / (seeds.len() * (LEVEL_SHARE - 1)) as f64;
            scale *= libm::exp((share - TARGET_ACCEPTANCE) / ((group + 1) as f64).sqrt());
            for (point, value) in history.into_iter().flatten() {
                next_points.push(point);
                next_values.push(value);
            }
        }
        width = scale.clamp(0.05, 1.0);
        (points, values, chain_length) = (next_points, next_values, LEVEL_SHARE);
    }
}

/// The estimate from the `hits` in the last level, `before` being the probability of that level.
fn last_estimate(before: f64, squared_variation: f64, hits: &[bool], chain_length: usize) -> RareEstimate {
    let count = hits.iter().filter(|hit| **hit).count();
    if count == 0 {
        // The levels do not reach the event: all that is known is that it is no likelier than the last of them.
        return RareEstimate { value: 0.0, standard_error: 0.0, interval: [0.0, before] };
    }
    let value = before * (count as f64 / hits.len() as f64);
    let squared_variation = squared_variation + variation(hits, chain_length);
    let standard_error = value * squared_variation.sqrt();
    let factor = libm::exp(normal_quantile(0.5 + 0.5 * RARE_CONFIDENCE) * libm::log1p(squared_variation).sqrt());
    RareEstimate { value, standard_error, interval: [value / factor, (value * factor).min(1.0)] }
}

fn take_failed_as_event(values: &mut [f64], failed: &mut usize) {
    for value in values.iter_mut().filter(|value| value.is_nan()) {
        *value = FAILED;
        *failed += 1;
    }
}

/// Square of the coefficient of variation of the share of `hits`, in chains that lie behind one another:
/// (1 - p)/(p N) (1 + γ), γ = 2 Σ (1 - k/L) ρ_k, ρ_k the correlation of hits k moves apart.
fn variation(hits: &[bool], chain_length: usize) -> f64 {
    let count = hits.len() as f64;
    let share = hits.iter().filter(|hit| **hit).count() as f64 / count;
    let mut gamma = 0.0;
    let variance = share * (1.0 - share);
    if variance > 0.0 {
        for lag in 1..chain_length {
            let pairs = hits.chunks(chain_length).flat_map(|chain| chain.iter().zip(&chain[lag.min(chain.len())..]));
            let (mut both, mut all) = (0.0, 0.0);
            for (&a, &b) in pairs {
                both += f64::from(u8::from(a && b));
                all += 1.0;
            }
            gamma += 2.0 * (1.0 - lag as f64 / chain_length as f64) * (both / all - share * share) / variance;
        }
    }
    (1.0 - share) / (share * count) * (1.0 + gamma.max(0.0))
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{SubsetSimulation, subset_simulation};
    use crate::reliability::RareProbability;
    use crate::reliability::tests::{FOUR_BRANCHES, LIMIT_STATES};

    #[test]
    fn analytic_one_in_a_hundred_thousand_to_a_quarter() {
        const SEEDS: u64 = 40;
        /// 95 % of 40 less three standard deviations of that count.
        const MIN_CONTAINED: usize = 34;
        for known in LIMIT_STATES.iter().chain([&FOUR_BRANCHES]) {
            let truth = (known.probability)();
            let estimate = |seed| {
                let mut limit_state = |points: &[Vec<f64>]| -> Result<Vec<f64>, Infallible> {
                    Ok(points.iter().map(|point| (known.limit_state)(point)).collect())
                };
                let settings = SubsetSimulation { seed, ..SubsetSimulation::default() };
                subset_simulation(&mut limit_state, known.dimensions, &settings).unwrap()
            };
            let found: Vec<RareProbability> = (0..SEEDS).map(estimate).collect();
            let squares: f64 = found.iter().map(|f| (f.high.value / truth - 1.0).powi(2)).sum();
            let deviation = (squares / SEEDS as f64).sqrt();
            let stated = found.iter().map(|f| f.high.coefficient_of_variation()).sum::<f64>() / SEEDS as f64;
            assert!(deviation < 0.25, "{}: {deviation}, stated {stated}", known.name);
            let contained = found.iter().filter(|f| f.high.interval[0] <= truth && truth <= f.high.interval[1]).count();
            assert!(contained >= MIN_CONTAINED, "{}: {contained} of {SEEDS}; {deviation}, stated {stated}", known.name);
            assert!(found.iter().all(|f| f.runs < 20_000), "{}", known.name);
        }
    }

    #[test]
    fn an_event_that_is_not_reached_is_not_claimed_to_be_impossible() {
        let mut never = |points: &[Vec<f64>]| -> Result<Vec<f64>, Infallible> { Ok(vec![1.0; points.len()]) };
        let found = subset_simulation(&mut never, 2, &SubsetSimulation { level: 200, seed: 1 }).unwrap();
        assert_eq!((found.high.value, found.high.interval), (0.0, [0.0, 1.0]));
    }

    #[test]
    fn analytic_failed_runs_count_as_the_event_in_the_upper_end_alone() {
        // Φ(-3) of the mechanisms fail; none is seen at the limit.
        let mut fails = |points: &[Vec<f64>]| -> Result<Vec<f64>, Infallible> {
            Ok(points.iter().map(|point| if point[0] > 3.0 { f64::NAN } else { 4.0 - point[0] }).collect())
        };
        let found = subset_simulation(&mut fails, 2, &SubsetSimulation::default()).unwrap();
        let truth = crate::normal_cdf(-3.0);
        assert!(found.failed > 0 && (found.high.value / truth - 1.0).abs() < 0.2, "{found:?}");
        assert!(found.low.interval[0] == 0.0 && found.high.interval[1] >= truth, "{found:?}");
    }

    #[test]
    fn analytic_failed_runs_and_the_event_side_by_side() {
        // Φ(-3) reach the limit; of them Φ(-3.2), those that go furthest, fail.
        const SEEDS: u64 = 20;
        /// 95 % of 20 less three standard deviations of that count.
        const MIN_CONTAINED: usize = 16;
        let mut fails = |points: &[Vec<f64>]| -> Result<Vec<f64>, Infallible> {
            Ok(points.iter().map(|point| if point[0] > 3.2 { f64::NAN } else { 3.0 - point[0] }).collect())
        };
        let [all, failed] = [-3.0, -3.2].map(crate::normal_cdf);
        let mut contained = [0; 2];
        for seed in 0..SEEDS {
            let settings = SubsetSimulation { seed, ..SubsetSimulation::default() };
            let found = subset_simulation(&mut fails, 2, &settings).unwrap();
            for (count, (found, truth)) in contained.iter_mut().zip([(found.low, all - failed), (found.high, all)]) {
                *count += usize::from(found.interval[0] <= truth && truth <= found.interval[1]);
            }
        }
        assert!(contained.iter().all(|&count| count >= MIN_CONTAINED), "{contained:?} of {SEEDS}");
    }
}
