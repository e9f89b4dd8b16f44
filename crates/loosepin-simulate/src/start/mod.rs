//! The state at the start of a run: journals that rest, flexible bodies that have settled, and how far these will bend. Nothing here
//! steps through time.

pub(crate) mod bending_estimate;
pub(crate) mod resting;
pub(crate) mod static_equilibrium;
pub(crate) mod supports;
