//! The numbers of one sample, part by part: drives, loads, springs, friction, plays.
//! Each is read off the quantities of the model once for a sample.

pub(in crate::mechanism) mod arms;
pub(in crate::mechanism) mod control;
pub(in crate::mechanism) mod drive;
pub(in crate::mechanism) mod drive_place;
pub(in crate::mechanism) mod effort;
pub(in crate::mechanism) mod flanks;
pub(in crate::mechanism) mod foundation;
pub(in crate::mechanism) mod joint_friction;
pub(in crate::mechanism) mod load;
pub(in crate::mechanism) mod load_table;
pub(in crate::mechanism) mod nodal_geometry;
pub(in crate::mechanism) mod pin_pair;
pub(in crate::mechanism) mod spring;
pub(in crate::mechanism) mod stressed;
