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

impl RunFailure {
    /// A short name for tables.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Sample(SampleError::Quantity(_)) => "impossible_value",
            Self::Sample(SampleError::ClearanceChangesTopology { .. }) => "clearance_changes_topology",
            Self::Sample(SampleError::CannotClose { .. }) => "cannot_close",
            Self::Sample(SampleError::Singular { .. }) => "singular_position",
            Self::StepTooSmall { .. } => "step_too_small",
            Self::NotFinite { .. } => "not_finite",
            Self::StandsStill { .. } => "drive_stands_still",
            Self::TooManyEvaluations { .. } => "too_many_evaluations",
        }
    }
}
