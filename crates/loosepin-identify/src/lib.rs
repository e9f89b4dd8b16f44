#![doc = include_str!("../README.md")]

mod combinations;
mod consistent;
mod error;
mod friction;
mod further;
mod identify;
mod influence;
mod linear_program;
mod locked;
mod misfit;
mod motion;
mod narrowed_interval;
mod nominal;
mod rig;
mod specimen_file;
mod states;
mod yielding;

pub use error::IdentifyProblem;
pub use identify::{CONFIDENCE, Options, POINTS, identify};
pub use loosepin_result::identification as record;
pub use loosepin_result::motion_identification as motion_record;
pub use motion::{MotionRig, MotionValues, NO_CALLBACK, ProgressCallback, RunsOfValue, plan_motion};
pub use narrowed_interval::{NarrowedInterval, known_bounds, narrowed, write_narrowed};
pub use specimen_file::SpecimenStudy;
