//! Progress of a study while it runs: stages, counts, drafts, notes.

use loosepin_bounds::{DoubleLoop, Failure, RunInputs, SampleTable};
use loosepin_result::study::Draft;

/// Stage of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Says which runs come next, or works out the answer of a question from those that are made.
    Planning,
    /// Makes runs and keeps their rows.
    Runs,
    /// Runs the nominal mechanism, to draw it and the paths of its journals.
    Pictures,
    /// Puts the result together.
    Assembling,
    /// It is finished.
    Finished,
}

/// Receives the progress of a study.
pub trait Progress: Sync {
    /// `finished` of at most `most` runs are done.
    fn runs(&self, finished: usize, most: usize);

    /// What begins now.
    fn stage(&self, stage: Stage) {
        let _ = stage;
    }

    /// Whether drafts are wanted: they take time.
    fn wants_drafts(&self) -> bool {
        false
    }

    /// A draft from the runs so far.
    fn draft(&self, draft: &Draft) {
        let _ = draft;
    }

    /// Informational note to the user; it does not affect results.
    fn note(&self, text: &str) {
        let _ = text;
    }
}

/// Tells what runs say before all are made.
pub(crate) trait Drafts: Sync {
    /// Whether a run of the first round belongs to the pilot, which is made before the others.
    fn is_in_pilot(&self, inputs: &RunInputs) -> bool;

    /// The draft from the runs of the pilot; `None` if they do not suffice.
    fn of_pilot(&self, runs: &[PilotRun<'_>]) -> Option<Draft>;

    /// The draft that `plan` makes from the runs in `table`; `None` if it asks for nothing that a draft shows.
    fn of(&self, plan: &DoubleLoop, table: &SampleTable) -> Option<Draft>;
}

/// A finished run of the pilot.
pub(crate) type PilotRun<'r> = (&'r RunInputs, Result<&'r [f64], Failure>);
