//! What a study is going to run: the plans of all its parts, made once.

use super::accuracy::{Watch, budget, goals};
use super::allow::{most_studies, runs_of_a_study};
use super::conduct::StudyError;
use super::contributors::ContributorPlan;
use super::file::{Budget, Study};
use super::rare::{most_rare_runs, requests};
use super::response::StudyResponse;
use super::surrogate::{most_surrogate_runs, surrogate_plan};
use loosepin_bounds::{Problem, Refinement, SampleTable, Sampling, SurrogatePlan};

/// Runs of the probability-only treatment beside the double loop.
const MIXTURE_RUNS: usize = 1024;
/// Runs of the interval-only treatment for each combination of the members of lists, at least.
const EXTREME_RUNS: usize = 128;
/// Runs of the interval-only treatment for each uncertain input, where those are many.
const EXTREME_RUNS_PER_INPUT: usize = 8;
/// Each random input is cut at this many standard deviations where it is taken as an interval.
const CUT_STANDARD_DEVIATIONS: f64 = 3.0;
/// The numbers of all runs are in memory; what no computer holds is refused at once, not after hours.
const MOST_GIB: f64 = 256.0;
const BYTES_PER_GIB: f64 = (1_u64 << 30) as f64;
/// Confidence of every sampling error.
const CONFIDENCE: f64 = 0.99;

/// The plans of all parts of a study, before anything has run.
pub(super) struct Plans {
    /// The direct double loop; it is not run where the surrogate stands alone.
    pub refinement: Refinement,
    /// Shares of the variance, where a question asks for them.
    pub contributors: Option<ContributorPlan>,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<SurrogatePlan>,
    /// Whether all bounds are those of the surrogates.
    pub is_surrogate_alone: bool,
    /// Where the double loop ends although its goals are not reached.
    pub budget: Option<Budget>,
    /// Runs of all parts, samples not grown.
    stated_runs: usize,
    /// Those of them that are not of the double loop.
    reserved: usize,
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
        let budget = budget(study, stated_runs, row_length);
        check_size(study, row_length, Watch::new(budget, reserved).most_runs(stated_runs).min(stated_runs))?;
        Ok(Self { refinement, contributors, surrogate, is_surrogate_alone, budget, stated_runs, reserved, row_length })
    }

    /// An empty table with room for the runs of the first part.
    pub fn table(&self) -> SampleTable {
        SampleTable::with_capacity(self.row_length, self.stated_runs - self.reserved)
    }

    /// Watches the budget from now on.
    pub fn watch(&self) -> Watch {
        Watch::new(self.budget, self.reserved)
    }

    /// Runs at most; with a budget of time or rounds, those before the samples grow.
    pub fn most_runs(&self) -> usize {
        self.watch().most_runs(self.stated_runs)
    }

    /// The same once the double loop has come to `direct_runs` runs.
    pub fn most_runs_with(&self, direct_runs: usize) -> usize {
        self.watch().most_runs(self.stated_runs.max(direct_runs + self.reserved))
    }

    /// That the budget of `study` does not suffice for a first round of `round_runs` runs.
    pub fn budget_too_small(&self, round_runs: usize) -> StudyError {
        let budget = if let Some(Budget::Runs(runs)) = self.budget { runs } else { 0 };
        StudyError::BudgetTooSmall { budget, least: round_runs + self.reserved }
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
    if matches!(plans.budget, Some(Budget::Runs(_))) {
        let first = match &plans.surrogate {
            Some(surrogate) if plans.is_surrogate_alone => surrogate.most_runs(),
            _ => plans.refinement.plan(&SampleTable::new(response.row_length())).first_round_runs(),
        };
        if !plans.watch().allows(first, 0, 0) {
            return Err(plans.budget_too_small(first));
        }
    }
    Ok(plans.most_runs())
}

/// The question in the words of the uncertainty wing.
pub(super) fn problem(study: &Study, response: &StudyResponse) -> Problem {
    let plan = &response.shared.plan;
    let replicates = study.sampling.replicates;
    let choices = study.epistemic.iter().map(|input| input.variable.choices());
    let combinations = choices.fold(1_usize, usize::saturating_mul);
    let extreme = EXTREME_RUNS.max(EXTREME_RUNS_PER_INPUT * (study.random.len() + study.epistemic.len()));
    Problem {
        random: study.random.iter().map(|input| input.variable.clone()).collect(),
        copula: study.correlation.as_ref().map(|correlation| correlation.copula.clone()),
        epistemic: study.epistemic.iter().map(|input| input.variable.clone()).collect(),
        parameters: study.epistemic_parameters(),
        reading: study.readings[0],
        readings_beside: study.readings[1..].to_vec(),
        columns: response.row_length(),
        requests: plan.requests(),
        compared_columns: plan.compared_columns(),
        band_probability: super::columns::BAND[1] - super::columns::BAND[0],
        cut_standard_deviations: CUT_STANDARD_DEVIATIONS,
        percentiles: study.percentiles.clone(),
        sampling: Sampling {
            outer: study.sampling.outer,
            inner: study.sampling.inner,
            replicates,
            mixture: MIXTURE_RUNS.div_ceil(replicates) * replicates,
            extreme: extreme.saturating_mul(combinations),
            seed: study.seed,
            confidence: CONFIDENCE,
        },
    }
}
