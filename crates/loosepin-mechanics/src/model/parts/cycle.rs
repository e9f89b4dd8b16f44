//! The recorded part of a run, and the turn that it is counted by.

use crate::model::ids::DriveId;
use loosepin_text::document::{Key, Kind, Reads, count};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::Rule;

/// Rows recorded in a turn, at most.
const MAX_SAMPLES_PER_TURN: u64 = 1_000_000;

record! {
    /// the turns to simulate and to record
    pub(in crate::model) struct CycleNumbers for Reads;
    /// turns simulated before recording
    optional transient_turns: Option<f64> = Kind::Number { rule: Rule::Turns }, "2", or 2.0 called "2";
    /// turns recorded
    optional recorded_turns: Option<f64> = Kind::Number { rule: Rule::SomeTurns }, "1", or 1.0 called "1";
    /// rows recorded per turn
    optional samples_per_turn: Option<usize> = count(1, MAX_SAMPLES_PER_TURN), "500", or 500;
}

/// Numbers of `[cycle]`: turns run before recording, turns recorded, and rows recorded in a turn.
pub const CYCLE_NUMBERS: &[Key] = CycleNumbers::KEYS.keys;

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
