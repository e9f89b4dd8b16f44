//! Positions that close all loops: the equations, Newton's method with redundant rows, and the way along a cycle of the drives.
//!
//! Unknowns are 6 quasi-velocities for each body that moves, v/L and ω in ground axes, L the characteristic length; rows that are lengths are
//! divided by L. So singular values can be compared. Rank is counted with the relative threshold [`RANK_THRESHOLD`].

pub(crate) mod assembly;
pub(crate) mod bordered;
pub(crate) mod cycle;
pub(crate) mod error;
mod from_afar;
pub(crate) mod loops;
pub(crate) mod newton;
mod other_starts;
pub(crate) mod position;
pub(crate) mod singular;
mod sparse_lu;
pub(crate) mod step;

pub use assembly::assemble;
pub use cycle::{Cycle, cycle};
pub use singular::RANK_THRESHOLD;
