//! A vector in the plane.

use crate::Real;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A vector in the plane, its components in the unit of the variable's name.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Vec2<T> {
    /// Component along x.
    pub x: T,
    /// Component along y.
    pub y: T,
}

impl<T: Real> Vec2<T> {
    /// The vector (x, y).
    #[inline(always)]
    pub fn new(x: T, y: T) -> Self {
        Self { x, y }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { x: T::zero(), y: T::zero() }
    }
    /// A vector of constants.
    #[inline(always)]
    pub fn from_f64(vector: Vec2<f64>) -> Self {
        Self { x: T::from_f64(vector.x), y: T::from_f64(vector.y) }
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.x.mul_add(other.x, self.y * other.y)
    }
    /// The z component of the vector product.
    #[inline(always)]
    pub fn cross(self, other: Self) -> T {
        self.x.mul_add(other.y, -(self.y * other.x))
    }
    /// The vector turned by +90°.
    #[inline(always)]
    pub fn turned(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
    /// The vector turned by the angle whose sine and cosine are given.
    #[inline(always)]
    pub fn rotated(self, sine: T, cosine: T) -> Self {
        Self { x: cosine.mul_add(self.x, -(sine * self.y)), y: sine.mul_add(self.x, cosine * self.y) }
    }
    /// The vector plus `factor` times `other`.
    #[inline(always)]
    pub fn plus(self, other: Self, factor: T) -> Self {
        Self { x: other.x.mul_add(factor, self.x), y: other.y.mul_add(factor, self.y) }
    }
    /// Square of the length.
    #[inline(always)]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }
    /// Length.
    #[inline(always)]
    pub fn length(self) -> T {
        self.length_squared().sqrt()
    }
}

impl<T: Real> Add for Vec2<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}
impl<T: Real> Sub for Vec2<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}
impl<T: Real> Neg for Vec2<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}
impl<T: Real> Mul<T> for Vec2<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}
impl<T: Real> AddAssign for Vec2<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<T: Real> SubAssign for Vec2<T> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
