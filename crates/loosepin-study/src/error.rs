//! Why a study has no result.

use super::file::MAX_RUNS;
use crate::response::problem::PrepareError;
use crate::runs::memory_at_hand::MemoryKind;
use crate::runs::run_subset::OpenRound;
use crate::runs::table::RunsTable;
use loosepin_bounds::{PlanError, PromiseError, SurrogatePlanError, TableError};
use loosepin_result::study::FailureGroup;
use loosepin_simulate::RunFailure;
use loosepin_store::StoreError;
use loosepin_text::units::counted;
use loosepin_uncertainty::SobolError;
use loosepin_uncertainty::contributors::IndexPlanError;
use std::fmt;
use thiserror::Error;

/// Size below which memory is shown in MiB.
const GIB_FROM: f64 = 0.1;

/// An amount of memory.
fn memory(gib: f64) -> String {
    if gib < GIB_FROM { format!("{:.1} MiB", gib * 1024.0) } else { format!("{gib:.2} GiB") }
}

/// Why a study has no result.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The study cannot begin.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The study has readings of a rig for `identify`, and no question.
    #[error("the study asks no question: its readings are for identify")]
    NothingAsked,
    /// Its sampling is not possible.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The runs of its surrogate are not possible.
    #[error("surrogate: {0}")]
    Surrogate(#[from] SurrogatePlanError),
    /// A promise is impossible.
    #[error("promise: {0}")]
    Promise(#[from] PromiseError),
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
    #[error("the system refused to start the threads")]
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
    /// The study was interrupted; the finished runs are in the table.
    #[error("interrupted after {} of at most {most_runs} runs", finished.columns.first().map_or(0, |column| column.data.len()))]
    Interrupted {
        /// The finished runs.
        finished: Box<RunsTable>,
        /// How many there would have been at most.
        most_runs: usize,
    },
    /// A round waits for runs that are made elsewhere; the runs made here are in the store.
    #[error("{0}")]
    RoundOpen(OpenRound),
    /// Runs outside of this process failed to be made; the finished ones are in the store.
    #[error("the runs could not be made: {reason}")]
    NotMade {
        /// The reason in words, from the provider of the runs.
        reason: String,
    },
    /// A budget of time where shards make the runs.
    #[error("a budget of time cannot be shared by shards, which run at different times")]
    TimeOfShards,
    /// More runs than anybody waits for.
    #[error("{runs} runs; must be at most {MAX_RUNS}")]
    TooManyRuns {
        /// Runs of the study at most.
        runs: usize,
    },
    /// More numbers than the available memory holds.
    #[error(
        "{runs} runs of {numbers} numbers each on {} need about {} of {}",
        counted(*threads, "thread"),
        memory(*needed_gib),
        match kind {
            MemoryKind::Pages => format!("memory; {} are at hand", memory(*at_hand_gib)),
            MemoryKind::Data => format!("memory for data; its limit (ulimit -d) leaves {}", memory(*at_hand_gib)),
            MemoryKind::Addresses => format!("address space; its limit (ulimit -v) leaves {}", memory(*at_hand_gib)),
        }
    )]
    TooMuchMemory {
        /// Runs of the study at most.
        runs: usize,
        /// Numbers of each, its inputs included.
        numbers: usize,
        /// Threads that make them.
        threads: usize,
        /// What there is too little of.
        kind: MemoryKind,
        /// What they take.
        needed_gib: f64,
        /// What there is.
        at_hand_gib: f64,
    },
    /// Too many runs failed; the finished ones are in the table, and in the store.
    #[error("{0}")]
    TooManyFailed(Box<TooManyFailed>),
    /// Every run failed.
    #[error("{}: {reason}", if *runs == 1 { "the run failed".to_owned() } else { format!("all {runs} runs failed; the first one") })]
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

impl From<SobolError> for StudyError {
    fn from(error: SobolError) -> Self {
        Self::Plan(error.into())
    }
}
