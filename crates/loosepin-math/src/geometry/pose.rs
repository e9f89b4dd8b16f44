//! Where a body is, and how it is turned.

use super::quaternion::Quaternion;
use super::rotation::Rotation;
use super::vec3::Vec3;

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
    #[inline]
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
    #[inline]
    pub fn point_m(&self, point_m: Vec3) -> Vec3 {
        self.position_m + self.orientation.rotation().apply(point_m)
    }
}

/// A frame in another one: a pose with its axes written out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Its origin, m.
    pub origin_m: Vec3,
    /// Its axes.
    pub axes: Rotation,
}

impl Frame {
    /// The other frame itself.
    pub const IDENTITY: Self = Self { origin_m: Vec3::ZERO, axes: Rotation::IDENTITY };

    /// A point of this frame in the other one, m.
    #[inline(always)]
    pub fn point_m(&self, point_m: Vec3) -> Vec3 {
        self.origin_m + self.axes.apply(point_m)
    }

    /// A frame in this one, seen from the other one.
    #[inline(always)]
    pub fn compose(&self, inner: &Self) -> Self {
        Self { origin_m: self.point_m(inner.origin_m), axes: self.axes.compose(&inner.axes) }
    }

    /// The other frame, seen from this one.
    #[inline(always)]
    pub fn inverse(&self) -> Self {
        let axes = self.axes.transposed();
        Self { origin_m: -axes.apply(self.origin_m), axes }
    }
}

impl From<&Pose> for Frame {
    #[inline]
    fn from(pose: &Pose) -> Self {
        Self { origin_m: pose.position_m, axes: pose.orientation.rotation() }
    }
}
