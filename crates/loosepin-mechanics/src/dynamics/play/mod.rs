//! Contact between the bodies of a joint or a coupling with play: motion of the parts, gaps, forces; a file for each shape. The laws of the
//! force stand in `contact`.

pub(in crate::dynamics) mod circular_slot;
pub(in crate::dynamics) mod contact;
pub(in crate::dynamics) mod contact_motion;
pub(in crate::dynamics) mod corner;
pub(in crate::dynamics) mod film;
pub(in crate::dynamics) mod flank_force;
pub(in crate::dynamics) mod flanks;
pub(in crate::dynamics) mod foundation_contact;
pub(in crate::dynamics) mod motion;
pub(in crate::dynamics) mod pin;
pub(in crate::dynamics) mod pin_on_wall;
pub(in crate::dynamics) mod slot;
