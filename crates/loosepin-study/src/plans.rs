//! Plans of all questions of a study, made once, before anything has run.

use super::allow::{most_studies, runs_of_a_study};
use super::allow_together::most_tried_together;
use super::budget::{Limits, budget};
use super::contributors::ContributorPlan;
use super::error::StudyError;
use super::file::{Budget, MOST_RUNS, Study};
use super::goals::goals;
use super::memory_at_hand::memory_at_hand_bytes;
use super::problem::problem;
use super::promise::promise_plan;
use super::rare::{most_rare_runs, requests};
use super::response::StudyResponse;
use super::surrogate::{most_surrogate_runs, surrogate_plan};
use loosepin_bounds::{PromisePlan, Refinement, SampleTable, SurrogatePlan};

/// What a run takes in memory beside its numbers: two copies of its inputs with their places, while a round is made.
const BYTES_PER_RUN: usize = 400;
/// What each number of a run takes: its value, and two copies while bounds are computed. Measured on 4,000 to 260,000 runs of 30 and of
/// 560 numbers: 11 to 19 bytes a number and 500 a run.
const BYTES_PER_NUMBER: usize = 24;
const BYTES_PER_GIB: f64 = (1_u64 << 30) as f64;

/// Plans of all questions of a study.
pub(super) struct Plans {
    /// The direct double loop; it is not run where the surrogate stands alone.
    pub refinement: Refinement,
    /// Shares of the variance, where a question asks for them.
    pub contributors: Option<ContributorPlan>,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<SurrogatePlan>,
    /// The promise for a share of the box, where something is promised.
    pub promise: Option<PromisePlan>,
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
        let promise = promise_plan(study, response)?;
        let promised = promise.as_ref().map_or(0, PromisePlan::runs);
        let surrogate_runs = surrogate.as_ref().map_or(0, |plan| most_surrogate_runs(study, plan));
        let is_surrogate_alone = study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
        let rare = most_rare_runs(direct) * requests(&response.shared.plan.asks).count();
        let of_allowances = study.together.map_or_else(|| most_studies(study), |how| 2 * most_tried_together(how));
        let allowed = of_allowances.saturating_mul(runs_of_a_study(study));
        let contributing = contributors.as_ref().map_or(0, ContributorPlan::runs);
        let beside = [contributing, rare, allowed, surrogate_runs, promised].into_iter().fold(0, usize::saturating_add);
        let (stated_runs, reserved) = if is_surrogate_alone {
            (surrogate_runs.saturating_add(promised), promised)
        } else {
            (direct.most_runs().saturating_add(beside), beside)
        };
        let limits = Limits { budget: budget(study, stated_runs, row_length), stated_runs, reserved };
        let numbers = row_length + study.random.len() + study.epistemic.len();
        check_size(limits.most_runs().min(stated_runs), numbers, memory_at_hand_bytes())?;
        Ok(Self { refinement, contributors, surrogate, promise, is_surrogate_alone, limits, row_length })
    }

    /// An empty table with room for the runs of the first question.
    pub fn table(&self) -> SampleTable {
        SampleTable::with_capacity(self.row_length, self.limits.stated_runs - self.limits.reserved)
    }
}

/// That there are no more runs than anybody waits for, and that the memory at hand holds their numbers.
fn check_size(runs: usize, numbers: usize, at_hand_bytes: u64) -> Result<(), StudyError> {
    if runs as u64 > MOST_RUNS {
        return Err(StudyError::TooManyRuns { runs });
    }
    let needed_bytes = runs as u64 * (BYTES_PER_RUN + numbers * BYTES_PER_NUMBER) as u64;
    if needed_bytes <= at_hand_bytes {
        return Ok(());
    }
    let [needed_gib, at_hand_gib] = [needed_bytes, at_hand_bytes].map(|bytes| bytes as f64 / BYTES_PER_GIB);
    Err(StudyError::TooMuchMemory { runs, numbers, needed_gib, at_hand_gib })
}

/// How many runs `study` comes to at most; with a budget of time or rounds, how many it has before its samples grow.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, its budget does not suffice for anything, or the memory at hand does not
/// hold its runs.
pub fn plan_runs(study: &Study) -> Result<usize, StudyError> {
    Ok(planned(study, &StudyResponse::new(study)?)?.limits.most_runs())
}

/// The plans of `study`, whose budget suffices for a first answer.
pub(super) fn planned(study: &Study, response: &StudyResponse) -> Result<Plans, StudyError> {
    let plans = Plans::new(study, response)?;
    if matches!(plans.limits.budget, Some(Budget::Runs { .. })) {
        let first = match &plans.surrogate {
            Some(surrogate) if plans.is_surrogate_alone => surrogate.most_runs(),
            _ => plans.refinement.plan(&SampleTable::new(response.row_length())).first_round_runs(),
        };
        if !plans.limits.watch().allows(first, 0, 0) {
            return Err(plans.limits.too_small(first));
        }
    }
    Ok(plans)
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

#[cfg(test)]
mod tests {
    use super::check_size;

    #[test]
    fn analytic_what_a_plan_needs_and_what_there_is() {
        // 400 bytes a run and 24 a number.
        let needed = 1_000_000 * (400 + 15 * 24);
        assert!(check_size(1_000_000, 15, needed).is_ok());
        let said = check_size(1_000_000, 15, needed - 1).expect_err("a byte too few").to_string();
        assert_eq!(said, "1000000 runs of 15 numbers each need about 0.71 GiB of memory; 0.71 GiB are at hand");
    }

    #[test]
    fn more_runs_than_anybody_waits_for_are_refused_whatever_the_memory() {
        assert!(check_size(1 << 30, 0, u64::MAX).is_ok());
        let said = check_size((1 << 30) + 1, 0, u64::MAX).expect_err("one too many").to_string();
        assert_eq!(said, "1073741825 runs; must be at most 1073741824");
    }
}
