//! What is run and recorded, and by what it is counted.

use super::ids::DriveId;
use super::quantity::QuantityId;

/// What `simulate` runs and a study records.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// What a turn is.
    pub span: CycleSpan,
    /// Turns run before recording, >= 0.
    pub transient_turns: f64,
    /// Turns recorded, > 0.
    pub recorded_turns: f64,
    /// Rows of the history per recorded turn, >= 1.
    pub samples_per_turn: usize,
}

/// What is counted as a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleSpan {
    /// A turn of a revolute drive at constant speed: 2π of its joint coordinate.
    Turns(DriveId),
    /// A period of the motion that a drive prescribes.
    Periods(DriveId),
    /// This time, s.
    Duration(QuantityId),
}
