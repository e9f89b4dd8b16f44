//! How a command ends.

use std::io;
use std::process::ExitCode;

use loosepin::diagnostics::{Complaint, Complaints, Problem};
use loosepin::results::ResultsError;

use crate::console;

/// How a command ended that came to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Done {
    /// As asked.
    Well,
    /// As asked, and a requirement of the study, or a number of a reference case, is not shown to be met.
    RequirementNotMet,
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

/// Says why a command failed, and gives its exit status.
pub fn exit_code(ending: Ending) -> ExitCode {
    match ending {
        Ok(Done::Well) => ExitCode::SUCCESS,
        Ok(Done::RequirementNotMet) => ExitCode::from(1),
        Ok(Done::RoundOpen) => ExitCode::from(3),
        Ok(Done::Interrupted) => ExitCode::from(130),
        Err(Failure::Complaints(complaints)) => {
            console::complain(&complaints);
            ExitCode::from(2)
        }
        Err(Failure::Output(error)) => {
            console::message(&format!("error: cannot write to standard output: {error}"));
            ExitCode::from(2)
        }
    }
}
