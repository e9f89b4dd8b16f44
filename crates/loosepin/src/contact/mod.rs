//! Contact and friction laws of a revolute joint with clearance.
//!
//! One law a file. A new law of the family `F_N = K δⁿ (1 + χ δ̇/v0)` is one file with one struct that implements
//! [`PointLaw`], and one line in [`POINT_LAWS`].

mod laws;

pub use laws::{POINT_LAWS, PointLaw, point_law};
