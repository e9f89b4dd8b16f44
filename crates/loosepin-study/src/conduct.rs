//! Conducting a study: its parts one after the other.

use super::accuracy::{Ended, record};
use super::allow::{allocation, allowances};
use super::assemble::{Extra, Material, assemble, failures, learned_treatments, runs_table};
use super::contributors::contributors;
use super::elsewhere::RunMaker;
use super::file::Study;
use super::keep::Keeping;
use super::part::{OpenRound, Part, refuse_time};
use super::plans::Plans;
use super::rare::{Rare, rare_probabilities};
use super::response::{PrepareError, StudyResponse};
use super::runner::Runner;
use super::runs::RunsTable;
use super::saved_surrogates::SavedSurrogates;
use super::simultaneous::curve_bands;
use super::surrogate::{LearnedBounds, learned_bounds, saved_surrogates, surrogate_record};
use loosepin_bounds::{Bounds, DoubleLoop, PlanError, SampleTable, SurrogatePlanError, TableError};
use loosepin_result::study::{AllocationRecord, AllowanceRecord, FailureGroup, StudyResult};
use loosepin_simulate::RunFailure;
use loosepin_store::{RunStore, StoreError};
use loosepin_uncertainty::SobolError;
use loosepin_uncertainty::contributors::IndexPlanError;
use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicUsize};
use thiserror::Error;

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
    /// A round waits for runs that are made elsewhere; what was made here is in the store.
    #[error("{0}")]
    RoundOpen(OpenRound),
    /// Runs that were to be made outside of this process; what was made is in the store.
    #[error("the runs could not be made: {reason}")]
    NotMade {
        /// Why, in the words of whoever was to make them.
        reason: String,
    },
    /// A budget of time where shards make the runs.
    #[error("a budget of time cannot be shared by shards, which run at different times")]
    TimeOfShards,
    /// More numbers than a computer holds.
    #[error("{runs} runs of {numbers} numbers each are {size_gib:.0} GiB; must be at most {most_gib:.0} GiB")]
    TooManyNumbers {
        /// Runs of the study at most.
        runs: usize,
        /// Numbers of each, its inputs included.
        numbers: usize,
        /// What they take.
        size_gib: f64,
        /// What they may take.
        most_gib: f64,
    },
    /// More runs failed than may; what was run is in the table, and in the store.
    #[error("{0}")]
    TooManyFailed(Box<TooManyFailed>),
    /// Every run failed.
    #[error("all {runs} runs failed; the first one: {reason}")]
    AllFailed {
        /// How many.
        runs: usize,
        /// Why the first one did.
        reason: RunFailure,
    },
}

/// More failed runs than a study may have.
#[derive(Debug)]
pub struct TooManyFailed {
    /// All runs, finished and failed.
    pub runs: RunsTable,
    /// How many runs there are.
    pub made: usize,
    /// How many of them failed.
    pub failed: usize,
    /// The share that may fail.
    pub most_failed: f64,
    /// The most frequent reason, with a command that repeats such a run.
    pub commonest: Option<FailureGroup>,
}

/// `148 of 1344 runs failed (11.01 %); at most 10 % may: most_failed under [sampling]. 120 of them: ...`.
impl fmt::Display for TooManyFailed {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { made, failed, most_failed, .. } = self;
        let share = 100.0 * *failed as f64 / *made as f64;
        let most = 100.0 * most_failed;
        write!(
            formatter,
            "{failed} of {made} runs failed ({share:.3} %); at most {most} % may: most_failed under [sampling]"
        )?;
        match &self.commonest {
            Some(reason) => write!(formatter, "; {} of them: {}", reason.count, reason.words),
            None => Ok(()),
        }
    }
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

impl From<SobolError> for StudyError {
    fn from(error: SobolError) -> Self {
        Self::Plan(error.into())
    }
}

/// Conducts `study`. The result is the same for any number of threads, and whatever of it was found in a store.
///
/// # Errors
/// See [`StudyError`]; failed runs are no error as long as some succeed.
pub fn conduct(study: &Study, input_hash: &str, means: &Means<'_>) -> Result<Conducted, StudyError> {
    conduct_part(study, input_hash, means, Part::Whole)
}

/// Conducts `study` as far as its rounds are complete, with what is in the store and the runs that `part` makes. A part that is not
/// the whole needs a store.
///
/// # Errors
/// See [`StudyError`]; [`StudyError::RoundOpen`] where runs are missing that are made elsewhere.
pub fn conduct_part(study: &Study, input_hash: &str, means: &Means<'_>, part: Part) -> Result<Conducted, StudyError> {
    if part != Part::Whole {
        refuse_time(study)?;
    }
    conduct_with(study, input_hash, means, part, None)
}

/// [`conduct`] with runs that `maker` makes outside of this process. The result is the same.
///
/// # Errors
/// See [`StudyError`]; [`StudyError::NotMade`] where `maker` does not go on.
pub fn conduct_elsewhere(
    study: &Study,
    input_hash: &str,
    means: &Means<'_>,
    maker: &dyn RunMaker,
) -> Result<Conducted, StudyError> {
    conduct_with(study, input_hash, means, Part::Whole, Some(maker))
}

fn conduct_with(
    study: &Study,
    input_hash: &str,
    means: &Means<'_>,
    part: Part,
    maker: Option<&dyn RunMaker>,
) -> Result<Conducted, StudyError> {
    let Means { threads, progress, stop, store } = *means;
    let response = StudyResponse::new(study)?;
    let plans = Plans::new(study, &response)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let (before, keeping) = (AtomicUsize::new(0), Keeping::new(store));
    let mut runner = Runner {
        study,
        response: &response,
        pool: &pool,
        progress,
        stop,
        most_runs: plans.most_runs(),
        before: &before,
        keeping: &keeping,
        list: keeping.begin(),
        part,
        maker,
        loosened: &[],
    };
    progress.runs(0, runner.most_runs);
    let mut table = plans.table();
    let (plan, ended) = double_loop(&mut runner, &plans, &mut table)?;
    let refined = grown(study, &plan);
    let direct = direct_results(&runner, &plans, &plan, &table)?;
    let rare = match &direct {
        Some(bounds) => around(&Runner { study: &refined, ..runner }, &plans, &plan, bounds, &mut table)?,
        None => Vec::new(),
    };
    let mut learned = match &plans.surrogate {
        Some(plan) => Some(learned_bounds(&mut runner, &plans, plan, &mut table)?),
        None => None,
    };
    let ended = learned.as_mut().and_then(|learned| learned.ended.take()).unwrap_or(ended);
    let bounds = stated_bounds(&runner, direct, learned.as_ref(), &table)?;
    let (allowances, allocation) = inverse_question(&runner, &table)?;
    let found = Found { refined, plan, ended, bounds, rare, learned, allowances, allocation };
    tell(&runner, &plans, &table, found, input_hash)
}

/// What the parts of a study have found.
struct Found {
    /// The study with the samples that it came to have.
    refined: Study,
    /// The double loop with these.
    plan: DoubleLoop,
    ended: Ended,
    bounds: Bounds,
    rare: Vec<Rare>,
    learned: Option<LearnedBounds>,
    allowances: Vec<AllowanceRecord>,
    allocation: Option<AllocationRecord>,
}

/// The rounds of the direct double loop, as far as goals and budget go; none where the surrogate stands alone.
fn double_loop(
    runner: &mut Runner<'_>,
    plans: &Plans,
    table: &mut SampleTable,
) -> Result<(DoubleLoop, Ended), StudyError> {
    let mut refinement = plans.refinement.clone();
    let watch = plans.watch();
    let mut rounds = 0;
    let mut round = if plans.is_surrogate_alone { Vec::new() } else { refinement.next_round(table)? };
    while !round.is_empty() && watch.allows(round.len(), table.len(), rounds) {
        runner.most_runs = plans.most_runs_with(table.len() + round.len());
        runner.run(&round, table)?;
        refuse_failures(runner, table)?;
        rounds += 1;
        round = runner.pool.install(|| refinement.next_round(table))?;
    }
    if table.is_empty() && !plans.is_surrogate_alone {
        return Err(plans.budget_too_small(round.len()));
    }
    let left = Some(round.len()).filter(|runs| *runs > 0);
    let ended = Ended::new(&refinement, left, (rounds, table.len()), plans.budget);
    Ok((refinement.plan(table).clone(), ended))
}

/// That no more of the runs so far failed than may: bounds would say little, and every further round as little.
pub(super) fn refuse_failures(runner: &Runner<'_>, table: &SampleTable) -> Result<(), StudyError> {
    let (study, response) = (runner.study, runner.response);
    let (made, failed, most_failed) = (table.len(), table.failed(), study.sampling.most_failed);
    if failed as f64 <= most_failed * made as f64 {
        return Ok(());
    }
    let commonest = failures(study, response, table).into_iter().next();
    let runs = runs_table(study, response, table);
    Err(StudyError::TooManyFailed(Box::new(TooManyFailed { runs, made, failed, most_failed, commonest })))
}

/// `study` with the samples that its double loop came to have.
fn grown(study: &Study, plan: &DoubleLoop) -> Study {
    let sampling = plan.problem().sampling;
    let mut grown = study.clone();
    grown.sampling.outer = sampling.outer;
    grown.sampling.inner = sampling.inner;
    grown.sampling.replicates = sampling.replicates;
    grown
}

/// What the direct double loop says; nothing where the surrogate stands alone.
fn direct_results(
    runner: &Runner<'_>,
    plans: &Plans,
    plan: &DoubleLoop,
    table: &SampleTable,
) -> Result<Option<Bounds>, StudyError> {
    if plans.is_surrogate_alone {
        return Ok(None);
    }
    if table.failed() == table.len() {
        return Err(all_failed(runner.response, table));
    }
    Ok(Some(runner.pool.install(|| plan.results(table))?))
}

/// The runs around the double loop: those of the contributors, and what they and the bounds leave to be counted of rare events.
fn around(
    runner: &Runner<'_>,
    plans: &Plans,
    plan: &DoubleLoop,
    bounds: &Bounds,
    table: &mut SampleTable,
) -> Result<Vec<Rare>, StudyError> {
    if let Some(contributors) = &plans.contributors {
        runner.run(&contributors.round(plan, bounds.rounds), table)?;
    }
    rare_probabilities(runner, plan, bounds, table)
}

/// The bounds that the study states: the direct ones, or those of the surrogate that stands alone.
fn stated_bounds(
    runner: &Runner<'_>,
    direct: Option<Bounds>,
    learned: Option<&LearnedBounds>,
    table: &SampleTable,
) -> Result<Bounds, StudyError> {
    match (direct, learned) {
        (Some(bounds), _) => Ok(bounds),
        (None, Some(learned)) if table.failed() < table.len() => {
            Ok(learned.bounds.to_bounds(&learned.plan, table.rounds()))
        }
        (None, _) => Err(all_failed(runner.response, table)),
    }
}

/// How loose inputs may be. Its studies have tables of their own; what is in `table` is kept whatever happens to them.
fn inverse_question(
    runner: &Runner<'_>,
    table: &SampleTable,
) -> Result<(Vec<AllowanceRecord>, Option<AllocationRecord>), StudyError> {
    runner.advance(table.len());
    let answers = || Ok((allowances(runner)?, allocation(runner)?));
    answers().map_err(|error| match error {
        StudyError::Interrupted { most_runs, .. } => {
            let finished = Box::new(runs_table(runner.study, runner.response, table));
            StudyError::Interrupted { finished, most_runs }
        }
        error => error,
    })
}

/// Puts the result together.
fn tell(
    runner: &Runner<'_>,
    plans: &Plans,
    table: &SampleTable,
    found: Found,
    input_hash: &str,
) -> Result<Conducted, StudyError> {
    let Found { refined, plan, ended, bounds, rare, learned, allowances, allocation } = found;
    let (study, response, pool) = (runner.study, runner.response, runner.pool);
    let material = Material { study: &refined, response, table, bounds: &bounds, pairs: &bounds.pairs, rare: &rare };
    let beside: Vec<Bounds> = study.readings[1..]
        .iter()
        .map(|&reading| pool.install(|| plan.read_as(reading).statistics_alone().results(table)))
        .collect::<Result<_, _>>()?;
    let curve_bands = pool.install(|| curve_bands(&material, &plan))?;
    let learned = learned.as_ref().map(|learned| (&learned.plan, &learned.bounds));
    let result = pool.install(|| {
        let contributors = if plans.is_surrogate_alone {
            Vec::new()
        } else {
            contributors(&material, &plan, plans.contributors.as_ref())
        };
        let surrogate = learned.map(|(plan, learned)| surrogate_record(&material, plan, learned));
        let accuracy = record(&material, &ended);
        let treatments = learned.filter(|_| plans.is_surrogate_alone);
        let treatments = treatments.map(|(plan, learned)| learned_treatments(&material, plan, learned));
        let extra =
            Extra { accuracy, contributors, allowances, allocation, surrogate, treatments, curve_bands, beside };
        assemble(&material, input_hash, extra)
    });
    let surrogates = learned.map(|(plan, learned)| saved_surrogates(&material, input_hash, plan, learned));
    Ok(Conducted { result, runs: runs_table(study, response, table), surrogates })
}

pub(super) fn all_failed(response: &StudyResponse, table: &SampleTable) -> StudyError {
    let first = &table.inputs()[0];
    let mut row = vec![f64::NAN; response.row_length()];
    match response.run(&first.random, &first.epistemic, &mut row) {
        Err(reason) => StudyError::AllFailed { runs: table.len(), reason },
        // The same inputs give the same run; were it otherwise, the table would hold a finished run.
        Ok(()) => StudyError::Table(TableError::WrongColumns { run: 0, found: 0, expected: row.len() }),
    }
}
