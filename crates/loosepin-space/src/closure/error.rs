//! Why loops are not closed.

use core::fmt;
use loosepin_text::units::{Dimension, format_value};

/// Where on the way of a drive something happens.
#[derive(Debug, Clone, PartialEq)]
pub struct DrivePlace {
    /// The input of the cycle.
    pub input: f64,
    /// The joint of the first drive that moves; empty if none does.
    pub driven_joint: String,
    /// Its coordinate there, rad or m.
    pub value: f64,
    /// Whether that is a length, m.
    pub is_length: bool,
}

/// The joint whose row is farthest from closing.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenJoint {
    /// The joint.
    pub joint: String,
    /// How far it is apart, m or rad.
    pub apart: f64,
    /// Whether that is a length, m.
    pub is_length: bool,
}

/// Why a position is not found.
#[derive(Debug, Clone, PartialEq)]
pub enum ClosureError {
    /// Not one finite value for each drive.
    BadDrives {
        /// Number of drives of the mechanism.
        drives: usize,
        /// Number of finite values that were given.
        values: usize,
    },
    /// The loops cannot be closed from the start poses.
    DoesNotClose(OpenJoint),
    /// The parts do not fit: they cannot reach each other, or redundant rows contradict each other.
    Contradiction(OpenJoint),
    /// The start poses close a joint with axes that point against each other.
    Reversed {
        /// The joint.
        joint: String,
    },
    /// The drive cannot go on: another joint has come to its dead position.
    Locked {
        /// Where.
        place: DrivePlace,
        /// The joint whose bodies could move there with the drive held.
        joint: String,
    },
    /// The joints hold the coordinate of a drive, so that it cannot move at all.
    DriveHeld {
        /// Where.
        place: DrivePlace,
    },
    /// Two ways of assembly meet, so that what follows is not determined.
    ChangePoint {
        /// Where.
        place: DrivePlace,
        /// The joint whose bodies could move there with the drive held.
        joint: String,
    },
    /// The rank of the loop equations changes, so that what follows is not determined.
    RankChanges {
        /// Where.
        place: DrivePlace,
        /// The rank before.
        before: usize,
        /// The rank here.
        here: usize,
    },
    /// The motion could not be followed with the shortest step.
    NotFollowed {
        /// Where.
        place: DrivePlace,
    },
}

impl ClosureError {
    /// The joint at fault, where there is one.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::DoesNotClose(open) | Self::Contradiction(open) => Some(&open.joint),
            Self::Reversed { joint } | Self::Locked { joint, .. } | Self::ChangePoint { joint, .. } => Some(joint),
            Self::DriveHeld { place } => Some(&place.driven_joint),
            Self::BadDrives { .. } | Self::RankChanges { .. } | Self::NotFollowed { .. } => None,
        }
    }
}

impl fmt::Display for DrivePlace {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.driven_joint.is_empty() {
            return write!(out, "input {}", self.input);
        }
        write!(out, "'{}' at {}", self.driven_joint, readable(self.value, self.is_length))
    }
}

impl fmt::Display for OpenJoint {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        // To three digits.
        let apart = format!("{:.2e}", self.apart).parse().unwrap_or(self.apart);
        write!(out, "joint '{}' is {} apart", self.joint, readable(apart, self.is_length))
    }
}

/// A length or an angle for people.
fn readable(value_si: f64, is_length: bool) -> String {
    // What a search ends at has no more digits than these.
    let value_si = format!("{value_si:.5e}").parse().unwrap_or(value_si);
    format_value(value_si, if is_length { Dimension::LENGTH } else { Dimension::ANGLE })
}

impl fmt::Display for ClosureError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BadDrives { drives, values } => {
                write!(out, "the mechanism has {drives} drives and takes as many finite values, not {values}")
            }
            Self::DoesNotClose(open) => write!(out, "the loops do not close from the start poses: {open}"),
            Self::Contradiction(open) => write!(
                out,
                "the parts do not fit: as near as they come, {open}; lengths are too short or too long, or joints that hold the \
                 same motion contradict each other"
            ),
            Self::Reversed { joint } => {
                write!(
                    out,
                    "joint '{joint}': at the start its axes in bearing and journal are more than a right angle apart; say where its bodies start \
                     under [assembly] guess, or turn one of the axes"
                )
            }
            Self::Locked { place, joint } => {
                write!(out, "the drive locks at {place}: joint '{joint}' is in its dead position")
            }
            Self::DriveHeld { place } => {
                write!(out, "the drive cannot move from {place}: the joints hold it, and what is left moves without it")
            }
            Self::ChangePoint { place, joint } => {
                write!(
                    out,
                    "change point at {place}: joint '{joint}' can move either way, so that what follows is not determined"
                )
            }
            Self::RankChanges { place, before, here } => {
                write!(
                    out,
                    "at {place} the loop equations have rank {here}, and {before} before: what follows is not determined"
                )
            }
            Self::NotFollowed { place } => write!(out, "the motion cannot be followed beyond {place}"),
        }
    }
}

impl std::error::Error for ClosureError {}
