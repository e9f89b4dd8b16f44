//! The kinds of results.

use serde::{Deserialize, Serialize};

/// Name of the file that says what a folder holds.
pub const MARKER_FILE: &str = "loosepin.json";

/// A kind of result, which has a folder of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ResultKind {
    /// One dynamic run.
    Simulation,
    /// Ideal motion and quasi-static answer.
    Motion,
    /// An uncertainty study.
    Study,
    /// Runs for many values of a quantity.
    Sweep,
    /// What readings and motion of a rig say of the unknowns.
    Identification,
    /// Neural networks of a study, for other programs.
    Networks,
}

impl ResultKind {
    /// As a noun: `simulation`, `motion`, `study`, `sweep`, `identification`, `export of networks`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Simulation => "simulation",
            Self::Motion => "motion",
            Self::Study => "study",
            Self::Sweep => "sweep",
            Self::Identification => "identification",
            Self::Networks => "export of networks",
        }
    }
}
