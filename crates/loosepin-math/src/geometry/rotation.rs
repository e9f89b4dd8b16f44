//! A turn as three axes.

use super::vec3::Vec3;
use crate::Real;

/// Axes of a frame, x, y and z, in the axes of another: the columns of the matrix R of the turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation<T = f64> {
    /// The x axis.
    pub x: Vec3<T>,
    /// The y axis.
    pub y: Vec3<T>,
    /// The z axis.
    pub z: Vec3<T>,
}

impl<T: Real> Rotation<T> {
    /// R v: a vector of this frame in the axes of the other.
    #[inline(always)]
    pub fn apply(&self, vector: Vec3<T>) -> Vec3<T> {
        self.x * vector.x + self.y * vector.y + self.z * vector.z
    }

    /// Rᵀ v: a vector of the other frame in the axes of this one.
    #[inline(always)]
    pub fn apply_transposed(&self, vector: Vec3<T>) -> Vec3<T> {
        Vec3::new(self.x.dot(vector), self.y.dot(vector), self.z.dot(vector))
    }

    /// R S: first the turn `other`, then this one.
    #[inline(always)]
    pub fn compose(&self, other: &Self) -> Self {
        Self { x: self.apply(other.x), y: self.apply(other.y), z: self.apply(other.z) }
    }

    /// Rᵀ: the way back.
    #[inline(always)]
    pub fn transposed(&self) -> Self {
        let Self { x, y, z } = *self;
        Self { x: Vec3::new(x.x, y.x, z.x), y: Vec3::new(x.y, y.y, z.y), z: Vec3::new(x.z, y.z, z.z) }
    }

    /// Rᵀ S.
    #[inline]
    pub fn transposed_times(&self, other: &Self) -> Self {
        Self { x: self.apply_transposed(other.x), y: self.apply_transposed(other.y), z: self.apply_transposed(other.z) }
    }
}

impl Rotation {
    /// No turn.
    pub const IDENTITY: Self = Self { x: Vec3::X, y: Vec3::Y, z: Vec3::Z };

    /// The axial vector of (R - Rᵀ)/2: sin θ times the axis of the turn.
    #[inline]
    pub fn axial_vector(&self) -> Vec3 {
        Vec3::new(self.y.z - self.z.y, self.z.x - self.x.z, self.x.y - self.y.x) * 0.5
    }

    /// The sum of the diagonal, 1 + 2 cos θ.
    #[inline]
    pub fn trace(&self) -> f64 {
        self.x.x + self.y.y + self.z.z
    }

    /// The rotation vector, θ times the axis, 0 <= θ <= π.
    pub fn rotation_vector(&self) -> Vec3 {
        let axial = self.axial_vector();
        let (sine, cosine) = (axial.length(), 0.5 * (self.trace() - 1.0));
        let angle = libm::atan2(sine, cosine);
        if sine > 1e-6 || cosine > 0.0 {
            // θ/sin θ → 1 + θ²/6
            let factor = if sine > 1e-6 { angle / sine } else { 1.0 + angle * angle / 6.0 };
            return axial * factor;
        }
        // Close to half a turn (R + Rᵀ)/2 = 2aaᵀ - 1 holds the axis a.
        let diagonal = [self.x.x, self.y.y, self.z.z];
        let column = if diagonal[0] >= diagonal[1] && diagonal[0] >= diagonal[2] {
            self.x + Vec3::X
        } else if diagonal[1] >= diagonal[2] {
            self.y + Vec3::Y
        } else {
            self.z + Vec3::Z
        };
        let axis = column.normalised().unwrap_or(Vec3::X);
        let sign = if axis.dot(axial) < 0.0 { -1.0 } else { 1.0 };
        axis * (sign * angle)
    }

    /// Whether the axes are unit vectors, at right angles, right-handed, each to within `tolerance`.
    pub fn is_orthonormal(&self, tolerance: f64) -> bool {
        let pairs = [(self.x, self.x), (self.y, self.y), (self.z, self.z)];
        let across = [(self.x, self.y), (self.y, self.z), (self.z, self.x)];
        pairs.iter().all(|(a, b)| (a.dot(*b) - 1.0).abs() <= tolerance)
            && across.iter().all(|(a, b)| a.dot(*b).abs() <= tolerance)
            && self.x.cross(self.y).dot(self.z) > 0.0
    }
}
