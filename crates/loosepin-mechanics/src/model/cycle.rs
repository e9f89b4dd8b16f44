//! The recorded part of a run, and the turn that it is counted by.

use super::ids::DriveId;
use super::quantity::QuantityId;

/// The part of the motion that `simulate` runs and a study records.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// The turn that everything is counted by.
    pub span: CycleSpan,
    /// Turns run before recording, >= 0.
    pub transient_turns: f64,
    /// Turns recorded, > 0.
    pub recorded_turns: f64,
    /// Rows of the history per recorded turn, >= 1.
    pub samples_per_turn: usize,
}

/// The turn that a cycle is counted by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleSpan {
    /// A turn of a revolute drive at constant speed: 2π of its joint coordinate.
    Turns(DriveId),
    /// A period of the motion that a drive prescribes.
    Periods(DriveId),
    /// This time, s.
    Duration(QuantityId),
}
