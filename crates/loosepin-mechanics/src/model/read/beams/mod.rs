//! Beams and what they hang by.

pub(in crate::model) mod beam;
pub(in crate::model) mod beam_joints;
pub(in crate::model) mod beam_mass;
pub(in crate::model) mod section;
