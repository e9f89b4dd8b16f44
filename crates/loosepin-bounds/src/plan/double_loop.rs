//! A checked problem and its plan.

use super::error::PlanError;
use super::inner_runs::InnerRuns;
use crate::data::problem::{Problem, Reading, Request, Sampling};
use crate::data::table::{RunInputs, SampleTable};
use crate::estimators::estimate::Confidence;
use crate::estimators::pool::{Pool, PoolPoint};
use crate::readings::setup::Setup;
use crate::search::design::{first_points, structural_point_count};
use crate::search::parts::{Element, Structure};
use crate::search::search_box::{BoxPoint, Region, SearchBox};
use loosepin_uncertainty::{EpistemicVariable, SobolError};

/// Runs in each replicate of a pilot, at least.
const MIN_PILOT_RUNS: usize = 2;

/// The direct double loop, in rounds.
///
/// Round 0 holds the corners, the centre and low-discrepancy points of the epistemic box, with all inner runs at each; the runs of the
/// probability-only treatment; and the first points of the joint box for the interval-only treatment. Of each box there is one for every
/// combination of the members of lists. Later rounds add points where a model of some requested statistic promises more than has been
/// attained, then where most is conceded, until nothing is or the budget is spent. The inner points are the same at every u (common random numbers).
#[derive(Debug, Clone)]
pub struct DoubleLoop {
    pub(crate) setup: Setup,
    inner_runs: InnerRuns,
    /// Elements of all cuts.
    pub(super) searched_elements: Vec<Element>,
    pub(super) whole_joint_box: [Element; 1],
    pub(super) first_outer: Vec<BoxPoint>,
    pub(super) first_extreme: Vec<BoxPoint>,
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
        let mut joint: Vec<EpistemicVariable> = Vec::with_capacity(problem.random.len() + problem.epistemic.len());
        for input in 0..problem.random.len() {
            let standard_deviations = problem.cut_standard_deviations;
            let interval =
                problem.widest_cut(input).map_err(|source| PlanError::Cut { input, standard_deviations, source })?;
            joint.push(interval.into());
        }
        // A parameter tells which values are likely; within the cut all of them are possible.
        joint.extend(problem.epistemic.iter().enumerate().map(|(epistemic, variable)| {
            if problem.is_parameter(epistemic) { variable.at_middle() } else { variable.clone() }
        }));
        let setup = Setup::try_new(problem, joint)?;
        let (epistemic_box, structure) = (&setup.epistemic_box, &setup.structure);
        // Every combination of the members of lists of the problem has a box of its own.
        let combinations = epistemic_box.combinations();
        let everywhere = |search_box: &SearchBox, points: Vec<Vec<f64>>| -> Vec<BoxPoint> {
            let points: Vec<Vec<f64>> = points.into_iter().map(|at| search_box.axes().vertex(at)).collect();
            let places = |combination| points.iter().map(move |at| BoxPoint { combination, at: at.clone() });
            (0..combinations).flat_map(places).collect()
        };
        let first = |search_box: &SearchBox, count: usize| -> Result<Vec<BoxPoint>, SobolError> {
            let dimensions = search_box.dimensions();
            let points = first_points(sampling.seed, dimensions, first_count(dimensions, count / combinations))?;
            Ok(everywhere(search_box, points))
        };
        let first_outer = if structure.is_divided() {
            let dimensions = epistemic_box.dimensions();
            let points = first_divided(sampling.seed, dimensions, sampling.outer / combinations, structure)?;
            everywhere(epistemic_box, points)
        } else {
            first(epistemic_box, sampling.outer)?
        };
        Ok(Self {
            inner_runs: InnerRuns::new(&setup),
            searched_elements: structure.elements().cloned().collect(),
            whole_joint_box: [Element { mass: 1.0, region: Region::whole(setup.joint_box.dimensions()) }],
            first_extreme: first(&setup.joint_box, sampling.extreme)?,
            first_outer,
            setup,
        })
    }

    /// This plan with sampling errors at another confidence than the stated one.
    pub(crate) fn with_errors_at(mut self, confidence: f64) -> Self {
        self.setup.confidence = Confidence::new(confidence, self.setup.problem.sampling.replicates);
        self
    }

    /// The problem.
    pub fn problem(&self) -> &Problem {
        &self.setup.problem
    }

    /// This plan with intervals read in another way.
    #[must_use]
    pub fn read_as(&self, reading: Reading) -> Self {
        let mut plan = self.clone();
        plan.setup.problem.reading = reading;
        plan
    }

    /// This plan for the single statistics alone, without distribution functions and compared treatments.
    #[must_use]
    pub fn statistics_alone(mut self) -> Self {
        self.setup.problem.compared_columns.clear();
        self.setup.problem.requests.retain(|request| request.statistic.is_single());
        self
    }

    /// This plan for the requests that are `meant`, without distribution functions, compared treatments and other readings: what its
    /// runs say of them so far, at little cost. Nothing where none are.
    pub fn draft(&self, is_meant: impl Fn(&Request) -> bool) -> Option<Self> {
        let mut plan = self.clone().statistics_alone();
        let problem = &mut plan.setup.problem;
        problem.requests.retain(is_meant);
        problem.readings_beside.clear();
        problem.percentiles.clear();
        (!problem.requests.is_empty()).then_some(plan)
    }

    /// A plan whose first round is a part of that of this one: a quarter of the inner runs and `runs` altogether at most, but two in each
    /// replicate; `None` if this plan has no more.
    pub fn pilot(&self, runs: usize) -> Option<Self> {
        let mut problem = self.problem().clone();
        let Sampling { replicates, inner, .. } = problem.sampling;
        let each = (runs / (self.first_outer.len() * replicates)).min(inner / replicates / 4).max(MIN_PILOT_RUNS);
        // Scrambled points fill the box evenly by powers of two.
        let each = 1 << each.ilog2();
        if problem.random.is_empty() || replicates * each >= inner {
            return None;
        }
        problem.sampling.inner = replicates * each;
        let mut pilot = Self::try_new(problem).ok()?;
        pilot.setup.confidence = self.setup.confidence;
        Some(pilot)
    }

    /// Outer index of the centre of the epistemic box, discrete inputs at their first members.
    pub fn centre_point(&self) -> u32 {
        structural_point_count(self.setup.epistemic_box.dimensions()) as u32 - 1
    }

    /// Values of the epistemic inputs at the centre and at the corners of their box, the centre first; for each combination of the
    /// members of lists, those of the first members first.
    pub fn structural_points(&self) -> Vec<Vec<f64>> {
        let places = self.centre_and_corners();
        (0..self.box_combinations())
            .flat_map(|combination| places.iter().map(move |at| (combination, at)))
            .map(|(combination, at)| self.box_values(combination, at))
            .collect()
    }

    /// Centre and corners of the unit box of the intervals, the centre first.
    pub fn centre_and_corners(&self) -> Vec<Vec<f64>> {
        let count = structural_point_count(self.setup.epistemic_box.dimensions());
        self.first_outer[..count].iter().rev().map(|place| place.at.clone()).collect()
    }

    /// Whether each axis of that box is an angle over a whole turn, so that its ends are the same.
    pub fn box_closes(&self) -> Vec<bool> {
        let axes = self.setup.epistemic_box.axes();
        (0..self.setup.epistemic_box.dimensions()).map(|axis| axes.is_periodic(axis)).collect()
    }

    /// Combinations of the members of lists, each with a box of intervals of its own; 1 without lists.
    pub fn box_combinations(&self) -> usize {
        self.setup.epistemic_box.combinations()
    }

    /// Values of the random inputs at a point of the unit cube, coordinate by coordinate the probability of not exceeding them, for
    /// these values of the epistemic inputs.
    pub fn random_values(&self, point: &[f64], epistemic: &[f64]) -> Vec<f64> {
        self.setup.problem.random_at(epistemic, &self.setup.problem.levels(point))
    }

    /// Values of the epistemic inputs at a place of the unit box, in one of the combinations.
    pub fn box_values(&self, combination: usize, at: &[f64]) -> Vec<f64> {
        self.setup.epistemic_box.values_at(&BoxPoint { combination, at: at.to_vec() })
    }

    /// Upper limit of the number of runs of the plan.
    pub fn most_runs(&self) -> usize {
        let outer =
            if self.setup.has_no_epistemic_inputs() { self.first_outer.len() } else { self.problem().sampling.outer };
        self.runs_of(outer, self.problem().sampling.extreme)
    }

    /// How many runs the first round has.
    pub fn first_round_runs(&self) -> usize {
        self.runs_of(self.first_outer.len(), self.first_extreme.len())
    }

    fn runs_of(&self, outer: usize, extreme: usize) -> usize {
        let mixture = if self.setup.has_mixture() { self.problem().sampling.mixture } else { 0 };
        let extreme = if self.setup.has_extremes() { extreme } else { 0 };
        outer.saturating_mul(self.inner_runs()).saturating_add(mixture + extreme)
    }

    /// Inner runs at each outer point.
    pub fn inner_runs(&self) -> usize {
        self.setup.inner_runs()
    }

    /// The first inner runs, `each` at most, at each of the first outer points whose epistemic inputs are meant, `points` at most; no
    /// others are drawn.
    pub fn first_runs(&self, points: usize, each: usize, is_meant: impl Fn(&[f64]) -> bool) -> Vec<RunInputs> {
        let all = (0..).zip(self.first_outer.iter().map(|place| self.setup.epistemic_box.values_at(place)));
        let meant = all.filter(|(_, epistemic)| is_meant(epistemic)).take(points);
        meant.flat_map(|(point, at)| self.inner_runs.first(&self.setup, each, point, at)).collect()
    }

    /// Every inner run at the outer point `point`.
    pub(crate) fn runs_at(&self, round: u32, point: u32, epistemic: Vec<f64>) -> impl Iterator<Item = RunInputs> {
        self.inner_runs.at(&self.setup, round, point, epistemic)
    }

    /// Whether `table` has the columns of the problem.
    pub(super) fn check_table(&self, table: &SampleTable) -> Result<(), PlanError> {
        if table.columns() == self.problem().columns {
            Ok(())
        } else {
            Err(PlanError::OtherColumns { found: table.columns(), expected: self.problem().columns })
        }
    }

    /// Whether every outer point of `pool` has all its inner runs, and members of lists alone.
    pub(super) fn check_points(&self, pool: &Pool) -> Result<(), PlanError> {
        let expected = self.inner_runs();
        for PoolPoint { point, epistemic, .. } in &pool.points {
            if let Some(input) = self.setup.epistemic_box.first_unlisted(epistemic) {
                return Err(PlanError::UnknownMember { point: *point, input, value: epistemic[input] });
            }
        }
        match pool.points.iter().find(|point| point.runs != expected) {
            Some(point) => Err(PlanError::UnfinishedPoint { point: point.point, found: point.runs, expected }),
            None => Ok(()),
        }
    }
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

#[cfg(test)]
mod tests;
