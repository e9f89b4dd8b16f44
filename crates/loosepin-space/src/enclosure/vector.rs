//! Vectors in space of such numbers.

use crate::enclosure::jet::{Jet, Number};
use crate::geometry::quaternion::Quaternion;
use crate::geometry::rotation::Rotation;
use crate::geometry::vector::Vec3;
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// A vector that does not move, known to round-off.
pub(crate) type FixedVector = [Interval; 3];
/// Axes that do not move, row by row of their matrix.
pub(crate) type FixedAxes = [FixedVector; 3];
/// A vector with its derivatives.
pub(crate) type JetVector<T> = [Jet<T>; 3];

pub(crate) fn exact(vector: Vec3) -> FixedVector {
    vector.to_array().map(Interval::from_f64)
}

pub(crate) fn constant<T: Number>(vector: &FixedVector) -> JetVector<T> {
    vector.map(Jet::constant)
}

/// The matrix of the turn of a quaternion, whatever its length: 1 + 2 (w [v] + [v]²)/(w² + v·v).
pub(crate) fn axes_of(turn: &Quaternion) -> FixedAxes {
    let w = Interval::from_f64(turn.w);
    let v = exact(turn.vector);
    let factor = Interval::from_f64(2.0) / (w.squared() + v[0].squared() + v[1].squared() + v[2].squared());
    let across = cross_matrix(v);
    from_fn(|i| {
        from_fn(|j| {
            let square = (0..3).fold(Interval::ZERO, |sum, k| sum + across[i][k] * across[k][j]);
            let one = Interval::from_f64(f64::from(u8::from(i == j)));
            one + factor * (w * across[i][j] + square)
        })
    })
}

fn cross_matrix([x, y, z]: FixedVector) -> FixedAxes {
    [[Interval::ZERO, -z, y], [z, Interval::ZERO, -x], [-y, x, Interval::ZERO]]
}

/// A v.
pub(crate) fn turned(axes: &FixedAxes, vector: FixedVector) -> FixedVector {
    from_fn(|i| (0..3).fold(Interval::ZERO, |sum, k| sum + axes[i][k] * vector[k]))
}

/// The axes x, y and z of a frame on a body, turned with it.
pub(crate) fn turned_axes(axes: &FixedAxes, own: &Rotation) -> [FixedVector; 3] {
    [own.x, own.y, own.z].map(|axis| turned(axes, exact(axis)))
}

pub(crate) fn dot<T: Number>(a: &JetVector<T>, b: &JetVector<T>) -> Jet<T> {
    &a[0] * &b[0] + &(&a[1] * &b[1]) + &(&a[2] * &b[2])
}

pub(crate) fn plus<T: Number>(a: JetVector<T>, b: &JetVector<T>) -> JetVector<T> {
    let mut sum = a;
    for (own, b) in sum.iter_mut().zip(b) {
        *own = own.clone() + b;
    }
    sum
}

pub(crate) fn minus<T: Number>(a: JetVector<T>, b: &JetVector<T>) -> JetVector<T> {
    let mut sum = a;
    for (own, b) in sum.iter_mut().zip(b) {
        *own = own.clone() - b;
    }
    sum
}

pub(crate) fn scaled<T: Number>(a: &JetVector<T>, factor: &Jet<T>) -> JetVector<T> {
    from_fn(|k| &a[k] * factor)
}
