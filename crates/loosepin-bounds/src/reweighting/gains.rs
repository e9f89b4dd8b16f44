//! By how much a statistic of weighted runs may lie beyond that at an outer point.

use super::pooled::{At, LEAST_BEYOND, Weighted};
use super::weights::kish;
use crate::measure::{Event, Sought};
use crate::probability::wilson;
use crate::sample::{Confidence, replicate_error};
use crate::search::Direction;

/// A share with fewer hits or misses in each replicate of the pool has no error from the spread of the replicates.
const LEAST_PER_REPLICATE: usize = 2;
/// So many draws must make up the spread of what is averaged: where fewer do, that of the replicates says nothing of its error.
const LEAST_CONTRIBUTORS: f64 = 4.0;
/// A spread below this share of what is averaged is round-off.
const NEGLIGIBLE_SPREAD: f64 = 1e-12;
/// Halvings of the range in which a quantile may lie.
const HALVINGS: usize = 30;

/// By how much a statistic may lie beyond at a place; nothing where the pool cannot tell.
pub type Gain<'s> = Box<dyn Fn(&At<'_>) -> Option<f64> + Sync + 's>;

impl Weighted {
    /// By how much the statistic may lie beyond `value`, that at the outer point `witness`.
    pub fn gain<'s>(
        &'s self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
    ) -> Gain<'s> {
        match sought {
            Sought::Mean => self.mean_gain(direction, witness, confidence, |_| |y: f64| y),
            Sought::Variance => self.mean_gain(direction, witness, confidence, |at| {
                let centre = average(&self.expectation(at, |y| y));
                move |y: f64| (y - centre) * (y - centre)
            }),
            Sought::Probability(event) => self.share_gain(direction, witness, confidence, event),
            Sought::Quantile(probability) => self.quantile_gain(direction, (witness, value), confidence, probability),
        }
    }

    /// What h(Y) has beyond that of the polynomials at every run, and its weighted mean at a place.
    fn changes(&self, at: &At<'_>, h: impl Fn(f64) -> f64) -> (Vec<f64>, f64) {
        let changes: Vec<f64> = self.values.iter().zip(&self.explained).map(|(y, p)| h(*y) - h(*p)).collect();
        let total = at.seen.weights.iter().zip(&changes).map(|(w, change)| w * change).sum();
        (changes, total)
    }

    /// E h(Y) at a place as each replicate sees it.
    fn expectation(&self, at: &At<'_>, h: impl Fn(f64) -> f64) -> Vec<f64> {
        let changes = self.changes(at, &h);
        self.expectation_by(at, h, &changes)
    }

    /// The same from [`Self::changes`].
    fn expectation_by(&self, at: &At<'_>, h: impl Fn(f64) -> f64, (changes, total): &(Vec<f64>, f64)) -> Vec<f64> {
        let (layout, points) = (self.ground.layout, self.ground.points);
        let (weights, runs) = (&at.seen.weights, layout.runs());
        (0..layout.replicates)
            .map(|replicate| {
                let own = replicate * runs..(replicate + 1) * runs;
                let beyond: f64 = own.map(|run| weights[run] * (changes[run] - total)).sum();
                let asked = &at.expected[replicate * points..(replicate + 1) * points];
                let expected = asked.iter().map(|&value| h(value)).sum::<f64>() / points as f64;
                expected + total + layout.replicates as f64 * beyond
            })
            .collect()
    }

    /// Whether enough draws make up the spread of what is averaged, if there is any.
    fn is_spread_over_many(&self, at: &At<'_>, h: impl Fn(f64) -> f64, (changes, total): &(Vec<f64>, f64)) -> bool {
        let weights = &at.seen.weights;
        let squares: Vec<f64> = self
            .ground
            .layout
            .by_row(|run| weights[run] * (changes[run] - total))
            .into_iter()
            .map(|change| change * change)
            .collect();
        // What does not scatter needs none: a constant response, or one that the polynomials follow.
        let size: f64 = weights.iter().zip(&self.values).map(|(w, y)| w * h(*y).abs()).sum();
        let is_negligible = squares.iter().sum::<f64>() <= (NEGLIGIBLE_SPREAD * size).powi(2);
        is_negligible || kish(&squares) >= LEAST_CONTRIBUTORS
    }

    /// By how much E h(Y) may lie beyond that at `witness`.
    fn mean_gain<'s, H: Fn(f64) -> f64 + 's>(
        &'s self,
        direction: Direction,
        witness: usize,
        confidence: &'s Confidence,
        h: impl Fn(&At<'_>) -> H + Sync + 's,
    ) -> Gain<'s> {
        let own = self.at(witness, witness);
        let at_witness = self.expectation(&own, h(&own));
        Box::new(move |at| {
            let h = h(at);
            let changes = self.changes(at, &h);
            let is_known = at.is_witness || self.is_spread_over_many(at, &h, &changes);
            is_known.then(|| beyond(&self.expectation_by(at, h, &changes), &at_witness, direction, confidence))
        })
    }

    /// The same for a probability; nothing where the pool holds too few hits or misses.
    fn share_gain<'s>(
        &'s self,
        direction: Direction,
        witness: usize,
        confidence: &'s Confidence,
        event: Event,
    ) -> Gain<'s> {
        let layout = self.ground.layout;
        let hits = layout.by_row(|run| f64::from(event.holds(self.values[run])));
        let (hit, missed) = (
            hits.iter().filter(|&&hits| hits > 0.0).count(),
            hits.iter().filter(|&&hits| hits < layout.outer as f64).count(),
        );
        let least = LEAST_PER_REPLICATE * layout.replicates;
        if hit.min(missed) < least {
            return Box::new(|_| None);
        }
        let indicator = move |y: f64| f64::from(event.holds(y));
        let at_witness = self.expectation(&self.at(witness, witness), indicator);
        let share_there = average(&at_witness);
        Box::new(move |at| {
            let paired = beyond(&self.expectation(at, indicator), &at_witness, direction, confidence);
            // Where hardly any draw hits the spread of the replicates is too small: not less than as many independent runs.
            let weights = |is_hit: bool| {
                layout.by_row(|run| if event.holds(self.values[run]) == is_hit { at.seen.weights[run] } else { 0.0 })
            };
            let (hits, misses) = (weights(true), weights(false));
            let counted = kish(&hits).min(kish(&misses));
            if at.is_witness || counted >= least as f64 {
                return Some(paired);
            }
            let share: f64 = hits.iter().sum();
            let rarer = share.min(1.0 - share);
            let runs =
                if counted > 0.0 && rarer > 0.0 { (counted / rarer).min(at.seen.effective) } else { at.seen.effective };
            let independent = wilson(share, runs, confidence.normal);
            let far = match direction {
                Direction::Maximum => independent.1 - share_there,
                Direction::Minimum => share_there - independent.0,
            };
            Some(paired.max(far))
        })
    }

    /// How far the quantile may lie beyond `value`, that at `witness`: the distribution function there, its error conceded, must have
    /// reached the probability. Nothing where too few draws lie beyond it.
    fn quantile_gain<'s>(
        &'s self,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
        probability: f64,
    ) -> Gain<'s> {
        let indicator = |limit: f64| move |y: f64| if y <= limit { 1.0 } else { 0.0 };
        let at_witness = self.expectation(&self.at(witness, witness), indicator(value));
        let sign = direction.sign();
        let outermost = self.values.iter().map(|y| sign * y).fold(f64::MIN, f64::max);
        Box::new(move |at| {
            if at.is_witness {
                return Some(0.0);
            }
            if self.beyond_quantile(at, probability) < LEAST_BEYOND {
                return None;
            }
            // F(x) at the place less that of `value` at the witness, which is the probability.
            let is_reached = |x: f64| {
                beyond(&self.expectation(at, indicator(x)), &at_witness, direction.opposite(), confidence) <= 0.0
            };
            if is_reached(value) {
                return Some(0.0);
            }
            let (mut near, mut far) = (value, sign * outermost);
            if !(sign * (far - near) > 0.0) || !is_reached(far) {
                return None;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (near + far);
                if is_reached(middle) { far = middle } else { near = middle }
            }
            Some((sign * (far - value)).max(0.0))
        })
    }

    /// Independent draws in the lesser of the two parts that the quantile at a place divides the runs into.
    fn beyond_quantile(&self, at: &At<'_>, probability: f64) -> f64 {
        let is_upper = probability > 0.5;
        let share = probability.min(1.0 - probability);
        let (mut sum, mut own) = (0.0, vec![0.0; self.values.len()]);
        let count = self.order.len();
        for k in 0..count {
            let run = self.order[if is_upper { count - 1 - k } else { k }];
            if sum >= share {
                break;
            }
            own[run] = at.seen.weights[run];
            sum += own[run];
        }
        kish(&self.ground.layout.by_row(|run| own[run]))
    }

    /// How far E h(Y) may go at the outer point `witness` by the runs of all points; not for quantiles.
    pub fn outermost(
        &self,
        sought: Sought,
        direction: Direction,
        witness: usize,
        confidence: &Confidence,
    ) -> Option<f64> {
        let at = self.at(witness, witness);
        let plain = self.expectation(&at, |y| y);
        let of_replicates = match sought {
            Sought::Mean => plain,
            Sought::Variance => {
                let centre = average(&plain);
                self.expectation(&at, |y| (y - centre) * (y - centre))
            }
            Sought::Probability(event) => self.expectation(&at, |y| f64::from(event.holds(y))),
            Sought::Quantile(_) => return None,
        };
        let none = vec![0.0; of_replicates.len()];
        Some(direction.sign() * beyond(&of_replicates, &none, direction, confidence))
    }
}

/// By how much the mean of one number a replicate may lie beyond that of others, from the differences of both.
fn beyond(at: &[f64], other: &[f64], direction: Direction, confidence: &Confidence) -> f64 {
    let differences: Vec<f64> = at.iter().zip(other).map(|(a, b)| a - b).collect();
    let (below, above) = replicate_error(&differences, confidence);
    match direction {
        Direction::Maximum => average(&differences) + above,
        Direction::Minimum => below - average(&differences),
    }
}

fn average(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}
