//! Why a path names no quantity that can be set.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::quoted;

problems! {
    /// Why a path names no quantity that can be set.
    #[derive(Debug, Clone, PartialEq)]
    pub enum PathError {
        Unknown { path: String, nearest: Option<String> } => Code::UnknownPath,
            says("the model has no quantity '{path}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => "paths follow the model file, for example joint.gudgeon.radial_clearance".to_owned(),
            }));
        NoPlay { path: String, joint: String } => Code::UnknownPath,
            says("'{path}': joint '{joint}' has no play"),
            hint("give it a clearance in the model file, with what a joint with play needs");
        Expression { path: String, depends_on: Vec<String> } => Code::NotSettable,
            says("'{path}' is given by an expression and cannot be set"),
            hint("it depends on {}", quoted(depends_on));
        /// The quantity fixes the unit of others, or the kind of a joint.
        Fixed { path: String } => Code::NotSettable,
            says("'{path}' cannot be set"),
            hint("{}", if path.ends_with(".radial_clearance") {
                "a joint with play needs bearing_radius and contact in the model file"
            } else {
                "it fixes the unit of the stiffness; change both in the model file"
            });
    }
}
