//! Space: turns are matrices of axes, spins are vectors.

use super::kind::{Geometry, Vector};
use super::quaternion::Quaternion;
use super::rotation::Rotation;
use super::vec3::Vec3;
use crate::{KnownAngle, Real, sin_cos_by};

impl<T: Real> Vector<T> for Vec3<T> {
    #[inline(always)]
    fn zero() -> Self {
        Self::new(T::zero(), T::zero(), T::zero())
    }
    #[inline(always)]
    fn write(self, out: &mut [T]) {
        (out[0], out[1], out[2]) = (self.x, self.y, self.z);
    }
    #[inline(always)]
    fn inner(self, other: Self) -> T {
        self.x.mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }
    #[inline(always)]
    fn inner_plus(self, other: Self, addend: T) -> T {
        self.x.mul_add(other.x, self.y.mul_add(other.y, self.z.mul_add(other.z, addend)))
    }
    #[inline(always)]
    fn plus(self, other: Self, factor: T) -> Self {
        Self {
            x: other.x.mul_add(factor, self.x),
            y: other.y.mul_add(factor, self.y),
            z: other.z.mul_add(factor, self.z),
        }
    }
}

/// Space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Space;

/// The markers of a joint in the axes of its two bodies: a revolute joint turns about their z axes, a prismatic one slides along them.
#[derive(Debug, Clone, Copy)]
pub struct SpaceMount<T> {
    /// The marker on the parent.
    pub parent: Rotation<T>,
    /// The marker on the child.
    pub own: Rotation<T>,
    /// The turn of a child that does not turn against its parent.
    pub turn_from_parent: Rotation<T>,
}

impl<T: Real> SpaceMount<T> {
    /// With these markers on parent and child.
    pub fn new(parent: Rotation<T>, own: Rotation<T>) -> Self {
        Self { parent, own, turn_from_parent: compose(&parent, &own.transposed()) }
    }
}

/// Moments of inertia about the centre of mass in the axes of the body, kg m²: the entries of the symmetric matrix J.
#[derive(Debug, Clone, Copy)]
pub struct SpaceInertia<T> {
    /// J_xx, J_yy and J_zz.
    pub diagonal_kg_m2: [T; 3],
    /// J_xy, J_xz and J_yz: the negative products of inertia.
    pub beside_kg_m2: [T; 3],
}

impl<T: Real> SpaceInertia<T> {
    /// J v.
    #[inline(always)]
    fn apply(&self, v: Vec3<T>) -> Vec3<T> {
        let ([xx, yy, zz], [xy, xz, yz]) = (self.diagonal_kg_m2, self.beside_kg_m2);
        Vec3 { x: Vec3::new(xx, xy, xz).inner(v), y: Vec3::new(xy, yy, yz).inner(v), z: Vec3::new(xz, yz, zz).inner(v) }
    }
}

/// A turning in the axes of the body, and its angular momentum there, kg m².
#[derive(Debug, Clone, Copy)]
pub struct SpaceSwing<T> {
    turning: Vec3<T>,
    momentum: Vec3<T>,
}

/// R v, its products fused.
#[inline(always)]
fn apply<T: Real>(turn: &Rotation<T>, v: Vec3<T>) -> Vec3<T> {
    let Rotation { x, y, z } = turn;
    let row = |x: T, y: T, z: T| x.mul_add(v.x, y.mul_add(v.y, z * v.z));
    Vec3 { x: row(x.x, y.x, z.x), y: row(x.y, y.y, z.y), z: row(x.z, y.z, z.z) }
}

/// Rᵀ v, its products fused.
#[inline(always)]
fn apply_back<T: Real>(turn: &Rotation<T>, v: Vec3<T>) -> Vec3<T> {
    Vec3 { x: turn.x.inner(v), y: turn.y.inner(v), z: turn.z.inner(v) }
}

/// R S, its products fused. The y axis is z × x: so a turn about z has the same sine and cosine in both of its axes, as in the plane.
#[inline(always)]
fn compose<T: Real>(turn: &Rotation<T>, other: &Rotation<T>) -> Rotation<T> {
    let (x, z) = (apply(turn, other.x), apply(turn, other.z));
    Rotation { x, y: cross(z, x), z }
}

/// a × b, its products fused.
#[inline(always)]
fn cross<T: Real>(a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    Vec3 { x: a.y.mul_add(b.z, -(a.z * b.y)), y: a.z.mul_add(b.x, -(a.x * b.z)), z: a.x.mul_add(b.y, -(a.y * b.x)) }
}

/// v + a × b, its products fused.
#[inline(always)]
fn plus_cross<T: Real>(v: Vec3<T>, a: Vec3<T>, b: Vec3<T>) -> Vec3<T> {
    Vec3 {
        x: (-a.z).mul_add(b.y, a.y.mul_add(b.z, v.x)),
        y: (-a.x).mul_add(b.z, a.z.mul_add(b.x, v.y)),
        z: (-a.y).mul_add(b.x, a.x.mul_add(b.y, v.z)),
    }
}

impl Geometry for Space {
    const POSITION: usize = 3;
    const ORIENTATION_COORDINATES: usize = 4;
    const ORIENTATION_SPEEDS: usize = 3;

    type Vector<T: Real> = Vec3<T>;
    type Spin<T: Real> = Vec3<T>;
    type Turning<T: Real> = Vec3<T>;
    type Rotation<T: Real> = Rotation<T>;
    type Marker<T: Real> = Rotation<T>;
    type Mount<T: Real> = SpaceMount<T>;
    type Inertia<T: Real> = SpaceInertia<T>;
    type Swing<T: Real> = SpaceSwing<T>;
    type Turnings<T: Real> = [Vec3<T>; 3];

    #[inline(always)]
    fn position<T: Real>(components: &[T]) -> Vec3<T> {
        Vec3::new(components[0], components[1], components[2])
    }
    #[inline(always)]
    fn unturned<T: Real>() -> Rotation<T> {
        Rotation { x: Self::unit(0), y: Self::unit(1), z: Self::unit(2) }
    }
    #[inline(always)]
    fn turn<T: Real>(rotation: &Rotation<T>, vector: Vec3<T>) -> Vec3<T> {
        apply(rotation, vector)
    }
    #[inline(always)]
    fn turn_back<T: Real>(rotation: &Rotation<T>, vector: Vec3<T>) -> Vec3<T> {
        apply_back(rotation, vector)
    }
    /// What turns alone has its axis fixed in the ground: where the parent stands does not matter.
    #[inline(always)]
    fn revolved<T: Real>(
        parent: &Rotation<T>,
        mount: &SpaceMount<T>,
        angle_rad: T,
        turns_alone: bool,
        near: Option<&KnownAngle<T>>,
    ) -> Rotation<T> {
        let (sine, cosine) = sin_cos_by(angle_rad, near);
        let marker = if turns_alone { mount.parent } else { compose(parent, &mount.parent) };
        let (zero, one) = (T::zero(), T::one());
        let about_z = Rotation {
            x: Vec3::new(cosine, sine, zero),
            y: Vec3::new(-sine, cosine, zero),
            z: Vec3::new(zero, zero, one),
        };
        compose(&compose(&marker, &about_z), &mount.own.transposed())
    }
    #[inline(always)]
    fn axis<T: Real>(parent: &Rotation<T>, mount: &SpaceMount<T>, turns_alone: bool, is_reversed: bool) -> Vec3<T> {
        let axis = if turns_alone { mount.parent.z } else { apply(parent, mount.parent.z) };
        if is_reversed { -axis } else { axis }
    }
    #[inline(always)]
    fn fixed<T: Real>(parent: &Rotation<T>, mount: &SpaceMount<T>) -> Rotation<T> {
        compose(parent, &mount.turn_from_parent)
    }
    #[inline(always)]
    fn line<T: Real>(parent: &Rotation<T>, mount: &SpaceMount<T>) -> Vec3<T> {
        apply(parent, mount.parent.z)
    }
    /// φ = atan2(y_i·x_j, x_i·x_j), with φ' = z_i·(ω_j - ω_i).
    fn angle_between(
        [parent, own]: [&Rotation; 2],
        [parent_spin, own_spin]: [Vec3; 2],
        mount: &SpaceMount<f64>,
        turns_alone: bool,
    ) -> [f64; 2] {
        let marker = if turns_alone { mount.parent } else { compose(parent, &mount.parent) };
        let along = apply(own, mount.own.x);
        let spin = if turns_alone { own_spin } else { own_spin - parent_spin };
        [libm::atan2(marker.y.inner(along), marker.x.inner(along)), marker.z.inner(spin)]
    }
    #[inline(always)]
    fn oriented<T: Real>(coordinates: &[T], _: Option<&KnownAngle<T>>) -> Rotation<T> {
        let [w, x, y, z] = [coordinates[0], coordinates[1], coordinates[2], coordinates[3]];
        let (one, two) = (T::one(), T::from_f64(2.0));
        let diagonal = |a: T, b: T| one - two * a.mul_add(a, b * b);
        let (xy, xz, yz) = (x * y, x * z, y * z);
        let (wx, wy, wz) = (w * x, w * y, w * z);
        Rotation {
            x: Vec3::new(diagonal(y, z), two * (xy + wz), two * (xz - wy)),
            y: Vec3::new(two * (xy - wz), diagonal(x, z), two * (yz + wx)),
            z: Vec3::new(two * (xz + wy), two * (yz - wx), diagonal(x, y)),
        }
    }
    fn orientation(rotation: &Rotation, spin: &Vec3, coordinates: &mut [f64], speeds: &mut [f64]) {
        let Quaternion { w, vector } = Quaternion::from_rotation(rotation);
        coordinates[0] = w;
        coordinates[1..4].copy_from_slice(&vector.to_array());
        speeds[..3].copy_from_slice(&apply_back(rotation, *spin).to_array());
    }
    #[inline(always)]
    fn turnings<T: Real>(rotation: &Rotation<T>) -> [Vec3<T>; 3] {
        [rotation.x, rotation.y, rotation.z]
    }
    /// q̇ = q ∘ (0, ω)/2, ω in the axes of the body.
    #[inline(always)]
    fn orientation_rates<T: Real>(coordinates: &[T], speeds: &[T], rates: &mut [T]) {
        let half = T::from_f64(0.5);
        let (w, v) = (coordinates[0], Vec3::new(coordinates[1], coordinates[2], coordinates[3]));
        let spin = Vec3::new(speeds[0], speeds[1], speeds[2]);
        rates[0] = -(v.inner(spin) * half);
        rates[1..4].copy_from_slice(&(cross(v, spin).plus(spin, w) * half).to_array());
    }

    #[inline(always)]
    fn unit<T: Real>(index: usize) -> Vec3<T> {
        let entry = |own: usize| if own == index { T::one() } else { T::zero() };
        Vec3::new(entry(0), entry(1), entry(2))
    }
    #[inline(always)]
    fn spin<T: Real>(turning: Vec3<T>) -> Vec3<T> {
        turning
    }
    #[inline(always)]
    fn at_rest<T: Real>() -> Vec3<T> {
        Vec3::zero()
    }
    #[inline(always)]
    fn still<T: Real>() -> Vec3<T> {
        Vec3::zero()
    }
    #[inline(always)]
    fn turned<T: Real>(spin: Vec3<T>, turning: Vec3<T>, speed: T) -> Vec3<T> {
        spin.plus(turning, speed)
    }
    #[inline(always)]
    fn swung<T: Real>(turning: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        cross(turning, arm)
    }
    #[inline(always)]
    fn moved<T: Real>(velocity: Vec3<T>, turning: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        plus_cross(velocity, turning, arm)
    }
    #[inline(always)]
    fn carried<T: Real>(linear: Vec3<T>, spin: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        plus_cross(linear, spin, arm)
    }
    #[inline(always)]
    fn carried_back<T: Real>(linear: Vec3<T>, spin: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        plus_cross(linear, arm, spin)
    }
    /// ω × (ω × r) = ω (ω·r) - ω² r, which leaves the sums of the plane.
    #[inline(always)]
    fn centripetal<T: Real>(linear: Vec3<T>, spin: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        linear.plus(spin, spin.inner(arm)).plus(arm, -spin.inner(spin))
    }
    #[inline(always)]
    fn centrifugal<T: Real>(linear: Vec3<T>, spin: Vec3<T>, arm: Vec3<T>) -> Vec3<T> {
        linear.plus(spin, -spin.inner(arm)).plus(arm, spin.inner(spin))
    }
    #[inline(always)]
    fn coriolis<T: Real>(spin: Vec3<T>, line: Vec3<T>, speed: T) -> Vec3<T> {
        cross(spin * T::from_f64(2.0) * speed, line)
    }
    #[inline(always)]
    fn precessed<T: Real>(change: Vec3<T>, spin: Vec3<T>, turning: Vec3<T>, speed: T) -> Vec3<T> {
        plus_cross(change, spin, turning * speed)
    }
    #[inline(always)]
    fn triple<T: Real>(spin: Vec3<T>, line: Vec3<T>, arm: Vec3<T>) -> T {
        cross(spin, line).inner(arm)
    }
    #[inline(always)]
    fn moment<T: Real>(arm: Vec3<T>, force: Vec3<T>) -> Vec3<T> {
        cross(arm, force)
    }
    #[inline(always)]
    fn push<T: Real>(moment: Vec3<T>, turning: Vec3<T>, addend: T) -> T {
        moment.inner_plus(turning, addend)
    }

    #[inline(always)]
    fn swing<T: Real>(rotation: &Rotation<T>, inertia: &SpaceInertia<T>, turning: Vec3<T>) -> SpaceSwing<T> {
        let turning = apply_back(rotation, turning);
        SpaceSwing { turning, momentum: inertia.apply(turning) }
    }
    /// -(J α + ω × J ω), all in the axes of the body.
    #[inline(always)]
    fn inertia_moment<T: Real>(
        rotation: &Rotation<T>,
        inertia: &SpaceInertia<T>,
        change: Vec3<T>,
        spin: Vec3<T>,
    ) -> Vec3<T> {
        let (change, spin) = (apply_back(rotation, change), apply_back(rotation, spin));
        -plus_cross(inertia.apply(change), spin, inertia.apply(spin))
    }
    #[inline(always)]
    fn inertia_push<T: Real>(moment: Vec3<T>, swing: &SpaceSwing<T>, addend: T) -> T {
        moment.inner_plus(swing.turning, addend)
    }
    #[inline(always)]
    fn coupled<T: Real>(first: &SpaceSwing<T>, second: &SpaceSwing<T>, addend: T) -> T {
        first.turning.inner_plus(second.momentum, addend)
    }
}
