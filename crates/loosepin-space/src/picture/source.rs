//! What a picture is made of.

use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::{Pose, Vec3};

/// A mechanism in the positions in which it is drawn.
#[derive(Debug, Clone, Copy)]
pub struct PictureSource<'a> {
    /// The mechanism.
    pub mechanism: &'a SpatialMechanism,
    /// Pose of each body, for each position.
    pub poses: &'a [Vec<Pose>],
    /// Named points of each body, in its frame.
    pub points: &'a [Vec<(String, Vec3)>],
    /// Speed of each drive, rad/s or m/s; its sign is the direction of the arrow.
    pub speeds: &'a [f64],
}
