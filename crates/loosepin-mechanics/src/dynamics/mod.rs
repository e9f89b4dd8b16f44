//! Equations of motion of a compiled mechanism, written once over [`loosepin_math::Real`].
//!
//! Kane's method in tree coordinates q: the mass matrix M and the generalised forces h come from the partial velocities
//! of the bodies; loops of ideal joints add constraint forces: `M q̈ = h + Jᵀ λ`, `J q̈ = -γ`.

mod beam;
mod beam_room;
mod circular_slot;
mod contact;
mod contact_motion;
mod control;
mod corner;
mod effort;
mod element_force;
mod energy;
mod equations;
mod film;
mod flank_force;
mod flanks;
mod foundation_contact;
mod inverse;
mod joint_friction;
mod linear_spring;
mod load;
mod nodal_beam;
mod nodal_room;
mod output;
mod pin;
mod pin_on_wall;
mod play;
mod reactions;
mod slot;
mod spring;
mod stress;
mod torsional_spring;
mod without_value;

pub use crate::contact::PlayState;
pub use contact_motion::{ContactForce, ContactMotion, ContactUnknowns, DepthRoot, GapMotion};
pub use element_force::{ActuatorForce, LoadForce, SpringForce};
pub use energy::MechanicalEnergy;
pub use equations::{Dynamics, Powers};
pub use foundation_contact::foundation_motion;
pub use play::PlayMotion;
pub use stress::SectionForce;
pub use without_value::WithoutValue;
