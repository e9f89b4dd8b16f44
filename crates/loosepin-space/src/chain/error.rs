//! Why there is no open chain.

use core::fmt;

/// Why a body does not hang on the ground by an open chain of driven joints.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ChainError {
    /// There is no such body, or it is the ground.
    NoBody {
        /// Number of the body.
        body: usize,
    },
    /// The body hangs on the ground by no joints, or in a loop.
    NotAChain {
        /// The body.
        body: String,
    },
    /// A joint of the chain has a coordinate that no drive holds, or moves otherwise than by an angle and a slide.
    NotDriven {
        /// The joint.
        joint: String,
    },
}

impl fmt::Display for ChainError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBody { body } => write!(out, "there is no moving body number {body}"),
            Self::NotAChain { body } => {
                write!(out, "body '{body}' does not hang on the ground by a chain of joints without a loop")
            }
            Self::NotDriven { joint } => {
                write!(
                    out,
                    "joint '{joint}' is not held by drives: a chain has driven revolute, prismatic and cylindrical joints, driven \
                     screws and rigid ones"
                )
            }
        }
    }
}

impl std::error::Error for ChainError {}
