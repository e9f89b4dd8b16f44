//! From the finished table to bounds.

use rayon::prelude::*;

use super::bound::{Bound, BoundError, BoundPair, Bounds, Guarantee, LevelBounds, Reading};
use super::combine::{Parts, QuantileJob};
use super::index::probability_of_index;
use super::measure::{Event, Measure, MeasureKind};
use super::plan::{DoubleLoop, PlanError};
use super::pool::{Pool, PoolPoint};
use super::probability_box::ProbabilityBox;
use super::problem::Request;
use super::random_set::RandomSet;
use super::sample::Sample;
use super::search::{Branch, Direction, SEARCH_RESOLUTION, Search, extreme_among, smoothed};
use super::search_box::{Place, Region};
use super::statistic::Statistic;
use super::structure::{Element, Level};
use super::table::{Purpose, SampleTable};
use super::treatment::TreatmentComparison;

/// A model of a probability itself says something where at least this share of the points is strictly between 0 and 1.
const LEAST_SHARE_BETWEEN: f64 = 0.5;

/// A model that takes more than this share of the sampling variance for noise has averaged over points; errors that all points share,
/// as with the same random numbers at each, are no noise to it.
const LEAST_NOISE_SHARE: f64 = 0.1;

/// By this share of the range of all responses a bound may lie beyond the furthest of them.
const RESPONSE_MARGIN: f64 = 0.1;

/// Fewer runs at a point than this do not show the range of the response.
const LEAST_RUNS_FOR_RANGE: usize = 8;

impl DoubleLoop {
    /// What the runs in `table` say. The plan need not be finished, but the first round must be.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table is empty, belongs to another problem or lacks runs.
    pub fn results(&self, table: &SampleTable) -> Result<Bounds, PlanError> {
        let problem = self.problem();
        if table.columns() != problem.columns {
            return Err(PlanError::OtherColumns { found: table.columns(), expected: problem.columns });
        }
        let pool = Pool::gather(table, Purpose::DoubleLoop, self.needed_columns());
        if pool.points.is_empty() {
            return Err(PlanError::NoRuns);
        }
        self.check_points(&pool)?;
        let pool = pool.with_polynomials(self.inner_basis());
        let evidence = Evidence::new(self, &pool, table);
        let mut levels = evidence.levels();
        let pairs = levels.first().map(|level| level.pairs.clone()).unwrap_or_default();
        if levels.len() == 1 {
            levels.clear();
        }
        let boxes = problem
            .requests
            .iter()
            .filter(|request| request.statistic == Statistic::Cdf)
            .map(|request| ProbabilityBox::new(&evidence, table, request.column))
            .collect();
        let comparisons = TreatmentComparison::all(&evidence, table);
        Ok(Bounds {
            reading: problem.reading,
            pairs,
            levels,
            percentiles: evidence.percentiles(),
            boxes,
            comparisons,
            outer_points: pool.points.iter().map(|point| point.epistemic.clone()).collect(),
            centre_point: self.centre_point(),
            runs: table.len(),
            failed_runs: table.failed(),
            rounds: table.rounds(),
        })
    }
}

/// All runs of the double loop, ready to be asked.
pub(super) struct Evidence<'a> {
    pub plan: &'a DoubleLoop,
    pub pool: &'a Pool,
    pub table: &'a SampleTable,
    /// Outer points in the search box.
    pub places: Vec<Place>,
}

/// A part of the epistemic box, and the outer points in it.
pub(super) struct Part<'a> {
    pub region: &'a Region,
    pub members: Vec<usize>,
}

impl<'a> Evidence<'a> {
    /// The runs of `pool`, gathered from `table`.
    pub fn new(plan: &'a DoubleLoop, pool: &'a Pool, table: &'a SampleTable) -> Self {
        Self { plan, pool, table, places: plan.outer_places(pool) }
    }
}

impl Evidence<'_> {
    /// The bounds at every degree, what is possible at all first; those at a lower degree hold those at higher ones.
    fn levels(&self) -> Vec<LevelBounds> {
        let requests: Vec<Request> = self.plan.problem().requests.clone();
        let requests: Vec<Request> =
            requests.into_iter().filter(|request| request.statistic != Statistic::Cdf).collect();
        let measures: Vec<Option<Measure>> = requests
            .par_iter()
            .map(|request| Measure::new(&self.pool.samples(request.column), request.statistic, self.plan.confidence()))
            .collect();
        let search = self.search(measures.iter().flatten());
        let structure = self.plan.structure();
        let mut levels: Vec<LevelBounds> = structure
            .levels
            .iter()
            .map(|level| {
                let parts = self.parts(level);
                LevelBounds { alpha: level.alpha, pairs: self.pairs(&requests, &measures, &search, &parts) }
            })
            .collect();
        for level in (1..levels.len()).rev() {
            let (outer, inner) = levels.split_at_mut(level);
            for (outer, inner) in outer[level - 1].pairs.iter_mut().zip(&inner[0].pairs) {
                outer.lower.widen_to(inner.lower.widened, Direction::Minimum);
                outer.upper.widen_to(inner.upper.widened, Direction::Maximum);
            }
        }
        levels
    }

    /// The parts of `level` with the outer points in each.
    pub fn parts<'l>(&self, level: &'l Level) -> Parts<'l> {
        let part = |element: &'l Element| {
            (element.mass, Part { region: &element.region, members: element.region.members(&self.places) })
        };
        Parts { parts: level.elements.iter().map(part).collect() }
    }

    /// Whether values may differ from sample to sample within an element.
    pub fn is_scattering(&self) -> bool {
        self.plan.structure().is_scattering
    }

    fn pairs(
        &self,
        requests: &[Request],
        measures: &[Option<Measure>],
        search: &Search<'_>,
        parts: &Parts<'_>,
    ) -> Vec<BoundPair> {
        let reading = self.plan.problem().reading;
        if reading == Reading::RandomSet {
            return self.random_set_pairs(requests, parts);
        }
        let is_one = parts.parts.len() == 1;
        let jobs: Vec<QuantileJob> = requests
            .iter()
            .filter_map(|request| match request.statistic {
                Statistic::Quantile(probability) if !is_one => Some((request.column, probability)),
                _ => None,
            })
            .flat_map(|(column, probability)| {
                Direction::BOTH.map(|direction| QuantileJob { column, probability, direction })
            })
            .collect();
        let quantiles: Vec<Bound> = self.quantiles(&jobs, parts);
        requests
            .par_iter()
            .zip(measures)
            .filter_map(|(request, measure)| {
                let samples = self.pool.samples(request.column);
                let measure = Modelled::new(search, measure.as_ref()?);
                let failed_runs = samples.iter().map(|sample| sample.failed()).sum();
                let has_no_bound = matches!(request.statistic, Statistic::Mean | Statistic::StandardDeviation);
                let is_mixed = reading == Reading::UnknownDistribution || self.is_scattering();
                let [lower, upper] = match request.statistic {
                    Statistic::Quantile(probability) if !is_one => {
                        let found = |direction| {
                            let job = QuantileJob { column: request.column, probability, direction };
                            let place = jobs.iter().position(|known| *known == job);
                            place.map_or_else(|| self.nothing(direction), |place| quantiles[place].clone())
                        };
                        Direction::BOTH.map(found)
                    }
                    Statistic::StandardDeviation if !is_one || is_mixed => {
                        self.deviations(request.column, parts, reading)
                    }
                    _ => Direction::BOTH.map(|direction| self.added(search, &samples, &measure, parts, direction)),
                };
                let at: Vec<f64> = measure.measure.low.iter().map(|estimate| estimate.value).collect();
                // Of several elements the sum has been attained, at no single point.
                let estimates =
                    if is_one { at } else { Direction::BOTH.map(|d| parts.sum_of_extremes(&at, d)).to_vec() };
                Some(BoundPair {
                    column: request.column,
                    statistic: request.statistic,
                    estimates,
                    lower,
                    upper,
                    failed_runs,
                    unbounded_by_failures: has_no_bound && failed_runs > 0,
                })
            })
            .collect()
    }

    /// Belief and plausibility, and what else the random set says.
    fn random_set_pairs(&self, requests: &[Request], parts: &Parts<'_>) -> Vec<BoundPair> {
        let mut columns: Vec<usize> = requests.iter().map(|request| request.column).collect();
        columns.sort_unstable();
        columns.dedup();
        let of_column = |column: usize| {
            let set = RandomSet::new(self, parts, column);
            let failed_runs = self.pool.samples(column).iter().map(|sample| sample.failed()).sum();
            let own = requests.iter().enumerate().filter(move |(_, request)| request.column == column);
            let pair = |(place, request): (usize, &Request)| {
                let [lower, upper] = set.bounds(self, request.statistic);
                let has_no_bound = matches!(request.statistic, Statistic::Mean | Statistic::StandardDeviation);
                // The ends of a sample that failed somewhere are not known.
                let estimates = if failed_runs > 0 { Vec::new() } else { vec![lower.value, upper.value] };
                let unbounded_by_failures = has_no_bound && failed_runs > 0;
                let Request { column, statistic } = *request;
                (place, BoundPair { column, statistic, lower, upper, estimates, failed_runs, unbounded_by_failures })
            };
            own.map(pair).collect::<Vec<_>>()
        };
        let mut pairs: Vec<(usize, BoundPair)> = columns.into_par_iter().flat_map_iter(of_column).collect();
        pairs.sort_by_key(|(place, _)| *place);
        pairs.into_iter().map(|(_, pair)| pair).collect()
    }

    /// Models for everything that `measures` search.
    pub fn search<'s>(&'s self, measures: impl Iterator<Item = &'s Measure>) -> Search<'s> {
        let targets = measures
            .flat_map(|measure| [Some(&measure.target), measure.margin.as_ref().map(|margin| &margin.target)])
            .flatten();
        Search::new(self.plan.epistemic_box().axes(), &self.places, self.plan.candidates(), targets)
    }

    /// The kind of guarantee that bounds from these runs have.
    pub fn guarantee(&self) -> Guarantee {
        let problem = self.plan.problem();
        match (problem.random.is_empty(), self.plan.epistemic_box().dimensions() == 0) {
            (true, true) => Guarantee::Enclosure,
            (true, false) => Guarantee::Optimised,
            (false, _) => Guarantee::Sampled { confidence: problem.sampling.confidence },
        }
    }

    /// The extreme of `measure` in `direction` over a part of the box: attained, with what was not resolved.
    pub fn bound(
        &self,
        search: &Search<'_>,
        samples: &[&Sample],
        modelled: &Modelled<'_>,
        direction: Direction,
        part: &Part<'_>,
    ) -> Bound {
        let measure = modelled.measure;
        let estimates = match direction {
            Direction::Minimum => &measure.low,
            Direction::Maximum => &measure.high,
        };
        let guarantee = self.guarantee();
        let Some((witness, sampling)) = modelled.witness(direction, part) else {
            let error = BoundError { sampling: f64::INFINITY, ..BoundError::default() };
            let widened = measure.kind.limited(direction.sign() * f64::INFINITY);
            return Bound { value: f64::NAN, widened, witness: None, error, guarantee };
        };
        let estimate = estimates[witness];
        let sign = direction.sign();
        let optimisation = if self.plan.epistemic_box().dimensions() == 0 || estimate.value.is_infinite() {
            0.0
        } else {
            let further = modelled.furthest(search, samples, direction, (witness, estimate.value), part);
            (sign * (further - estimate.value)).max(0.0)
        };
        // What the search concedes ends where no response goes; the sampling error keeps what it needs.
        let possible = measure.kind.possible(samples, direction);
        let room = (sign * (measure.kind.limited(possible) - estimate.value)).max(0.0);
        let optimisation = optimisation.min((room - sampling).max(0.0));
        let error = BoundError { sampling, optimisation, surrogate: 0.0 };
        let bound = Bound {
            value: estimate.value,
            widened: measure.kind.limited(estimate.value + sign * error.total()),
            witness: self.pool.points.get(witness).map(PoolPoint::witness),
            error,
            guarantee,
        };
        bound.within_responses(samples, direction)
    }
}

impl Bound {
    /// Where fewer samples lie beyond a quantile than a confidence takes, no finite error holds with it. What is known then is how
    /// far responses have been seen to go: the bound ends there, and says that this is not confirmed. Failed runs may have gone
    /// anywhere, and stay infinite.
    pub(super) fn within_responses(self, samples: &[&Sample], direction: Direction) -> Self {
        let possible = MeasureKind::Plain.possible(samples, direction);
        let has_failed = samples.iter().any(|sample| sample.failed() > 0);
        if self.widened.is_finite() || !self.value.is_finite() || !possible.is_finite() || has_failed {
            return self;
        }
        let room = (direction.sign() * (possible - self.value)).max(0.0);
        let error = BoundError { sampling: room, optimisation: 0.0, ..self.error };
        let widened = self.value + direction.sign() * room;
        Self { widened, error, guarantee: Guarantee::Inner, ..self }
    }
}

impl MeasureKind {
    /// The furthest that the statistic can go when no response lies further than those seen at all points together and a
    /// margin: means and quantiles stay within the range of the responses, deviations within half of it. Infinite where
    /// the runs at a point are too few to show that range. Where the motion is chaotic the statistic is so uneven over u
    /// that a model of it alone would concede what no mechanism does.
    pub fn possible(self, samples: &[&Sample], direction: Direction) -> f64 {
        let unlimited = direction.sign() * f64::INFINITY;
        let Some((low, high)) = responses(samples) else { return unlimited };
        let margin = RESPONSE_MARGIN * (high - low);
        match (self, direction) {
            (Self::Plain, Direction::Minimum) => low - margin,
            (Self::Plain, Direction::Maximum) => high + margin,
            (Self::Deviation, Direction::Minimum) => 0.0,
            (Self::Deviation, Direction::Maximum) => 0.5 * (high - low) + margin,
            (Self::Probability(_) | Self::SmoothProbability(_), _) => unlimited,
        }
    }

    /// `value` moved into the range that the statistic can have at all.
    fn limited(self, value: f64) -> f64 {
        match self {
            Self::Plain => value,
            Self::Deviation => value.max(0.0),
            Self::Probability(_) | Self::SmoothProbability(_) => value.clamp(0.0, 1.0),
        }
    }
}

impl Event {
    /// Whether any response, moved by the margin beyond the furthest of all, is on the other side of the limit than one
    /// that was seen: otherwise the share is the same at every u.
    fn can_change(self, samples: &[&Sample]) -> bool {
        let Some((low, high)) = responses(samples) else { return true };
        let margin = RESPONSE_MARGIN * (high - low);
        self.holds(low - margin) || self.holds(high + margin)
    }
}

/// The least and the greatest response at all points together; nothing where the runs at a point are too few to show them.
fn responses(samples: &[&Sample]) -> Option<(f64, f64)> {
    if samples.iter().any(|sample| sample.values().len() < LEAST_RUNS_FOR_RANGE) {
        return None;
    }
    let seen = samples.iter().flat_map(|sample| sample.values());
    Some(seen.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v))))
}

/// A measure with the models of what is searched.
pub(super) struct Modelled<'a> {
    measure: &'a Measure,
    branches: Vec<Branch<'a>>,
    margin_branches: Vec<Branch<'a>>,
}

impl<'a> Modelled<'a> {
    pub fn new(search: &'a Search<'_>, measure: &'a Measure) -> Self {
        let margin_branches = measure.margin.as_ref().map_or_else(Vec::new, |margin| search.branches(&margin.target));
        Self { measure, branches: search.branches(&measure.target), margin_branches }
    }

    /// The outer point in `part` at which the statistic, smoothed where its differences are partly noise, goes furthest; and the
    /// sampling error there: how far its confidence interval, or that of any other point in `part`, reaches beyond it.
    pub fn witness(&self, direction: Direction, part: &Part<'_>) -> Option<(usize, f64)> {
        let measure = self.measure;
        let estimates = match direction {
            Direction::Minimum => &measure.low,
            Direction::Maximum => &measure.high,
        };
        let outward = direction.sign() * f64::INFINITY;
        let own_error = |point: usize| match direction {
            Direction::Minimum => estimates[point].below,
            Direction::Maximum => estimates[point].above,
        };
        if let Some(&point) = part.members.iter().find(|&&point| estimates[point].value == outward) {
            return Some((point, own_error(point)));
        }
        let mut scores = smoothed(&measure.target, &self.branches, |point| measure.target_errors[point]);
        for (point, score) in scores.iter_mut().enumerate() {
            // Failed runs move the two estimates apart; the target is the low one.
            let gap = measure.high[point].value - measure.low[point].value;
            if direction == Direction::Maximum && gap.is_finite() {
                *score += gap;
            }
        }
        let margin = |point: usize| measure.margin.as_ref().map_or(0.0, |margin| margin.target.values[point]);
        let mut best: Option<usize> = None;
        for (point, score) in part.members.iter().map(|&point| (point, &scores[point])) {
            if !score.is_finite() || !estimates[point].value.is_finite() {
                continue;
            }
            let is_better = best.is_none_or(|best| {
                direction.is_beyond(*score, scores[best])
                    || (*score == scores[best] && direction.is_beyond(margin(point), margin(best)))
            });
            if is_better {
                best = Some(point);
            }
        }
        let best = best?;
        // The statistic itself at a point, as it was compared.
        let compared = |point: usize| match measure.kind {
            MeasureKind::Plain | MeasureKind::Probability(_) => scores[point],
            MeasureKind::Deviation => scores[point].max(0.0).sqrt(),
            MeasureKind::SmoothProbability(_) => estimates[point].value,
        };
        // Where differences are noise the neighbours of a point have been heard too: its own interval says nothing more.
        let least_noise = LEAST_NOISE_SHARE * measure.target.noise_variance;
        let is_averaged = |point: usize| {
            let own = self.branches.iter().find(|branch| branch.points.contains(&point));
            own.is_some_and(|branch| branch.noise_variance() > least_noise)
        };
        let beyond = |&point: &usize| direction.sign() * (compared(point) - estimates[best].value) + own_error(point);
        let is_known = |point: usize| scores[point].is_finite() && estimates[point].value.is_finite();
        let known = part.members.iter().filter(|&&point| is_known(point) && !is_averaged(point));
        Some((best, known.map(beyond).fold(own_error(best), f64::max)))
    }

    /// How far the statistic may go in `direction`, `attained` at the point `witness`.
    fn furthest(
        &self,
        search: &Search<'_>,
        samples: &[&Sample],
        direction: Direction,
        (witness, attained): (usize, f64),
        part: &Part<'_>,
    ) -> f64 {
        let target = &self.measure.target;
        let at_witness = target.values[witness];
        let beyond = |a: f64, b: f64| if direction.is_beyond(a, b) { a } else { b };
        let conceded = direction.sign() * SEARCH_RESOLUTION * target.range();
        let most =
            || beyond(search.furthest_reach(target, &self.branches, direction, part.region), at_witness + conceded);
        match self.measure.kind {
            MeasureKind::Plain => beyond(most(), attained),
            MeasureKind::Deviation => beyond(most().max(0.0).sqrt(), attained),
            MeasureKind::SmoothProbability(event) => {
                if !event.can_change(samples) {
                    return attained;
                }
                let further = probability_of_index(most()) - probability_of_index(at_witness);
                beyond(attained + further, attained).clamp(0.0, 1.0)
            }
            MeasureKind::Probability(event) => {
                if !event.can_change(samples) {
                    return attained;
                }
                let mut furthest = attained;
                for branch in &self.branches {
                    let shares = branch.points.iter().map(|&point| target.values[point]);
                    let between = shares.filter(|&share| share > 0.0 && share < 1.0).count() as f64;
                    if between >= LEAST_SHARE_BETWEEN * branch.points.len() as f64 {
                        let most = beyond(search.reach(target, branch, direction, part.region), at_witness + conceded);
                        furthest = beyond(furthest, most);
                    }
                }
                let inside = |branch: &Branch<'_>| -> Vec<usize> {
                    branch.points.iter().copied().filter(|point| part.members.contains(point)).collect()
                };
                for branch in &self.margin_branches {
                    if let Some(margin) = &self.measure.margin
                        && let Some(nearest) =
                            extreme_among(&margin.target.values, inside(branch).into_iter(), direction)
                    {
                        let most = search.reach(&margin.target, branch, direction, part.region);
                        let shifted = shifted_share(samples[nearest], event, margin.shift(nearest, most), direction);
                        furthest = beyond(furthest, shifted);
                    }
                }
                furthest.clamp(0.0, 1.0)
            }
        }
    }
}

/// The share of `sample`, moved by `shift`, for which `event` holds; failed runs count towards `direction`.
fn shifted_share(sample: &Sample, event: Event, shift: f64, direction: Direction) -> f64 {
    if let Some(smooth) = sample.smooth() {
        return smooth.probability(event, shift).value;
    }
    let hits = sample.values().iter().filter(|&&value| event.holds(value + shift)).count();
    let failed = if direction == Direction::Maximum { sample.failed() } else { 0 };
    (hits + failed) as f64 / sample.runs() as f64
}
