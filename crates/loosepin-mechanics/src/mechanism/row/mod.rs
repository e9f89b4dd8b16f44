//! The conditions that ideal joints put on two bodies, where a cut joint closes a loop: a file for each, and those that each geometry has.
//!
//! Nothing else knows a condition by its name: residuals, Jacobian and accelerations of the constraints, the force that the joint carries, and
//! what a displacement by play changes go through this module.
//!
//! d is the way from the first point to the second, a an axis of the first marker, b one of the second:
//!
//! | Condition | Residual Φ | in the plane | in space |
//! |---|---|---|---|
//! | `coincident.rs` | d, less the eccentricity | x, y | x, y, z |
//! | `on_line.rs`, `across.rs` | a·d | a across the line | any a |
//! | `on_circle.rs` | \|d\| - R | yes | |
//! | `angle.rs`, `perpendicular.rs` | sine of the angle; a·b | yes | any a and b |

mod across;
mod angle;
mod coincident;
mod form;
mod list;
mod of_cuts;
mod on_circle;
mod on_line;
mod perpendicular;
mod plane;
mod space;

pub(in crate::mechanism) use angle::turn_rad;
pub use form::{CutColumns, CutMotion, CutState, RowAt, RowGeometry};
pub(in crate::mechanism) use of_cuts::cut_gradient;
pub use of_cuts::{cut_biases, cut_forces_n, cut_jacobian, cut_residuals};
pub(in crate::mechanism) use plane::displace;
