//! Why a path names no quantity that can be set.

use loosepin_text::diagnostics::{Code, Problem};
use loosepin_text::units::quoted;
use thiserror::Error;

/// Why a path names no quantity that can be set.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum PathError {
    #[error("the model has no quantity '{path}'")]
    Unknown { path: String, nearest: Option<String> },
    #[error("'{path}': joint '{joint}' has no play")]
    NoPlay { path: String, joint: String },
    #[error("'{path}' is given by an expression and cannot be set")]
    Expression { path: String, depends_on: Vec<String> },
    /// The quantity fixes the unit of others, or the kind of a joint.
    #[error("'{path}' cannot be set")]
    Fixed { path: String },
}

impl Problem for PathError {
    fn code(&self) -> Code {
        match self {
            Self::Unknown { .. } | Self::NoPlay { .. } => Code::UnknownPath,
            Self::Expression { .. } | Self::Fixed { .. } => Code::NotSettable,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Unknown { nearest: Some(nearest), .. } => Some(format!("did you mean '{nearest}'?")),
            Self::Unknown { .. } => {
                Some("paths follow the model file, for example joint.gudgeon.radial_clearance".to_owned())
            }
            Self::NoPlay { .. } => {
                Some("give it a clearance in the model file, with what a joint with play needs".to_owned())
            }
            Self::Expression { depends_on, .. } => Some(format!("it depends on {}", quoted(depends_on))),
            Self::Fixed { path } if path.ends_with(".radial_clearance") => {
                Some("a joint with play needs bearing_radius and contact in the model file".to_owned())
            }
            Self::Fixed { .. } => Some("it fixes the unit of the stiffness; change both in the model file".to_owned()),
        }
    }
}
