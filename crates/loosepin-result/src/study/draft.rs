//! What a study knows before it is finished.

use super::{BoundRecord, RequirementOutcome, Verdict};
use loosepin_text::units::DisplayUnits;

/// Bounds from the runs so far. Each has the stated confidence by itself, and is mostly wider than that of the
/// finished study.
#[derive(Debug, Clone)]
pub struct Draft {
    /// Runs that these bounds come from.
    pub runs: usize,
    /// Those asked for of single numbers: of extremes and means of a cycle, not of curves.
    pub bounds: Vec<BoundRecord>,
    /// The requirements over a whole cycle.
    pub requirements: Vec<RequirementOutcome>,
    /// The units of the study.
    pub display_units: DisplayUnits,
}

impl Draft {
    /// The worst of the verdicts so far; nothing without requirements.
    pub fn verdict(&self) -> Option<Verdict> {
        Verdict::of_all(self.requirements.iter().map(|requirement| requirement.verdict))
    }
}
