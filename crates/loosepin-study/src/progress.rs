//! What a study tells whoever waits for it, while it runs.

use loosepin_bounds::{DoubleLoop, Failure, RunInputs, SampleTable};
use loosepin_result::study::Draft;

/// What a study does.
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
    /// Nothing more.
    Finished,
}

/// Hears how far a study is.
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

    /// Hears what the runs so far say.
    fn draft(&self, draft: &Draft) {
        let _ = draft;
    }

    /// Hears what is otherwise than whoever waits expects, and changes no result.
    fn note(&self, text: &str) {
        let _ = text;
    }
}

/// Tells what runs say before all are made.
pub(super) trait Drafts: Sync {
    /// Whether a run of the first round belongs to the pilot, which is made before the others.
    fn is_in_pilot(&self, inputs: &RunInputs) -> bool;

    /// What the runs of the pilot say; nothing where they do not suffice.
    fn of_pilot(&self, runs: &[PilotRun<'_>]) -> Option<Draft>;

    /// What `plan` says of the runs in `table`; nothing where it asks for nothing that a draft tells.
    fn of(&self, plan: &DoubleLoop, table: &SampleTable) -> Option<Draft>;
}

/// A finished run of the pilot.
pub(super) type PilotRun<'r> = (&'r RunInputs, Result<&'r [f64], Failure>);
