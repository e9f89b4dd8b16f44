//! From features of a measured motion to the values of the unknowns that are consistent with them.
//! Tests of values against features, where they are made, what they leave. Readings of a backlash test stand outside.

mod agreement;
mod distribution;
mod grid;
mod invert;
mod joint_test;
mod lengths;
mod likelihood;
mod plan;
mod posterior;
mod run_cache;
mod scatter;
mod sided;
mod unknowns;

pub(crate) use invert::identify_motion;
pub use invert::{MotionRig, MotionValues, RunsOfValue};
pub use plan::plan_motion;
pub use run_cache::{NO_CALLBACK, ProgressCallback};
