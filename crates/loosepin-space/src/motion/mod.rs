//! Velocities and accelerations of bodies and points at the rates of the drives.

mod path_direction;
mod path_frame;
mod rates;

pub(crate) use path_direction::{RESTING, path_direction};
pub use path_frame::PathFrame;
pub use rates::{BodyRates, Motion, motion};
