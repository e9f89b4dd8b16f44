//! Why a path names no quantity that can be set.

use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::numbers::{DIAMETRAL, Origin, QuantityId, QuantityTable, RADIAL};
use loosepin_text::units::quoted;

problems! {
    /// Why a path names no quantity that can be set.
    #[derive(Debug, Clone, PartialEq)]
    pub enum PathError {
        /// `why` names the unknown part of the path, `hint` the likely intention.
        Unknown { path: String, why: Option<String>, hint: String } => Code::UnknownPath,
            says("the model has no quantity '{path}'{}", why.as_ref().map_or(String::new(), |why| format!(": {why}"))),
            hint_of(Some(hint.clone()));
        /// The joint states its clearance under the other of the two keys.
        OtherClearance { path: String, stated: String } => Code::UnknownPath,
            says("'{path}' cannot be set: the model gives '{stated}'"),
            hint("set '{stated}', with {} the value", if stated.ends_with(RADIAL) { "half" } else { "twice" });
        NoPlay { path: String, joint: String } => Code::UnknownPath,
            says("'{path}': joint '{joint}' has no play"),
            hint("give it a clearance in the model file, with the other keys of a joint with play");
        Expression { path: String, depends_on: Vec<String> } => Code::NotSettable,
            says("'{path}' is given by an expression and cannot be set"),
            hint("it depends on {}", quoted(depends_on));
        /// The quantity fixes the unit of others, or the kind of a joint.
        Fixed { path: String } => Code::NotSettable,
            says("'{path}' cannot be set"),
            hint("{}", if path.ends_with(RADIAL) || path.ends_with(DIAMETRAL) {
                "a joint with play needs bearing_radius and contact in the model file"
            } else if path.ends_with(".clearance") {
                "a joint with play needs its half_length, half_height or end_radius, and contact in the model file"
            } else {
                "it fixes the unit of the stiffness; change both in the model file"
            });
    }
}

impl PathError {
    /// The quantity, if it can be set from outside.
    ///
    /// # Errors
    /// It is fixed, or given by an expression (with what it depends on).
    pub fn demand_settable(quantities: &QuantityTable, id: QuantityId) -> Result<QuantityId, PathError> {
        let path = quantities[id].path.clone();
        match &quantities[id].origin {
            Origin::Literal | Origin::Default => Ok(id),
            Origin::Fixed => Err(PathError::Fixed { path }),
            Origin::Expression { .. } => {
                let roots = quantities.roots(id).into_iter();
                Err(PathError::Expression {
                    path,
                    depends_on: roots.map(|root| quantities[root].path.clone()).collect(),
                })
            }
        }
    }
}
