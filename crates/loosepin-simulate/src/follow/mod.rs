//! Deviations of positions that are followed through the recorded part of every run, on all lanes at once.
//!
//! Between two steps a position is the polynomial of degree five through its values, rates and accelerations at their ends. What it is
//! compared with is a table of such polynomials ([`crate::IdealCurve`]); so a deviation is one as well, which has limits, integrals
//! and values at given instants in closed form. Only extremes are located lane by lane, where the limits allow a new one.

mod extremes;
mod lane;
mod layout;
mod plan;

pub use extremes::{extremes_within, points_within};
pub(crate) use lane::LaneFollow;
pub use layout::GAUSS;
pub(crate) use layout::{FollowLayout, StepEnds};
pub use plan::{DeviationRange, Findings, Follow, FollowedDeviation, FollowedRun};
