//! Rotations of joints.

use crate::numbers::Mount;
use loosepin_math::Real;
use parts::{Matrix3, Vector3};

/// The child of a revolute joint at `angle`, and the axis.
#[inline(always)]
pub fn revolved<T: Real>(
    parent: &Matrix3<T>,
    mount: &Mount<T>,
    angle: T,
    turns_alone: bool,
    forward: bool,
) -> (Matrix3<T>, Vector3<T>) {
    let (sine, cosine) = angle.sin_cos();
    // What turns alone has its axis fixed in the ground: where the parent stands does not matter.
    let marker = if turns_alone { mount.parent } else { parent.times(&mount.parent) };
    let back = !turns_alone && !forward;
    let turn = Matrix3::about_z(if back { -sine } else { sine }, cosine);
    let axis = marker.column(2);
    (marker.times(&turn).times(&mount.own.transposed()), if back { -axis } else { axis })
}

/// A child that does not turn against its parent.
#[inline(always)]
pub fn held<T: Real>(parent: &Matrix3<T>, mount: &Mount<T>) -> Matrix3<T> {
    parent.times(&mount.parent.times(&mount.own.transposed()))
}

/// The orientation of a quaternion.
#[inline(always)]
pub fn oriented<T: Real>(coordinates: &[T]) -> Matrix3<T> {
    Matrix3::of_quaternion([coordinates[0], coordinates[1], coordinates[2], coordinates[3]])
}

/// Rates of a quaternion for a spin in the axes of the body.
pub fn quaternion_rates<T: Real>(coordinates: &[T], speeds: &[T], rates: &mut [T]) {
    let half = T::from_f64(0.5);
    let (w, v) = (coordinates[0], Vector3([coordinates[1], coordinates[2], coordinates[3]]));
    let spin = Vector3([speeds[0], speeds[1], speeds[2]]);
    let vector = (v.cross(spin).plus(spin, w)) * half;
    rates[0] = -(v.dot(spin) * half);
    rates[1..4].copy_from_slice(&vector.0);
}
