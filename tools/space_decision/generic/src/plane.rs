//! The plane.

use crate::geometry::{Geometry, Vector};
use loosepin_math::{Real, Vec2};
use loosepin_mechanics::mechanism::turned_by;
use parts::Counts;

impl<T: Real> Vector<T> for Vec2<T> {
    #[inline(always)]
    fn zero() -> Self {
        Vec2::zero()
    }
    #[inline(always)]
    fn component(&self, index: usize) -> T {
        [self.x, self.y][index]
    }
    #[inline(always)]
    fn dot(self, other: Self) -> T {
        Vec2::dot(self, other)
    }
    #[inline(always)]
    fn dot_plus(self, other: Self, addend: T) -> T {
        self.x.mul_add(other.x, self.y.mul_add(other.y, addend))
    }
    #[inline(always)]
    fn plus(self, other: Self, factor: T) -> Self {
        Vec2::plus(self, other, factor)
    }
}

/// The plane.
#[derive(Debug, Clone, Copy)]
pub struct Plane;

/// An angle with its sine and cosine.
#[derive(Debug, Clone, Copy)]
pub struct Angle<T> {
    angle: T,
    sine: T,
    cosine: T,
}

/// Direction of a line in the parent, and the turn of a child that does not turn.
#[derive(Debug, Clone, Copy)]
pub struct PlaneMount<T> {
    pub line: Vec2<T>,
    pub turn: Vec2<T>,
    pub angle: T,
}

/// A turning, and the moment of inertia.
#[derive(Debug, Clone, Copy)]
pub struct PlaneSwing<T>(f64, T);

#[inline(always)]
fn angle<T: Real>(angle: T) -> Angle<T> {
    let (sine, cosine) = angle.sin_cos();
    Angle { angle, sine, cosine }
}

impl<T: Real + 'static> Geometry<T> for Plane {
    const COUNTS: Counts = Counts::PLANE;
    const AXIS_ROWS: usize = 0;

    type Vector = Vec2<T>;
    type Spin = T;
    type Turning = f64;
    type Rotation = Angle<T>;
    type Mount = PlaneMount<T>;
    type Inertia = T;
    type Swing = PlaneSwing<T>;
    type Turnings = [f64; 1];

    #[inline(always)]
    fn unturned() -> Angle<T> {
        Angle { angle: T::zero(), sine: T::zero(), cosine: T::one() }
    }
    #[inline(always)]
    fn turn(rotation: &Angle<T>, vector: Vec2<T>) -> Vec2<T> {
        vector.rotated(rotation.sine, rotation.cosine)
    }
    #[inline(always)]
    fn revolved(parent: &Angle<T>, _: &PlaneMount<T>, turn: T, turns_alone: bool) -> Angle<T> {
        angle(if turns_alone { turn } else { parent.angle + turn })
    }
    #[inline(always)]
    fn axis(_: &Angle<T>, _: &PlaneMount<T>, _: bool, is_reversed: bool) -> f64 {
        if is_reversed { -1.0 } else { 1.0 }
    }
    #[inline(always)]
    fn held(parent: &Angle<T>, mount: &PlaneMount<T>) -> Angle<T> {
        let direction = Self::turn(parent, mount.turn);
        Angle { angle: parent.angle + mount.angle, sine: direction.y, cosine: direction.x }
    }
    #[inline(always)]
    fn line(parent: &Angle<T>, mount: &PlaneMount<T>) -> Vec2<T> {
        Self::turn(parent, mount.line)
    }
    #[inline(always)]
    fn oriented(coordinates: &[T]) -> Angle<T> {
        angle(coordinates[0])
    }
    #[inline(always)]
    fn turnings(_: &Angle<T>) -> [f64; 1] {
        [1.0]
    }
    #[inline(always)]
    fn orientation_rates(_: &[T], speeds: &[T], rates: &mut [T]) {
        rates[0] = speeds[0];
    }

    #[inline(always)]
    fn at_rest() -> T {
        T::zero()
    }
    #[inline(always)]
    fn still() -> f64 {
        0.0
    }
    #[inline(always)]
    fn unit(index: usize) -> Vec2<T> {
        if index == 0 { Vec2::new(T::one(), T::zero()) } else { Vec2::new(T::zero(), T::one()) }
    }
    #[inline(always)]
    fn turned(spin: T, turning: f64, speed: T) -> T {
        turned_by(spin, speed, turning)
    }
    #[inline(always)]
    fn moved(velocity: Vec2<T>, turning: f64, arm: Vec2<T>) -> Vec2<T> {
        loosepin_mechanics::mechanism::moved(velocity, arm.turned(), turning)
    }
    #[inline(always)]
    fn swept(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm.turned(), spin)
    }
    #[inline(always)]
    fn swept_back(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm.turned(), -spin)
    }
    #[inline(always)]
    fn pulled(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm, -spin.squared())
    }
    #[inline(always)]
    fn pulled_back(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm, spin.squared())
    }
    #[inline(always)]
    fn coriolis(spin: T, line: Vec2<T>, speed: T) -> Vec2<T> {
        line.turned() * (T::from_f64(2.0) * spin * speed)
    }
    #[inline(always)]
    fn precessed(change: T, _: T, _: f64, _: T) -> T {
        change
    }
    #[inline(always)]
    fn moment(arm: Vec2<T>, force: Vec2<T>) -> T {
        arm.cross(force)
    }
    #[inline(always)]
    fn push(moment: T, turning: f64, addend: T) -> T {
        turned_by(addend, moment, turning)
    }

    #[inline(always)]
    fn swing(_: &Angle<T>, inertia: &T, turning: f64) -> PlaneSwing<T> {
        PlaneSwing(turning, *inertia)
    }
    #[inline(always)]
    fn inertia_moment(_: &Angle<T>, inertia: &T, change: T, _: T) -> T {
        -(*inertia * change)
    }
    #[inline(always)]
    fn inertia_push(moment: T, swing: &PlaneSwing<T>, addend: T) -> T {
        turned_by(addend, moment, swing.0)
    }
    #[inline(always)]
    fn coupled(first: &PlaneSwing<T>, second: &PlaneSwing<T>, addend: T) -> T {
        turned_by(addend, first.1, first.0 * second.0)
    }

    fn axes(_: usize, _: [&Angle<T>; 2], _: &PlaneMount<T>) -> [Vec2<T>; 2] {
        unreachable!("axes in the plane are parallel")
    }
}
