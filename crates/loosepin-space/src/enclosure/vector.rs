//! Vectors in space of such numbers.

use crate::enclosure::jet::{Jet, Number};
use core::array::from_fn;
use loosepin_math::{Interval, Quaternion, Real, Rotation, Vec3};

/// A vector with its derivatives.
pub(crate) type JetVector<T> = [Jet<T>; 3];

pub(crate) fn exact(vector: Vec3) -> Vec3<Interval> {
    vector.map(Interval::from_f64)
}

pub(crate) fn constant<T: Number>(vector: Vec3<Interval>) -> JetVector<T> {
    vector.to_array().map(Jet::constant)
}

/// The axes of the turn of a quaternion, whatever its length, known to round-off: e + 2 (w v×e + v×(v×e))/(w² + v·v) for each axis e.
pub(crate) fn axes_of(turn: &Quaternion) -> Rotation<Interval> {
    let w = Interval::from_f64(turn.w);
    let v = exact(turn.vector);
    let factor = Interval::from_f64(2.0) / (w.squared() + v.x.squared() + v.y.squared() + v.z.squared());
    let [x, y, z] = Vec3::AXES.map(exact).map(|e| e + (v.cross(e) * w + v.cross(v.cross(e))) * factor);
    Rotation { x, y, z }
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
