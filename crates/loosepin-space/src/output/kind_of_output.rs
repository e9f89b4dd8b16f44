//! What every kind of output says of itself.

use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::{Pose, Vec3};

/// The poses that an output is read off.
#[derive(Debug, Clone, Copy)]
pub struct OutputState<'a> {
    /// The mechanism.
    pub mechanism: &'a SpatialMechanism,
    /// Pose of each of its bodies.
    pub poses: &'a [Pose],
}

/// Derivative of an output by the motion of one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyGradient {
    /// Number of the body.
    pub body: usize,
    /// By the displacement of the origin of its frame, in ground axes.
    pub by_displacement: Vec3,
    /// By its turning, in ground axes.
    pub by_turning: Vec3,
}

/// A number that is read off a position, as a deviation from the ideal position.
pub trait KindOfOutput {
    /// Its name.
    fn word(&self) -> &'static str;
    /// The deviation of `actual` from `ideal`, m or rad.
    fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64;
    /// Its derivatives at `actual`.
    fn gradient(&self, ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient>;
    /// Whether it can be read off this mechanism: bodies and joints are there, directions are unit vectors.
    fn fits(&self, mechanism: &SpatialMechanism) -> bool;
}

/// Largest departure of a direction from unit length.
pub(crate) const UNIT_TOLERANCE: f64 = 1e-9;

/// Whether a direction is a unit vector.
pub(crate) fn is_unit(direction: Vec3) -> bool {
    (direction.length() - 1.0).abs() <= UNIT_TOLERANCE
}
