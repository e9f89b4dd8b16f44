//! Which runs come next.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use rayon::prelude::*;
use thiserror::Error;

use super::assemble::Evidence;
use super::bound::Reading;
use super::inner_basis::InnerBasis;
use super::measure::{Measure, target};
use super::moments::mean;
use super::orthogonal::Axis;
use super::points::{candidates, first_points, structural_point_count};
use super::pool::{Pool, PoolPoint};
use super::problem::{MOST_POINTS, Problem, ProblemError, Request, Sampling};
use super::random_set::{run_target, values_by_run};
use super::sample::{Confidence, Estimate};
use super::search::{Direction, MOST_LOCATED_TARGETS, Search};
use super::search_box::{Place, Region, SearchBox};
use super::statistic::Statistic;
use super::structure::{Element, Structure};
use super::table::{Purpose, RunInputs, SampleTable};
use super::target::Target;
use loosepin_uncertainty::{
    Distribution, EpistemicVariable, IntervalError, Level, RandomVariable, ScrambledSobol, SobolError, hash,
};

/// After the first round, the remaining points are spent in this many rounds.
const REFINING_ROUNDS: usize = 6;

/// The whole distribution function is searched by these quantiles.
const CDF_SEARCH_PROBABILITIES: [f64; 3] = [0.05, 0.5, 0.95];

/// Of every column so many inner runs are searched where each may have its own u, to this share of their range.
const SINGLE_RUNS: usize = 8;
const SINGLE_RUN_RESOLUTION: f64 = 1e-4;

/// Separates the streams of random numbers.
const INNER: u64 = 0x0069_6e6e_6572;
const MIXTURE: u64 = 0x006d_6978_7475;

/// A checked problem and its plan: the direct double loop, in rounds.
///
/// Round 0 holds the corners, the centre and low-discrepancy points of the epistemic box, with all inner runs at each; the
/// runs of the probability-only treatment; and the first points of the joint box for the interval-only treatment; of each box
/// there is one for every combination of the members of lists. Later rounds add points where a model of some requested statistic promises more than has been attained, until none does or
/// the budget is spent. The inner points are the same at every u (common random numbers).
#[derive(Debug, Clone)]
pub struct DoubleLoop {
    problem: Problem,
    confidence: Confidence,
    /// Points of the inner runs.
    inner_sobol: ScrambledSobol,
    /// Every inner run, worked out when they are needed: a sample of millions is planned in no time.
    inner: OnceLock<Vec<InnerRun>>,
    /// Polynomials on them, worked out when they are needed; nothing where they are too few.
    inner_basis: OnceLock<Option<Arc<InnerBasis>>>,
    /// The random inputs whose values differ from one u to another, since parameters are among the epistemic inputs.
    moving: Vec<usize>,
    epistemic_box: SearchBox,
    /// The joint box of the interval-only treatment: random inputs cut, then epistemic inputs.
    joint_box: SearchBox,
    /// The parts of the epistemic box.
    structure: Structure,
    /// Those of all levels.
    searched_elements: Vec<Element>,
    whole_joint_box: [Element; 1],
    candidates: Vec<Vec<f64>>,
    joint_candidates: Vec<Vec<f64>>,
    first_outer: Vec<Place>,
    first_extreme: Vec<Place>,
    mixture: ScrambledSobol,
    /// Polynomials on the points of the mixture, worked out when they are needed.
    mixture_basis: OnceLock<Option<Arc<InnerBasis>>>,
}

/// A point of the random inputs, the same at every u.
#[derive(Debug, Clone)]
struct InnerRun {
    replicate: u32,
    index: u32,
    /// Values of the random inputs; of those that move, at no particular u.
    random: Vec<f64>,
    /// Of those that move: the part of the distribution that is taken at each u.
    levels: Vec<Level>,
}

/// Why there is no plan, or no next round.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PlanError {
    /// The problem breaks a rule.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// Sobol' points do not exist in that many dimensions.
    #[error(transparent)]
    Sobol(#[from] SobolError),
    /// A random input has no finite interval between the quantiles at which it is cut.
    #[error("random input {input}, cut at {standard_deviations} standard deviations: {source}")]
    Cut {
        /// Position of the random input.
        input: usize,
        /// Where it is cut.
        standard_deviations: f64,
        /// What is wrong with the interval.
        source: IntervalError,
    },
    /// The table belongs to a response with another number of columns.
    #[error("the table has {found} columns; the problem has {expected}")]
    OtherColumns {
        /// Columns of the table.
        found: usize,
        /// Columns of the problem.
        expected: usize,
    },
    /// A point of an earlier round lacks runs.
    #[error(
        "point {point} has {found} runs; its plan has {expected}\nhint: add all runs of a round before asking for the next"
    )]
    UnfinishedPoint {
        /// Outer index.
        point: u32,
        /// Runs in the table.
        found: usize,
        /// Runs planned.
        expected: usize,
    },
    /// There are no runs at all.
    #[error("the table is empty\nhint: run the rounds first")]
    NoRuns,
}

impl DoubleLoop {
    /// Checks `problem` and prepares its plan.
    ///
    /// # Errors
    ///
    /// [`PlanError::Problem`] where the problem breaks a rule, [`PlanError::Cut`] where a random input cannot be cut.
    pub fn try_new(problem: Problem) -> Result<Self, PlanError> {
        problem.check()?;
        let sampling = problem.sampling;
        let mut joint_box: Vec<EpistemicVariable> = Vec::with_capacity(problem.random.len() + problem.epistemic.len());
        for input in 0..problem.random.len() {
            let standard_deviations = problem.cut_standard_deviations;
            let interval =
                problem.widest_cut(input).map_err(|source| PlanError::Cut { input, standard_deviations, source })?;
            joint_box.push(interval.into());
        }
        // A parameter tells which values are likely; within the cut all of them are possible.
        joint_box.extend(problem.epistemic.iter().enumerate().map(|(epistemic, variable)| {
            if problem.is_parameter(epistemic) { variable.held() } else { variable.clone() }
        }));
        let (epistemic_box, joint_box) = (SearchBox::new(problem.epistemic.clone()), SearchBox::new(joint_box));
        let (epistemic, joint) = (epistemic_box.dimensions(), joint_box.dimensions());
        let combinations = epistemic_box.combinations();
        let structure = Structure::new(&problem, &epistemic_box);
        let mut epistemic_candidates = candidates(epistemic)?;
        if structure.is_divided() {
            epistemic_candidates.extend(structure.candidates(epistemic)?);
        }
        let everywhere = |search_box: &SearchBox, points: Vec<Vec<f64>>| -> Vec<Place> {
            let points: Vec<Vec<f64>> = points.into_iter().map(|at| search_box.axes().vertex(at)).collect();
            let places = |combination| points.iter().map(move |at| Place { combination, at: at.clone() });
            (0..combinations).flat_map(places).collect()
        };
        let first = |search_box: &SearchBox, count: usize| -> Result<Vec<Place>, SobolError> {
            let dimensions = search_box.dimensions();
            let points = first_points(sampling.seed, dimensions, first_count(dimensions, count / combinations))?;
            Ok(everywhere(search_box, points))
        };
        Ok(Self {
            confidence: Confidence::new(sampling.confidence, sampling.replicates),
            inner_sobol: ScrambledSobol::try_new(hash(sampling.seed, INNER), problem.random.len())?,
            inner: OnceLock::new(),
            inner_basis: OnceLock::new(),
            moving: problem.inputs_with_parameters(),
            candidates: epistemic_candidates,
            joint_candidates: candidates(joint)?,
            first_outer: if structure.is_divided() {
                let points = first_divided(sampling.seed, epistemic, sampling.outer / combinations, &structure)?;
                everywhere(&epistemic_box, points)
            } else {
                first(&epistemic_box, sampling.outer)?
            },
            whole_joint_box: [Element { mass: 1.0, region: Region::whole(joint) }],
            searched_elements: structure.levels.iter().flat_map(|level| level.elements.iter().cloned()).collect(),
            structure,
            first_extreme: first(&joint_box, sampling.extreme)?,
            mixture: ScrambledSobol::try_new(hash(sampling.seed, MIXTURE), joint_box.inputs().len())?,
            mixture_basis: OnceLock::new(),
            epistemic_box,
            joint_box,
            problem,
        })
    }

    /// The same plan with sampling errors at another confidence than the stated one.
    pub(super) fn with_errors_at(self, confidence: f64) -> Self {
        Self { confidence: Confidence::new(confidence, self.problem.sampling.replicates), ..self }
    }

    /// The problem.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The same plan with intervals read in another way.
    #[must_use]
    pub fn read_as(&self, reading: Reading) -> Self {
        let mut plan = self.clone();
        plan.problem.reading = reading;
        plan
    }

    /// The same plan for the single statistics alone, without distribution functions and compared treatments.
    #[must_use]
    pub fn statistics_alone(mut self) -> Self {
        self.problem.compared_columns.clear();
        self.problem.requests.retain(|request| request.statistic != Statistic::Cdf);
        self
    }

    /// Outer index of the centre of the epistemic box, discrete inputs at their first members.
    pub fn centre_point(&self) -> u32 {
        structural_point_count(self.epistemic_box.dimensions()) as u32 - 1
    }

    /// Values of the epistemic inputs at the centre and at the corners of their box, the centre first; for each combination of the
    /// members of lists, those of the first members first.
    pub fn structural_points(&self) -> Vec<Vec<f64>> {
        let places = self.box_places();
        (0..self.box_combinations())
            .flat_map(|combination| places.iter().map(move |at| (combination, at)))
            .map(|(combination, at)| self.box_values(combination, at))
            .collect()
    }

    /// Centre and corners of the unit box of the intervals, the centre first.
    pub fn box_places(&self) -> Vec<Vec<f64>> {
        let count = structural_point_count(self.epistemic_box.dimensions());
        self.first_outer[..count].iter().rev().map(|place| place.at.clone()).collect()
    }

    /// Whether each axis of that box is an angle over a whole turn, so that its ends are the same.
    pub fn box_closes(&self) -> Vec<bool> {
        let axes = self.epistemic_box.axes();
        (0..self.epistemic_box.dimensions()).map(|axis| axes.is_periodic(axis)).collect()
    }

    /// Combinations of the members of lists, each with a box of intervals of its own; 1 without lists.
    pub fn box_combinations(&self) -> usize {
        self.epistemic_box.combinations()
    }

    /// Values of the random inputs at a point of the unit cube, coordinate by coordinate the probability of not exceeding them, for
    /// these values of the epistemic inputs.
    pub fn random_values(&self, point: &[f64], epistemic: &[f64]) -> Vec<f64> {
        self.problem.random_at(epistemic, &self.problem.levels(point))
    }

    /// Values of the epistemic inputs at a place of the unit box, in one of the combinations.
    pub fn box_values(&self, combination: usize, at: &[f64]) -> Vec<f64> {
        self.epistemic_box.values_at(&Place { combination, at: at.to_vec() })
    }

    /// The most runs that the plan may come to.
    pub fn most_runs(&self) -> usize {
        let sampling = &self.problem.sampling;
        let outer = if self.epistemic_box.dimensions() == 0 { self.first_outer.len() } else { sampling.outer };
        let mixture = if self.has_mixture() { sampling.mixture } else { 0 };
        let extreme = if self.has_extremes() { sampling.extreme } else { 0 };
        outer.saturating_mul(self.inner_runs()).saturating_add(mixture + extreme)
    }

    /// Inner runs at each outer point.
    pub fn inner_runs(&self) -> usize {
        if self.problem.random.is_empty() { 1 } else { self.problem.sampling.inner }
    }

    /// The runs of the next round, in their order; empty when the plan is finished.
    ///
    /// Depends only on the problem and on the results in `table`, which must hold every run of the rounds before. These may be
    /// those of a plan of the same problem with smaller samples: then what its points lack comes first.
    ///
    /// # Errors
    ///
    /// [`PlanError::OtherColumns`] or [`PlanError::UnfinishedPoint`] where the table is not that.
    pub fn next_round(&self, table: &SampleTable) -> Result<Vec<RunInputs>, PlanError> {
        self.check_table(table)?;
        let round = table.rounds();
        if round == 0 {
            return Ok(self.first_round());
        }
        let mut runs = Vec::new();
        let outer = Pool::gather(table, Purpose::DoubleLoop, self.searched().iter().map(|search| search.0.column));
        if let Some([replicates, each]) = self.smaller_sample(table, &outer) {
            let of_point = |point: &PoolPoint| self.runs_at(round, point.point, point.epistemic.clone());
            let wanted = outer.points.iter().flat_map(of_point);
            let mut runs: Vec<RunInputs> =
                wanted.filter(|inputs| inputs.replicate >= replicates || inputs.index >= each).collect();
            if self.has_mixture() {
                let more = self.mixture_runs().filter(|inputs| inputs.replicate >= replicates);
                runs.extend(more.map(|inputs| RunInputs { round, ..inputs }));
            }
            return Ok(runs);
        }
        self.check_points(&outer)?;
        // Of curves only the bounds themselves are worth the time that polynomials take, the search is not.
        let is_curve = self.searched().len() > MOST_LOCATED_TARGETS;
        let outer = if is_curve { outer } else { outer.with_polynomials(self.inner_basis()) };
        let rest = self.problem.sampling.outer.saturating_sub(outer.points.len());
        if self.epistemic_box.dimensions() > 0 && rest > 0 {
            let count = rest.min(self.points_per_round(self.problem.sampling.outer, &self.first_outer));
            for place in self.next_outer(table, &outer, count) {
                let point = (outer.points.len() + runs.len() / self.inner_runs()) as u32;
                runs.extend(self.runs_at(round, point, self.epistemic_box.values_at(&place)));
            }
        }
        if self.has_extremes() {
            let extremes = Pool::gather(table, Purpose::Extreme, self.problem.compared_columns.iter().copied());
            let rest = self.problem.sampling.extreme.saturating_sub(extremes.points.len());
            let count = rest.min(self.points_per_round(self.problem.sampling.extreme, &self.first_extreme));
            if count > 0 {
                let next = self.next_extremes(&extremes, count);
                let known = extremes.points.len();
                runs.extend(
                    next.iter().enumerate().map(|(i, place)| self.extreme_run(round, (known + i) as u32, place)),
                );
            }
        }
        Ok(runs)
    }

    /// How many runs the first round has.
    pub fn first_round_runs(&self) -> usize {
        let mixture = if self.has_mixture() { self.problem.sampling.mixture } else { 0 };
        let extreme = if self.has_extremes() { self.first_extreme.len() } else { 0 };
        self.first_outer.len().saturating_mul(self.inner_runs()).saturating_add(mixture + extreme)
    }

    fn first_round(&self) -> Vec<RunInputs> {
        let mut runs: Vec<RunInputs> = Vec::new();
        for (point, place) in self.first_outer.iter().enumerate() {
            runs.extend(self.runs_at(0, point as u32, self.epistemic_box.values_at(place)));
        }
        if self.has_mixture() {
            runs.extend(self.mixture_runs());
        }
        if self.has_extremes() {
            let first = self.first_extreme.iter().enumerate();
            runs.extend(first.map(|(point, place)| self.extreme_run(0, point as u32, place)));
        }
        runs
    }

    fn next_outer(&self, table: &SampleTable, pool: &Pool, count: usize) -> Vec<Place> {
        let points = self.outer_places(pool);
        let searched = self.searched();
        // Quantiles of several elements together end where the probabilities of all of them add up. For curves, whose targets are
        // many, the quantiles of each element have to do.
        let has_joint_quantiles = self.structure.widest().elements.len() > 1 && searched.len() <= MOST_LOCATED_TARGETS;
        let is_joint = |request: &Request| {
            has_joint_quantiles
                && matches!(request.statistic, Statistic::Quantile(_))
                && self.problem.requests.contains(request)
        };
        let mut targets: Vec<(Target, Vec<Direction>)> = searched
            .par_iter()
            .filter(|(request, _)| !is_joint(request))
            .flat_map_iter(|(request, directions)| {
                let measure = Measure::new(&pool.samples(request.column), request.statistic, &self.confidence);
                let targets = measure.into_iter().flat_map(Measure::into_targets);
                targets.map(|target| (target, directions.clone()))
            })
            .collect();
        if has_joint_quantiles {
            targets.extend(Evidence::new(self, pool, table).joint_quantile_targets());
        }
        let mut readings = std::iter::once(self.problem.reading).chain(self.problem.readings_beside.iter().copied());
        if readings.any(|reading| reading == Reading::RandomSet) {
            targets.extend(self.single_runs(table));
        }
        let search =
            Search::new(self.epistemic_box.axes(), &points, &self.candidates, targets.iter().map(|(target, _)| target));
        next_or_surrounding(&search, &targets, &self.searched_elements, count)
    }

    /// The response itself at some of the inner runs: where every sample may have its own u, their extremes are wanted.
    fn single_runs(&self, table: &SampleTable) -> Vec<(Target, Vec<Direction>)> {
        let of_column = |column: usize| {
            let (replicates, points) = values_by_run(table, column);
            let step = replicates.len().div_ceil(SINGLE_RUNS).max(1);
            let runs = (0..replicates.len()).step_by(step);
            let targets = runs.map(move |run| {
                let target = run_target(&points, run, f64::MIN_POSITIVE);
                let resolution = (SINGLE_RUN_RESOLUTION * target.range()).max(f64::MIN_POSITIVE);
                (run_target(&points, run, resolution), Direction::BOTH.to_vec())
            });
            targets.collect::<Vec<_>>()
        };
        self.needed_columns().into_iter().flat_map(of_column).collect()
    }

    fn next_extremes(&self, pool: &Pool, count: usize) -> Vec<Place> {
        let points = self.extreme_places(pool);
        let targets: Vec<(Target, Vec<Direction>)> = self
            .problem
            .compared_columns
            .iter()
            .map(|&column| (self.extreme_target(pool, column), Direction::BOTH.to_vec()))
            .collect();
        let search = Search::new(
            self.joint_box.axes(),
            &points,
            &self.joint_candidates,
            targets.iter().map(|(target, _)| target),
        );
        next_or_surrounding(&search, &targets, &self.whole_joint_box, count)
    }

    /// Statistics whose extremes steer the search, and which extremes.
    pub(super) fn searched(&self) -> Vec<(Request, Vec<Direction>)> {
        let both = Direction::BOTH.to_vec();
        let mut searched = Vec::new();
        for request in &self.problem.requests {
            if request.statistic == Statistic::Cdf {
                for probability in CDF_SEARCH_PROBABILITIES {
                    let statistic = Statistic::Quantile(probability);
                    searched.push((Request { column: request.column, statistic }, both.clone()));
                }
            } else {
                searched.push((*request, both.clone()));
            }
        }
        for &column in &self.problem.compared_columns {
            for (statistic, direction) in self.band_statistics() {
                let request = Request { column, statistic };
                if !self.problem.requests.contains(&request) {
                    searched.push((request, vec![direction]));
                }
            }
        }
        searched
    }

    /// The statistics that bound the central band of the mixed treatment, and the extreme that is wanted of each.
    pub(super) fn band_statistics(&self) -> [(Statistic, Direction); 2] {
        let tail = 0.5 * (1.0 - self.problem.band_probability);
        [(Statistic::Quantile(tail), Direction::Minimum), (Statistic::Quantile(1.0 - tail), Direction::Maximum)]
    }

    /// Columns that any result needs.
    pub(super) fn needed_columns(&self) -> BTreeSet<usize> {
        let requested = self.problem.requests.iter().map(|request| request.column);
        requested.chain(self.problem.compared_columns.iter().copied()).collect()
    }

    /// One run at each place of the joint box, as something to search.
    pub(super) fn extreme_target(&self, pool: &Pool, column: usize) -> Target {
        let at: Vec<Estimate> = pool.samples(column).into_iter().map(|sample| mean(sample, &self.confidence)).collect();
        target(&at, &self.confidence)
    }

    /// Places of the outer points.
    pub(super) fn outer_places(&self, pool: &Pool) -> Vec<Place> {
        pool.points.iter().map(|point| self.epistemic_box.place_of(&point.epistemic)).collect()
    }

    /// Shares of the mechanisms whose u lies somewhere in an element, each with the outer points in it, where u differs from mechanism to
    /// mechanism; else all of them at one u, which may be any.
    pub(super) fn shares_of_mechanisms(&self, pool: &Pool) -> Vec<(f64, Vec<usize>)> {
        let is_unknown = |input: &EpistemicVariable| {
            let EpistemicVariable::Evidence(evidence) = input else { return false };
            evidence.elements().len() > 1 && !evidence.is_scattering()
        };
        let is_fixed =
            self.problem.reading == Reading::FixedButUnknown && self.problem.epistemic.iter().any(is_unknown);
        if is_fixed {
            return vec![(1.0, (0..pool.points.len()).collect())];
        }
        let places = self.outer_places(pool);
        let elements = self.structure.widest().elements.iter();
        elements.map(|element| (element.mass, element.region.members(&places))).collect()
    }

    /// Places of single runs in the box of all inputs.
    pub(super) fn extreme_places(&self, pool: &Pool) -> Vec<Place> {
        let values = |point: &PoolPoint| [&point.random[..], &point.epistemic].concat();
        pool.points.iter().map(|point| self.joint_box.place_of(&values(point))).collect()
    }

    /// The parts of the epistemic box.
    pub(super) fn structure(&self) -> &Structure {
        &self.structure
    }

    pub(super) fn confidence(&self) -> &Confidence {
        &self.confidence
    }

    /// Polynomials on the inner points; nothing where these are too few.
    pub(super) fn inner_basis(&self) -> Option<&InnerBasis> {
        self.inner_basis.get_or_init(|| inner_basis(&self.problem, &self.inner_sobol).map(Arc::new)).as_deref()
    }

    /// Polynomials of all inputs on the points of the probability-only treatment, or on those of the double loop where that is the same;
    /// nothing where these are too few.
    pub(super) fn mixture_basis(&self) -> Option<&InnerBasis> {
        if !self.has_mixture() {
            return self.inner_basis();
        }
        let basis = || {
            let axes: Vec<Axis> =
                random_axes(&self.problem).chain(self.problem.epistemic.iter().map(|_| Axis::Legendre)).collect();
            let points: Vec<Vec<f64>> = self.mixture_points().map(|(_, _, point)| point).collect();
            InnerBasis::new(&axes, &points, self.problem.sampling.replicates).map(Arc::new)
        };
        self.mixture_basis.get_or_init(basis).as_deref()
    }

    pub(super) fn candidates(&self) -> &[Vec<f64>] {
        &self.candidates
    }

    pub(super) fn joint_candidates(&self) -> &[Vec<f64>] {
        &self.joint_candidates
    }

    pub(super) fn epistemic_box(&self) -> &SearchBox {
        &self.epistemic_box
    }

    pub(super) fn joint_box(&self) -> &SearchBox {
        &self.joint_box
    }

    /// Whether the probability-only treatment needs runs of its own: without epistemic inputs it is the double loop.
    pub(super) fn has_mixture(&self) -> bool {
        !self.problem.compared_columns.is_empty() && !self.epistemic_box.is_a_point()
    }

    /// Whether the interval-only treatment needs runs of its own: without random inputs it is the double loop.
    pub(super) fn has_extremes(&self) -> bool {
        !self.problem.compared_columns.is_empty() && !self.problem.random.is_empty()
    }

    fn points_per_round(&self, budget: usize, first: &[Place]) -> usize {
        (budget - first.len()).div_ceil(REFINING_ROUNDS)
    }

    /// Every inner run at the outer point `point`.
    pub(super) fn runs_at(&self, round: u32, point: u32, epistemic: Vec<f64>) -> impl Iterator<Item = RunInputs> {
        let moved: Vec<(usize, Option<RandomVariable>)> =
            self.moving.iter().map(|&input| (input, self.problem.variable_at(input, &epistemic))).collect();
        let inner = self.inner.get_or_init(|| inner_runs(&self.problem, &self.inner_sobol));
        inner.iter().map(move |run| {
            let mut random = run.random.clone();
            for ((input, variable), &level) in moved.iter().zip(&run.levels) {
                random[*input] = variable.as_ref().map_or(f64::NAN, |variable| variable.at(level));
            }
            RunInputs {
                round,
                purpose: Purpose::DoubleLoop,
                point,
                replicate: run.replicate,
                index: run.index,
                random,
                epistemic: epistemic.clone(),
            }
        })
    }

    fn mixture_runs(&self) -> impl Iterator<Item = RunInputs> {
        self.mixture_points().map(|(replicate, index, point)| {
            let (random, epistemic) = point.split_at(self.problem.random.len());
            let epistemic = self.problem.epistemic.iter().zip(epistemic);
            let epistemic: Vec<f64> = epistemic.map(|(variable, &fraction)| variable.at(fraction)).collect();
            let random = self.problem.random_at(&epistemic, &self.problem.levels(random));
            RunInputs { round: 0, purpose: Purpose::Mixture, point: 0, replicate, index, random, epistemic }
        })
    }

    /// Replicate, index and point of the unit cube of every run of the probability-only treatment.
    fn mixture_points(&self) -> impl Iterator<Item = (u32, u32, Vec<f64>)> {
        let per_replicate = (self.problem.sampling.mixture / self.problem.sampling.replicates) as u32;
        let replicates = 0..self.problem.sampling.replicates as u32;
        replicates.flat_map(move |replicate| {
            (0..per_replicate).map(move |index| {
                let mut point = vec![0.0; self.mixture.dimensions()];
                self.mixture.write_point(replicate, index, &mut point);
                (replicate, index, point)
            })
        })
    }

    fn extreme_run(&self, round: u32, point: u32, place: &Place) -> RunInputs {
        let mut random = self.joint_box.values_at(place);
        let epistemic = random.split_off(self.problem.random.len());
        RunInputs { round, purpose: Purpose::Extreme, point, replicate: 0, index: 0, random, epistemic }
    }

    fn check_table(&self, table: &SampleTable) -> Result<(), PlanError> {
        if table.columns() == self.problem.columns {
            Ok(())
        } else {
            Err(PlanError::OtherColumns { found: table.columns(), expected: self.problem.columns })
        }
    }

    /// Replicates, and runs in each, at the outer points of `pool`, where the plan has more of either: `table` is then that of a
    /// plan with a smaller sample, whose runs are the first ones of these.
    fn smaller_sample(&self, table: &SampleTable, pool: &Pool) -> Option<[u32; 2]> {
        let known = pool.points.first()?;
        let own = table.inputs().iter().filter(|inputs| inputs.purpose == Purpose::DoubleLoop);
        let [replicates, each] =
            own.filter(|inputs| inputs.point == known.point).fold([0; 2], |[replicates, each], inputs| {
                [replicates.max(inputs.replicate + 1), each.max(inputs.index + 1)]
            });
        let is_whole = known.runs == replicates as usize * each as usize;
        let is_smaller = known.runs < self.inner_runs() && replicates as usize <= self.problem.sampling.replicates;
        let is_same = |point: &PoolPoint| point.runs == known.runs;
        (is_whole && is_smaller && pool.points.iter().all(is_same)).then_some([replicates, each])
    }

    /// Whether every outer point of `pool` has all its inner runs.
    pub(super) fn check_points(&self, pool: &Pool) -> Result<(), PlanError> {
        let expected = self.inner_runs();
        match pool.points.iter().find(|point| point.runs != expected) {
            Some(point) => Err(PlanError::UnfinishedPoint { point: point.point, found: point.runs, expected }),
            None => Ok(()),
        }
    }
}

/// Where two slopes meet and where models promise more than was attained; where neither does, the surroundings of what was attained.
fn next_or_surrounding(
    search: &Search<'_>,
    targets: &[(Target, Vec<Direction>)],
    elements: &[Element],
    count: usize,
) -> Vec<Place> {
    let mut places = search.kinks(targets, elements, count, MOST_POINTS);
    if places.len() < count {
        places.extend(search.next_points(targets, elements, count - places.len(), MOST_POINTS));
    }
    if places.is_empty() { search.surroundings(targets, elements, count, MOST_POINTS) } else { places }
}

/// How many of `budget` points the first round takes: the corners, the centre, and about half of the budget.
fn first_count(dimensions: usize, budget: usize) -> usize {
    if dimensions == 0 { 1 } else { budget.min((budget / 2).max(structural_point_count(dimensions) + 2 * dimensions)) }
}

/// The first points of a box with parts: corners and centres of all of them, then low-discrepancy points up to half of the budget.
fn first_divided(
    seed: u64,
    dimensions: usize,
    budget: usize,
    structure: &Structure,
) -> Result<Vec<Vec<f64>>, SobolError> {
    let structural = structure.points(dimensions);
    let count = first_count(dimensions, budget).max(structural.len() + 2 * dimensions).min(budget);
    let interior = first_points(seed, dimensions, structural_point_count(dimensions) + count - structural.len())?;
    let interior = interior.into_iter().skip(structural_point_count(dimensions));
    Ok(structural.into_iter().chain(interior).collect())
}

/// Every inner run; a single one where nothing is random.
fn inner_runs(problem: &Problem, sobol: &ScrambledSobol) -> Vec<InnerRun> {
    if problem.random.is_empty() {
        return vec![InnerRun { replicate: 0, index: 0, random: Vec::new(), levels: Vec::new() }];
    }
    let moving = problem.inputs_with_parameters();
    let run = |(replicate, index, point): (u32, u32, Vec<f64>)| {
        let levels = problem.levels(&point);
        InnerRun {
            replicate,
            index,
            random: problem.random.iter().zip(&levels).map(|(variable, &level)| variable.at(level)).collect(),
            levels: moving.iter().map(|&input| levels[input]).collect(),
        }
    };
    inner_points(&problem.sampling, sobol).map(run).collect()
}

/// Replicate, index and point of the unit cube of every inner run.
fn inner_points(sampling: &Sampling, sobol: &ScrambledSobol) -> impl Iterator<Item = (u32, u32, Vec<f64>)> {
    let replicates = sampling.replicates as u32;
    let per_replicate = (sampling.inner / sampling.replicates) as u32;
    let indices = (0..replicates).flat_map(move |replicate| (0..per_replicate).map(move |index| (replicate, index)));
    indices.map(|(replicate, index)| {
        let mut point = vec![0.0; sobol.dimensions()];
        sobol.write_point(replicate, index, &mut point);
        (replicate, index, point)
    })
}

/// In what a response may be smooth: a uniform input in its own probability; what else there is, and what is correlated, in the standard
/// normal variable of the same rank.
fn random_axes(problem: &Problem) -> impl Iterator<Item = Axis> {
    problem.random.iter().map(|variable| match variable.distribution() {
        Distribution::Uniform { .. } if problem.copula.is_none() => Axis::Legendre,
        _ => Axis::Hermite,
    })
}

/// Polynomials of the random inputs on the inner points; none where an input takes single values only: runs do not show what a response
/// does at one that was never drawn.
fn inner_basis(problem: &Problem, sobol: &ScrambledSobol) -> Option<InnerBasis> {
    if problem.random.is_empty() || problem.random.iter().any(RandomVariable::has_atoms) {
        return None;
    }
    let axes: Vec<Axis> = random_axes(problem).collect();
    let points: Vec<Vec<f64>> = inner_points(&problem.sampling, sobol).map(|(_, _, point)| point).collect();
    InnerBasis::new(&axes, &points, problem.sampling.replicates)
}

#[cfg(test)]
mod tests;
