//! Beams and what they hang by.
//! Section, mass, lumps and the joints at a beam. What a beam does stands in `dynamics`.

pub(in crate::model) mod beam;
pub(in crate::model) mod beam_joints;
pub(in crate::model) mod beam_mass;
pub(in crate::model) mod section;
