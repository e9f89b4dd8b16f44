//! The runs behind a promise for a share of the box, and what they promise.

use std::collections::BTreeMap;

use thiserror::Error;

use super::check::ProblemError;
use super::error::PlanError;
use crate::data::bound::Witness;
use crate::data::problem::{Problem, Reading, Request};
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::parallel;
use crate::readings::promise::{InnerRuns, OneSidedLimit, least_runs};
use crate::readings::simultaneous::SimultaneousBand;
use crate::search::parts::{Element, Structure};
use crate::search::search_box::{BoxPoint, SearchBox};
use loosepin_terms::{Side, Statistic};
use loosepin_uncertainty::{EpistemicVariable, hash, uniform};

/// Probability that the limit at one u fails. It costs one value of u in a hundred, and its order statistics need half the runs that
/// a ten-thousandth does.
pub const PROMISE_MISS: f64 = 0.01;

/// Streams of random numbers.
const VALUES: u64 = 0x7072_6f6d_6973_6500;
const SAMPLES: u64 = 0x7072_6f6d_6973_6501;

/// The promise, and the number of its runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PromiseSettings {
    /// Share of the box that keeps a bound, each of them at least, in (0, 1).
    pub share: f64,
    /// Confidence that this is so for all bounds together, in (0, 1).
    pub confidence: f64,
    /// Runs at each value of u.
    pub inner: usize,
}

impl Default for PromiseSettings {
    fn default() -> Self {
        Self { share: 0.99, confidence: 0.99, inner: 256 }
    }
}

/// End of a statistic that is to be promised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PromiseRequest {
    /// The statistic: a quantile or a probability.
    pub request: Request,
    /// Which end.
    pub side: Side,
}

/// A promised bound.
#[derive(Debug, Clone, PartialEq)]
pub struct PromisedBound {
    /// The request.
    pub asked: PromiseRequest,
    /// The bound; infinite, for a probability 0 or 1, where a run failed at some u.
    pub bound: f64,
    /// The u with the furthest limit.
    pub witness: Witness,
    /// Values of u at which a run failed.
    pub failed_values: usize,
}

/// Runs at each u without which a quantile at `probability` cannot be promised on `side`, nor that so large a share keeps a limit.
pub fn least_promise_runs(probability: f64, side: Side) -> usize {
    least_runs(probability, side, PROMISE_MISS)
}

/// Why nothing can be promised.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum PromiseError {
    /// The problem breaks a rule.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    #[error("nothing is to be promised; ask for at least one end")]
    NothingAsked,
    #[error("{name} {value}; must lie between 0 and 1, both excluded")]
    OutsideUnit { name: &'static str, value: f64 },
    #[error("no input has an interval: there is no box of which a share could be promised")]
    NoBox,
    #[error(
        "{what} cannot be used with a promise: it is for intervals read as fixed but unknown, lists and focal elements"
    )]
    NotFixed { what: &'static str },
    #[error(
        "nothing can be promised of a {}: no number of runs bounds it without a known range\nhint: ask for a quantile or a probability",
        .statistic.word()
    )]
    Unbounded { statistic: Statistic },
    #[error("inner 0; must be at least 1")]
    NoRuns,
    #[error(
        "{boxes} boxes with {values} values each; must be fewer than 2^32 values\nhint: fewer ends, or a smaller share"
    )]
    TooManyValues { boxes: usize, values: usize },
    #[error("inner {inner}; the quantile at {probability} needs at least {least} runs at each value")]
    TooFewInner { inner: usize, probability: f64, least: usize },
}

/// The runs behind a promise: n values of u, fixed beforehand, independent and uniform in each box, and independent runs at each.
///
/// Every combination of the members of lists and every focal element has a box of its own, with as many values. What is promised
/// holds for each box by itself.
#[derive(Debug, Clone)]
pub struct PromisePlan {
    problem: Problem,
    search_box: SearchBox,
    elements: Vec<Element>,
    asked: Vec<(PromiseRequest, OneSidedLimit)>,
    /// Shares of mechanisms for which a band over a whole curve is promised.
    bands: Vec<f64>,
    settings: PromiseSettings,
    values: usize,
}

impl PromisePlan {
    /// Checks `problem` and prepares the plan. Its requests and sampling play no part, but for the seed. Beside the ends that are asked
    /// for, it promises as many bands over curves as `bands` has shares of mechanisms.
    ///
    /// # Errors
    ///
    /// [`PromiseError`] where nothing can be promised.
    pub fn try_new(
        problem: Problem,
        asked: Vec<PromiseRequest>,
        bands: Vec<f64>,
        settings: PromiseSettings,
    ) -> Result<Self, PromiseError> {
        problem.check()?;
        let search_box = SearchBox::new(problem.epistemic.clone());
        check_known(&problem, &search_box)?;
        for (name, value) in [("share", settings.share), ("confidence", settings.confidence)] {
            if !(value > 0.0 && value < 1.0) {
                return Err(PromiseError::OutsideUnit { name, value });
            }
        }
        let is_exact = problem.random.is_empty();
        if settings.inner == 0 && !is_exact {
            return Err(PromiseError::NoRuns);
        }
        let miss = if is_exact { 0.0 } else { PROMISE_MISS };
        let inner = if is_exact { InnerRuns::Exact } else { InnerRuns::Independent { miss } };
        let runs = if is_exact { 1 } else { settings.inner };
        let limit = |asked: PromiseRequest| {
            let PromiseRequest { request: Request { column, statistic }, side } = asked;
            if column >= problem.columns {
                return Err(ProblemError::NoSuchColumn { request: 0, column, columns: problem.columns }.into());
            }
            match (OneSidedLimit::new(statistic, side, runs, miss), statistic.probability_of_quantile()) {
                (Some(limit), _) => Ok((asked, limit)),
                (None, Some(probability)) => {
                    let least = least_runs(probability, side, miss);
                    Err(PromiseError::TooFewInner { inner: runs, probability, least })
                }
                (None, None) => Err(PromiseError::Unbounded { statistic }),
            }
        };
        for &share in &bands {
            let statistic = Statistic::quantile_at(share);
            limit(PromiseRequest { request: Request { column: 0, statistic }, side: Side::Upper })?;
        }
        let asked = asked.into_iter().map(limit).collect::<Result<Vec<_>, PromiseError>>()?;
        let ends = asked.len() + bands.len();
        if ends == 0 {
            return Err(PromiseError::NothingAsked);
        }
        // Each end may fail with an equal share of what all of them may fail with.
        let miss_each = (1.0 - settings.confidence) / ends as f64;
        // Nothing but a confidence that rounds to 0 or 1 has no number of values.
        let (name, value) = ("confidence", settings.confidence);
        let values = inner.values_for(settings.share, miss_each).ok_or(PromiseError::OutsideUnit { name, value })?;
        let elements = Structure::new(&search_box).widest().elements.clone();
        let settings = PromiseSettings { inner: runs, ..settings };
        let plan = Self { problem, search_box, elements, asked, bands, settings, values };
        let boxes = plan.boxes();
        if boxes.checked_mul(values).is_none_or(|points| u32::try_from(points).is_err()) {
            return Err(PromiseError::TooManyValues { boxes, values });
        }
        Ok(plan)
    }

    /// Values of u in each box.
    pub fn values(&self) -> usize {
        self.values
    }

    /// Ends that are promised together, each band over a curve one of them.
    pub fn ends(&self) -> usize {
        self.asked.len() + self.bands.len()
    }

    /// Boxes: combinations of the members of lists times focal elements.
    pub fn boxes(&self) -> usize {
        self.search_box.combinations() * self.elements.len()
    }

    /// Runs at each value of u; 1 where nothing is random.
    pub fn inner(&self) -> usize {
        self.settings.inner
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.boxes().saturating_mul(self.values).saturating_mul(self.settings.inner)
    }

    /// The settings of the promise.
    pub fn settings(&self) -> PromiseSettings {
        self.settings
    }

    /// Probability that the limit at one u fails; 0 where nothing is random.
    pub fn miss(&self) -> f64 {
        if self.problem.random.is_empty() { 0.0 } else { PROMISE_MISS }
    }

    /// All runs in their order, as round `round`.
    pub fn round(&self, round: u32) -> Vec<RunInputs> {
        let points = 0..(self.boxes() * self.values) as u32;
        points.flat_map(|point| self.runs_at(round, point)).collect()
    }

    /// The runs at value `point` of u. Random numbers belong to their place: no run depends on another.
    fn runs_at(&self, round: u32, point: u32) -> impl Iterator<Item = RunInputs> {
        let epistemic = self.value(point as usize);
        let key = hash(hash(self.problem.sampling.seed, SAMPLES), u64::from(point));
        (0..self.settings.inner as u32).map(move |index| {
            let own = hash(key, u64::from(index));
            let at: Vec<f64> = (0..self.problem.random.len() as u64).map(|input| uniform(own, input)).collect();
            let random = self.problem.random_at(&epistemic, &self.problem.levels(&at));
            let (purpose, epistemic) = (Purpose::Promise, epistemic.clone());
            RunInputs { round, purpose, point, replicate: 0, index, random, epistemic }
        })
    }

    /// Value `point` of u.
    fn value(&self, point: usize) -> Vec<f64> {
        let own_box = point / self.values;
        let key = hash(hash(self.problem.sampling.seed, VALUES), point as u64);
        let fractions: Vec<f64> = (0..self.search_box.dimensions() as u64).map(|axis| uniform(key, axis)).collect();
        let at = self.elements[own_box % self.elements.len()].region.at(&fractions);
        self.search_box.values_at(&BoxPoint { combination: own_box / self.elements.len(), at })
    }

    /// The promised bounds from the runs in `table`, in the order of the requests.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table belongs to another problem or lacks runs.
    pub fn results(&self, table: &SampleTable) -> Result<Vec<PromisedBound>, PlanError> {
        let points = self.points(table)?;
        let bound = |(asked, limit): &(PromiseRequest, OneSidedLimit)| {
            promised(table, &points, *asked, limit, |values| values[asked.request.column])
        };
        Ok(parallel::map(&self.asked, bound))
    }

    /// The factor by which the shape of `band`, over `columns`, is widened so that its share of the mechanisms stays inside for the whole
    /// curve. The shape must have been fixed without a look at the runs of the promise; one end of the promise is spent on it.
    ///
    /// # Errors
    ///
    /// [`PlanError`] where the table belongs to another problem or lacks runs.
    pub fn band(
        &self,
        table: &SampleTable,
        columns: &[usize],
        band: &SimultaneousBand,
    ) -> Result<PromisedBound, PlanError> {
        let points = self.points(table)?;
        let request = Request { column: columns[0], statistic: Statistic::band_of_curve(band.share) };
        let asked = PromiseRequest { request, side: Side::Upper };
        let (runs, shape) = (self.settings.inner, band.shape());
        let limit = OneSidedLimit::new(Statistic::quantile_at(band.share), Side::Upper, runs, self.miss());
        Ok(match limit {
            Some(limit) => promised(table, &points, asked, &limit, |values| shape.excess(values, columns)),
            None => PromisedBound { asked, bound: f64::INFINITY, witness: nowhere(), failed_values: 0 },
        })
    }

    /// The runs in `table` at each value of u, all of which must be there.
    fn points(&self, table: &SampleTable) -> Result<BTreeMap<u32, Vec<usize>>, PlanError> {
        if table.columns() != self.problem.columns {
            return Err(PlanError::OtherColumns { found: table.columns(), expected: self.problem.columns });
        }
        let mut points: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (run, inputs) in table.inputs().iter().enumerate().filter(|(_, run)| run.purpose == Purpose::Promise) {
            points.entry(inputs.point).or_default().push(run);
        }
        let expected = self.settings.inner;
        for point in 0..(self.boxes() * self.values) as u32 {
            let found = points.get(&point).map_or(0, Vec::len);
            if found != expected {
                return Err(PlanError::UnfinishedPoint { point, found, expected });
            }
        }
        Ok(points)
    }
}

/// That intervals, lists and focal elements are all that is known.
fn check_known(problem: &Problem, search_box: &SearchBox) -> Result<(), PromiseError> {
    let not_fixed = |what| Err(PromiseError::NotFixed { what });
    if problem.reading != Reading::FixedButUnknown {
        return not_fixed("another reading of intervals");
    }
    for input in &problem.epistemic {
        match input {
            EpistemicVariable::SecondOrder(_) => return not_fixed("a parameter with a distribution"),
            EpistemicVariable::Evidence(evidence) if evidence.is_scattering() => {
                return not_fixed("a quantity that scatters in an unknown way");
            }
            _ => {}
        }
    }
    if search_box.dimensions() == 0 { Err(PromiseError::NoBox) } else { Ok(()) }
}

/// The witness of what is attained nowhere.
fn nowhere() -> Witness {
    Witness { purpose: Purpose::Promise, point: 0, epistemic: Vec::new(), random: Vec::new() }
}

/// The furthest limit over all `points` of the number that `of_run` makes of the columns of a run.
fn promised(
    table: &SampleTable,
    points: &BTreeMap<u32, Vec<usize>>,
    asked: PromiseRequest,
    limit: &OneSidedLimit,
    of_run: impl Fn(&[f64]) -> f64,
) -> PromisedBound {
    let (mut furthest, mut at, mut failed_values) = (f64::NEG_INFINITY, 0, 0);
    let mut values = Vec::new();
    for (&point, runs) in points {
        values.clear();
        values.extend(runs.iter().map(|&run| of_run(table.values(run))));
        let score = limit.score(&mut values);
        failed_values += usize::from(score == f64::INFINITY);
        if score > furthest {
            (furthest, at) = (score, point);
        }
    }
    let epistemic = points.get(&at).map(|runs| table.inputs()[runs[0]].epistemic.clone()).unwrap_or_default();
    let witness = Witness { point: at, epistemic, ..nowhere() };
    PromisedBound { asked, bound: limit.of_score(furthest), witness, failed_values }
}
