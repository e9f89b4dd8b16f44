//! How far play and manufacture take an output from its ideal value, in one position with the drives held.
//!
//! [`PoseAccuracy`] is where to begin. Its gains g are derivatives of an output by the variables p of play; the worst case of first order is
//! the largest g·p over the admissible set. Loops with redundant rows allow only p with h·p = 0.

mod dead_centre;
mod displaced;
mod error;
mod extreme;
mod farthest;
mod first_order;
mod gains;
mod largest_norm;
mod least_play;
pub(crate) mod linear;
mod multiple;
mod placed;
pub(crate) mod play_set;
pub(crate) mod plays;
mod pose_accuracy;
mod proven;
mod reserve;
mod sampled;
mod scatter;
pub(crate) mod search;
mod searched;
mod variance;
mod vector_reach;
mod worst_case;

pub use dead_centre::DeadCentreNearness;
pub use displaced::DisplacedPosition;
pub use error::AccuracyError;
pub use extreme::{Extreme, SearchOptions};
pub use first_order::FirstOrder;
pub use gains::{Gains, JournalGain};
pub use largest_norm::LargestNorm;
pub(crate) use largest_norm::Longest;
pub use least_play::{ClosedByPlay, LeastPlay};
pub use play_set::{PlacedBlock, PlaySet};
pub use pose_accuracy::PoseAccuracy;
pub use proven::ProvenEnds;
pub use reserve::{AssemblyReserve, MarkerError};
pub use sampled::SampledDeviation;
pub use scatter::{MarkerGain, MarkerGains, MarkerScatter, MarkerSide};
pub use searched::{Worst, WorstPlaces};
pub use variance::PlayDistribution;
pub use worst_case::WorstCase;
