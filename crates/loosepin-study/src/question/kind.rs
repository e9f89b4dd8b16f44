//! Interface of a question, and its keys in a study file.

use super::found::{Found, StudyRun};
use crate::assemble::Material;
use crate::error::StudyError;
use crate::file::{QuestionSettings, Study};
use crate::planning::cost_estimate::CostEstimate;
use crate::response::study_response::StudyResponse;
use crate::runs::all_runs::Runs;
use loosepin_bounds::{DoubleLoop, SurrogatePlan};
use loosepin_text::document::{Entry, Key, Reader};

/// A question that a study asks beside its bounds.
///
/// Which runs it wants depends on nothing but the study and the runs so far, so that a study that goes on, or that shards share, asks for
/// the same runs again (see [`super::steps::Steps`]).
pub trait Question: Send + Sync {
    /// Runs that it makes at most.
    fn most_runs(&self) -> usize {
        0
    }

    /// Adds its expected cost before any run.
    fn add_cost(&self, cost: &mut CostEstimate) {
        let _ = cost;
    }

    /// Makes its runs, and works out what needs them. `found`: the bounds, and the answers of the questions before it.
    ///
    /// # Errors
    /// Those of the runs; the question cannot be answered.
    fn run(&mut self, runs: &mut Runs<'_>, found: &mut Found) -> Result<(), StudyError>;

    /// Writes its answer into the result. `material`: what the bounds say; `found`: the answers of all questions.
    ///
    /// # Errors
    /// The question cannot be answered.
    fn record(&self, material: &Material<'_>, found: &Found, run: &mut StudyRun) -> Result<(), StudyError>;
}

/// Inputs for planning a question.
#[derive(Clone, Copy)]
pub struct QuestionContext<'b> {
    pub study: &'b Study,
    pub response: &'b StudyResponse,
    /// The double loop as it begins.
    pub double_loop: &'b DoubleLoop,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<&'b SurrogatePlan>,
    /// Whether all bounds are those of the surrogates.
    pub is_surrogate_alone: bool,
}

/// The plan of a question; `None` if the study does not ask it.
pub type Planned = Result<Option<Box<dyn Question>>, StudyError>;

/// A kind of question.
pub struct QuestionKind {
    /// Its table in a study file; `None` if other statements of a study decide whether it is asked.
    pub table: Option<QuestionTable>,
    /// Plans it.
    pub planned: fn(&QuestionContext<'_>) -> Planned,
}

/// The table of a single question in a study file.
pub struct QuestionTable {
    /// Its key, of a table that may be left out.
    pub key: Key,
    /// Reads the table, if it is there, and stores the settings of the question.
    pub read: fn(Option<&Entry<'_>>, &mut Reader, &mut QuestionSettings),
}

impl QuestionKind {
    /// A question that is asked by what a study states besides.
    pub const fn without_table(planned: fn(&QuestionContext<'_>) -> Planned) -> Self {
        Self { table: None, planned }
    }
}
