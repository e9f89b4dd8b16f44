//! Why a run ends without a result.

use crate::mechanism::SampleError;
use thiserror::Error;

/// The one reason why a run failed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RunFailure {
    /// The sample is impossible or its loops cannot close.
    #[error(transparent)]
    Sample(#[from] SampleError),
    /// The step became too small.
    #[error("at {time_s} s the step fell to {step_s:e} s, below the smallest of {smallest_s:e} s")]
    StepTooSmall {
        /// Time, s.
        time_s: f64,
        /// The step, s.
        step_s: f64,
        /// The smallest step, s.
        smallest_s: f64,
    },
    /// A position or velocity is not a number.
    #[error("at {time_s} s a position or velocity is not a finite number")]
    NotFinite {
        /// Time, s.
        time_s: f64,
    },
    /// The drive whose turns are counted does not turn.
    #[error("drive '{drive}' stands still: its turns cannot be counted")]
    StandsStill {
        /// The drive.
        drive: String,
    },
    /// The limit of evaluations is reached.
    #[error("at {time_s} s the limit of {limit} evaluations was reached")]
    TooManyEvaluations {
        /// Time, s.
        time_s: f64,
        /// The limit.
        limit: u64,
    },
}

/// Short names of all reasons, in the order of [`RunFailure::number`].
const CODES: [&str; 8] = [
    "impossible_value",
    "clearance_changes_topology",
    "cannot_close",
    "singular_position",
    "step_too_small",
    "not_finite",
    "drive_stands_still",
    "too_many_evaluations",
];

impl RunFailure {
    /// A short name for tables.
    pub fn code(&self) -> &'static str {
        Self::code_of(self.number())
    }

    /// A number for tables.
    pub fn number(&self) -> u16 {
        match self {
            Self::Sample(SampleError::Quantity(_)) => 0,
            Self::Sample(SampleError::ClearanceChangesTopology { .. }) => 1,
            Self::Sample(SampleError::CannotClose { .. }) => 2,
            Self::Sample(SampleError::Singular { .. }) => 3,
            Self::StepTooSmall { .. } => 4,
            Self::NotFinite { .. } => 5,
            Self::StandsStill { .. } => 6,
            Self::TooManyEvaluations { .. } => 7,
        }
    }

    /// The short name of a number that [`Self::number`] gave.
    pub fn code_of(number: u16) -> &'static str {
        CODES.get(usize::from(number)).copied().unwrap_or("unknown")
    }
}
