//! Why loops are not closed.

use core::fmt;
use loosepin_text::units::{Dimension, format_number, format_value};

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
    /// The parts fit, but for what numbers with few digits are off: redundant rows contradict each other by little.
    FewDigits(OpenJoint),
    /// The joints close without the drives, and not with them.
    DrivesDoNotFit {
        /// The joint of the first drive.
        joint: String,
        /// Number of drives that hold what others or the joints hold.
        repeated: usize,
    },
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
    /// Redundant rows, which agree so far, contradict each other from here on.
    Diverges {
        /// Where.
        place: DrivePlace,
        /// Whether drives take part in them.
        is_of_drives: bool,
    },
    /// The motion could not be followed with the shortest step.
    NotFollowed {
        /// Where.
        place: DrivePlace,
    },
    /// The way of the drives is so long that following it would take for ever.
    TooLong {
        /// The joint of the drive that moves furthest.
        joint: String,
        /// Steps along the motion, at least.
        steps: f64,
        /// As many are followed at most.
        most: usize,
    },
    /// Somebody stopped it.
    Stopped,
}

impl ClosureError {
    /// The joint at fault, where there is one.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::DoesNotClose(open) | Self::Contradiction(open) | Self::FewDigits(open) => Some(&open.joint),
            Self::Reversed { joint }
            | Self::Locked { joint, .. }
            | Self::ChangePoint { joint, .. }
            | Self::TooLong { joint, .. }
            | Self::DrivesDoNotFit { joint, .. } => Some(joint),
            Self::DriveHeld { place } | Self::Diverges { place, .. } | Self::NotFollowed { place } => {
                Some(place.driven_joint.as_str()).filter(|joint| !joint.is_empty())
            }
            Self::BadDrives { .. } | Self::RankChanges { .. } | Self::Stopped => None,
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
            Self::DoesNotClose(open) | Self::Contradiction(open) => write!(
                out,
                "no position was found in which all joints close: as near as the search came, {open}; dimensions do not fit, joints that hold the \
                 same motion contradict each other, or bodies start too far off: [assembly] guess says where they are"
            ),
            Self::FewDigits(open) => write!(
                out,
                "the joints fit to a few digits only: as near as they come, {open}; constraints that repeat each other need dimensions that fit to \
                 nine digits: write one as an expression of the others"
            ),
            Self::DrivesDoNotFit { repeated, .. } if *repeated > 0 => write!(
                out,
                "the joints close, but not with the drives: {} what others or the joints hold",
                if *repeated == 1 { "one of them holds".to_owned() } else { format!("{repeated} of them hold") }
            ),
            Self::DrivesDoNotFit { .. } => write!(
                out,
                "the joints close, but no position was found with the drives where they start: a start is out of reach, or bodies start too far off: \
                 [assembly] guess says where they are"
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
                write!(out, "the drive cannot move from {place}: the joints or other drives hold it")
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
            Self::Diverges { place, is_of_drives: true } => {
                write!(out, "the motion ends at {place}: a drive holds what another one or the joints hold")
            }
            Self::Diverges { place, is_of_drives: false } => write!(
                out,
                "the motion ends at {place}: constraints that repeat each other contradict each other from there on; they need dimensions that fit to \
                 nine digits: write one as an expression of the others"
            ),
            Self::NotFollowed { place } => write!(out, "the motion cannot be followed beyond {place}"),
            Self::TooLong { joint, steps, most } => write!(
                out,
                "to follow the drive of joint '{joint}' over the cycle takes about {} steps along the motion; at most {most} are made",
                format_number(steps.round())
            ),
            Self::Stopped => write!(out, "the motion was stopped before its end"),
        }
    }
}

impl std::error::Error for ClosureError {}
