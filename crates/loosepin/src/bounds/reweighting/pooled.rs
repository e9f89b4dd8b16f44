//! One column of the pool: by how much its statistics may lie beyond those at an outer point.

use std::sync::Arc;

use rayon::prelude::*;

use super::ground::{Ground, Seen, View};
use crate::bounds::inner_basis::{CrossFit, Design};
use crate::bounds::measure::{Event, Sought};
use crate::bounds::moments::{mean, standard_deviation, variance};
use crate::bounds::probability::wilson;
use crate::bounds::quantile::quantile;
use crate::bounds::sample::{Confidence, Estimate, Sample, replicate_error};
use crate::bounds::search::Direction;
use crate::bounds::search_box::{Axes, Place, Region};
use crate::bounds::smooth::smooth;
use crate::uncertainty::RandomVariable;

/// Weights must be worth so many independent runs.
const LEAST_EFFECTIVE: f64 = 64.0;
/// Of these so many must lie beyond a quantile.
const LEAST_BEYOND: f64 = 4.0;
/// The furthest place is moved on by steps from the first length down to the last.
const FIRST_STEP: f64 = 0.05;
const LAST_STEP: f64 = 1e-4;
/// Polynomials of a higher degree only stand for a response that they follow everywhere.
const MOST_DEGREE_BESIDE: usize = 4;
/// A polynomial of a higher degree must leave less of the squares by this factor: else it follows what it should not.
const CLEARLY_LESS: f64 = 0.7;
/// Polynomials that leave no more than this share of the deviation of the pool at any run stand for the response; between the runs it
/// may be more, by the second factor.
const LARGEST_RESIDUAL: f64 = 1e-3;
const RESIDUAL_MARGIN: f64 = 2.0;
/// A share with fewer hits or misses in each replicate of the pool has no error from the spread of the replicates.
const LEAST_PER_REPLICATE: usize = 2;
/// Halvings of the range in which a quantile may lie.
const HALVINGS: usize = 30;

/// By how much a statistic may lie beyond at a place; nothing where the pool cannot tell.
type Gain<'s> = Box<dyn Fn(usize) -> Option<f64> + Sync + 's>;

/// One column of the pool.
#[derive(Debug)]
pub struct Pooled {
    view: Arc<View>,
    /// Values of the runs, replicate by replicate.
    values: Vec<f64>,
    /// Those of the polynomials, each replicate by the other ones.
    explained: Vec<f64>,
    /// The polynomials at points at each place, replicate by replicate.
    expected: Vec<Vec<f64>>,
    /// Where the polynomials stand for the response.
    smooth: Option<StandIn>,
}

/// Polynomials that stand for the response at every u.
#[derive(Debug)]
struct StandIn {
    ground: Arc<Ground>,
    design: Arc<Design>,
    fit: CrossFit,
    /// A sample at each place.
    samples: Vec<Sample>,
    /// How far the response may be from them.
    left: f64,
}

/// A place beyond an extreme, as far as is known.
#[derive(Debug, Clone)]
pub struct Beyond {
    /// How far the statistic may lie beyond that at the outer point, in units of what is searched; 0 where it does not.
    pub gain: f64,
    /// Where.
    pub place: Place,
}

impl StandIn {
    /// The sample at `variables`, without its polynomials.
    fn sample(ground: &Ground, by: (&Design, &CrossFit), variables: &[RandomVariable]) -> Sample {
        let values = ground.expected(by, variables, ground.each, false);
        Sample::new(values.chunks(ground.each).map(|own| own.iter().copied()))
    }

    /// The sample at `place`; nothing where the polynomials are not smooth there.
    fn at(&self, place: &Place) -> Option<Sample> {
        let ground = &self.ground;
        let epistemic = ground.epistemic_box.values_at(place);
        let variables: Option<Vec<RandomVariable>> =
            ground.moving.iter().map(|&input| ground.problem.variable_at(input, &epistemic)).collect();
        let mut sample = Self::sample(ground, (&self.design, &self.fit), &variables?);
        smooth(ground.basis.as_deref()?, &mut [&mut sample]);
        sample.smooth().is_some().then_some(sample)
    }
}

impl Pooled {
    /// One column; nothing where a run failed.
    pub fn new(ground: &Arc<Ground>, designs: &[Arc<Design>], view: &Arc<View>, samples: &[&Sample]) -> Option<Self> {
        if samples.iter().any(|sample| sample.failed() > 0) {
            return None;
        }
        let each = ground.each;
        let mut values = Vec::with_capacity(ground.drawn.len());
        for replicate in 0..ground.replicates {
            for sample in samples {
                values.extend_from_slice(&sample.values()[replicate * each..(replicate + 1) * each]);
            }
        }
        let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let spread = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>();
        let best = |most_degree: usize| {
            let mut least = spread;
            let mut best: Option<(&Arc<Design>, CrossFit)> = None;
            for design in designs.iter().filter(|design| design.degree <= most_degree) {
                let fit = design.fit(&values);
                let left = square(&fit.residuals);
                if left < CLEARLY_LESS * least {
                    least = left;
                    best = Some((design, fit));
                }
            }
            best
        };
        let places = 0..view.seen.len();
        let deviation = (spread / values.len() as f64).sqrt();
        let is_asked = samples.iter().all(|sample| sample.smooth().is_some());
        if let Some((design, fit)) = is_asked.then(|| best(usize::MAX)).flatten() {
            let left = fit.residuals.iter().fold(0.0_f64, |most, left| most.max(left.abs()));
            let sample = |place: usize| StandIn::sample(ground, (design, &fit), &ground.variables[place]);
            if let Some(basis) = ground.basis.as_deref().filter(|_| left <= LARGEST_RESIDUAL * deviation) {
                let mut at: Vec<Sample> = places.clone().into_par_iter().map(sample).collect();
                smooth(basis, &mut at.iter_mut().collect::<Vec<_>>());
                if at.iter().all(|sample| sample.smooth().is_some()) {
                    let (design, left) = (design.clone(), RESIDUAL_MARGIN * left);
                    let smooth = Some(StandIn { ground: ground.clone(), design, fit, samples: at, left });
                    let (explained, expected) = (Vec::new(), Vec::new());
                    return Some(Self { view: view.clone(), values, explained, expected, smooth });
                }
            }
        }
        let Some((design, fit)) = best(MOST_DEGREE_BESIDE) else {
            let expected = vec![vec![mean; ground.points * ground.replicates]; view.seen.len()];
            let explained = vec![mean; values.len()];
            return Some(Self { view: view.clone(), values, explained, expected, smooth: None });
        };
        let explained = values.iter().zip(&fit.residuals).map(|(value, left)| value - left).collect();
        let at = |place: usize| ground.expected((design, &fit), &ground.variables[place], ground.points, true);
        let expected = places.into_par_iter().map(at).collect();
        Some(Self { view: view.clone(), values, explained, expected, smooth: None })
    }

    /// The weights.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Whether the polynomials stand for the response.
    pub fn is_smooth(&self) -> bool {
        self.smooth.is_some()
    }

    /// By how much the statistic of `sample` may lie beyond `value`, where the response is within `left` of it.
    fn smooth_gain(
        (sample, left): (&Sample, f64),
        sought: Sought,
        direction: Direction,
        value: f64,
        confidence: &Confidence,
    ) -> Option<f64> {
        let sign = direction.sign();
        let outward = |at: Estimate| {
            let error = if direction == Direction::Maximum { at.above } else { at.below };
            sign * at.value + error
        };
        let gain = match sought {
            Sought::Mean => outward(mean(sample, confidence)) + left - sign * value,
            Sought::Variance => {
                let deviation = (sign * (outward(standard_deviation(variance(sample, confidence))) + left)).max(0.0);
                sign * (deviation * deviation - value * value)
            }
            Sought::Quantile(probability) => {
                let at = quantile(sample, confidence, probability);
                outward(if direction == Direction::Maximum { at.high } else { at.low }) + left - sign * value
            }
            Sought::Probability(event) => {
                let smooth = sample.smooth()?;
                let moved = [left, -left].map(|shift| outward(smooth.probability(event, shift)));
                moved[0].max(moved[1]) - sign * value
            }
        };
        Some(gain)
    }

    /// E h(Y) at `place` as each replicate sees it.
    fn expectation(&self, place: usize, h: impl Fn(f64) -> f64) -> Vec<f64> {
        let View { replicates, runs, points, ref seen, .. } = *self.view;
        let weights = &seen[place].weights;
        let change = |run: usize| h(self.values[run]) - h(self.explained[run]);
        let total: f64 = weights.iter().enumerate().map(|(run, w)| w * change(run)).sum();
        (0..replicates)
            .map(|replicate| {
                let own = replicate * runs..(replicate + 1) * runs;
                let beyond: f64 = own.map(|run| weights[run] * (change(run) - total)).sum();
                let asked = &self.expected[place][replicate * points..(replicate + 1) * points];
                let expected = asked.iter().map(|&value| h(value)).sum::<f64>() / points as f64;
                expected + total + replicates as f64 * beyond
            })
            .collect()
    }

    /// Independent runs that the weights must be worth.
    fn needed(&self, sought: Sought) -> f64 {
        match sought {
            // Polynomials only need runs wherever they are asked.
            _ if self.is_smooth() => LEAST_EFFECTIVE,
            Sought::Quantile(probability) => (LEAST_BEYOND / probability.min(1.0 - probability)).max(LEAST_EFFECTIVE),
            Sought::Mean | Sought::Variance | Sought::Probability(_) => LEAST_EFFECTIVE,
        }
    }

    /// The place in `region` where the weights are worth least, if that is too little for the statistic.
    fn unseen(&self, sought: Sought, region: &Region) -> Option<&Seen> {
        let needed = self.needed(sought);
        let own = self.view.seen.iter().filter(|seen| region.holds(&seen.place.at) && seen.effective < needed);
        own.min_by(|a, b| a.effective.total_cmp(&b.effective))
    }

    /// Where the statistic, `value` at the outer point `witness`, goes furthest beyond that in `region`, errors conceded.
    ///
    /// # Errors
    ///
    /// A place at which the pool cannot tell.
    pub fn furthest(
        &self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        region: &Region,
        confidence: &Confidence,
    ) -> Result<Beyond, Place> {
        if let Some(seen) = self.unseen(sought, region) {
            return Err(seen.place.clone());
        }
        let places: Vec<usize> =
            (0..self.view.seen.len()).filter(|&k| region.holds(&self.view.seen[k].place.at)).collect();
        let gain: Gain<'_> = match &self.smooth {
            Some(stand_in) => Box::new(move |place| {
                // The runs at an outer point speak for themselves.
                if place < self.view.outer {
                    return Some(0.0);
                }
                let sample = (&stand_in.samples[place], stand_in.left);
                Self::smooth_gain(sample, sought, direction, value, confidence)
            }),
            None => self.weighted_gain(sought, direction, (witness, value), confidence),
        };
        let gains: Result<Vec<f64>, Place> =
            places.par_iter().map(|&place| gain(place).ok_or_else(|| self.view.seen[place].place.clone())).collect();
        let mut beyond = Beyond { gain: 0.0, place: self.view.seen[witness].place.clone() };
        for (&place, gain) in places.iter().zip(gains?) {
            if gain > beyond.gain {
                beyond = Beyond { gain, place: self.view.seen[place].place.clone() };
            }
        }
        if let Some(stand_in) = &self.smooth {
            let gain = |place: &Place| {
                let sample = stand_in.at(place)?;
                Self::smooth_gain((&sample, stand_in.left), sought, direction, value, confidence)
            };
            // From the outer point as well, whose own gain is 0 by its runs.
            let mut from = vec![self.view.seen[witness].place.clone()];
            if beyond.place != from[0] {
                from.push(beyond.place.clone());
            }
            for place in from {
                let climbed = climb(stand_in.ground.epistemic_box.axes(), place, region, &gain);
                if climbed.gain > beyond.gain {
                    beyond = climbed;
                }
            }
        }
        Ok(beyond)
    }

    /// How far `h` of the response may go in `direction` at the outer point `witness` itself, in units of what is searched, by the runs of
    /// all points: those at this point alone may agree by chance (each replicate of a stratified sample meets a jump as often as the
    /// others). Nothing where polynomials stand for the response, and for shares, whose errors know that.
    pub fn outermost(
        &self,
        sought: Sought,
        direction: Direction,
        witness: usize,
        confidence: &Confidence,
    ) -> Option<f64> {
        if self.is_smooth() {
            return None;
        }
        let plain = self.expectation(witness, |y| y);
        let at = match sought {
            Sought::Mean => plain,
            Sought::Variance => {
                let centre = average(&plain);
                self.expectation(witness, |y| (y - centre) * (y - centre))
            }
            Sought::Quantile(_) | Sought::Probability(_) => return None,
        };
        Some(direction.sign() * beyond(&at, &vec![0.0; at.len()], direction, confidence))
    }

    fn weighted_gain<'s>(
        &'s self,
        sought: Sought,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
    ) -> Gain<'s> {
        match sought {
            Sought::Mean => self.gain(direction, witness, confidence, |_| Some(|y: f64| y)),
            Sought::Variance => self.gain(direction, witness, confidence, |place| {
                let centre = average(&self.expectation(place, |y| y));
                Some(move |y: f64| (y - centre) * (y - centre))
            }),
            Sought::Probability(event) => self.share_gain(direction, witness, confidence, event),
            Sought::Quantile(_) => self.quantile_gain(direction, (witness, value), confidence),
        }
    }

    /// By how much E h(Y) may lie beyond that at `witness`.
    fn gain<'s, H: Fn(f64) -> f64 + 's>(
        &'s self,
        direction: Direction,
        witness: usize,
        confidence: &'s Confidence,
        h: impl Fn(usize) -> Option<H> + Sync + 's,
    ) -> Gain<'s> {
        let at_witness = h(witness).map(|h| self.expectation(witness, h));
        Box::new(move |place| {
            Some(beyond(&self.expectation(place, h(place)?), at_witness.as_ref()?, direction, confidence))
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
        let hits = self.values.iter().filter(|&&value| event.holds(value)).count();
        let least = LEAST_PER_REPLICATE * self.view.replicates;
        if hits < least || self.values.len() - hits < least {
            return Box::new(|_| None);
        }
        let indicator = move |y: f64| if event.holds(y) { 1.0 } else { 0.0 };
        let paired = self.gain(direction, witness, confidence, move |_| Some(indicator));
        let at_witness = average(&self.expectation(witness, indicator));
        Box::new(move |place| {
            // Where hardly any weight lies on hits the spread of the replicates is too small: not less than as many independent runs.
            let seen = &self.view.seen[place];
            let weight = |k: usize| {
                let own = self.view.seen[k].weights.iter().zip(&self.values);
                own.filter(|(_, value)| event.holds(**value)).map(|(w, _)| w).sum::<f64>()
            };
            let share = weight(place);
            let independent = wilson(share, seen.effective, confidence.normal);
            let is_counted = (share.min(1.0 - share) * seen.effective) >= least as f64;
            let far = if is_counted || place == witness {
                0.0
            } else {
                match direction {
                    Direction::Maximum => independent.1 - at_witness,
                    Direction::Minimum => at_witness - independent.0,
                }
            };
            Some(paired(place)?.max(far))
        })
    }

    /// How far the quantile may lie beyond `value`, that at `witness`: the distribution function there, its error conceded, must have
    /// reached the probability.
    fn quantile_gain<'s>(
        &'s self,
        direction: Direction,
        (witness, value): (usize, f64),
        confidence: &'s Confidence,
    ) -> Gain<'s> {
        let indicator = |limit: f64| move |y: f64| if y <= limit { 1.0 } else { 0.0 };
        let at_witness = self.expectation(witness, indicator(value));
        let sign = direction.sign();
        let outermost =
            self.values.iter().chain(self.expected.iter().flatten()).map(|y| sign * y).fold(f64::MIN, f64::max);
        Box::new(move |place| {
            if place == witness {
                return Some(0.0);
            }
            let opposite = if direction == Direction::Maximum { Direction::Minimum } else { Direction::Maximum };
            // F(x) at the place less that of `value` at the witness, which is the probability.
            let is_reached =
                |x: f64| beyond(&self.expectation(place, indicator(x)), &at_witness, opposite, confidence) <= 0.0;
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
}

/// The nearest place of `region` from which no step along an axis gains; it gains without limit where nothing is known.
fn climb(axes: &Axes, mut place: Place, region: &Region, gain: &impl Fn(&Place) -> Option<f64>) -> Beyond {
    let gain = |place: &Place| gain(place).unwrap_or(f64::INFINITY);
    let mut best = gain(&place);
    let mut step = FIRST_STEP;
    while step >= LAST_STEP {
        let mut has_moved = false;
        for axis in 0..place.at.len() {
            for signed in [step, -step] {
                let mut trial = place.clone();
                trial.at[axis] = axes.inside(axis, trial.at[axis] + signed, [region.lower[axis], region.upper[axis]]);
                if trial.at[axis] == place.at[axis] {
                    continue;
                }
                let at_trial = gain(&trial);
                if at_trial > best {
                    (best, place, has_moved) = (at_trial, trial, true);
                    break;
                }
            }
        }
        if !has_moved {
            step *= 0.25;
        }
    }
    Beyond { gain: best, place }
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
