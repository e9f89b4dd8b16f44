//! Running a study: rounds of runs on all threads, with progress and an emergency stop.

use super::accuracy::{Ended, Watch, budget, goals, record};
use super::allow::{allocation, allowances, most_studies, runs_of_a_study};
use super::assemble::{Extra, Material, assemble};
use super::contributors::{ContributorPlan, contributors};
use super::file::{Budget, Study};
use super::keep::{Keeping, KeptList};
use super::rare::{MOST_RARE_RUNS, rare_probabilities, requests};
use super::response::{PrepareError, StudyResponse};
use super::result::StudyResult;
use super::runs::RunsTable;
use super::saved_surrogates::SavedSurrogates;
use super::simultaneous::curve_bands;
use super::surrogate::{learned_bounds, most_surrogate_runs, saved_surrogates, surrogate_plan, surrogate_record};
use crate::bounds::{
    Bounds, DoubleLoop, Failure, PlanError, Problem, Refinement, RunInputs, SampleTable, Sampling, SurrogatePlanError,
    TableError,
};
use crate::contributors::IndexPlanError;
use crate::math::Vectors;
use crate::simulate::RunFailure;
use crate::store::{RunStore, StoreError};
use crate::uncertainty::SobolError;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use thiserror::Error;

/// Runs that are handed to the threads at once: so many that the lanes which idle at the end hardly count.
const RUNS_PER_BATCH: usize = 8192;
/// Runs between two reports of progress.
const RUNS_PER_REPORT: usize = 64;

/// Runs of the probability-only treatment beside the double loop.
const MIXTURE_RUNS: usize = 1024;
/// Runs of the interval-only treatment for each combination of the members of lists, at least.
const EXTREME_RUNS: usize = 128;
/// Runs of the interval-only treatment for each uncertain input, where those are many.
const EXTREME_RUNS_PER_INPUT: usize = 8;
/// Each random input is cut at this many standard deviations where it is taken as an interval.
const CUT_STANDARD_DEVIATIONS: f64 = 3.0;
/// Confidence of every sampling error.
const CONFIDENCE: f64 = 0.99;

/// Why a study has no result.
#[derive(Debug, Error)]
pub enum StudyError {
    /// It cannot begin.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// Its sampling is not possible.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The runs of its surrogate are not possible.
    #[error("surrogate: {0}")]
    Surrogate(#[from] SurrogatePlanError),
    /// An accuracy or a budget where there is no direct double loop.
    #[error("surrogate: accuracy and budget let the samples of the direct double loop grow, and there is none")]
    AccuracyOfSurrogate,
    /// Shares of the variance are not possible.
    #[error(transparent)]
    Contributors(#[from] IndexPlanError),
    /// A value of an input that may be loosened is not possible.
    #[error("'{path}' under [allow] at {value_si} in SI units: {reason}")]
    Loosened {
        /// The input.
        path: String,
        /// The value that was tried.
        value_si: f64,
        /// Why not.
        reason: String,
    },
    /// The threads could not be started.
    #[error("the threads could not be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// A budget that the runs which nothing can be said without go beyond.
    #[error("a budget of {budget} runs; the first round and what follows it take at most {least}")]
    BudgetTooSmall {
        /// The budget.
        budget: u64,
        /// Runs of the first round and of what follows the rounds.
        least: usize,
    },
    /// Finished runs cannot be kept, or not be taken over.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// A row did not fit.
    #[error(transparent)]
    Table(#[from] TableError),
    /// It was interrupted; what was finished is in the table.
    #[error("interrupted after {} of at most {most_runs} runs", finished.columns.first().map_or(0, |column| column.data.len()))]
    Interrupted {
        /// The finished runs.
        finished: Box<RunsTable>,
        /// How many there would have been at most.
        most_runs: usize,
    },
    /// Every run failed.
    #[error("all {runs} runs failed; the first one: {reason}")]
    AllFailed {
        /// How many.
        runs: usize,
        /// Why the first one did.
        reason: RunFailure,
    },
}

/// Hears how far a study is.
pub trait Progress: Sync {
    /// `finished` of at most `most` runs are done.
    fn runs(&self, finished: usize, most: usize);
}

/// With what a study is conducted.
#[derive(Clone, Copy)]
pub struct Means<'a> {
    /// Number of threads; the result is the same for any.
    pub threads: usize,
    /// Hears how far it is.
    pub progress: &'a dyn Progress,
    /// Stops it when set.
    pub stop: &'a AtomicBool,
    /// Where finished runs are kept and found again; nowhere if left out.
    pub store: Option<&'a RunStore>,
}

/// A finished study.
pub struct Conducted {
    /// Everything for pages and files.
    pub result: StudyResult,
    /// Every run.
    pub runs: RunsTable,
    /// What was learned, to be saved; nothing where the study asks for no surrogate.
    pub surrogates: Option<SavedSurrogates>,
}

/// How many runs `study` comes to at most; with a budget of time or rounds, how many it has before its samples grow.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, or its budget does not suffice for anything.
pub fn plan_runs(study: &Study) -> Result<usize, StudyError> {
    let response = StudyResponse::new(study)?;
    let plan = DoubleLoop::try_new(problem(study, &response))?;
    let contributor_plan = ContributorPlan::new(study, &plan)?;
    let surrogate_runs = surrogate_plan(study, &response)?.map_or(0, |plan| most_surrogate_runs(study, &plan));
    if study.surrogate.is_some_and(|surrogate| surrogate.is_alone) {
        return Ok(surrogate_runs);
    }
    let most_runs = most_runs(study, &response, &plan, contributor_plan.as_ref()) + surrogate_runs;
    let reserved = most_runs - plan.most_runs();
    if let Some(Budget::Runs(budget)) = study.budget {
        let least = plan.next_round(&SampleTable::new(response.row_length()))?.len() + reserved;
        if (least as u64) > budget {
            return Err(StudyError::BudgetTooSmall { budget, least });
        }
    }
    Ok(Watch::new(budget(study, most_runs, response.row_length()), reserved).most_runs(most_runs))
}

/// The runs of all parts.
fn most_runs(
    study: &Study,
    response: &StudyResponse,
    plan: &DoubleLoop,
    contributors: Option<&ContributorPlan>,
) -> usize {
    let rare = MOST_RARE_RUNS * requests(&response.shared.plan.asks).count();
    let allowed = most_studies(study) * runs_of_a_study(study);
    plan.most_runs() + contributors.map_or(0, ContributorPlan::runs) + rare + allowed
}

/// Runs that are timed: enough to fill the lanes of a thread more than once.
const TIMED_RUNS: usize = 48;

/// Processor time of a run of `study` on the lanes of one thread, s: measured on the first runs of its plan, each given up
/// after `largest_evaluations` and counted in proportion to how far it came.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, or all of these runs failed.
pub fn time_a_run_s(study: &Study, largest_evaluations: u64) -> Result<f64, StudyError> {
    let mut response = StudyResponse::new(study)?;
    response.limit_evaluations(largest_evaluations);
    let plan = DoubleLoop::try_new(problem(study, &response))?;
    let round = plan.next_round(&SampleTable::new(response.row_length()))?;
    let variants = response.mechanisms.len();
    let (mut passed, mut reason) = (0.0, None);
    let end_s = response.nominal_end_s();
    let started = std::time::Instant::now();
    for variant in 0..variants {
        let own = round.iter().filter(|inputs| response.variant(&inputs.epistemic) == variant);
        let mut waiting =
            own.take(TIMED_RUNS.div_ceil(variants)).map(|inputs| (0, &inputs.random[..], &inputs.epistemic[..]));
        response.run_all(
            variant,
            Vectors::best(),
            || waiting.next(),
            |_, outcome| match outcome {
                Ok(_) => passed += 1.0,
                Err(RunFailure::TooManyEvaluations { time_s, .. }) if time_s > 0.0 => passed += time_s / end_s,
                Err(failure) => reason = Some(failure),
            },
        );
    }
    let elapsed_s = started.elapsed().as_secs_f64();
    match reason {
        Some(reason) if passed == 0.0 => Err(StudyError::AllFailed { runs: TIMED_RUNS.min(round.len()), reason }),
        _ => Ok(elapsed_s / passed),
    }
}

/// Conducts `study`. The result is the same for any number of threads, and whatever of it was found in a store.
///
/// # Errors
/// See [`StudyError`]; failed runs are no error as long as some succeed.
pub fn conduct(study: &Study, input_hash: &str, means: &Means<'_>) -> Result<Conducted, StudyError> {
    let Means { threads, progress, stop, store } = *means;
    let response = StudyResponse::new(study)?;
    let goals = goals(study, &response.shared.plan);
    let mut refinement = Refinement::try_new(problem(study, &response), goals)?;
    let mut table = SampleTable::new(response.row_length());
    let stated = refinement.plan(&table);
    let contributor_plan = ContributorPlan::new(study, stated)?;
    let is_alone = study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
    let surrogate_plan = surrogate_plan(study, &response)?;
    let surrogate_runs = surrogate_plan.as_ref().map_or(0, |plan| most_surrogate_runs(study, plan));
    let stated_runs = most_runs(study, &response, stated, contributor_plan.as_ref()) + surrogate_runs;
    let reserved = stated_runs - stated.most_runs();
    let direct_runs = if is_alone { surrogate_runs } else { stated.most_runs() };
    table = SampleTable::with_capacity(response.row_length(), direct_runs);
    let budget = budget(study, stated_runs, response.row_length());
    let watch = Watch::new(budget, reserved);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let before = AtomicUsize::new(0);
    let most_runs = watch.most_runs(stated_runs);
    let keeping = Keeping::new(store);
    let mut runner = Runner {
        study,
        response: &response,
        pool: &pool,
        progress,
        stop,
        most_runs,
        before: &before,
        keeping: &keeping,
        list: keeping.begin(),
    };
    progress.runs(0, most_runs);
    let mut rounds = 0;
    let mut round = if is_alone { Vec::new() } else { refinement.next_round(&table)? };
    while !round.is_empty() && watch.allows(round.len(), table.len(), rounds) {
        runner.most_runs = watch.most_runs(stated_runs.max(table.len() + round.len() + reserved));
        runner.run(&round, &mut table)?;
        rounds += 1;
        round = pool.install(|| refinement.next_round(&table))?;
    }
    if table.is_empty() && !is_alone {
        let budget = study.budget.map_or(0, |budget| if let Budget::Runs(runs) = budget { runs } else { 0 });
        return Err(StudyError::BudgetTooSmall { budget, least: round.len() + reserved });
    }
    let left = Some(round.len()).filter(|runs| *runs > 0);
    let ended = Ended::new(&refinement, left, (rounds, table.len()), budget);
    let plan = refinement.plan(&table).clone();
    let direct = if is_alone { None } else { Some(direct_results(&runner, &plan, &table)?) };
    // What the samples have become.
    let grown = plan.problem().sampling;
    let mut refined = study.clone();
    refined.sampling.outer = grown.outer;
    refined.sampling.inner = grown.inner;
    refined.sampling.replicates = grown.replicates;
    let runner = Runner { study: &refined, ..runner };
    if let (Some(contributor_plan), Some(bounds)) = (&contributor_plan, &direct) {
        runner.run(&contributor_plan.round(&plan, bounds.rounds), &mut table)?;
    }
    let rare = match &direct {
        Some(bounds) => rare_probabilities(&runner, &plan, bounds, &mut table)?,
        None => Vec::new(),
    };
    let runner = Runner { study, ..runner };
    let learned = match &surrogate_plan {
        Some(plan) => Some((plan, learned_bounds(&runner, plan, &mut table)?)),
        None => None,
    };
    let bounds = match (direct, &learned) {
        (Some(bounds), _) => bounds,
        (None, Some((plan, learned))) if table.failed() < table.len() => learned.to_bounds(plan, made_rounds(&table)),
        (None, _) => return Err(all_failed(&response, &table)),
    };
    // The studies of the inverse question have tables of their own; what was run before is kept whatever happens to them.
    runner.advance(table.len());
    let kept = |error: StudyError| match error {
        StudyError::Interrupted { most_runs, .. } => {
            let finished = Box::new(super::assemble::runs_table(study, &response, &table));
            StudyError::Interrupted { finished, most_runs }
        }
        error => error,
    };
    let allowances = allowances(&runner).map_err(kept)?;
    let allocation = allocation(&runner).map_err(kept)?;
    let material = Material {
        study: &refined,
        response: &response,
        table: &table,
        bounds: &bounds,
        pairs: &bounds.pairs,
        rare: &rare,
    };
    let beside: Vec<Bounds> = study.readings[1..]
        .iter()
        .map(|&reading| pool.install(|| plan.read_as(reading).statistics_alone().results(&table)))
        .collect::<Result<_, _>>()?;
    let curve_bands = pool.install(|| curve_bands(&material, &plan))?;
    let result = pool.install(|| {
        let contributors =
            if is_alone { Vec::new() } else { contributors(&material, &plan, contributor_plan.as_ref()) };
        let surrogate = learned.as_ref().map(|(plan, learned)| surrogate_record(&material, plan, learned));
        let accuracy = record(&material, &ended);
        assemble(
            &material,
            input_hash,
            Extra { accuracy, contributors, allowances, allocation, surrogate, curve_bands, beside },
        )
    });
    let surrogates = learned.as_ref().map(|(plan, learned)| saved_surrogates(&material, input_hash, plan, learned));
    Ok(Conducted { result, runs: super::assemble::runs_table(study, &response, &table), surrogates })
}

/// What the direct double loop says.
fn direct_results(runner: &Runner<'_>, plan: &DoubleLoop, table: &SampleTable) -> Result<Bounds, StudyError> {
    if table.failed() == table.len() {
        return Err(all_failed(runner.response, table));
    }
    Ok(runner.pool.install(|| plan.results(table))?)
}

/// Rounds that the runs were made in.
fn made_rounds(table: &SampleTable) -> u32 {
    table.inputs().iter().map(|inputs| inputs.round + 1).max().unwrap_or(0)
}

/// What runs need, whatever they are for.
#[derive(Clone, Copy)]
pub(super) struct Runner<'s> {
    pub study: &'s Study,
    pub response: &'s StudyResponse,
    pub pool: &'s rayon::ThreadPool,
    pub progress: &'s dyn Progress,
    pub stop: &'s AtomicBool,
    pub most_runs: usize,
    /// Runs in tables that are finished.
    pub before: &'s AtomicUsize,
    /// Where finished runs are kept.
    pub keeping: &'s Keeping<'s>,
    /// The list that is being run.
    pub list: KeptList<'s>,
}

impl From<SobolError> for StudyError {
    fn from(error: SobolError) -> Self {
        Self::Plan(error.into())
    }
}

impl Runner<'_> {
    /// Counts the runs of a finished table for the progress.
    pub fn advance(&self, runs: usize) {
        self.before.fetch_add(runs, Ordering::Relaxed);
    }

    /// Runs `round` and adds its rows to `table`; those that are kept are taken over.
    ///
    /// # Errors
    /// The study was interrupted, or the store cannot be used.
    pub fn run(&self, round: &[RunInputs], table: &mut SampleTable) -> Result<(), StudyError> {
        for batch in round.chunks(RUNS_PER_BATCH) {
            let before = self.before.load(Ordering::Relaxed);
            let first = table.len();
            let kept = self.list.find(first, batch)?;
            let done = AtomicUsize::new(before + first + kept.iter().flatten().count());
            let finished = |index: usize, row: &Row| {
                self.list.keep(first + index, &batch[index], row);
                let runs = done.fetch_add(1, Ordering::Relaxed) + 1;
                if runs.is_multiple_of(RUNS_PER_REPORT) {
                    self.progress.runs(runs, self.most_runs);
                }
            };
            let is_stopped = || self.stop.load(Ordering::Relaxed) || self.list.is_broken();
            let outcomes = self.pool.install(|| evaluate(batch, kept, self.response, &is_stopped, &finished));
            if self.list.is_broken() {
                self.list.settle()?;
            }
            let is_stopped = outcomes.iter().any(Option::is_none);
            for (inputs, outcome) in batch.iter().zip(outcomes) {
                if let Some(outcome) = outcome {
                    table.push(inputs.clone(), outcome.as_deref().map_err(|&failure| failure))?;
                }
            }
            if is_stopped {
                self.list.settle()?;
                let finished = Box::new(super::assemble::runs_table(self.study, self.response, table));
                return Err(StudyError::Interrupted { finished, most_runs: self.most_runs });
            }
            self.progress.runs(before + table.len(), self.most_runs);
        }
        Ok(())
    }
}

/// Columns and extras of a finished run, or why it gave nothing.
pub(super) type Row = Result<Vec<f64>, Failure>;

/// The rows of a batch, those that are `kept` as they are; nothing for runs that a stop has kept from starting. Each thread takes the next run as soon as one
/// of its lanes is free; which thread and which lane a run meets has no influence on its bits. Runs with other laws have other
/// equations: each thread takes those of one combination after those of another.
fn evaluate(
    batch: &[RunInputs],
    kept: Vec<Option<Row>>,
    response: &StudyResponse,
    is_stopped: &(dyn Fn() -> bool + Sync),
    finished: &(dyn Fn(usize, &Row) + Sync),
) -> Vec<Option<Row>> {
    let mut queues: Vec<(Vec<usize>, AtomicUsize)> =
        response.mechanisms.iter().map(|_| (Vec::new(), AtomicUsize::new(0))).collect();
    for (index, inputs) in batch.iter().enumerate().filter(|(index, _)| kept[*index].is_none()) {
        queues[response.variant(&inputs.epistemic)].0.push(index);
    }
    let vectors = Vectors::best();
    let parts: Vec<Vec<(usize, Row)>> = (0..rayon::current_num_threads())
        .into_par_iter()
        .with_max_len(1)
        .map(|_| {
            let mut rows = Vec::new();
            for (variant, (queue, taken)) in queues.iter().enumerate() {
                let next = || {
                    let index = *queue.get(taken.fetch_add(1, Ordering::Relaxed))?;
                    let inputs = batch.get(index).filter(|_| !is_stopped())?;
                    Some((index, &inputs.random[..], &inputs.epistemic[..]))
                };
                response.run_all(variant, vectors, next, |index, outcome| {
                    let row = outcome.map_err(|failure| Failure(failure.number()));
                    finished(index, &row);
                    rows.push((index, row));
                });
            }
            rows
        })
        .collect();
    let mut rows = kept;
    for (index, row) in parts.into_iter().flatten() {
        rows[index] = Some(row);
    }
    rows
}

fn all_failed(response: &StudyResponse, table: &SampleTable) -> StudyError {
    let first = &table.inputs()[0];
    let mut row = vec![f64::NAN; response.row_length()];
    match response.run(&first.random, &first.epistemic, &mut row) {
        Err(reason) => StudyError::AllFailed { runs: table.len(), reason },
        // The same inputs give the same run; were it otherwise, the table would hold a finished run.
        Ok(()) => StudyError::Table(TableError::WrongColumns { run: 0, found: 0, expected: row.len() }),
    }
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
            reweighting: study.sampling.is_reweighted,
        },
    }
}
