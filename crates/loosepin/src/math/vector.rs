//! A vector in the plane.

use super::Real;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A vector in the plane, its components in the unit that the name of the variable tells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vec2<T> {
    /// Component along x.
    pub x: T,
    /// Component along y.
    pub y: T,
}

impl<T: Real> Vec2<T> {
    /// The vector (x, y).
    #[inline]
    pub fn new(x: T, y: T) -> Self {
        Self { x, y }
    }
    /// The zero vector.
    #[inline]
    pub fn zero() -> Self {
        Self { x: T::zero(), y: T::zero() }
    }
    /// A vector of constants.
    pub fn from_f64(vector: Vec2<f64>) -> Self {
        Self { x: T::from_f64(vector.x), y: T::from_f64(vector.y) }
    }
    /// Scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y
    }
    /// The z component of the vector product.
    #[inline]
    pub fn cross(self, other: Self) -> T {
        self.x * other.y - self.y * other.x
    }
    /// The vector turned by +90°.
    #[inline]
    pub fn turned(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
    /// The vector turned by the angle whose sine and cosine are given.
    #[inline]
    pub fn rotated(self, sine: T, cosine: T) -> Self {
        Self { x: cosine * self.x - sine * self.y, y: sine * self.x + cosine * self.y }
    }
    /// Square of the length.
    #[inline]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }
    /// Length.
    #[inline]
    pub fn length(self) -> T {
        self.length_squared().sqrt()
    }
}

impl<T: Real> Add for Vec2<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}
impl<T: Real> Sub for Vec2<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}
impl<T: Real> Neg for Vec2<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}
impl<T: Real> Mul<T> for Vec2<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}
impl<T: Real> AddAssign for Vec2<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<T: Real> SubAssign for Vec2<T> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
