//! Reading B: the epistemic inputs may differ from sample to sample, in any relation to the random ones.
//!
//! For every sample x the response lies anywhere from g_lo(x) = min over u of g(x, u) to g_hi(x) = max; this is a random set.
//!
//! ```text
//! belief P(g_hi <= y) <= P(Y <= y) <= plausibility P(g_lo <= y),   E g_lo <= E Y <= E g_hi,
//! Var <= min over c of E max((g_lo - c)², (g_hi - c)²),   Var >= min over c of E dist(c, [g_lo, g_hi])²
//! ```
//!
//! The two bounds of the variance are attained: for each c the extreme of (Y - c)² is taken sample by sample, and mean square distance and
//! choice of Y change places (M. Sion 1958). A. P. Dempster, "Upper and lower probabilities induced by a multivalued mapping",
//! Annals of Mathematical Statistics 38 (1967) 325-339. The extremes are taken over the outer points for every sample by itself; how much
//! further a model of the response over u lets each of them go is conceded as the error of the search.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::assemble::{Evidence, Part};
use super::bound::{Bound, BoundError};
use super::combine::Parts;
use super::measure::Event;
use super::moments::mean;
use super::probability::share;
use super::sample::{Estimate, Sample};
use super::search::{Direction, Search};
use super::spread::golden;
use super::statistic::Statistic;
use super::table::{Purpose, SampleTable};
use super::target::{Target, TargetKind};

/// The ends of the response in one part, sample by sample: as attained, and as far as the models let them go.
struct Ends {
    mass: f64,
    attained: [Sample; 2],
    widened: [Sample; 2],
}

impl Ends {
    /// Whether a model lets a run go anywhere that was finished at every point.
    fn are_unlimited(&self) -> bool {
        let [attained, widened] = [&self.attained, &self.widened].map(|ends| ends[0].failed() + ends[1].failed());
        widened > attained
    }
}

/// Least and greatest response of one run: attained, and as far as a model lets them go.
type EndsOfRun = ([f64; 2], [f64; 2]);

/// The random set of one column.
pub(super) struct RandomSet {
    elements: Vec<Ends>,
}

/// Every value of a column, by outer point, in the order of the inner runs, and the replicate of each of these; not a number where
/// a run failed. A sample that has grown lies in the table in parts.
pub(super) fn values_by_run(table: &SampleTable, column: usize) -> (Vec<u32>, Vec<Vec<f64>>) {
    let mut points: BTreeMap<u32, BTreeMap<(u32, u32), f64>> = BTreeMap::new();
    for (run, inputs) in table.inputs().iter().enumerate() {
        if inputs.purpose == Purpose::DoubleLoop {
            let values = points.entry(inputs.point).or_default();
            values.insert((inputs.replicate, inputs.index), table.values(run)[column]);
        }
    }
    let first = points.values().next();
    let replicates = first.map_or_else(Vec::new, |values| values.keys().map(|&(replicate, _)| replicate).collect());
    (replicates, points.into_values().map(|values| values.into_values().collect()).collect())
}

/// The response at one inner run over the outer points, as something to search.
pub(super) fn run_target(points: &[Vec<f64>], run: usize, resolution: f64) -> Target {
    let values = points.iter().map(|values| values.get(run).copied().unwrap_or(f64::NAN)).collect();
    Target { values, kind: TargetKind::Plain, noise_variance: 0.0, resolutions: [resolution; 2] }
}

impl RandomSet {
    /// The ends of `column` over `parts`.
    pub fn new(evidence: &Evidence<'_>, parts: &Parts<'_>, column: usize) -> Self {
        let (replicates, points) = values_by_run(evidence.table, column);
        let targets: Vec<Target> =
            (0..replicates.len()).map(|run| run_target(&points, run, f64::MIN_POSITIVE)).collect();
        let has_box = evidence.plan.epistemic_box().dimensions() > 0;
        let search =
            Search::new(evidence.plan.epistemic_box().axes(), &evidence.places, evidence.plan.candidates(), &targets);
        let ends = |part: &Part<'_>, target: &Target| -> EndsOfRun {
            // A run that failed anywhere may have gone anywhere there.
            if part.members.iter().any(|&point| !target.values[point].is_finite()) || part.members.is_empty() {
                return ([f64::NAN; 2], [f64::NAN; 2]);
            }
            let branches = if has_box { search.branches(target) } else { Vec::new() };
            let ends = Direction::BOTH.map(|direction| {
                let values = part.members.iter().map(|&point| target.values[point]);
                let attained = values.reduce(|a, b| if direction.is_beyond(b, a) { b } else { a }).unwrap_or(f64::NAN);
                let reach =
                    if has_box { search.furthest_reach(target, &branches, direction, part.region) } else { attained };
                (attained, if direction.is_beyond(reach, attained) { reach } else { attained })
            });
            ([ends[0].0, ends[1].0], [ends[0].1, ends[1].1])
        };
        let elements = parts.parts.iter().map(|(mass, part)| {
            let found: Vec<EndsOfRun> = targets.par_iter().map(|target| ends(part, target)).collect();
            let sample = |of: &dyn Fn(&EndsOfRun) -> f64| {
                let mut by_replicate: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
                for (ends, replicate) in found.iter().zip(&replicates) {
                    by_replicate.entry(*replicate).or_default().push(of(ends));
                }
                Sample::new(by_replicate.into_values().map(Vec::into_iter))
            };
            Ends {
                mass: *mass,
                attained: [sample(&|ends| ends.0[0]), sample(&|ends| ends.0[1])],
                widened: [sample(&|ends| ends.1[0]), sample(&|ends| ends.1[1])],
            }
        });
        Self { elements: elements.collect() }
    }

    /// Both ends of `statistic`, which is not a whole distribution function.
    pub fn bounds(&self, evidence: &Evidence<'_>, statistic: Statistic) -> [Bound; 2] {
        Direction::BOTH.map(|direction| match statistic {
            Statistic::Mean => {
                let confidence = evidence.plan.confidence();
                self.added(evidence, direction, |[low, high]| {
                    mean(if direction == Direction::Minimum { low } else { high }, confidence)
                })
            }
            Statistic::StandardDeviation => self.deviation(evidence, direction),
            Statistic::Quantile(probability) => self.quantile(evidence, probability, direction),
            Statistic::ProbabilityAbove(limit) => self.probability(evidence, Event::Above(limit), direction),
            Statistic::ProbabilityBelow(limit) => self.probability(evidence, Event::Below(limit), direction),
            Statistic::ProbabilityBeyond(limit) => self.probability(evidence, Event::Beyond(limit), direction),
            Statistic::Cdf | Statistic::SimultaneousBand(_) => evidence.nothing(direction),
        })
    }

    /// Belief (minimum) or plausibility (maximum) of `event`.
    pub fn probability(&self, evidence: &Evidence<'_>, event: Event, direction: Direction) -> Bound {
        let confidence = evidence.plan.confidence();
        let bound = self.added(evidence, direction, |[low, high]| {
            // The end that has the event if all of the set has it, or if any of it has.
            let hit = |low: f64, high: f64| {
                let is_sure = direction == Direction::Minimum;
                match event {
                    Event::Above(_) => event.holds(if is_sure { low } else { high }),
                    Event::Below(_) | Event::UpTo(_) => event.holds(if is_sure { high } else { low }),
                    Event::Beyond(limit) if is_sure => low > limit || high < -limit,
                    Event::Beyond(_) => event.holds(low) || event.holds(high),
                }
            };
            let hits = low.joined(high, |low, high| if hit(low, high) { 1.0 } else { 0.0 });
            let share = share(&hits, confidence, |hit| hit > 0.5);
            if direction == Direction::Minimum { share.low } else { share.high }
        });
        Bound { widened: bound.widened.clamp(0.0, 1.0), ..bound }
    }

    /// Σ mass x estimate, from the attained and the widened ends.
    fn added(
        &self,
        evidence: &Evidence<'_>,
        direction: Direction,
        estimate: impl Fn(&[Sample; 2]) -> Estimate,
    ) -> Bound {
        let of_element = |ends: &Ends| {
            let attained = estimate(&ends.attained);
            let unlimited = Estimate::symmetric(direction.sign() * f64::INFINITY, 0.0);
            let widened = if ends.are_unlimited() { unlimited } else { estimate(&ends.widened) };
            let sampling = if direction == Direction::Minimum { widened.below } else { widened.above };
            let optimisation = (direction.sign() * (widened.value - attained.value)).max(0.0);
            let error = BoundError { sampling, optimisation, surrogate: 0.0 };
            let total = direction.sign() * error.total();
            let widened =
                if attained.value.is_nan() { direction.sign() * f64::INFINITY } else { attained.value + total };
            let bound = Bound { value: attained.value, widened, witness: None, error, guarantee: evidence.guarantee() };
            (ends.mass, bound)
        };
        Bound::sum(self.elements.iter().map(of_element)).unwrap_or_else(|| evidence.nothing(direction))
    }

    /// The quantile of the lower ends (minimum) or of the upper ends (maximum).
    fn quantile(&self, evidence: &Evidence<'_>, probability: f64, direction: Direction) -> Bound {
        let confidence = evidence.plan.confidence();
        let end = direction.index();
        // The added share of ends up to y, moved by its sampling error against the probability sought.
        let added = |y: f64, is_widened: bool| -> f64 {
            let of_element = |ends: &Ends| {
                let sample = if is_widened { &ends.widened[end] } else { &ends.attained[end] };
                let share = share(sample, confidence, |value| value <= y);
                let moved = match direction {
                    Direction::Minimum => share.high.value + if is_widened { share.high.above } else { 0.0 },
                    Direction::Maximum => share.low.value - if is_widened { share.low.below } else { 0.0 },
                };
                ends.mass * moved
            };
            self.elements.iter().map(of_element).sum()
        };
        let find = |is_widened: bool| -> f64 {
            let samples = self.elements.iter().map(|e| if is_widened { &e.widened[end] } else { &e.attained[end] });
            let mut values: Vec<f64> = samples.flat_map(|sample| sample.values().iter().copied()).collect();
            values.sort_unstable_by(f64::total_cmp);
            let index = values.partition_point(|&y| added(y, is_widened) < probability);
            match direction {
                Direction::Minimum if index == 0 && added(f64::NEG_INFINITY, is_widened) >= probability => {
                    f64::NEG_INFINITY
                }
                _ => values.get(index).copied().unwrap_or(f64::INFINITY),
            }
        };
        if self.elements.iter().all(|ends| ends.attained[end].values().is_empty()) {
            return evidence.nothing(direction);
        }
        let (value, widened) = (find(false), find(true));
        let total = if value == widened { 0.0 } else { (direction.sign() * (widened - value)).max(0.0) };
        // What the search concedes of it: the shift of the ends themselves.
        let shift = self.elements.iter().map(|ends| {
            let means = [&ends.widened[end], &ends.attained[end]].map(|sample| mean(sample, confidence).value);
            ends.mass * (means[0] - means[1]).abs()
        });
        let optimisation = shift.sum::<f64>().min(total);
        let sampling = if total.is_finite() { total - optimisation } else { total };
        let error = BoundError { sampling, optimisation, surrogate: 0.0 };
        let bound = Bound {
            value,
            widened: value + direction.sign() * total,
            witness: None,
            error,
            guarantee: evidence.guarantee(),
        };
        let ends: Vec<&Sample> = self.elements.iter().flat_map(|ends| &ends.widened).collect();
        bound.within_responses(&ends, direction)
    }

    fn deviation(&self, evidence: &Evidence<'_>, direction: Direction) -> Bound {
        let confidence = evidence.plan.confidence();
        let square = |low: f64, high: f64, c: f64| match direction {
            Direction::Maximum => ((low - c) * (low - c)).max((high - c) * (high - c)),
            Direction::Minimum => {
                let distance = (low - c).max(c - high).max(0.0);
                distance * distance
            }
        };
        let estimate = |of: fn(&Ends) -> &[Sample; 2], c: f64| -> [f64; 2] {
            self.elements.iter().fold([0.0; 2], |[value, error], ends| {
                let [low, high] = of(ends);
                let squares = low.joined(high, |low, high| square(low, high, c));
                let at = mean(&squares, confidence);
                let own = if direction == Direction::Minimum { at.below } else { at.above };
                [value + ends.mass * at.value, error + ends.mass * own]
            })
        };
        let least = |of: fn(&Ends) -> &[Sample; 2]| -> [f64; 2] {
            let range = self.elements.iter().flat_map(of).filter_map(Sample::ends);
            let (low, high) =
                range.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (a, b)| (low.min(a), high.max(b)));
            estimate(of, golden(low, high, |c| estimate(of, c)[0]))
        };
        if self.elements.iter().any(Ends::are_unlimited) {
            return evidence.nothing(direction);
        }
        let [attained, _] = least(|ends| &ends.attained);
        let [widened, sampling] = least(|ends| &ends.widened);
        let sign = direction.sign();
        let root = |variance: f64| variance.max(0.0).sqrt();
        let value = root(attained);
        if !attained.is_finite() {
            return evidence.nothing(direction);
        }
        let optimisation = (sign * (root(widened) - value)).max(0.0);
        let moved = root(widened + sign * sampling);
        let sampling = (sign * (moved - value)).max(0.0) - optimisation;
        let error = BoundError { sampling: sampling.max(0.0), optimisation, surrogate: 0.0 };
        let end = value + sign * error.total();
        Bound { value, widened: end.max(0.0), witness: None, error, guarantee: evidence.guarantee() }
    }
}
