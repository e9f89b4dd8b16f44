//! Equations of motion of a compiled mechanism, written once over [`loosepin_math::Real`].
//!
//! Kane's method in tree coordinates q: the mass matrix M and the generalised forces h come from the partial velocities
//! of the bodies; loops of ideal joints add constraint forces: `M q̈ = h + Jᵀ λ`, `J q̈ = -γ`.

mod bodies;
mod elements;
mod energy;
mod equations;
mod inverse;
mod output;
mod play;
mod reactions;
mod stress;

pub use crate::contact::PlayState;
pub use bodies::BodyEquations;
pub use elements::element_force::{ActuatorForce, LoadForce, SpringForce};
pub use elements::without_value::WithoutValue;
pub use energy::MechanicalEnergy;
pub use equations::{Dynamics, Powers};
pub use play::contact_motion::{ContactForce, ContactMotion, ContactUnknowns, DepthRoot, GapMotion};
pub use play::foundation_contact::foundation_motion;
pub use play::motion::PlayMotion;
pub use stress::SectionForce;
