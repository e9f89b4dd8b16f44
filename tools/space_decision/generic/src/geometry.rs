//! What the kernel asks of a geometry. Vectors and spins are seen from the ground.

use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};
use loosepin_math::Real;
use parts::Counts;

/// A displacement, velocity, acceleration or force.
pub trait Vector<T: Real>:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + Mul<T, Output = Self>
{
    fn zero() -> Self;
    fn component(&self, index: usize) -> T;
    fn dot(self, other: Self) -> T;
    /// `self · other + addend`.
    fn dot_plus(self, other: Self, addend: T) -> T;
    /// `self + factor · other`.
    fn plus(self, other: Self, factor: T) -> Self;
}

/// The plane, or space.
pub trait Geometry<T: Real>: Copy + Debug + 'static {
    const COUNTS: Counts;
    /// Rows that keep the axes of a revolute joint parallel.
    const AXIS_ROWS: usize;

    type Vector: Vector<T>;
    /// An angular velocity or acceleration, or a moment.
    type Spin: Copy + Debug;
    /// A spin for a unit speed.
    type Turning: Copy + Debug;
    type Rotation: Copy + Debug;
    /// How the markers of a joint stand on its two bodies.
    type Mount: Copy + Debug;
    type Inertia: Copy + Debug;
    /// A turning, and the angular momentum that goes with it.
    type Swing: Copy + Debug;
    /// The turnings of an orientation of its own.
    type Turnings: AsRef<[Self::Turning]>;

    // Rotations.
    fn unturned() -> Self::Rotation;
    fn turn(rotation: &Self::Rotation, vector: Self::Vector) -> Self::Vector;
    /// The child of a revolute joint at `angle`.
    fn revolved(parent: &Self::Rotation, mount: &Self::Mount, angle: T, turns_alone: bool) -> Self::Rotation;
    /// The axis of a revolute joint.
    fn axis(parent: &Self::Rotation, mount: &Self::Mount, turns_alone: bool, is_reversed: bool) -> Self::Turning;
    /// A child that does not turn against its parent.
    fn held(parent: &Self::Rotation, mount: &Self::Mount) -> Self::Rotation;
    /// The line of a prismatic joint.
    fn line(parent: &Self::Rotation, mount: &Self::Mount) -> Self::Vector;
    /// An orientation of its own, by its coordinates.
    fn oriented(coordinates: &[T]) -> Self::Rotation;
    fn turnings(rotation: &Self::Rotation) -> Self::Turnings;
    /// Rates of these coordinates.
    fn orientation_rates(coordinates: &[T], speeds: &[T], rates: &mut [T]);

    // Spins.
    fn at_rest() -> Self::Spin;
    fn still() -> Self::Turning;
    /// The unit vector of coordinate `index` of a position.
    fn unit(index: usize) -> Self::Vector;
    /// `spin + turning · speed`.
    fn turned(spin: Self::Spin, turning: Self::Turning, speed: T) -> Self::Spin;
    /// `velocity + turning × arm`.
    fn moved(velocity: Self::Vector, turning: Self::Turning, arm: Self::Vector) -> Self::Vector;
    /// `linear + spin × arm`, and `linear - spin × arm`.
    fn swept(linear: Self::Vector, spin: Self::Spin, arm: Self::Vector) -> Self::Vector;
    fn swept_back(linear: Self::Vector, spin: Self::Spin, arm: Self::Vector) -> Self::Vector;
    /// `linear + spin × (spin × arm)`, and `linear - spin × (spin × arm)`.
    fn pulled(linear: Self::Vector, spin: Self::Spin, arm: Self::Vector) -> Self::Vector;
    fn pulled_back(linear: Self::Vector, spin: Self::Spin, arm: Self::Vector) -> Self::Vector;
    /// `2 spin × line · speed`.
    fn coriolis(spin: Self::Spin, line: Self::Vector, speed: T) -> Self::Vector;
    /// `change + spin × (turning · speed)`: an axis is carried round by its body.
    fn precessed(change: Self::Spin, spin: Self::Spin, turning: Self::Turning, speed: T) -> Self::Spin;
    /// `arm × force`.
    fn moment(arm: Self::Vector, force: Self::Vector) -> Self::Spin;
    /// `moment · turning + addend`.
    fn push(moment: Self::Spin, turning: Self::Turning, addend: T) -> T;

    // Inertia about the centre of mass.
    fn swing(rotation: &Self::Rotation, inertia: &Self::Inertia, turning: Self::Turning) -> Self::Swing;
    /// The moment of inertia forces for the angular acceleration `change`, dotted with the turning of a swing.
    fn inertia_moment(
        rotation: &Self::Rotation,
        inertia: &Self::Inertia,
        change: Self::Spin,
        spin: Self::Spin,
    ) -> Self::Spin;
    fn inertia_push(moment: Self::Spin, swing: &Self::Swing, addend: T) -> T;
    /// Turning · inertia · turning + addend.
    fn coupled(first: &Self::Swing, second: &Self::Swing, addend: T) -> T;

    /// The axes of a revolute joint that closes a loop, of both bodies, that are perpendicular in row `row`.
    fn axes(row: usize, rotations: [&Self::Rotation; 2], mount: &Self::Mount) -> [Self::Vector; 2];
}
