//! Space.

use crate::geometry::{Geometry, Vector};
use loosepin_math::Real;
use parts::{Counts, Matrix3, Vector3};

impl<T: Real> Vector<T> for Vector3<T> {
    #[inline(always)]
    fn zero() -> Self {
        Vector3::zero()
    }
    #[inline(always)]
    fn component(&self, index: usize) -> T {
        self.0[index]
    }
    #[inline(always)]
    fn dot(self, other: Self) -> T {
        Vector3::dot(self, other)
    }
    #[inline(always)]
    fn dot_plus(self, other: Self, addend: T) -> T {
        Vector3::dot_plus(self, other, addend)
    }
    #[inline(always)]
    fn plus(self, other: Self, factor: T) -> Self {
        Vector3::plus(self, other, factor)
    }
}

/// Space.
#[derive(Debug, Clone, Copy)]
pub struct Space;

/// Axes of the markers of a joint in their bodies: a revolute joint turns about z, a prismatic one slides along x.
#[derive(Debug, Clone, Copy)]
pub struct SpaceMount<T> {
    pub parent: Matrix3<T>,
    pub own: Matrix3<T>,
}

/// A turning in the axes of the body, and its angular momentum.
#[derive(Debug, Clone, Copy)]
pub struct SpaceSwing<T>(Vector3<T>, Vector3<T>);

impl<T: Real + 'static> Geometry<T> for Space {
    const COUNTS: Counts = Counts::SPACE;
    const AXIS_ROWS: usize = 2;

    type Vector = Vector3<T>;
    type Spin = Vector3<T>;
    type Turning = Vector3<T>;
    type Rotation = Matrix3<T>;
    type Mount = SpaceMount<T>;
    type Inertia = Matrix3<T>;
    type Swing = SpaceSwing<T>;
    type Turnings = [Vector3<T>; 3];

    #[inline(always)]
    fn unturned() -> Matrix3<T> {
        Matrix3::identity()
    }
    #[inline(always)]
    fn turn(rotation: &Matrix3<T>, vector: Vector3<T>) -> Vector3<T> {
        rotation.turn(vector)
    }
    #[inline(always)]
    fn revolved(parent: &Matrix3<T>, mount: &SpaceMount<T>, angle: T, turns_alone: bool) -> Matrix3<T> {
        let (sine, cosine) = angle.sin_cos();
        // What turns alone has its axis fixed in the ground: where the parent stands does not matter.
        let marker = if turns_alone { mount.parent } else { parent.times(&mount.parent) };
        marker.times(&Matrix3::about_z(sine, cosine)).times(&mount.own.transposed())
    }
    #[inline(always)]
    fn axis(parent: &Matrix3<T>, mount: &SpaceMount<T>, turns_alone: bool, is_reversed: bool) -> Vector3<T> {
        let axis = mount.parent.column(2);
        let axis = if turns_alone { axis } else { parent.turn(axis) };
        if is_reversed { -axis } else { axis }
    }
    #[inline(always)]
    fn held(parent: &Matrix3<T>, mount: &SpaceMount<T>) -> Matrix3<T> {
        parent.times(&mount.parent.times(&mount.own.transposed()))
    }
    #[inline(always)]
    fn line(parent: &Matrix3<T>, mount: &SpaceMount<T>) -> Vector3<T> {
        parent.turn(mount.parent.column(0))
    }
    #[inline(always)]
    fn oriented(coordinates: &[T]) -> Matrix3<T> {
        Matrix3::of_quaternion([coordinates[0], coordinates[1], coordinates[2], coordinates[3]])
    }
    #[inline(always)]
    fn turnings(rotation: &Matrix3<T>) -> [Vector3<T>; 3] {
        [0, 1, 2].map(|index| rotation.column(index))
    }
    #[inline(always)]
    fn orientation_rates(coordinates: &[T], speeds: &[T], rates: &mut [T]) {
        let half = T::from_f64(0.5);
        let (w, v) = (coordinates[0], Vector3([coordinates[1], coordinates[2], coordinates[3]]));
        let spin = Vector3([speeds[0], speeds[1], speeds[2]]);
        let vector = (v.cross(spin).plus(spin, w)) * half;
        rates[0] = -(v.dot(spin) * half);
        rates[1..4].copy_from_slice(&vector.0);
    }

    #[inline(always)]
    fn at_rest() -> Vector3<T> {
        Vector3::zero()
    }
    #[inline(always)]
    fn still() -> Vector3<T> {
        Vector3::zero()
    }
    #[inline(always)]
    fn unit(index: usize) -> Vector3<T> {
        Matrix3::identity().0[index]
    }
    #[inline(always)]
    fn turned(spin: Vector3<T>, turning: Vector3<T>, speed: T) -> Vector3<T> {
        spin.plus(turning, speed)
    }
    #[inline(always)]
    fn moved(velocity: Vector3<T>, turning: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
        velocity.plus_cross(turning, arm)
    }
    #[inline(always)]
    fn swept(linear: Vector3<T>, spin: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
        linear.plus_cross(spin, arm)
    }
    #[inline(always)]
    fn swept_back(linear: Vector3<T>, spin: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
        linear.plus_cross(arm, spin)
    }
    #[inline(always)]
    fn pulled(linear: Vector3<T>, spin: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
        linear.plus(spin, spin.dot(arm)).plus(arm, -spin.dot(spin))
    }
    #[inline(always)]
    fn pulled_back(linear: Vector3<T>, spin: Vector3<T>, arm: Vector3<T>) -> Vector3<T> {
        linear.plus(spin, -spin.dot(arm)).plus(arm, spin.dot(spin))
    }
    #[inline(always)]
    fn coriolis(spin: Vector3<T>, line: Vector3<T>, speed: T) -> Vector3<T> {
        spin.cross(line) * (T::from_f64(2.0) * speed)
    }
    #[inline(always)]
    fn precessed(change: Vector3<T>, spin: Vector3<T>, turning: Vector3<T>, speed: T) -> Vector3<T> {
        change.plus_cross(spin, turning * speed)
    }
    #[inline(always)]
    fn moment(arm: Vector3<T>, force: Vector3<T>) -> Vector3<T> {
        arm.cross(force)
    }
    #[inline(always)]
    fn push(moment: Vector3<T>, turning: Vector3<T>, addend: T) -> T {
        moment.dot_plus(turning, addend)
    }

    #[inline(always)]
    fn swing(rotation: &Matrix3<T>, inertia: &Matrix3<T>, turning: Vector3<T>) -> SpaceSwing<T> {
        let in_body = rotation.turn_back(turning);
        SpaceSwing(in_body, inertia.turn(in_body))
    }
    #[inline(always)]
    fn inertia_moment(rotation: &Matrix3<T>, inertia: &Matrix3<T>, change: Vector3<T>, spin: Vector3<T>) -> Vector3<T> {
        let (change, spin) = (rotation.turn_back(change), rotation.turn_back(spin));
        -inertia.turn(change).plus_cross(spin, inertia.turn(spin))
    }
    #[inline(always)]
    fn inertia_push(moment: Vector3<T>, swing: &SpaceSwing<T>, addend: T) -> T {
        moment.dot_plus(swing.0, addend)
    }
    #[inline(always)]
    fn coupled(first: &SpaceSwing<T>, second: &SpaceSwing<T>, addend: T) -> T {
        first.0.dot_plus(second.1, addend)
    }

    #[inline(always)]
    fn axes(row: usize, [i, j]: [&Matrix3<T>; 2], mount: &SpaceMount<T>) -> [Vector3<T>; 2] {
        [i.turn(mount.parent.column(row)), j.turn(mount.own.column(2))]
    }
}
