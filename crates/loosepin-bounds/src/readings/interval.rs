//! The extreme of a statistic over a box, or a part of it: the attained value, with the unresolved rest.

use super::experiment::{Experiment, Focal};
use super::limits::{can_change, furthest_conceded};
use crate::data::bound::{Bound, BoundError};
use crate::data::direction::{Direction, extreme_among};
use crate::estimators::pool::PoolPoint;
use crate::estimators::sample::Sample;
use crate::measures::measure::Measure;
use crate::search::models::of_points::{Branch, Search, smoothed};
use crate::search::search_box::Region;
use crate::search::target::Target;
use loosepin_terms::Event;

/// A model of a probability itself says something where at least this share of the points is strictly between 0 and 1.
const MIN_SHARE_BETWEEN: f64 = 0.5;

/// A model that takes more than this share of the sampling variance for noise has averaged over points; errors that all points share,
/// as with the same random numbers at each, are no noise to it.
const MIN_NOISE_SHARE: f64 = 0.1;

/// A measure with the samples that it was taken of, and the models of what is searched.
pub(crate) struct Modelled<'a> {
    pub measure: &'a Measure,
    samples: &'a [&'a Sample],
    search: &'a Search<'a>,
    branches: Vec<Branch<'a>>,
    margin_branches: Vec<Branch<'a>>,
    /// Values by which points are compared, for each direction: the target where models take part of its differences for noise.
    scores: [Vec<f64>; 2],
}

/// The attained extreme of a statistic.
struct Attained {
    /// Outer point.
    point: usize,
    /// How far the confidence interval there, or that of any other point, reaches beyond it.
    sampling: f64,
}

impl Experiment<'_> {
    /// The extreme of a measure in `direction` over `focal`.
    pub fn bound(&self, modelled: &Modelled<'_>, direction: Direction, focal: &Focal<'_>) -> Bound {
        let measure = modelled.measure;
        let guarantee = self.guarantee();
        let Some(Attained { point, sampling }) = modelled.attained(direction, focal) else {
            let unknown = Bound::unknown(direction, guarantee);
            return Bound { widened: measure.of.limited(unknown.widened), ..unknown };
        };
        let value = measure.estimates(direction)[point].value;
        let sign = direction.sign();
        let optimisation = if self.setup.has_no_epistemic_inputs() || value.is_infinite() {
            0.0
        } else {
            let further = modelled.furthest(direction, (point, value), focal);
            (sign * (further - value)).max(0.0)
        };
        // What the search concedes ends where no response goes; the sampling error keeps what it needs.
        let is_of_rough_curves = modelled.search.is_of_curves() && modelled.branches.iter().any(Branch::is_rough);
        let possible = furthest_conceded(&*measure.of, is_of_rough_curves, modelled.samples, direction);
        let room = (sign * (measure.of.limited(possible) - value)).max(0.0);
        let error = BoundError::of_runs(sampling, optimisation.min((room - sampling).max(0.0)));
        Bound {
            value,
            widened: measure.of.limited(error.widen(value, direction)),
            witness: self.pool.points.get(point).map(PoolPoint::witness),
            error,
            guarantee,
        }
    }

    /// The extreme of a mean or of a probability over `elements`: the sum of mass times extreme.
    pub fn added(&self, modelled: &Modelled<'_>, elements: &[Focal<'_>], direction: Direction) -> Bound {
        let bounds = elements.iter().map(|element| (element.mass, self.bound(modelled, direction, element)));
        Bound::sum(bounds).unwrap_or_else(|| self.unknown(direction))
    }
}

impl<'a> Modelled<'a> {
    pub fn new(search: &'a Search<'a>, measure: &'a Measure, samples: &'a [&'a Sample]) -> Self {
        let margin_branches = measure.margin.as_ref().map_or_else(Vec::new, |margin| search.branches(&margin.target));
        Self::with(search, measure, samples, [search.branches(&measure.target), margin_branches])
    }

    /// [`Self::new`] for several measures, whose models are made together; `None` stays `None`.
    pub fn all(
        search: &'a Search<'a>,
        measures: &'a [Option<Measure>],
        samples: &'a [Vec<&'a Sample>],
    ) -> Vec<Option<Self>> {
        let mut branches = branches_of_all(search, measures.iter().flatten());
        let own = measures.iter().zip(samples);
        own.map(|(measure, samples)| Some(Self::with(search, measure.as_ref()?, samples, branches.next()?))).collect()
    }

    /// [`Self::all`] of measures of the same `samples`.
    pub fn of_column(search: &'a Search<'a>, measures: &'a [Measure], samples: &'a [&'a Sample]) -> Vec<Self> {
        let own = measures.iter().zip(branches_of_all(search, measures.iter()));
        own.map(|(measure, branches)| Self::with(search, measure, samples, branches)).collect()
    }

    fn with(
        search: &'a Search<'a>,
        measure: &'a Measure,
        samples: &'a [&'a Sample],
        [branches, margin_branches]: [Vec<Branch<'a>>; 2],
    ) -> Self {
        let lowest = smoothed(&measure.target, &branches, |point| measure.target_errors[point]);
        // Failed runs move the two estimates apart; the target is the low one.
        let gaps = measure.low.iter().zip(&measure.high).map(|(low, high)| high.value - low.value);
        let highest = lowest.iter().zip(gaps).map(|(score, gap)| if gap.is_finite() { score + gap } else { *score });
        let scores = [lowest.clone(), highest.collect()];
        Self { measure, samples, search, branches, margin_branches, scores }
    }

    /// The statistic at a point as it is compared with all others in `direction`: no bound over a box that holds the point is narrower.
    fn compared(&self, direction: Direction, point: usize) -> f64 {
        self.measure.of.compared(self.scores(direction)[point], self.measure.estimates(direction)[point].value)
    }

    /// [`Modelled::compared`] in both directions.
    pub fn at(&self, point: usize) -> [f64; 2] {
        Direction::BOTH.map(|direction| self.compared(direction, point))
    }

    fn scores(&self, direction: Direction) -> &[f64] {
        &self.scores[direction.index()]
    }

    /// The outer point in `focal` at which the statistic, smoothed where its differences are partly noise, goes furthest.
    fn attained(&self, direction: Direction, focal: &Focal<'_>) -> Option<Attained> {
        let measure = self.measure;
        let estimates = measure.estimates(direction);
        let outward = direction.sign() * f64::INFINITY;
        let own_error = |point: usize| direction.of(estimates[point].below, estimates[point].above);
        if let Some(&point) = focal.members.iter().find(|&&point| estimates[point].value == outward) {
            return Some(Attained { point, sampling: own_error(point) });
        }
        let scores = self.scores(direction);
        let is_known = |point: usize| scores[point].is_finite() && estimates[point].value.is_finite();
        let margin = |point: usize| measure.margin.as_ref().map_or(0.0, |margin| margin.target.values[point]);
        let is_better = |point: usize, best: usize| {
            direction.is_beyond(scores[point], scores[best])
                || (scores[point] == scores[best] && direction.is_beyond(margin(point), margin(best)))
        };
        let known = focal.members.iter().copied().filter(|&point| is_known(point));
        let best = known.clone().reduce(|best, point| if is_better(point, best) { point } else { best })?;
        // Where differences are noise the neighbours of a point have been heard too: its own interval says nothing more.
        let least_noise = MIN_NOISE_SHARE * measure.target.noise.variance;
        let is_averaged = |point: usize| {
            let own = self.branches.iter().find(|branch| branch.points.contains(&point));
            own.is_some_and(|branch| branch.averaged_noise() > least_noise)
        };
        let beyond = |point: usize| {
            direction.sign() * (self.compared(direction, point) - estimates[best].value) + own_error(point)
        };
        let heard = known.filter(|&point| !is_averaged(point));
        Some(Attained { point: best, sampling: heard.map(beyond).fold(own_error(best), f64::max) })
    }

    /// How far the statistic may go in `direction` where `value` is attained at `point`.
    fn furthest(&self, direction: Direction, (point, value): (usize, f64), focal: &Focal<'_>) -> f64 {
        let Measure { of, target, .. } = self.measure;
        let event = of.event();
        // What is certain at a point is no more than certain between the points.
        let is_certain = direction.of(value <= 0.0, value >= 1.0);
        if event.is_some_and(|event| is_certain || !can_change(event, self.samples)) {
            return value;
        }
        let least = target.values[point] + target.conceded(direction);
        if let Some(event) = event.filter(|_| of.is_counted()) {
            let is_on_atom = atoms(self.samples, point).iter().any(|&atom| event.missed_by(atom) == 0.0);
            let least_between = if is_on_atom { 0.0 } else { MIN_SHARE_BETWEEN };
            let by_shares = self.furthest_by_shares(direction, value, least, least_between, focal.region);
            return self.furthest_by_margins(direction, by_shares, event, focal).clamp(0.0, 1.0);
        }
        let reach = self.search.furthest_reach(target, &self.branches, direction, focal.region);
        direction.further(value, of.reached(value, target.values[point], direction.further(least, reach)))
    }

    /// Extreme of a counted probability by its models, where at least the share `least_between` of the points lies between 0 and 1.
    fn furthest_by_shares(
        &self,
        direction: Direction,
        value: f64,
        least: f64,
        least_between: f64,
        region: &Region,
    ) -> f64 {
        let target = &self.measure.target;
        let mut furthest = value;
        for branch in &self.branches {
            let shares = branch.points.iter().map(|&point| target.values[point]);
            let between = shares.filter(|&share| share > 0.0 && share < 1.0).count() as f64;
            if between >= least_between * branch.points.len() as f64 {
                let most = direction.further(least, self.search.reach(target, branch, direction, region));
                furthest = direction.further(most, furthest);
            }
        }
        furthest
    }

    /// How far a counted probability goes where the sample nearest to the limit is moved as far as the models of the margin let it.
    fn furthest_by_margins(&self, direction: Direction, value: f64, event: Event, focal: &Focal<'_>) -> f64 {
        let Some(margin) = &self.measure.margin else { return value };
        let mut furthest = value;
        for branch in &self.margin_branches {
            let inside = branch.points.iter().copied().filter(|point| focal.members.contains(point));
            if let Some(nearest) = extreme_among(&margin.target.values, inside, direction) {
                let most = self.search.reach(&margin.target, branch, direction, focal.region);
                let shift = margin.shift(nearest, most);
                let atoms = atoms(self.samples, nearest);
                let share = shifted_share(self.samples[nearest], event, shift, &atoms, direction);
                furthest = direction.further(share, furthest);
            }
        }
        furthest
    }
}

/// Models of the target and of the margin of each of `measures`, those of all made together.
fn branches_of_all<'a>(
    search: &'a Search<'a>,
    measures: impl Iterator<Item = &'a Measure> + Clone,
) -> impl Iterator<Item = [Vec<Branch<'a>>; 2]> {
    let targets: Vec<&Target> = measures.clone().flat_map(Measure::targets).collect();
    let mut branches = search.branches_of_all(&targets).into_iter();
    let mut next = move || branches.next().unwrap_or_default();
    let of = move |measure: &Measure| {
        let own = next();
        [own, if measure.margin.is_some() { next() } else { Vec::new() }]
    };
    measures.map(of).collect::<Vec<_>>().into_iter()
}

/// Atoms of the response, values with positive probability, that do not move with u: several runs at `point` have exactly this response, and
/// several at another u, as where a part rests on a stop, or there is no contact. In increasing order.
fn atoms(samples: &[&Sample], point: usize) -> Vec<f64> {
    let own = repeated(samples[point]);
    let is_elsewhere = |atom: &f64| {
        let others = samples.iter().filter(|other| !other.is_same(samples[point]));
        others.into_iter().any(|other| other.values().iter().filter(|value| *value == atom).count() > 1)
    };
    own.into_iter().filter(is_elsewhere).collect()
}

/// Values of several runs, in increasing order.
fn repeated(sample: &Sample) -> Vec<f64> {
    let mut values: Vec<f64> =
        sample.sorted().windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]).collect();
    values.dedup();
    values
}

/// The share of `sample`, moved by `shift` but for its `atoms`, for which `event` holds; failed runs count towards `direction`.
fn shifted_share(sample: &Sample, event: Event, shift: f64, atoms: &[f64], direction: Direction) -> f64 {
    if let Some(smooth) = sample.smooth() {
        return smooth.probability(event, shift).value;
    }
    // Zeros of either sign are the same value.
    let is_atom = |value: f64| atoms.binary_search_by(|atom| (atom + 0.0).total_cmp(&(value + 0.0))).is_ok();
    let moved = |&value: &f64| event.holds(if is_atom(value) { value } else { value + shift });
    let hits = sample.values().iter().filter(|value| moved(value)).count();
    let failed = direction.of(0, sample.failed());
    (hits + failed) as f64 / sample.runs() as f64
}
