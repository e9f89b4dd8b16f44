//! Vectors and matrices of three components.

use core::ops::{Add, Mul, Neg, Sub};
use loosepin_math::Real;

/// A vector.
#[derive(Debug, Clone, Copy)]
pub struct Vector3<T>(pub [T; 3]);

impl<T: Real> Vector3<T> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self([T::zero(); 3])
    }
    #[inline(always)]
    pub fn new(x: f64, y: f64, z: f64) -> Self {
        Self([x, y, z].map(T::from_f64))
    }
    #[inline(always)]
    pub fn dot(self, other: Self) -> T {
        self.dot_plus(other, T::zero())
    }
    /// `self · other + addend`.
    #[inline(always)]
    pub fn dot_plus(self, other: Self, addend: T) -> T {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a.mul_add(x, b.mul_add(y, c.mul_add(z, addend)))
    }
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b.mul_add(z, -(c * y)), c.mul_add(x, -(a * z)), a.mul_add(y, -(b * x))])
    }
    /// `self + other × arm`.
    #[inline(always)]
    pub fn plus_cross(self, other: Self, arm: Self) -> Self {
        let ([p, q, r], [a, b, c], [x, y, z]) = (self.0, other.0, arm.0);
        Self([(-c).mul_add(y, b.mul_add(z, p)), (-a).mul_add(z, c.mul_add(x, q)), (-b).mul_add(x, a.mul_add(y, r))])
    }
    /// `self + factor · other`.
    #[inline(always)]
    pub fn plus(self, other: Self, factor: T) -> Self {
        let ([p, q, r], [x, y, z]) = (self.0, other.0);
        Self([x.mul_add(factor, p), y.mul_add(factor, q), z.mul_add(factor, r)])
    }
}

impl<T: Real> Add for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([p, q, r], [x, y, z]) = (self.0, other.0);
        Self([p + x, q + y, r + z])
    }
}
impl<T: Real> Sub for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        let ([p, q, r], [x, y, z]) = (self.0, other.0);
        Self([p - x, q - y, r - z])
    }
}
impl<T: Real> Neg for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|component| -component))
    }
}
impl<T: Real> Mul<T> for Vector3<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}

/// A matrix by its rows.
#[derive(Debug, Clone, Copy)]
pub struct Matrix3<T>(pub [Vector3<T>; 3]);

impl<T: Real> Matrix3<T> {
    #[inline(always)]
    pub fn identity() -> Self {
        Self([Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 1.0)])
    }
    /// The rotation about z by the angle whose sine and cosine are given.
    #[inline(always)]
    pub fn about_z(sine: T, cosine: T) -> Self {
        let (zero, one) = (T::zero(), T::one());
        Self([Vector3([cosine, -sine, zero]), Vector3([sine, cosine, zero]), Vector3([zero, zero, one])])
    }
    /// The rotation of a unit quaternion (w, x, y, z).
    #[inline(always)]
    pub fn of_quaternion([w, x, y, z]: [T; 4]) -> Self {
        let two = T::from_f64(2.0);
        let one = T::one();
        let diagonal = |a: T, b: T| one - two * a.mul_add(a, b * b);
        let (xy, xz, yz) = (x * y, x * z, y * z);
        let (wx, wy, wz) = (w * x, w * y, w * z);
        Self([
            Vector3([diagonal(y, z), two * (xy - wz), two * (xz + wy)]),
            Vector3([two * (xy + wz), diagonal(x, z), two * (yz - wx)]),
            Vector3([two * (xz - wy), two * (yz + wx), diagonal(x, y)]),
        ])
    }
    #[inline(always)]
    pub fn column(&self, index: usize) -> Vector3<T> {
        Vector3(self.0.map(|row| row.0[index]))
    }
    #[inline(always)]
    pub fn transposed(&self) -> Self {
        Self([0, 1, 2].map(|index| self.column(index)))
    }
    /// The matrix times `vector`.
    #[inline(always)]
    pub fn turn(&self, vector: Vector3<T>) -> Vector3<T> {
        Vector3(self.0.map(|row| row.dot(vector)))
    }
    /// Its transpose times `vector`.
    #[inline(always)]
    pub fn turn_back(&self, vector: Vector3<T>) -> Vector3<T> {
        self.transposed().turn(vector)
    }
    /// The matrix times `other`.
    #[inline(always)]
    pub fn times(&self, other: &Self) -> Self {
        let columns = other.transposed();
        Self(self.0.map(|row| Vector3([0, 1, 2].map(|index| row.dot(columns.0[index])))))
    }
}
