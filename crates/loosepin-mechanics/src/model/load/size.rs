//! How the size of a load is written: constant, over time or the motion of a joint, or by points.

use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension, Rule};

/// The keys under which a kind of load has its size.
#[derive(Debug, Clone, Copy)]
pub struct SizeKeys {
    /// The key of the size itself.
    pub key: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Keys of a size that goes up and down.
    pub harmonic: &'static Keys,
    /// Whether the points of a table may be pressures on an area.
    pub takes_pressures: bool,
}

pub(super) const FREQUENCY: Key =
    required("frequency", quantity(Dimension::FREQUENCY, Rule::Positive), "\"20 Hz\"", "oscillations in a second");
pub(super) const PHASE: Key = optional(
    "phase",
    quantity(Dimension::ANGLE, Rule::Finite),
    "\"90 deg\"",
    "phase at time zero, 0 for the middle on the way up; 0 deg if left out",
);
pub(super) const JOINT: Key = optional(
    "joint",
    Kind::Reference("joint"),
    "\"main\"",
    "the joint whose angle (or position) and speed the expression reads, or the table is over",
);

/// The words for what a table is over.
pub(in crate::model) const ARGUMENTS: [&str; 4] = ["time", "angle", "position", "speed"];

pub(super) const OF: Key = optional(
    "of",
    Kind::Choice(&ARGUMENTS),
    "\"angle\"",
    "beside points or csv, needed there: what the first column is: the time, or angle, position or speed of the joint",
);
pub(super) const PERIOD: Key = optional(
    "period",
    Kind::AnyQuantity,
    "\"720 deg\"",
    "beside points or csv: after which the table begins again; if left out, it keeps the value of each end beyond it",
);
pub(super) const CURVE: Key = optional(
    "curve",
    Kind::Choice(&["monotone", "spline"]),
    "\"spline\"",
    "beside points or csv: monotone, if left out: between two points nowhere beyond them; spline: smoother, and it may swing beyond them",
);
