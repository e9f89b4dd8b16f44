//! Bounds to an accuracy: samples that grow until no bound is widened by more than is asked.

use super::double_loop::DoubleLoop;
use super::error::PlanError;
use crate::data::bound::{Bound, BoundPair};
use crate::data::problem::{Problem, Request, Sampling};
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::estimators::pool::Pool;
use crate::readings::bounds::Bounds;
use crate::search::design::{first_points, structural_point_count};
use crate::search::search_box::BoxPoint;

/// Inner runs, at most.
const MAX_INNER: usize = 1 << 24;

/// Outer points of a combination to which samples grow by themselves: their models are some 400 matrices of order 384. More must be asked
/// for.
const MAX_GROWN: usize = 2048;

/// Least number of replicates for a sampling error that decides when to end: a few of them agree by chance too often, and the end would be
/// where they do.
const MIN_REPLICATES: usize = 16;

/// Share of the existing points that is added between them where the search sees nothing to gain, and at least [`MIN_FILLING`].
const FILLING_SHARE: usize = 8;
const MIN_FILLING: usize = 4;

/// Two points are not the same where they differ by more than this, in units of the box.
const MIN_DISTANCE: f64 = 1e-6;

/// How far the bounds of a statistic may be widened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Goal {
    /// The statistic.
    pub request: Request,
    /// The most that either of its bounds may be widened by, > 0, in the unit of the bound.
    pub most: f64,
}

/// Widening over the requested accuracy at the end of a plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assessment {
    /// Rounds that were made.
    pub rounds: u32,
    /// Runs that were made.
    pub runs: usize,
    /// Outer points.
    pub outer: usize,
    /// Inner runs at each.
    pub inner: usize,
    /// Runs to learn from, where the bounds are those of surrogates.
    pub training: usize,
    /// Direct runs at the witnesses of such bounds.
    pub confirming: usize,
    /// The largest widening over the allowed one; 1 or less if all goals are reached.
    pub share: f64,
    /// The largest sampling error over the allowed one, among bounds that are too wide.
    pub sampling_share: f64,
    /// The largest error of the search over the allowed one, among bounds that are too wide.
    pub optimisation_share: f64,
}

/// Progress of the sample refinement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RefinementStatus {
    /// Further rounds are needed.
    Growing,
    /// Every goal is reached.
    Reached,
    /// More runs are not possible, or do not help.
    Exhausted,
}

/// The direct double loop with samples that grow until goals are reached.
///
/// The plan of the problem comes first, as it stands. Then, again and again, the part of the error that is furthest from its goal
/// is made smaller: twice as many inner runs at every point (the first half of them being there: Sobol' points of the same
/// scramblings, first with more scramblings, then with more points in each), or half as many points again, where the search
/// promises most or, where it promises nothing, between those that are there. All runs stay. The rounds depend on the results of
/// the rounds before alone, so that the same number of rounds gives the same bits. Without goals there is nothing but the plan.
///
/// Whoever looks again and again and ends when the error looks small ends where it looks smaller than it is. So sample size
/// k = 1, 2, ... may err with the probability α/(k (k + 1)), which sums to α = 1 - confidence: wherever it ends, its bounds have
/// the stated confidence (Bonferroni's inequality; C. Jennison and B. W. Turnbull, "Group sequential methods", 2000, chapter 7).
#[derive(Debug, Clone)]
pub struct Refinement {
    goals: Vec<Goal>,
    plan: DoubleLoop,
    /// A larger plan, and the round that it begins with, which was given out last.
    larger: Option<(u32, DoubleLoop)>,
    /// Sizes of the inner sample that its end has depended on, that of `plan` included.
    looks: u32,
    history: Vec<Assessment>,
    standing: RefinementStatus,
}

/// The sample that is made larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Growth {
    Inner,
    Outer,
}

impl Refinement {
    /// Checks `problem`; its sampling is the least.
    ///
    /// # Errors
    /// [`PlanError`] where the problem cannot be planned.
    pub fn try_new(problem: Problem, goals: Vec<Goal>) -> Result<Self, PlanError> {
        let plan = DoubleLoop::try_new(problem)?;
        let plan = if goals.is_empty() { plan } else { at_look(plan, 1) };
        Ok(Self { goals, plan, larger: None, looks: 1, history: Vec::new(), standing: RefinementStatus::Growing })
    }

    /// The plan that the rounds in `table` belong to: it gives their results, at whatever round they end.
    pub fn plan(&self, table: &SampleTable) -> &DoubleLoop {
        match &self.larger {
            Some((round, larger)) if table.rounds() > *round => larger,
            _ => &self.plan,
        }
    }

    /// How the goals were approached, plan by plan.
    pub fn history(&self) -> &[Assessment] {
        &self.history
    }

    /// Whether the goals are reached.
    pub fn status(&self) -> RefinementStatus {
        self.standing
    }

    /// The runs of the next round, in their order; empty where the goals are reached or cannot be. Whoever does not want to make
    /// them asks no further.
    ///
    /// # Errors
    /// [`PlanError`] where the table lacks runs of a round before or belongs to another problem.
    pub fn next_round(&mut self, table: &SampleTable) -> Result<Vec<RunInputs>, PlanError> {
        if let Some((round, larger)) = self.larger.take()
            && table.rounds() > round
        {
            self.looks += u32::from(larger.inner_runs() > self.plan.inner_runs());
            self.plan = larger;
        }
        let round = self.plan.next_round(table)?;
        if !round.is_empty() || self.goals.is_empty() {
            return Ok(round);
        }
        let assessment = self.assess(table)?;
        self.history.push(assessment);
        if assessment.share <= 1.0 {
            self.standing = RefinementStatus::Reached;
            return Ok(Vec::new());
        }
        let first = if assessment.sampling_share >= assessment.optimisation_share {
            [Growth::Inner, Growth::Outer]
        } else {
            [Growth::Outer, Growth::Inner]
        };
        for growth in first {
            let Some(larger) = self.enlarged(growth, &assessment) else { continue };
            let mut round = larger.next_round(table)?;
            if round.is_empty() && growth == Growth::Outer {
                round = filling_round(&larger, table, (assessment.outer / FILLING_SHARE).max(MIN_FILLING))?;
            }
            if !round.is_empty() {
                self.larger = Some((table.rounds(), larger));
                return Ok(round);
            }
        }
        self.standing = RefinementStatus::Exhausted;
        Ok(Vec::new())
    }

    /// Bounds from the runs in `table`.
    ///
    /// # Errors
    /// As [`DoubleLoop::results`].
    pub fn results(&self, table: &SampleTable) -> Result<Bounds, PlanError> {
        self.plan(table).results(table)
    }

    fn assess(&self, table: &SampleTable) -> Result<Assessment, PlanError> {
        let bounds = self.plan.results(table)?;
        let (mut share, mut sampling_share, mut optimisation_share) = (0.0_f64, 0.0_f64, 0.0_f64);
        for goal in &self.goals {
            let of_goal =
                |pair: &&BoundPair| pair.column == goal.request.column && pair.statistic == goal.request.statistic;
            let Some(pair) = bounds.pairs.iter().find(of_goal) else {
                // A statistic that was not asked for has no bound, and is no nearer with more runs.
                share = f64::INFINITY;
                continue;
            };
            for end in [&pair.lower, &pair.upper] {
                let widened = widening(end) / goal.most;
                share = share.max(widened);
                // What no run has will not be had from more of them.
                if widened > 1.0 && end.value.is_finite() {
                    sampling_share = sampling_share.max(end.error.sampling / goal.most);
                    optimisation_share = optimisation_share.max(end.error.optimisation / goal.most);
                }
            }
        }
        Ok(Assessment {
            rounds: bounds.rounds,
            runs: bounds.runs,
            outer: bounds.outer_points.len(),
            inner: self.plan.inner_runs(),
            training: 0,
            confirming: 0,
            share,
            sampling_share,
            optimisation_share,
        })
    }

    /// The plan with more of `growth`; `None` if there cannot be more.
    fn enlarged(&self, growth: Growth, assessment: &Assessment) -> Option<DoubleLoop> {
        let problem = self.plan.problem();
        let sampling = problem.sampling;
        let sampling = match growth {
            Growth::Inner => {
                let helps = assessment.sampling_share > 0.0 && !problem.random.is_empty();
                let inner = 2 * sampling.inner;
                let larger = if sampling.replicates < MIN_REPLICATES {
                    Sampling { inner, replicates: 2 * sampling.replicates, mixture: 2 * sampling.mixture, ..sampling }
                } else {
                    Sampling { inner, ..sampling }
                };
                (helps && inner <= MAX_INNER).then_some(larger)
            }
            Growth::Outer => {
                let helps = assessment.optimisation_share > 0.0 && !self.plan.setup.has_no_epistemic_inputs();
                let most = MAX_GROWN * self.plan.box_combinations();
                let outer = (assessment.outer + assessment.outer.div_ceil(2)).min(most);
                (helps && outer > assessment.outer).then_some(Sampling { outer, ..sampling })
            }
        };
        let look = self.looks + u32::from(growth == Growth::Inner);
        Some(at_look(DoubleLoop::try_new(Problem { sampling: sampling?, ..problem.clone() }).ok()?, look))
    }
}

/// The plan with the confidence that sample size `look` needs.
fn at_look(plan: DoubleLoop, look: u32) -> DoubleLoop {
    let miss = (1.0 - plan.problem().sampling.confidence) / f64::from(look * (look + 1));
    plan.with_errors_at(1.0 - miss)
}

/// Distance of the shown bound outside of the attained value; infinite if nothing is known.
fn widening(bound: &Bound) -> f64 {
    let widening = (bound.widened - bound.value).abs();
    if widening.is_nan() { f64::INFINITY } else { widening }
}

/// A round of up to `count` low-discrepancy points that are not there yet.
fn filling_round(plan: &DoubleLoop, table: &SampleTable, count: usize) -> Result<Vec<RunInputs>, PlanError> {
    let (round, seed, outer) = (table.rounds(), plan.problem().sampling.seed, plan.problem().sampling.outer);
    let pool = Pool::gather(table, Purpose::DoubleLoop, []);
    let known = plan.setup.outer_places(&pool);
    let search_box = &plan.setup.epistemic_box;
    let structural = structural_point_count(search_box.dimensions());
    // As many as are there already may be the same.
    let points = first_points(seed, search_box.dimensions(), structural + known.len() + count)?;
    let places = points.into_iter().skip(structural).flat_map(|at| {
        let of = move |combination| BoxPoint { combination, at: at.clone() };
        (0..plan.box_combinations()).map(of).collect::<Vec<BoxPoint>>()
    });
    let is_new = |place: &BoxPoint| known.iter().all(|point| search_box.axes().distance(point, place) > MIN_DISTANCE);
    let rest = outer.saturating_sub(known.len());
    let chosen = places.filter(is_new).take(count.min(rest)).enumerate();
    let runs = |(place, at): (usize, BoxPoint)| {
        plan.runs_at(round, (known.len() + place) as u32, search_box.values_at(&at)).collect::<Vec<_>>()
    };
    Ok(chosen.flat_map(runs).collect())
}

#[cfg(test)]
mod tests;
