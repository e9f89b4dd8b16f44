//! Plans of all questions of a study, made once, before anything has run.

use super::allow::{most_studies, runs_of_a_study};
use super::budget::{Limits, budget};
use super::contributors::ContributorPlan;
use super::error::StudyError;
use super::file::{Budget, Study};
use super::goals::goals;
use super::problem::problem;
use super::rare::{most_rare_runs, requests};
use super::response::StudyResponse;
use super::surrogate::{most_surrogate_runs, surrogate_plan};
use loosepin_bounds::{Refinement, SampleTable, SurrogatePlan};

/// The numbers of all runs are in memory; what no computer holds is refused at once, not after hours.
const MOST_GIB: f64 = 256.0;
const BYTES_PER_GIB: f64 = (1_u64 << 30) as f64;
/// Plans of all questions of a study.
pub(super) struct Plans {
    /// The direct double loop; it is not run where the surrogate stands alone.
    pub refinement: Refinement,
    /// Shares of the variance, where a question asks for them.
    pub contributors: Option<ContributorPlan>,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<SurrogatePlan>,
    /// Whether all bounds are those of the surrogates.
    pub is_surrogate_alone: bool,
    /// Limits of the question that gives the bounds.
    pub limits: Limits,
    /// Numbers of a row of the table.
    row_length: usize,
}

impl Plans {
    /// The plans of `study`.
    ///
    /// # Errors
    /// Its sampling, its surrogates or its contributors are not possible.
    pub fn new(study: &Study, response: &StudyResponse) -> Result<Self, StudyError> {
        let row_length = response.row_length();
        let refinement = Refinement::try_new(problem(study, response), goals(study, &response.shared.plan))?;
        let direct = refinement.plan(&SampleTable::new(row_length));
        let contributors = ContributorPlan::new(study, direct)?;
        let surrogate = surrogate_plan(study, response)?;
        let surrogate_runs = surrogate.as_ref().map_or(0, |plan| most_surrogate_runs(study, plan));
        let is_surrogate_alone = study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
        let rare = most_rare_runs(direct) * requests(&response.shared.plan.asks).count();
        let allowed = most_studies(study).saturating_mul(runs_of_a_study(study));
        let contributing = contributors.as_ref().map_or(0, ContributorPlan::runs);
        let beside = [contributing, rare, allowed, surrogate_runs].into_iter().fold(0, usize::saturating_add);
        let (stated_runs, reserved) =
            if is_surrogate_alone { (surrogate_runs, 0) } else { (direct.most_runs().saturating_add(beside), beside) };
        let limits = Limits { budget: budget(study, stated_runs, row_length), stated_runs, reserved };
        check_size(study, row_length, limits.most_runs().min(stated_runs))?;
        Ok(Self { refinement, contributors, surrogate, is_surrogate_alone, limits, row_length })
    }

    /// An empty table with room for the runs of the first question.
    pub fn table(&self) -> SampleTable {
        SampleTable::with_capacity(self.row_length, self.limits.stated_runs - self.limits.reserved)
    }
}

/// That a computer can hold the numbers of all runs.
fn check_size(study: &Study, row_length: usize, runs: usize) -> Result<(), StudyError> {
    let numbers = row_length + study.random.len() + study.epistemic.len();
    let size_gib = runs as f64 * numbers as f64 * size_of::<f64>() as f64 / BYTES_PER_GIB;
    if size_gib <= MOST_GIB {
        return Ok(());
    }
    Err(StudyError::TooManyNumbers { runs, numbers, size_gib, most_gib: MOST_GIB })
}

/// How many runs `study` comes to at most; with a budget of time or rounds, how many it has before its samples grow.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, or its budget does not suffice for anything.
pub fn plan_runs(study: &Study) -> Result<usize, StudyError> {
    let response = StudyResponse::new(study)?;
    let plans = Plans::new(study, &response)?;
    if matches!(plans.limits.budget, Some(Budget::Runs { .. })) {
        let first = match &plans.surrogate {
            Some(surrogate) if plans.is_surrogate_alone => surrogate.most_runs(),
            _ => plans.refinement.plan(&SampleTable::new(response.row_length())).first_round_runs(),
        };
        if !plans.limits.watch().allows(first, 0, 0) {
            return Err(plans.limits.too_small(first));
        }
    }
    Ok(plans.limits.most_runs())
}

/// How many runs `study` comes to at most, as [`plan_runs`], where shards make them.
///
/// # Errors
/// As for [`plan_runs`], and a budget of time: processes that do not run at the same time cannot share one.
pub fn plan_shards(study: &Study) -> Result<usize, StudyError> {
    refuse_time(study)?;
    plan_runs(study)
}

/// That no time ends a study whose rounds are to be the same wherever they are made.
pub(super) fn refuse_time(study: &Study) -> Result<(), StudyError> {
    match study.budget {
        Some(Budget::Time { .. }) => Err(StudyError::TimeOfShards),
        _ => Ok(()),
    }
}
