//! Records of results: plain data in SI, and numbers that follow from it alone. Pages, tables and files are made of them; nothing is
//! computed here that needs a mechanism or a sample.

pub mod cases;
mod contact_basis;
pub mod identification;
mod identification_gain;
pub mod json;
pub mod kinematics;
pub mod motion;
pub mod motion_identification;
mod play_bounds;
pub mod point_path;
pub mod repeat;
pub mod round_off;
pub mod simulation;
pub mod spatial_picture;
pub mod study;
pub mod sweep;

pub use contact_basis::{ContactBasis, ContactShape, LongPinForce};
