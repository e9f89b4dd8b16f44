//! A vector in space.

use crate::Real;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A vector in space, its components in the unit of the variable's name.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Vec3<T = f64> {
    /// Component along x.
    pub x: T,
    /// Component along y.
    pub y: T,
    /// Component along z.
    pub z: T,
}

impl Vec3 {
    /// The zero vector.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0, z: 0.0 };
    /// The unit vector along x.
    pub const X: Self = Self { x: 1.0, y: 0.0, z: 0.0 };
    /// The unit vector along y.
    pub const Y: Self = Self { x: 0.0, y: 1.0, z: 0.0 };
    /// The unit vector along z.
    pub const Z: Self = Self { x: 0.0, y: 0.0, z: 1.0 };
    /// The three unit vectors.
    pub const AXES: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// Length.
    #[inline]
    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    /// The unit vector in this direction; `None` for the zero vector and for what is not finite.
    #[inline]
    pub fn normalised(self) -> Option<Self> {
        let length = self.length();
        (length > 0.0 && length.is_finite()).then(|| self / length)
    }

    /// A unit vector across this one: its own axis turned out of the coordinate axis that it is least along.
    pub fn across(self) -> Option<Self> {
        let sizes = [self.x.abs(), self.y.abs(), self.z.abs()];
        let axis = if sizes[0] <= sizes[1] && sizes[0] <= sizes[2] {
            Self::X
        } else if sizes[1] <= sizes[2] {
            Self::Y
        } else {
            Self::Z
        };
        (axis - self * (axis.dot(self) / self.dot(self))).normalised()
    }

    /// Whether all components are numbers.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<T> Vec3<T> {
    /// The vector (x, y, z).
    #[inline(always)]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Its components.
    #[inline(always)]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// Each component by itself.
    #[inline(always)]
    pub fn map<U>(self, of: impl Fn(T) -> U) -> Vec3<U> {
        Vec3 { x: of(self.x), y: of(self.y), z: of(self.z) }
    }
}

impl<T: Real> Vec3<T> {
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Vector product.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
}

impl<T> From<[T; 3]> for Vec3<T> {
    #[inline(always)]
    fn from([x, y, z]: [T; 3]) -> Self {
        Self { x, y, z }
    }
}
impl<T: Real> Add for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}
impl<T: Real> Sub for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}
impl<T: Real> Neg for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}
impl<T: Real> Mul<T> for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}
impl<T: Real> Div<T> for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: T) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }
    }
}
impl<T: Real> AddAssign for Vec3<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<T: Real> SubAssign for Vec3<T> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
