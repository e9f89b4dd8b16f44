//! Quantiles of distribution functions that are added over focal elements.

use std::collections::BTreeMap;

use super::experiment::{Experiment, Focal};
use super::interval::Modelled;
use crate::data::bound::{Bound, BoundError};
use crate::data::direction::Direction;
use crate::estimators::sample::Sample;
use crate::measures::mean::Mean;
use crate::measures::measure::{Estimator, Measure};
use crate::measures::probability::Probability;
use crate::parallel;
use crate::search::target::Target;
use loosepin_math::{sort_ascending, sort_by_number};
use loosepin_terms::Event;

/// After this many attempts to find a value that a quantile certainly does not exceed, the range of the response is conceded.
const MAX_ATTEMPTS: usize = 6;

/// A quantile is located to this share of the range of all runs.
const QUANTILE_RESOLUTION: f64 = 1e-9;

/// Masses that were divided by their sum add up to 1 within this.
const MASS_ROUND_OFF: f64 = 1e-12;

/// Each attempt after the second concedes more by this factor.
const MORE: f64 = 1.5;

/// A quantile of one column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct QuantileJob {
    pub column: usize,
    pub probability: f64,
    pub direction: Direction,
}

/// The event whose probability decides whether `y` is an end of a quantile: up to y for the upper end, below y for the lower.
fn quantile_event(y: f64, direction: Direction) -> Event {
    match direction {
        Direction::Maximum => Event::UpTo(y),
        Direction::Minimum => Event::Below(y),
    }
}

/// The finished values of one column, sorted, at every outer point and all together.
struct Sorted {
    points: Vec<Vec<f64>>,
    all: Vec<f64>,
}

impl Sorted {
    fn new(samples: &[&Sample]) -> Self {
        let points: Vec<Vec<f64>> = samples.iter().map(|sample| sample.sorted()).collect();
        let mut all: Vec<f64> = points.iter().flatten().copied().collect();
        sort_ascending(&mut all);
        all.dedup();
        Self { points, all }
    }

    /// The added distribution function at `y` as it has been attained: in every part the extreme over its points, failed runs
    /// taken the way that goes further.
    fn cdf(&self, samples: &[&Sample], elements: &[Focal<'_>], y: f64, direction: Direction) -> f64 {
        let event = quantile_event(y, direction.opposite());
        let share = |point: usize| {
            if let Some(smooth) = samples[point].smooth() {
                return smooth.probability(event, 0.0).value;
            }
            let hits = self.points[point].partition_point(|&value| event.holds(value));
            let failed = direction.of(0, samples[point].failed());
            (hits + failed) as f64 / samples[point].runs().max(1) as f64
        };
        let furthest = |element: &Focal<'_>| {
            let shares = element.members.iter().map(|&point| share(point));
            shares.reduce(|a, b| direction.further(a, b)).unwrap_or(direction.of(0.0, 1.0))
        };
        elements.iter().map(|element| element.mass * furthest(element)).sum()
    }

    /// The end of the quantile at `probability`: the least value at which the added lower distribution function reaches it (upper
    /// end), or the greatest below which the added upper one stays short of it (lower end); infinite where no value does.
    fn quantile(&self, samples: &[&Sample], elements: &[Focal<'_>], probability: f64, direction: Direction) -> f64 {
        if samples.iter().all(|sample| sample.smooth().is_some()) {
            return self.smooth_quantile(samples, elements, probability, direction);
        }
        match direction {
            Direction::Maximum => {
                let cdf = |y: f64| self.cdf(samples, elements, y, Direction::Minimum);
                let index = self.all.partition_point(|&y| cdf(y) < probability);
                self.all.get(index).copied().unwrap_or(f64::INFINITY)
            }
            Direction::Minimum => {
                let below = |y: f64| self.cdf(samples, elements, y, Direction::Maximum);
                if self.all.first().is_none_or(|&first| probability > 0.0 && below(first) >= probability) {
                    return f64::NEG_INFINITY;
                }
                let index = self.all.partition_point(|&y| below(y) < probability);
                // Where more is conceded than the probability itself, the least value of all is tried.
                self.all[index.saturating_sub(1)]
            }
        }
    }
}

impl Sorted {
    /// The end of the quantile for responses that are smooth in the random inputs, whose distribution functions do not step: halvings of the range of
    /// all runs and as much again on either side.
    fn smooth_quantile(
        &self,
        samples: &[&Sample],
        elements: &[Focal<'_>],
        probability: f64,
        direction: Direction,
    ) -> f64 {
        let outward = direction.sign() * f64::INFINITY;
        let (Some(&first), Some(&last)) = (self.all.first(), self.all.last()) else { return outward };
        let range = last - first;
        let (mut low, mut high) = (first - range, last + range);
        let is_reached = |y: f64| self.cdf(samples, elements, y, direction.opposite()) >= probability;
        if probability <= 0.0 || probability >= 1.0 || is_reached(low) || !is_reached(high) {
            return outward;
        }
        while high - low > QUANTILE_RESOLUTION * range {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if is_reached(middle) { high = middle } else { low = middle }
        }
        direction.of(low, high)
    }
}

/// How far a quantile has come.
struct Attempt {
    value: f64,
    at: f64,
    conceded: f64,
    /// Sampling and optimisation error of the distribution function at the value.
    errors: Option<[f64; 2]>,
    widened: Option<f64>,
}

impl Experiment<'_> {
    /// Quantiles of the added distribution functions. What is attained inverts the functions attained; the widened end is a value
    /// at which the widened functions have been evaluated and found beyond the probability.
    pub fn quantiles(&self, jobs: &[QuantileJob], elements: &[Focal<'_>]) -> Vec<Bound> {
        if self.setup.problem.random.is_empty() {
            return jobs.iter().map(|job| self.quantile_without_scatter(job, elements)).collect();
        }
        let mut columns: Vec<usize> = jobs.iter().map(|job| job.column).collect();
        columns.sort_unstable();
        columns.dedup();
        let sorted: BTreeMap<usize, Sorted> =
            parallel::map(&columns, |&column| (column, Sorted::new(&self.pool.samples(column)))).into_iter().collect();
        let quantile = |job: &QuantileJob, probability: f64| {
            sorted[&job.column].quantile(&self.pool.samples(job.column), elements, probability, job.direction)
        };
        let mut attempts: Vec<Attempt> = parallel::map(jobs, |job| {
            let value = quantile(job, job.probability);
            let widened = (!value.is_finite()).then_some(value);
            Attempt { value, at: value, conceded: 0.0, errors: None, widened }
        });
        for attempt in 0..MAX_ATTEMPTS {
            let pending: Vec<usize> = (0..jobs.len()).filter(|&job| attempts[job].widened.is_none()).collect();
            if pending.is_empty() {
                break;
            }
            let measures: Vec<Measure> = parallel::map(&pending, |&job| {
                let samples = self.pool.samples(jobs[job].column);
                let event = quantile_event(attempts[job].at, jobs[job].direction);
                Probability(event).measure(&samples, &self.setup.confidence)
            });
            let search = self.search(measures.iter());
            let found: Vec<(Bound, f64)> = parallel::map_indices(pending.len(), |place| {
                let (index, measure) = (pending[place], &measures[place]);
                let job = &jobs[index];
                let samples = self.pool.samples(job.column);
                let direction = job.direction.opposite();
                let cdf = self.added(&Modelled::new(&search, measure, &samples), elements, direction);
                let reached = sorted[&job.column].cdf(&samples, elements, attempts[index].at, direction);
                let gap = (reached - cdf.widened).abs();
                (cdf, gap)
            });
            for (&index, (cdf, gap)) in pending.iter().zip(found) {
                let (job, attempt_of) = (&jobs[index], &mut attempts[index]);
                attempt_of.errors.get_or_insert([cdf.error.sampling, cdf.error.optimisation]);
                let is_beyond = match job.direction {
                    Direction::Maximum => cdf.widened >= job.probability,
                    Direction::Minimum => cdf.widened <= job.probability,
                };
                if is_beyond {
                    attempt_of.widened = Some(attempt_of.at);
                    continue;
                }
                let more = if attempt == 0 { gap } else { (MORE * attempt_of.conceded).max(gap) };
                attempt_of.conceded = more;
                attempt_of.at = quantile(job, job.probability + job.direction.sign() * more);
                if !attempt_of.at.is_finite() {
                    attempt_of.widened = Some(attempt_of.at);
                }
            }
        }
        parallel::map_indices(jobs.len(), |index| self.quantile_bound(&jobs[index], &attempts[index]))
    }

    /// The probabilities that decide where the quantiles of several elements together end, as something to search: those of the
    /// values that have been attained.
    pub fn joint_quantile_targets(&self) -> Vec<(Target, Vec<Direction>)> {
        let quantiles: Vec<(usize, f64)> = self
            .setup
            .problem
            .requests
            .iter()
            .filter_map(|request| Some((request.column, request.statistic.probability_of_quantile()?)))
            .collect();
        let cuts: Vec<Vec<Focal<'_>>> = self.setup.structure.cuts.iter().map(|cut| self.focal_elements(cut)).collect();
        let of_quantile = |&(column, probability): &(usize, f64)| {
            let samples = self.pool.samples(column);
            let sorted = Sorted::new(&samples);
            let ends = cuts.iter().flat_map(|elements| Direction::BOTH.map(|direction| (elements, direction)));
            let of_end = |(elements, direction): (&Vec<Focal<'_>>, Direction)| {
                let value = sorted.quantile(&samples, elements, probability, direction);
                let event = quantile_event(value, direction);
                let measure = value.is_finite().then(|| Probability(event).measure(&samples, &self.setup.confidence));
                let targets = measure.map_or_else(Vec::new, Measure::into_targets);
                targets.into_iter().map(move |target| (target, vec![direction.opposite()])).collect::<Vec<_>>()
            };
            ends.flat_map(of_end).collect::<Vec<_>>()
        };
        parallel::flat_map(&quantiles, of_quantile)
    }

    /// Quantile without scatter: each element gives a range with its mass; its ends, sorted, are the added distribution functions.
    fn quantile_without_scatter(&self, job: &QuantileJob, elements: &[Focal<'_>]) -> Bound {
        let samples = self.pool.samples(job.column);
        let measure = Mean.measure(&samples, &self.setup.confidence);
        let search = self.search([&measure].into_iter());
        let modelled = Modelled::new(&search, &measure, &samples);
        let ends: Vec<(f64, Bound)> = elements
            .iter()
            .map(|element| {
                let mut bound = self.bound(&modelled, job.direction, element);
                // A run that failed may have gone anywhere.
                if element.members.iter().any(|&point| samples[point].failed() > 0) {
                    bound.value = job.direction.sign() * f64::INFINITY;
                    bound.widened = bound.value;
                }
                (element.mass, bound)
            })
            .collect();
        let quantile = |of: fn(&Bound) -> f64| {
            let mut sorted: Vec<(f64, f64)> = ends.iter().map(|(mass, bound)| (of(bound), *mass)).collect();
            sort_by_number(&mut sorted, |a| a.0);
            let mut sum = 0.0;
            for (value, mass) in &sorted {
                sum += mass;
                if sum >= job.probability - MASS_ROUND_OFF {
                    return *value;
                }
            }
            f64::INFINITY
        };
        let (value, widened) = (quantile(|bound| bound.value), quantile(|bound| bound.widened));
        let optimisation = if value.is_finite() { (job.direction.sign() * (widened - value)).max(0.0) } else { 0.0 };
        Bound::without_witness(value, widened, BoundError::of_runs(0.0, optimisation), self.guarantee())
    }

    fn quantile_bound(&self, job: &QuantileJob, attempt: &Attempt) -> Bound {
        let sign = job.direction.sign();
        if attempt.value.is_nan() {
            return self.unknown(job.direction);
        }
        let widened = attempt.widened.unwrap_or(sign * f64::INFINITY);
        let total = if attempt.value.is_finite() { (sign * (widened - attempt.value)).max(0.0) } else { 0.0 };
        let [sampling, optimisation] = attempt.errors.unwrap_or([1.0, 0.0]);
        let share = if sampling + optimisation > 0.0 { sampling / (sampling + optimisation) } else { 1.0 };
        let sampling = if total.is_finite() { share * total } else { total };
        let optimisation = if total.is_finite() { total - sampling } else { 0.0 };
        let error = BoundError::of_runs(sampling, optimisation);
        Bound::without_witness(attempt.value, attempt.value + sign * total, error, self.guarantee())
    }
}
