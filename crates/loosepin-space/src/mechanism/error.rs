//! Why a mechanism cannot be.

use core::fmt;

/// Why bodies, joints and drives do not make a mechanism. Numbers of bodies, joints and drives count from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum MechanismError {
    /// There is no body, or the first, the ground, is not at the origin without a turn.
    NoGround,
    /// A start pose has a number that is not finite, or a quaternion that is not a unit one.
    BadPose {
        /// The body.
        body: String,
    },
    /// A marker is on a body that is not there.
    NoBody {
        /// The joint.
        joint: String,
        /// Number of the body.
        body: usize,
    },
    /// Both markers are on one body.
    SameBody {
        /// The joint.
        joint: String,
        /// The body.
        body: String,
    },
    /// A marker has a number that is not finite, or axes that are not orthonormal.
    BadMarker {
        /// The joint.
        joint: String,
    },
    /// Numbers of a kind of joint break their rule.
    BadKind {
        /// The joint.
        joint: String,
        /// The rule.
        rule: &'static str,
    },
    /// Play of a kind that this kind of joint does not have.
    PlayOfAnotherJoint {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: &'static str,
        /// The kind of play.
        play: &'static str,
        /// The kind of joint that has this play.
        play_of: &'static str,
    },
    /// A number of a play breaks its rule.
    BadPlay {
        /// The joint.
        joint: String,
        /// What the number is.
        quantity: &'static str,
        /// The number.
        value: f64,
        /// The rule.
        rule: &'static str,
    },
    /// A drive of a joint that is not there.
    NoJoint {
        /// Number of the drive.
        drive: usize,
        /// Number of the joint.
        joint: usize,
    },
    /// A drive of a coordinate that the joint does not have.
    NoSuchCoordinate {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: &'static str,
    },
    /// Two drives of the same coordinate.
    DrivenTwice {
        /// The joint.
        joint: String,
    },
}

impl MechanismError {
    /// The joint at fault, if it is one.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::NoGround | Self::BadPose { .. } | Self::NoJoint { .. } => None,
            Self::NoBody { joint, .. }
            | Self::SameBody { joint, .. }
            | Self::BadMarker { joint }
            | Self::BadKind { joint, .. }
            | Self::PlayOfAnotherJoint { joint, .. }
            | Self::BadPlay { joint, .. }
            | Self::NoSuchCoordinate { joint, .. }
            | Self::DrivenTwice { joint } => Some(joint),
        }
    }
}

impl fmt::Display for MechanismError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoGround => write!(out, "the first body must be the ground, at the origin and not turned"),
            Self::BadPose { body } => {
                write!(out, "body '{body}': the start pose must be of finite numbers, with a unit quaternion")
            }
            Self::NoBody { joint, body } => write!(out, "joint '{joint}': there is no body number {body}"),
            Self::SameBody { joint, body } => {
                write!(out, "joint '{joint}': both markers are on body '{body}'; a joint connects two bodies")
            }
            Self::BadMarker { joint } => write!(
                out,
                "joint '{joint}': the point of a marker must be of finite numbers, and its axes orthonormal and \
                 right-handed"
            ),
            Self::BadKind { joint, rule } => write!(out, "joint '{joint}': {rule}"),
            Self::PlayOfAnotherJoint { joint, kind, play, play_of } => write!(
                out,
                "joint '{joint}': a {kind} joint has no play of kind '{play}', which is that of a {play_of} joint"
            ),
            Self::BadPlay { joint, quantity, value, rule } => {
                write!(out, "joint '{joint}': {quantity} is {value}; it {rule}")
            }
            Self::NoJoint { drive, joint } => write!(out, "drive number {drive}: there is no joint number {joint}"),
            Self::NoSuchCoordinate { joint, kind } => {
                write!(out, "joint '{joint}': a {kind} joint does not have the driven coordinate")
            }
            Self::DrivenTwice { joint } => write!(out, "joint '{joint}': its coordinate has two drives"),
        }
    }
}

impl std::error::Error for MechanismError {}
