//! Deviations of positions that are followed through the recorded part of every run, on all lanes at once.
//!
//! Between two steps a position is the polynomial of degree five through its values, rates and accelerations at their ends. What it is
//! compared with is a table of such polynomials ([`crate::IdealCurve`]); so a deviation is one as well, which has limits, integrals
//! and values at given instants in closed form. Only extremes are located lane by lane, where the limits allow a new one. Errors of points
//! from their ideal paths are made of two such deviations and are looked at within each step. Velocities, accelerations and forces are
//! evaluated at points of the dense output (`inside.rs`).

mod extremes;
mod inside;
mod instants;
mod lane;
mod layout;
mod path;
mod plan;
mod step_ends;

pub use extremes::{extremes_within, points_within};
pub(crate) use inside::{InsideLayout, LOBATTO};
pub(crate) use lane::LaneFollow;
pub(crate) use layout::FollowLayout;
pub use plan::{DeviationRange, Findings, Follow, FollowedDeviation, FollowedPath, FollowedRun};
pub use step_ends::GAUSS;
pub(crate) use step_ends::StepEnds;
