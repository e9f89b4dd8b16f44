//! The state at time zero: loops, drives, given values and journals in their bearings together.
//! Runs begin there; nothing here steps through time.

pub(in crate::mechanism) mod initial;
pub(in crate::mechanism) mod nodal_start;
pub(in crate::mechanism) mod offset;
pub(in crate::mechanism) mod offset_start;
pub(in crate::mechanism) mod start;
