#![doc = include_str!("../README.md")]

mod combinations;
mod conduct;
mod consistent;
mod error;
mod friction;
mod further;
mod influence;
mod linear_program;
mod locked;
mod misfit;
mod narrowed;
mod nominal;
mod rig;
mod states;
mod yielding;

pub use conduct::{CONFIDENCE, Options, identify};
pub use error::IdentifyProblem;
pub use loosepin_result::identification as record;
pub use narrowed::{Narrowed, narrowed, write_narrowed};
