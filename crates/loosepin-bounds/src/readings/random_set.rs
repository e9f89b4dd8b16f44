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

use super::deviation::golden_section_minimum;
use super::experiment::{Experiment, Focal};
use crate::data::bound::{Bound, BoundError, BoundPair};
use crate::data::direction::{Direction, range_of};
use crate::data::problem::Request;
use crate::data::table::{Purpose, SampleTable};
use crate::estimators::estimate::{Confidence, Estimate, FailureExtremes};
use crate::estimators::moments::mean;
use crate::estimators::probability::share;
use crate::estimators::sample::Sample;
use crate::parallel;
use crate::search::models::noise::Noise;
use crate::search::target::{Target, TargetKind};
use loosepin_math::{sort_ascending, sort_by_number};
use loosepin_terms::{Estimation, Event, Statistic};

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
pub(crate) struct RandomSet {
    elements: Vec<Ends>,
}

/// Every value of a column, by outer point, in the order of the inner runs, and the replicate of each of these; NaN if
/// a run failed. A sample that has grown lies in the table in parts.
pub(crate) fn values_by_run(table: &SampleTable, column: usize) -> (Vec<u32>, Vec<Vec<f64>>) {
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
pub(crate) fn run_target(points: &[Vec<f64>], run: usize, resolution: f64) -> Target {
    let values = points.iter().map(|values| values.get(run).copied().unwrap_or(f64::NAN)).collect();
    Target { values, kind: TargetKind::Plain, noise: Noise::NONE, resolutions: [resolution; 2] }
}

impl Experiment<'_> {
    /// Belief and plausibility, and what else the random set says, of all `requests` over `elements`.
    pub fn pairs_of_random_set(&self, requests: &[Request], elements: &[Focal<'_>]) -> Vec<BoundPair> {
        let mut columns: Vec<usize> = requests.iter().map(|request| request.column).collect();
        columns.sort_unstable();
        columns.dedup();
        let centre = self.centre(elements);
        let of_column = |&column: &usize| {
            let set = RandomSet::new(self, elements, column);
            let at_centre = centre.map(|point| RandomSet::at(self.pool.samples(column)[point]));
            let failed_runs = self.failed_runs(column);
            let own = requests.iter().enumerate().filter(move |(_, request)| request.column == column);
            let pair = |(place, request): (usize, &Request)| {
                let ends = set.bounds(self, request.statistic);
                // The ends of a sample that failed somewhere are not known.
                let seen = match request.statistic.event() {
                    Some(event) if failed_runs == 0 => set.attained_lower_limits(self, event),
                    _ => Vec::new(),
                };
                let central = at_centre.as_ref().map(|set| set.bounds(self, request.statistic).map(|end| end.value));
                (place, BoundPair { seen, central, ..BoundPair::new(column, request.statistic, ends, failed_runs) })
            };
            own.map(pair).collect::<Vec<_>>()
        };
        let mut pairs: Vec<(usize, BoundPair)> = parallel::flat_map(&columns, of_column);
        sort_by_number(&mut pairs, |(place, _)| *place as f64);
        pairs.into_iter().map(|(_, pair)| pair).collect()
    }
}

impl RandomSet {
    /// The ends of `column` over `elements`.
    pub fn new(experiment: &Experiment<'_>, elements: &[Focal<'_>], column: usize) -> Self {
        let (replicates, points) = values_by_run(experiment.table, column);
        let targets: Vec<Target> =
            (0..replicates.len()).map(|run| run_target(&points, run, f64::MIN_POSITIVE)).collect();
        let has_box = !experiment.setup.has_no_epistemic_inputs();
        let search = experiment.search_targets(&targets);
        let ends = |element: &Focal<'_>, target: &Target| -> EndsOfRun {
            // A run that failed anywhere may have gone anywhere there.
            let members = &element.members;
            if members.iter().any(|&point| !target.values[point].is_finite()) || members.is_empty() {
                return ([f64::NAN; 2], [f64::NAN; 2]);
            }
            let branches = if has_box { search.branches(target) } else { Vec::new() };
            let ends = Direction::BOTH.map(|direction| {
                let values = members.iter().map(|&point| target.values[point]);
                let attained = values.reduce(|a, b| direction.further(a, b)).unwrap_or(f64::NAN);
                if !has_box {
                    return (attained, attained);
                }
                let reach = search.furthest_reach(target, &branches, direction, element.region);
                (attained, direction.further(attained, reach))
            });
            ([ends[0].0, ends[1].0], [ends[0].1, ends[1].1])
        };
        let elements = elements.iter().map(|element| {
            let found: Vec<EndsOfRun> = parallel::map(&targets, |target| ends(element, target));
            let sample = |of: &dyn Fn(&EndsOfRun) -> f64| {
                let mut by_replicate: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
                for (ends, replicate) in found.iter().zip(&replicates) {
                    by_replicate.entry(*replicate).or_default().push(of(ends));
                }
                Sample::new(by_replicate.into_values().map(Vec::into_iter))
            };
            Ends {
                mass: element.mass,
                attained: [sample(&|ends| ends.0[0]), sample(&|ends| ends.0[1])],
                widened: [sample(&|ends| ends.1[0]), sample(&|ends| ends.1[1])],
            }
        });
        Self { elements: elements.collect() }
    }

    /// The random set of the runs at a single outer point: both ends are the response itself.
    fn at(sample: &Sample) -> Self {
        // The ends of a random set have no polynomials.
        let counted = sample.joined(sample, |value, _| value);
        let ends = [counted.clone(), counted];
        Self { elements: vec![Ends { mass: 1.0, attained: ends.clone(), widened: ends }] }
    }

    /// Both ends of `statistic`, which is one number.
    pub fn bounds(&self, experiment: &Experiment<'_>, statistic: Statistic) -> [Bound; 2] {
        Direction::BOTH.map(|direction| match statistic.estimation() {
            Some(Estimation::Mean) => {
                let confidence = &experiment.setup.confidence;
                self.added(experiment, direction, |[low, high]| mean(direction.of(low, high), confidence))
            }
            Some(Estimation::RootOfVariance) => self.deviation(experiment, direction),
            Some(Estimation::Ordered(probability)) => self.quantile(experiment, probability, direction),
            Some(Estimation::Counted(event)) => self.probability(experiment, event, direction),
            // What a random set does to it is not known.
            Some(Estimation::Sampled) | None => experiment.unknown_of(statistic, direction),
        })
    }

    /// Belief (minimum) or plausibility (maximum) of `event`.
    pub fn probability(&self, experiment: &Experiment<'_>, event: Event, direction: Direction) -> Bound {
        let bound = self.added(experiment, direction, |ends| {
            let share = share_of(ends, event, direction, &experiment.setup.confidence);
            direction.of(share.low, share.high)
        });
        Bound { widened: bound.widened.clamp(0.0, 1.0), ..bound }
    }

    /// The lower ends of the confidence intervals of belief and plausibility, from the attained ends.
    fn attained_lower_limits(&self, experiment: &Experiment<'_>, event: Event) -> Vec<f64> {
        let of = |direction| {
            let of_element = |ends: &Ends| {
                let share = share_of(&ends.attained, event, direction, &experiment.setup.confidence);
                ends.mass * share.low.lower_limit()
            };
            self.elements.iter().map(of_element).sum()
        };
        Direction::BOTH.map(of).to_vec()
    }

    /// Σ mass x estimate, from the attained and the widened ends.
    fn added(
        &self,
        experiment: &Experiment<'_>,
        direction: Direction,
        estimate: impl Fn(&[Sample; 2]) -> Estimate,
    ) -> Bound {
        let of_element = |ends: &Ends| {
            let attained = estimate(&ends.attained);
            let unlimited = Estimate::symmetric(direction.sign() * f64::INFINITY, 0.0);
            let widened = if ends.are_unlimited() { unlimited } else { estimate(&ends.widened) };
            let sampling = direction.of(widened.below, widened.above);
            let optimisation = (direction.sign() * (widened.value - attained.value)).max(0.0);
            let error = BoundError::of_runs(sampling, optimisation);
            let widened = error.widen(attained.value, direction);
            let bound = Bound::without_witness(attained.value, widened, error, experiment.guarantee());
            (ends.mass, bound)
        };
        Bound::sum(self.elements.iter().map(of_element)).unwrap_or_else(|| experiment.unknown(direction))
    }

    /// The quantile of the lower ends (minimum) or of the upper ends (maximum).
    pub fn quantile(&self, experiment: &Experiment<'_>, probability: f64, direction: Direction) -> Bound {
        let confidence = &experiment.setup.confidence;
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
            sort_ascending(&mut values);
            let index = values.partition_point(|&y| added(y, is_widened) < probability);
            match direction {
                Direction::Minimum if index == 0 && added(f64::NEG_INFINITY, is_widened) >= probability => {
                    f64::NEG_INFINITY
                }
                _ => values.get(index).copied().unwrap_or(f64::INFINITY),
            }
        };
        if self.elements.iter().all(|ends| ends.attained[end].values().is_empty()) {
            return experiment.unknown(direction);
        }
        let (value, widened) = (find(false), find(true));
        let total = if value == widened { 0.0 } else { (direction.sign() * (widened - value)).max(0.0) };
        // What the search concedes of it: the shift of the ends themselves.
        let shift = self.elements.iter().map(|ends| {
            let means = [&ends.widened[end], &ends.attained[end]].map(|sample| mean(sample, confidence).value);
            ends.mass * (means[0] - means[1]).abs()
        });
        let optimisation = shift.sum::<f64>().min(total);
        let error = BoundError::with_optimisation(total, optimisation);
        Bound::without_witness(value, value + direction.sign() * total, error, experiment.guarantee())
    }

    fn deviation(&self, experiment: &Experiment<'_>, direction: Direction) -> Bound {
        let confidence = &experiment.setup.confidence;
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
                let own = direction.of(at.below, at.above);
                [value + ends.mass * at.value, error + ends.mass * own]
            })
        };
        let least = |of: fn(&Ends) -> &[Sample; 2]| -> [f64; 2] {
            let (low, high) =
                range_of(self.elements.iter().flat_map(of).filter_map(Sample::ends).flat_map(|(a, b)| [a, b]));
            estimate(of, golden_section_minimum(low, high, |c| estimate(of, c)[0]))
        };
        if self.elements.iter().any(Ends::are_unlimited) {
            return experiment.unknown(direction);
        }
        let [attained, _] = least(|ends| &ends.attained);
        let [widened, sampling] = least(|ends| &ends.widened);
        let sign = direction.sign();
        let root = |variance: f64| variance.max(0.0).sqrt();
        let value = root(attained);
        if !attained.is_finite() {
            return experiment.unknown(direction);
        }
        let optimisation = (sign * (root(widened) - value)).max(0.0);
        let moved = root(widened + sign * sampling);
        let sampling = (sign * (moved - value)).max(0.0) - optimisation;
        let error = BoundError::of_runs(sampling.max(0.0), optimisation);
        Bound::without_witness(value, error.widen(value, direction).max(0.0), error, experiment.guarantee())
    }
}

/// The share of runs in whose ends [low, high] `event` is sure (minimum) or possible (maximum).
fn share_of([low, high]: &[Sample; 2], event: Event, direction: Direction, confidence: &Confidence) -> FailureExtremes {
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
    share(&hits, confidence, |hit| hit > 0.5)
}
