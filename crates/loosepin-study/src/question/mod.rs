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
pub(super) use found::Found;
pub use found::StudyRun;
pub(super) use kind::{Question, QuestionContext};
pub use loosest::with_loosened;
pub(super) use rare::Rare;
pub(super) use steps::take_steps;
pub use surrogate::{SavedInput, SavedOutput, SavedSurrogateError, SavedSurrogates};
pub(super) use surrogate::{SurrogateSteps, most_surrogate_runs, surrogate_plan};

use super::error::StudyError;
use super::file::QuestionSettings;
use kind::QuestionKind;
use loosepin_text::document::{Key, Reader, Table};

/// Every kind of question, in the order in which they make their runs.
static QUESTIONS: &[QuestionKind] = &[
    QuestionKind::without_table(contributors::planned),
    QuestionKind::without_table(rare::planned),
    QuestionKind::without_table(surrogate::planned),
    QuestionKind::without_table(promise::planned),
    QuestionKind::without_table(loosest::planned),
    further_turns::KIND,
];

/// The keys of a study file that are tables of single questions.
pub(super) fn question_keys() -> impl Iterator<Item = Key> {
    QUESTIONS.iter().filter_map(|kind| kind.table.as_ref()).map(|table| table.key)
}

/// Reads the tables of single questions.
pub(super) fn read_questions(root: &Table<'_>, reader: &mut Reader) -> QuestionSettings {
    let mut settings = QuestionSettings::default();
    for table in QUESTIONS.iter().filter_map(|kind| kind.table.as_ref()) {
        (table.read)(root.get(table.key.name).as_ref(), reader, &mut settings);
    }
    settings
}

/// The questions that the study asks.
///
/// # Errors
/// One of them is not possible.
pub(super) fn questions(basis: &QuestionContext<'_>) -> Result<Vec<Box<dyn Question>>, StudyError> {
    QUESTIONS.iter().filter_map(|kind| (kind.planned)(basis).transpose()).collect()
}
