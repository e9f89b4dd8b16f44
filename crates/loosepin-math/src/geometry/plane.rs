//! The plane: turns are angles about its normal.

use super::kind::{Geometry, Vector};
use super::vec2::Vec2;
use crate::{KnownAngle, Real, numbers, sin_cos, sin_cos_by};

impl<T: Real> Vector<T> for Vec2<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self::zero()
    }
    #[inline(always)]
    fn write(self, out: &mut [T]) {
        (out[0], out[1]) = (self.x, self.y);
    }
    #[inline(always)]
    fn inner(self, other: Self) -> T {
        self.dot(other)
    }
    #[inline(always)]
    fn inner_plus(self, other: Self, addend: T) -> T {
        self.x.mul_add(other.x, self.y.mul_add(other.y, addend))
    }
    #[inline(always)]
    fn plus(self, other: Self, factor: T) -> Self {
        self.plus(other, factor)
    }
}

/// The plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plane;

/// An angle with its sine and cosine.
#[derive(Debug, Clone, Copy)]
pub struct PlaneRotation<T> {
    /// The angle of the x axis from the ground's, rad, continuous.
    pub angle_rad: T,
    /// Its sine.
    pub sine: T,
    /// Its cosine.
    pub cosine: T,
}

/// The direction that both bodies of a joint share: the line of a prismatic joint, the x axis of the second body of a rigid one.
#[derive(Debug, Clone, Copy)]
pub struct PlaneMount<T> {
    /// Its angle in the parent's frame, rad.
    pub parent_angle_rad: T,
    /// Its angle in the child's frame, rad.
    pub own_angle_rad: T,
    /// Cosine and sine of `parent_angle_rad`.
    pub parent_direction: Vec2<T>,
    /// Cosine and sine of the constant angle of a child that does not turn against its parent.
    pub turn_from_parent: Vec2<T>,
}

numbers!(struct PlaneMount { parent_direction, turn_from_parent, parent_angle_rad, own_angle_rad });

impl<T: Real> PlaneMount<T> {
    /// With these angles of the direction in the frames of parent and child, rad.
    #[inline(always)]
    pub fn new(parent_angle_rad: T, own_angle_rad: T) -> Self {
        let direction = |angle_rad: T| {
            let (sine, cosine) = angle_rad.sin_cos();
            Vec2::new(cosine, sine)
        };
        Self {
            parent_angle_rad,
            own_angle_rad,
            parent_direction: direction(parent_angle_rad),
            turn_from_parent: direction(parent_angle_rad - own_angle_rad),
        }
    }
}

/// A turning, and the moment of inertia, kg m².
#[derive(Debug, Clone, Copy)]
pub struct PlaneSwing<T> {
    turning: f64,
    inertia_kg_m2: T,
}

/// `sum + value · turning`; without a product for a turning of 0, 1 or -1.
#[inline(always)]
fn turned_by<T: Real>(sum: T, value: T, turning: f64) -> T {
    if turning == 0.0 {
        sum
    } else if turning == 1.0 {
        sum + value
    } else if turning == -1.0 {
        sum - value
    } else {
        value.mul_add(T::from_f64(turning), sum)
    }
}

#[inline(always)]
fn rotation<T: Real>(angle_rad: T, near: Option<&KnownAngle<T>>) -> PlaneRotation<T> {
    let (sine, cosine) = sin_cos_by(angle_rad, near);
    PlaneRotation { angle_rad, sine, cosine }
}

impl Geometry for Plane {
    const POSITION: usize = 2;
    const ORIENTATION_COORDINATES: usize = 1;
    const ORIENTATION_SPEEDS: usize = 1;

    type Vector<T: Real> = Vec2<T>;
    type Spin<T: Real> = T;
    type Turning<T: Real> = f64;
    type Rotation<T: Real> = PlaneRotation<T>;
    type Marker<T: Real> = T;
    type Mount<T: Real> = PlaneMount<T>;
    type Inertia<T: Real> = T;
    type Swing<T: Real> = PlaneSwing<T>;
    type Turnings<T: Real> = [f64; 1];

    #[inline(always)]
    fn position<T: Real>(components: &[T]) -> Vec2<T> {
        Vec2::new(components[0], components[1])
    }
    #[inline(always)]
    fn unturned<T: Real>() -> PlaneRotation<T> {
        PlaneRotation { angle_rad: T::zero(), sine: T::zero(), cosine: T::one() }
    }
    #[inline(always)]
    fn turn<T: Real>(rotation: &PlaneRotation<T>, vector: Vec2<T>) -> Vec2<T> {
        vector.rotated(rotation.sine, rotation.cosine)
    }
    #[inline(always)]
    fn turn_back<T: Real>(rotation: &PlaneRotation<T>, vector: Vec2<T>) -> Vec2<T> {
        vector.rotated(-rotation.sine, rotation.cosine)
    }
    #[inline(always)]
    fn revolved<T: Real>(
        parent: &PlaneRotation<T>,
        _: &PlaneMount<T>,
        angle_rad: T,
        turns_alone: bool,
        near: Option<&KnownAngle<T>>,
    ) -> PlaneRotation<T> {
        rotation(if turns_alone { angle_rad } else { parent.angle_rad + angle_rad }, near)
    }
    #[inline(always)]
    fn axis<T: Real>(_: &PlaneRotation<T>, _: &PlaneMount<T>, _: bool, is_reversed: bool) -> f64 {
        if is_reversed { -1.0 } else { 1.0 }
    }
    /// Sine and cosine by the addition theorem.
    #[inline(always)]
    fn fixed<T: Real>(parent: &PlaneRotation<T>, mount: &PlaneMount<T>) -> PlaneRotation<T> {
        let direction = Self::turn(parent, mount.turn_from_parent);
        let angle_rad = parent.angle_rad + mount.parent_angle_rad - mount.own_angle_rad;
        PlaneRotation { angle_rad, sine: direction.y, cosine: direction.x }
    }
    #[inline(always)]
    fn line<T: Real>(parent: &PlaneRotation<T>, mount: &PlaneMount<T>) -> Vec2<T> {
        Self::turn(parent, mount.parent_direction)
    }
    fn line_by_angle(parent: &PlaneRotation<f64>, mount: &PlaneMount<f64>) -> Vec2<f64> {
        let (sine, cosine) = sin_cos(parent.angle_rad + mount.parent_angle_rad);
        Vec2::new(cosine, sine)
    }
    fn angle_between(
        [parent, own]: [&PlaneRotation<f64>; 2],
        [parent_spin, own_spin]: [f64; 2],
        _: &PlaneMount<f64>,
        turns_alone: bool,
    ) -> [f64; 2] {
        if turns_alone { [own.angle_rad, own_spin] } else { [own.angle_rad - parent.angle_rad, own_spin - parent_spin] }
    }
    #[inline(always)]
    fn oriented<T: Real>(coordinates: &[T], near: Option<&KnownAngle<T>>) -> PlaneRotation<T> {
        rotation(coordinates[0], near)
    }
    fn orientation(rotation: &PlaneRotation<f64>, spin: &f64, coordinates: &mut [f64], speeds: &mut [f64]) {
        (coordinates[0], speeds[0]) = (rotation.angle_rad, *spin);
    }
    #[inline(always)]
    fn turnings<T: Real>(_: &PlaneRotation<T>) -> [f64; 1] {
        [1.0]
    }
    #[inline(always)]
    fn orientation_rates<T: Real>(_: &[T], speeds: &[T], rates: &mut [T]) {
        rates[0] = speeds[0];
    }

    #[inline(always)]
    fn unit<T: Real>(index: usize) -> Vec2<T> {
        if index == 0 { Vec2::new(T::one(), T::zero()) } else { Vec2::new(T::zero(), T::one()) }
    }
    #[inline(always)]
    fn spin<T: Real>(turning: f64) -> T {
        T::from_f64(turning)
    }
    #[inline(always)]
    fn at_rest<T: Real>() -> T {
        T::zero()
    }
    #[inline(always)]
    fn still<T: Real>() -> f64 {
        0.0
    }
    #[inline(always)]
    fn turned<T: Real>(spin: T, turning: f64, speed: T) -> T {
        turned_by(spin, speed, turning)
    }
    #[inline(always)]
    fn swung<T: Real>(turning: f64, arm: Vec2<T>) -> Vec2<T> {
        if turning == 0.0 {
            Vec2::zero()
        } else if turning == 1.0 {
            arm.turned()
        } else if turning == -1.0 {
            -arm.turned()
        } else {
            arm.turned() * T::from_f64(turning)
        }
    }
    /// Without a product for a turning of 0, 1 or -1.
    #[inline(always)]
    fn moved<T: Real>(velocity: Vec2<T>, turning: f64, arm: Vec2<T>) -> Vec2<T> {
        if turning == 0.0 {
            velocity
        } else if turning == 1.0 {
            velocity + arm.turned()
        } else if turning == -1.0 {
            velocity - arm.turned()
        } else {
            velocity.plus(arm.turned(), T::from_f64(turning))
        }
    }
    #[inline(always)]
    fn carried<T: Real>(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm.turned(), spin)
    }
    #[inline(always)]
    fn carried_back<T: Real>(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm.turned(), -spin)
    }
    #[inline(always)]
    fn centripetal<T: Real>(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm, -spin.squared())
    }
    #[inline(always)]
    fn centrifugal<T: Real>(linear: Vec2<T>, spin: T, arm: Vec2<T>) -> Vec2<T> {
        linear.plus(arm, spin.squared())
    }
    #[inline(always)]
    fn coriolis<T: Real>(spin: T, line: Vec2<T>, speed: T) -> Vec2<T> {
        line.turned() * (T::from_f64(2.0) * spin * speed)
    }
    #[inline(always)]
    fn precessed<T: Real>(change: T, _: T, _: f64, _: T) -> T {
        change
    }
    #[inline(always)]
    fn triple<T: Real>(spin: T, line: Vec2<T>, arm: Vec2<T>) -> T {
        spin * line.turned().dot(arm)
    }
    #[inline(always)]
    fn moment<T: Real>(arm: Vec2<T>, force: Vec2<T>) -> T {
        arm.cross(force)
    }
    #[inline(always)]
    fn push<T: Real>(moment: T, turning: f64, addend: T) -> T {
        turned_by(addend, moment, turning)
    }

    #[inline(always)]
    fn swing<T: Real>(_: &PlaneRotation<T>, inertia: &T, turning: f64) -> PlaneSwing<T> {
        PlaneSwing { turning, inertia_kg_m2: *inertia }
    }
    #[inline(always)]
    fn inertia_moment<T: Real>(_: &PlaneRotation<T>, inertia: &T, change: T, _: T) -> T {
        -(*inertia * change)
    }
    #[inline(always)]
    fn inertia_push<T: Real>(moment: T, swing: &PlaneSwing<T>, addend: T) -> T {
        turned_by(addend, moment, swing.turning)
    }
    #[inline(always)]
    fn coupled<T: Real>(first: &PlaneSwing<T>, second: &PlaneSwing<T>, addend: T) -> T {
        turned_by(addend, first.inertia_kg_m2, first.turning * second.turning)
    }
}
