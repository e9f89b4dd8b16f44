//! The questions of a study. Each is a file or a folder here: its plan, its runs, its answer, and what it writes into the result.
//!
//! Bounds come first: of the double loop (`direct`), or of the surrogate where it stands alone. All other questions stand on them, in the
//! order of [`QUESTIONS`]. How bounds are worded and drawn is not here but in `assemble`.

mod contributors;
mod curve_bands;
mod direct;
mod found;
mod further_turns;
mod kind;
mod loosest;
mod promise;
mod rare;
mod steps;
mod surrogate;

pub(super) use curve_bands::CurveBand;
pub(super) use direct::DirectSteps;
pub(super) use found::{Conclusion, Found};
pub(super) use kind::{Basis, Question};
pub use loosest::with_loosened;
pub(super) use rare::Rare;
pub(super) use steps::take_steps;
pub use surrogate::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates};
pub(super) use surrogate::{SurrogateSteps, most_surrogate_runs, surrogate_plan};

use super::error::StudyError;
use kind::Planned;

/// How each question is planned, in the order in which they make their runs.
const QUESTIONS: [fn(&Basis<'_>) -> Planned; 6] = [
    contributors::planned,
    rare::planned,
    surrogate::planned,
    promise::planned,
    loosest::planned,
    further_turns::planned,
];

/// The questions that the study asks.
///
/// # Errors
/// One of them is not possible.
pub(super) fn questions(basis: &Basis<'_>) -> Result<Vec<Box<dyn Question>>, StudyError> {
    QUESTIONS.iter().filter_map(|planned| planned(basis).transpose()).collect()
}
