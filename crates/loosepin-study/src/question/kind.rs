//! What every question is asked.

use super::found::{Conclusion, Found};
use crate::error::StudyError;
use crate::file::Study;
use crate::foreseen::Foreseen;
use crate::response::StudyResponse;
use crate::sheet::Sheet;
use loosepin_bounds::{DoubleLoop, SurrogatePlan};

/// A question that a study asks beside its bounds.
///
/// Which runs it wants depends on nothing but the study and the runs so far, so that a study that goes on, or that shards share, asks for
/// the same runs again (see [`super::steps::Steps`]).
pub trait Question: Send + Sync {
    /// Runs that it makes at most.
    fn most_runs(&self) -> usize {
        0
    }

    /// Adds what is known of its cost before anything has run.
    fn foresee(&self, cost: &mut Foreseen) {
        let _ = cost;
    }

    /// Makes its runs, and works out what needs them. `found`: the bounds, and the answers of the questions before it.
    ///
    /// # Errors
    /// Those of the runs; the question cannot be answered.
    fn run(&mut self, sheet: &mut Sheet<'_>, found: &mut Found) -> Result<(), StudyError>;

    /// Writes its answer into the result.
    ///
    /// # Errors
    /// The question cannot be answered.
    fn record(&self, conclusion: &mut Conclusion<'_>) -> Result<(), StudyError>;
}

/// What a question is planned from.
#[derive(Clone, Copy)]
pub struct Basis<'b> {
    pub study: &'b Study,
    pub response: &'b StudyResponse,
    /// The double loop as it begins.
    pub double_loop: &'b DoubleLoop,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<&'b SurrogatePlan>,
    /// Whether all bounds are those of the surrogates.
    pub is_surrogate_alone: bool,
}

/// The plan of a question; nothing where the study does not ask it.
pub type Planned = Result<Option<Box<dyn Question>>, StudyError>;
