//! A turn as a unit quaternion.

use super::rotation::Rotation;
use super::vec3::Vec3;
use crate::sin_cos;

/// A unit quaternion (w, x, y, z): cos(θ/2), and sin(θ/2) times the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quaternion {
    /// cos(θ/2).
    pub w: f64,
    /// sin(θ/2) times the axis.
    pub vector: Vec3,
}

impl Quaternion {
    /// No turn.
    pub const IDENTITY: Self = Self { w: 1.0, vector: Vec3::ZERO };

    /// The quaternion (w, x, y, z), as it is.
    #[inline]
    pub fn new(w: f64, x: f64, y: f64, z: f64) -> Self {
        Self { w, vector: Vec3::new(x, y, z) }
    }

    /// The turn by |θ| about θ.
    pub fn from_rotation_vector(rotation_rad: Vec3) -> Self {
        let half = 0.5 * rotation_rad.length();
        let (sine, cosine) = sin_cos(half);
        // sin(h)/h → 1 - h²/6
        let factor = if half > 1e-5 { 0.5 * sine / half } else { 0.5 * (1.0 - half * half / 6.0) };
        Self { w: cosine, vector: rotation_rad * factor }
    }

    /// The turn with these axes.
    pub fn from_rotation(rotation: &Rotation) -> Self {
        Self::from_rotation_vector(rotation.rotation_vector()).normalised()
    }

    /// First the turn `other`, then this one.
    #[inline]
    pub fn compose(&self, other: &Self) -> Self {
        Self {
            w: self.w * other.w - self.vector.dot(other.vector),
            vector: other.vector * self.w + self.vector * other.w + self.vector.cross(other.vector),
        }
    }

    /// The same turn with a unit quaternion.
    #[inline]
    pub fn normalised(&self) -> Self {
        let size = self.size();
        Self { w: self.w / size, vector: self.vector / size }
    }

    /// √(w² + x² + y² + z²).
    #[inline]
    pub fn size(&self) -> f64 {
        (self.w * self.w + self.vector.dot(self.vector)).sqrt()
    }

    /// Its axes.
    #[inline]
    pub fn rotation(&self) -> Rotation {
        let (w, Vec3 { x, y, z }) = (self.w, self.vector);
        Rotation {
            x: Vec3::new(1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
            y: Vec3::new(2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)),
            z: Vec3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_rotation_vectors_and_back() {
        let pi = std::f64::consts::PI;
        for (axis, tolerance) in
            [(Vec3::new(0.6, 0.0, 0.8), 1e-14), (Vec3::new(-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0), 1e-14)]
        {
            for angle in [0.0, 1e-9, 1e-5, 0.3, 1.7, 3.1, pi - 1e-7] {
                let rotation = Quaternion::from_rotation_vector(axis * angle).rotation();
                assert!(rotation.is_orthonormal(tolerance));
                let back = rotation.rotation_vector();
                // Near half a turn the sine, which holds the angle, has lost its digits.
                assert!((back - axis * angle).length() < 1e-13 * (1.0 + 1.0 / (pi - angle)), "{angle}: {back:?}");
            }
        }
    }

    #[test]
    fn identity_composed_turns_are_the_product_of_their_axes() {
        let first = Quaternion::from_rotation_vector(Vec3::new(0.3, -1.1, 0.7));
        let second = Quaternion::from_rotation_vector(Vec3::new(-0.9, 0.2, 1.4));
        let (both, product) = (first.compose(&second).rotation(), first.rotation().compose(&second.rotation()));
        for (a, b) in [(both.x, product.x), (both.y, product.y), (both.z, product.z)] {
            assert!((a - b).length() < 1e-15 * 10.0);
        }
    }
}
