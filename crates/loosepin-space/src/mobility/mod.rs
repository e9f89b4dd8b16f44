//! Degrees of freedom, rows that repeat others, and parts that move without moving anything else.

pub(crate) mod idle;
mod of_position;

pub use idle::{IdleKind, IdleMotion};
pub use of_position::{Mobility, RedundantDirection, RedundantShare, mobility};
