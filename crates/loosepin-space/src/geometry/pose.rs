//! Where a body is, and how it is turned.

use crate::geometry::quaternion::Quaternion;
use crate::geometry::rotation::Rotation;
use crate::geometry::vector::Vec3;

/// Pose of a body: the origin of its frame in the ground's, and the turn that takes body axes into ground axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position of the origin of the body's frame, m.
    pub position_m: Vec3,
    /// The turn from body axes into ground axes.
    pub orientation: Quaternion,
}

impl Pose {
    /// The pose of the ground.
    pub const GROUND: Self = Self { position_m: Vec3::ZERO, orientation: Quaternion::IDENTITY };

    /// A pose.
    pub fn new(position_m: Vec3, orientation: Quaternion) -> Self {
        Self { position_m, orientation }
    }

    /// Moved by a displacement of the origin, m, and turned by a rotation vector in ground axes, rad:
    /// r + Δr, exp(θ/2) ∘ q, made a unit quaternion again.
    pub fn moved(&self, displacement_m: Vec3, rotation_rad: Vec3) -> Self {
        let turn = Quaternion::from_rotation_vector(rotation_rad);
        Self { position_m: self.position_m + displacement_m, orientation: turn.compose(&self.orientation).normalised() }
    }

    /// A point of the body in the ground's frame, m.
    pub fn point_m(&self, point_m: Vec3) -> Vec3 {
        self.position_m + self.orientation.rotation().apply(point_m)
    }
}

/// A pose with its axes written out.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frame {
    pub origin_m: Vec3,
    pub axes: Rotation,
}

impl From<&Pose> for Frame {
    fn from(pose: &Pose) -> Self {
        Self { origin_m: pose.position_m, axes: pose.orientation.rotation() }
    }
}
