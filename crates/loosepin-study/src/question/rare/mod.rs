//! Probabilities too small to be counted in the double loop: where they are largest and smallest over the epistemic inputs, and how
//! large there.

mod bounds;
mod record;

pub use bounds::{Rare, RareEnd};

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext};
use super::steps::{Next, Steps, take_steps};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::file::{Ask, RareMethod, Study};
use crate::runs::all_runs::Runs;
use loosepin_bounds::{
    Bound, BoundError, Bounds, DoubleLoop, Guarantee, Purpose, RunInputs, SampleTable, Statistic, Witness,
};
use loosepin_result::study::RareMethodUsed;
use loosepin_uncertainty::reliability::{
    BoxSearch, DesignSearch, ImportanceSampling, IndexExtreme, RARE_CONFIDENCE, RareEstimate, RareProbability,
    SubsetSimulation, importance_sampling, index_range, subset_simulation,
};
use loosepin_uncertainty::{SobolError, hash, normal_cdf};
use std::collections::VecDeque;

/// A share of fewer runs than this is counted anew where the method is chosen automatically.
const MIN_HITS: f64 = 10.0;
/// Corners of the box at which the search begins, besides its centre, at most.
const MAX_CORNERS: usize = 8;
/// An estimate around design points with a larger coefficient of variation gives way to subset simulation.
const MAX_VARIATION: f64 = 0.25;
/// Points of a level of the subset simulations that only compare places.
const COMPARING_LEVEL: usize = 500;
/// The nearest probability to 1 that has a quantile; the nearest to 0 is the least positive number.
const MAX_PROBABILITY: f64 = 1.0 - f64::EPSILON / 2.0;
/// Separates the stream of random numbers.
const RARE: u64 = 0x7261_7265_0000;

/// Runs of the search for design points over the box, for each combination of the members of lists, at most; where they do not
/// suffice, subset simulation takes its place.
const MAX_DESIGN_RUNS: usize = 40_000;

/// Runs that a rare probability takes at most: a search for design points that is given up, sampling around them that is not near
/// enough, then subset simulations at every place that is compared and at both ends.
fn most_rare_runs(plan: &DoubleLoop) -> usize {
    let comparing = SubsetSimulation { level: COMPARING_LEVEL, seed: 0 }.most_runs();
    let compared = plan.box_combinations() * (MAX_DESIGN_RUNS + places(plan).len() * comparing);
    compared + ImportanceSampling::default().most_runs + 2 * SubsetSimulation::default().most_runs()
}

/// Centre and corners of the box, of many corners some.
fn places(plan: &DoubleLoop) -> Vec<Vec<f64>> {
    let places = plan.centre_and_corners();
    let stride = places.len().saturating_sub(1).div_ceil(MAX_CORNERS).max(1);
    places.into_iter().enumerate().filter(|(k, _)| *k == 0 || (k - 1) % stride == 0).map(|(_, place)| place).collect()
}

/// The small probabilities that the double loop leaves to be estimated.
struct RareQuestion {
    most_runs: usize,
}

/// Planned where an ask names a method.
pub fn planned(basis: &QuestionContext<'_>) -> Planned {
    let number = requests(&basis.response.plan().asks).count();
    let is_asked = number > 0 && !basis.is_surrogate_alone;
    Ok(if is_asked {
        Some(Box::new(RareQuestion { most_runs: most_rare_runs(basis.double_loop) * number }))
    } else {
        None
    })
}

impl Question for RareQuestion {
    fn most_runs(&self) -> usize {
        self.most_runs
    }

    fn run(&mut self, runs: &mut Runs<'_>, found: &mut Found) -> Result<(), StudyError> {
        let Some(double_loop) = &found.double_loop else { return Ok(()) };
        let steps = RareSteps::new(runs.study, &runs.response.plan().asks, double_loop, &found.bounds);
        found.rare = take_steps(steps, runs, None)?;
        Ok(())
    }

    fn record(&self, material: &Material<'_>, _found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        run.result.rare = record::rare_records(material);
        Ok(())
    }
}

/// Every probability that is asked for so.
fn requests(asks: &[Ask]) -> impl Iterator<Item = (usize, Statistic, RareMethod)> {
    asks.iter().flat_map(|ask| {
        let rare = move |&column: &usize| ask.by_method().map(move |(statistic, method)| (column, statistic, method));
        ask.columns.iter().flat_map(rare)
    })
}

/// Small probabilities that are asked for so; where the method is automatic, only what the double loop has counted too few of.
///
/// The estimates ask for values of the limit state in the middle of what they do. Each is begun anew whenever runs were added, takes the
/// values that are there, and ends at the first that are not: these runs are wanted next.
struct RareSteps<'s> {
    study: &'s Study,
    plan: &'s DoubleLoop,
    round: u32,
    /// What is to be estimated: column, statistic, and whether subset simulation is asked for.
    waiting: VecDeque<(usize, Statistic, RareMethod)>,
    found: Vec<Rare>,
    /// Place in the table of the first run of the present estimate.
    first: Option<usize>,
}

impl<'s> RareSteps<'s> {
    /// The small probabilities of `study`, whose double loop `plan` has given `bounds`.
    fn new(study: &'s Study, asks: &[Ask], plan: &'s DoubleLoop, bounds: &Bounds) -> Self {
        let inner = plan.problem().sampling.inner;
        let hits = |column: usize, statistic: Statistic| {
            let pair = bounds.pairs.iter().find(|pair| pair.column == column && pair.statistic == statistic);
            pair.map_or(0.0, |pair| pair.upper.value * inner as f64)
        };
        let is_counted = |&(column, statistic, method): &(usize, Statistic, RareMethod)| {
            method == RareMethod::Automatic && hits(column, statistic) >= MIN_HITS
        };
        let waiting = requests(asks).filter(|request| !is_counted(request)).collect();
        Self { study, plan, round: bounds.rounds, waiting, found: Vec::new(), first: None }
    }
}

impl Steps for RareSteps<'_> {
    type Answer = Vec<Rare>;

    fn next(&mut self, runs: &SampleTable) -> Result<Next<Vec<Rare>>, StudyError> {
        while let Some(&(column, statistic, method)) = self.waiting.front() {
            let next = *self.first.get_or_insert(runs.len());
            let known = Known { study: self.study, plan: self.plan, round: self.round, runs };
            let mut event = Event { known, next, column, statistic, combination: 0 };
            match event.estimate(method) {
                Ok(rare) => {
                    self.found.push(rare);
                    self.waiting.pop_front();
                    self.first = None;
                }
                Err(Missing::Runs(wanted)) => return Ok(Next::Beside(wanted)),
                Err(Missing::Points(error)) => return Err(error.into()),
            }
        }
        Ok(Next::Answer(std::mem::take(&mut self.found)))
    }
}

/// Results of a study so far.
#[derive(Clone, Copy)]
struct Known<'r> {
    study: &'r Study,
    plan: &'r DoubleLoop,
    round: u32,
    runs: &'r SampleTable,
}

/// One event, whose runs stand in the table one after the other.
struct Event<'r> {
    known: Known<'r>,
    /// Place of the run that is read next.
    next: usize,
    column: usize,
    statistic: Statistic,
    combination: usize,
}

/// Reason why an estimate cannot continue.
enum Missing {
    /// Runs that are not made yet.
    Runs(Vec<RunInputs>),
    /// More random inputs than Sobol' points have dimensions.
    Points(SobolError),
}

impl From<SobolError> for Missing {
    fn from(error: SobolError) -> Self {
        Self::Points(error)
    }
}

/// Why a search for design points came to no end.
enum SearchEnd {
    /// The estimate has used its runs.
    Spent,
    /// The estimate cannot continue.
    Missing(Missing),
}

/// An estimate at one value of the epistemic inputs.
struct End {
    epistemic: Vec<f64>,
    method: RareMethodUsed,
    estimate: RareProbability,
    index: Option<f64>,
    /// What the search over the epistemic inputs has not resolved, as a change of the index.
    unresolved: f64,
}

/// Which bound an end is.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Lower,
    Upper,
}

impl Event<'_> {
    /// Both ends; where design points cannot be relied on, by subset simulation.
    fn estimate(&mut self, method: RareMethod) -> Result<Rare, Missing> {
        let plan = self.known.plan;
        let seed = hash(hash(self.known.study.seed, RARE), self.column as u64);
        let ends = match method {
            RareMethod::Subset => None,
            RareMethod::Automatic | RareMethod::Importance => self.by_design_points(seed)?,
        };
        let [lower, upper] = match ends {
            Some(ends) => ends,
            None => self.by_subsets(seed)?,
        };
        Ok(Rare {
            column: self.column,
            statistic: self.statistic,
            bounds: [lower.bound(Side::Lower), upper.bound(Side::Upper)],
            is_confirmed: plan.centre_and_corners().len() == 1 && plan.box_combinations() == 1,
            ends: [lower.summary(Side::Lower), upper.summary(Side::Upper)],
        })
    }

    /// g at standard normal points for one place of the box: 0 or less where the event is.
    fn limit_state(&mut self, points: &[Vec<f64>], at: &[f64]) -> Result<Vec<f64>, Missing> {
        let Known { plan, runs, .. } = self.known;
        let (first, end) = (self.next, self.next + points.len());
        if end > runs.len() {
            return Err(Missing::Runs(self.wanted(points, &plan.box_values(self.combination, at))));
        }
        self.next = end;
        let values = (first..end).map(|run| runs.values(run)[self.column]);
        Ok(values.map(|value| self.statistic.event().map_or(f64::NAN, |event| event.missed_by(value))).collect())
    }

    /// The runs at standard normal points for one place of the box.
    fn wanted(&self, points: &[Vec<f64>], epistemic: &[f64]) -> Vec<RunInputs> {
        let run = |(index, point): (usize, &Vec<f64>)| RunInputs {
            round: self.known.round,
            purpose: Purpose::Rare,
            point: 0,
            replicate: 0,
            index: index as u32,
            random: self.known.plan.random_values(&probabilities(point), epistemic),
            epistemic: epistemic.to_vec(),
        };
        points.iter().enumerate().map(run).collect()
    }

    fn dimensions(&self) -> usize {
        self.known.study.random.len()
    }

    /// Both ends by importance sampling where the index is largest and smallest; `None` if an index cannot be relied on.
    fn by_design_points(&mut self, seed: u64) -> Result<Option<[End; 2]>, Missing> {
        let dimensions = self.dimensions();
        let search = BoxSearch { design: DesignSearch { seed, ..DesignSearch::default() }, ..BoxSearch::default() };
        let places = places(self.known.plan);
        let closes = self.known.plan.box_closes();
        let mut ends: [Option<(usize, IndexExtreme)>; 2] = [None, None];
        for combination in 0..self.known.plan.box_combinations() {
            self.combination = combination;
            let mut left = MAX_DESIGN_RUNS;
            let mut limit_state = |points: &[Vec<f64>], at: &[f64]| {
                left = left.checked_sub(points.len()).ok_or(SearchEnd::Spent)?;
                self.limit_state(points, at).map_err(SearchEnd::Missing)
            };
            let range = match index_range(&mut limit_state, dimensions, &places, &closes, &search) {
                Ok(Some(range)) => range,
                Ok(None) | Err(SearchEnd::Spent) => return Ok(None),
                Err(SearchEnd::Missing(missing)) => return Err(missing),
            };
            for (end, extreme, sign) in [(0, range.largest, -1.0), (1, range.smallest, 1.0)] {
                let is_better = ends[end]
                    .as_ref()
                    .is_none_or(|(_, best)| sign * extreme.designs[0].index < sign * best.designs[0].index);
                if is_better {
                    ends[end] = Some((combination, extreme));
                }
            }
        }
        let [Some(lower), Some(upper)] = ends else { return Ok(None) };
        let upper = self.around(upper, seed)?;
        if !(upper.estimate.high.coefficient_of_variation() <= MAX_VARIATION) {
            return Ok(None);
        }
        let lower = self.around(lower, seed)?;
        Ok(Some([lower, upper]))
    }

    fn around(&mut self, (combination, extreme): (usize, IndexExtreme), seed: u64) -> Result<End, Missing> {
        self.combination = combination;
        let dimensions = self.dimensions();
        let settings = ImportanceSampling { seed, ..ImportanceSampling::default() };
        let mut limit_state = |points: &[Vec<f64>]| self.limit_state(points, &extreme.at);
        let estimate = importance_sampling(&mut limit_state, dimensions, &extreme.designs, &settings)?;
        Ok(End {
            epistemic: self.known.plan.box_values(combination, &extreme.at),
            method: RareMethodUsed::Importance,
            estimate,
            index: Some(extreme.designs[0].index),
            unresolved: extreme.unresolved,
        })
    }

    /// Both ends by subset simulation, at the places where short ones found most and least.
    fn by_subsets(&mut self, seed: u64) -> Result<[End; 2], Missing> {
        let dimensions = self.dimensions();
        let mut compared: Vec<(RareProbability, usize, Vec<f64>)> = Vec::new();
        for combination in 0..self.known.plan.box_combinations() {
            self.combination = combination;
            for place in places(self.known.plan) {
                let settings = SubsetSimulation { level: COMPARING_LEVEL, seed };
                let mut limit_state = |points: &[Vec<f64>]| self.limit_state(points, &place);
                let found = subset_simulation(&mut limit_state, dimensions, &settings)?;
                compared.push((found, combination, place));
            }
        }
        let least = compared.iter().min_by(|a, b| a.0.low.value.total_cmp(&b.0.low.value));
        let most = compared.iter().max_by(|a, b| a.0.high.value.total_cmp(&b.0.high.value));
        let mut ends = Vec::with_capacity(2);
        for (_, combination, place) in least.into_iter().chain(most) {
            self.combination = *combination;
            let mut limit_state = |points: &[Vec<f64>]| self.limit_state(points, place);
            let settings = SubsetSimulation { seed: hash(seed, 1), ..SubsetSimulation::default() };
            let estimate = subset_simulation(&mut limit_state, dimensions, &settings)?;
            let epistemic = self.known.plan.box_values(*combination, place);
            let method = RareMethodUsed::Subset;
            ends.push(End { epistemic, method, estimate, index: None, unresolved: 0.0 });
        }
        let upper = ends.remove(1);
        Ok([ends.remove(0), upper])
    }
}

impl End {
    /// How the probability is estimated as one side of its bounds.
    fn own(&self, side: Side) -> RareEstimate {
        match side {
            Side::Lower => self.estimate.low,
            Side::Upper => self.estimate.high,
        }
    }

    fn summary(&self, side: Side) -> RareEnd {
        let RareProbability { runs, failed, .. } = self.estimate;
        RareEnd { method: self.method, estimate: self.own(side), index: self.index, runs, failed }
    }

    /// This end as a bound.
    fn bound(&self, side: Side) -> Bound {
        let RareEstimate { value, interval, .. } = self.own(side);
        let is_upper = side == Side::Upper;
        let widened = interval[usize::from(is_upper)];
        let sampling = (widened - value).abs();
        let index = self.index.unwrap_or(f64::NAN);
        let moved = if is_upper { index - self.unresolved } else { index + self.unresolved };
        let factor = normal_cdf(-moved) / normal_cdf(-index);
        let optimisation =
            if self.unresolved > 0.0 && factor.is_finite() { (value * (factor - 1.0)).abs() } else { 0.0 };
        let further = if is_upper { (widened + optimisation).min(1.0) } else { (widened - optimisation).max(0.0) };
        Bound {
            value,
            widened: further,
            witness: Some(Witness {
                purpose: Purpose::Rare,
                point: 0,
                epistemic: self.epistemic.clone(),
                random: Vec::new(),
            }),
            error: BoundError { sampling, optimisation: (further - widened).abs(), surrogate: 0.0 },
            guarantee: Guarantee::of_sample(RARE_CONFIDENCE),
        }
    }
}

/// Φ of standard normal numbers: a point of the unit cube at which every input has a value.
fn probabilities(point: &[f64]) -> Vec<f64> {
    point.iter().map(|&x| normal_cdf(x).clamp(f64::MIN_POSITIVE, MAX_PROBABILITY)).collect()
}
