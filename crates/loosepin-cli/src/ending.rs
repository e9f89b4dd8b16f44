//! How a command ends.

use std::io;

use loosepin::diagnostics::{Diagnostic, Diagnostics, Problem};
use loosepin::results::ResultsError;

/// Outcome of a command that finished or was interrupted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Done {
    /// Success.
    Well,
    /// Finished, but a requirement of the study is not met or undecided, or a number of a reference case is outside its tolerance.
    RequirementNotMet,
    /// Finished, but no values explain the measurements.
    Misfit,
    /// Finished, but the stored run failed; its page gives the reason.
    RunFailed,
    /// Finished, but the shards of the study must run another round.
    RoundOpen,
    /// Ended by a signal; finished runs are kept.
    Interrupted,
}

/// Why a command failed.
#[derive(Debug)]
pub enum Failure {
    /// Errors in the input.
    Diagnostics(Diagnostics),
    /// Standard output cannot be written.
    Output(io::Error),
    /// A process that it started has reported why, and ended with this status.
    Reported(u8),
}

/// The result of a command.
pub type Ending = Result<Done, Failure>;

impl Failure {
    /// A failure without a position in a file.
    pub fn of(problem: &dyn Problem) -> Failure {
        Failure::Diagnostics(Diagnostics::one(problem, None))
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Failure {
        Failure::Diagnostics(diagnostics)
    }
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Failure {
        Failure::Diagnostics(diagnostic.into())
    }
}

impl From<ResultsError> for Failure {
    fn from(error: ResultsError) -> Failure {
        Failure::of(&error)
    }
}
