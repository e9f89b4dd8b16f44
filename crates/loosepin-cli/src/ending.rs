//! How a command ends.

use std::io;

use loosepin::diagnostics::{Complaint, Complaints, Problem};
use loosepin::results::ResultsError;

/// How a command ended that came to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Done {
    /// As asked.
    Well,
    /// As asked, and a requirement of the study, or a number of a reference case, is not shown to be met.
    RequirementNotMet,
    /// To the end, and no values explain what was measured.
    Misfit,
    /// To the end, and its result is that of a run that failed: its page says why.
    RunFailed,
    /// As asked, and shards of a study have a further round to run.
    RoundOpen,
    /// Ended by a signal, with what was finished kept.
    Interrupted,
}

/// Why a command did not come to its end.
#[derive(Debug)]
pub enum Failure {
    /// Something is wrong with what was given.
    Complaints(Complaints),
    /// Standard output cannot be written.
    Output(io::Error),
}

/// The result of a command.
pub type Ending = Result<Done, Failure>;

impl Failure {
    /// A failure that no place in a file is to blame for.
    pub fn of(problem: &dyn Problem) -> Failure {
        Failure::Complaints(Complaints::one(problem, None))
    }
}

impl From<Complaints> for Failure {
    fn from(complaints: Complaints) -> Failure {
        Failure::Complaints(complaints)
    }
}

impl From<Complaint> for Failure {
    fn from(complaint: Complaint) -> Failure {
        Failure::Complaints(complaint.into())
    }
}

impl From<ResultsError> for Failure {
    fn from(error: ResultsError) -> Failure {
        Failure::of(&error)
    }
}
