//! What every geometry says of itself: all that kinematics and equations of motion ask of vectors, turns and inertias.
//!
//! What is written over a [`Geometry`] is compiled for the [`Plane`](super::Plane) and for [`Space`](super::Space). Each operation of space is
//! the sum of the plane with further terms, in the same order, so that a planar mechanism in space has the plane's bits.

use crate::{KnownAngle, Real};
use core::fmt::Debug;
use core::ops::{Add, Mul, Neg, Sub};

/// A displacement, velocity, acceleration or force.
pub trait Vector<T: Real>:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Neg<Output = Self> + Mul<T, Output = Self>
{
    /// The zero vector.
    fn zero() -> Self;
    /// Writes its components along x, y, and in space z.
    fn write(self, out: &mut [T]);
    /// a·b, its products fused.
    fn inner(self, other: Self) -> T;
    /// a·b + `addend`, its products fused.
    fn inner_plus(self, other: Self, addend: T) -> T;
    /// a + `factor` · b, its products fused.
    fn plus(self, other: Self, factor: T) -> Self;
}

/// The plane, or space. Vectors and spins are seen from the ground unless something else is said.
pub trait Geometry: Copy + Debug + 'static {
    /// Coordinates of a point.
    const POSITION: usize;
    /// Coordinates of an orientation of its own.
    const ORIENTATION_COORDINATES: usize;
    /// Speeds of an orientation of its own.
    const ORIENTATION_SPEEDS: usize;

    /// A displacement, velocity, acceleration or force.
    type Vector<T: Real>: Vector<T>;
    /// An angular velocity or acceleration, rad/s or rad/s², or a moment, N m.
    type Spin<T: Real>: Copy + Debug + Neg<Output = Self::Spin<T>>;
    /// The spin for a unit speed. In the plane it is a constant: 0, 1 or -1, or φ' of a shape of a beam.
    type Turning<T: Real>: Copy + Debug;
    /// The turn of a body from the ground.
    type Rotation<T: Real>: Copy + Debug;
    /// How the marker of a joint lies in its body: the angle of its direction, rad, or the turn of its axes.
    type Marker<T: Real>: Copy + Debug;
    /// How the axes of a joint lie in its two bodies.
    type Mount<T: Real>: Copy + Debug;
    /// Moments of inertia about the centre of mass in the axes of the body, kg m².
    type Inertia<T: Real>: Copy + Debug;
    /// A turning, and the angular momentum that goes with it.
    type Swing<T: Real>: Copy + Debug;
    /// The turnings of an orientation of its own.
    type Turnings<T: Real>: AsRef<[Self::Turning<T>]>;

    /// The vector with these components.
    fn position<T: Real>(components: &[T]) -> Self::Vector<T>;
    /// No turn.
    fn unturned<T: Real>() -> Self::Rotation<T>;
    /// A vector of the body, seen from the ground.
    fn turn<T: Real>(rotation: &Self::Rotation<T>, vector: Self::Vector<T>) -> Self::Vector<T>;
    /// A vector of the ground, seen from the body.
    fn turn_back<T: Real>(rotation: &Self::Rotation<T>, vector: Self::Vector<T>) -> Self::Vector<T>;
    /// The child of a revolute joint at an angle, rad: from the parent, or where it `turns_alone` from the ground. `near` is a known
    /// angle close to that of the child.
    fn revolved<T: Real>(
        parent: &Self::Rotation<T>,
        mount: &Self::Mount<T>,
        angle_rad: T,
        turns_alone: bool,
        near: Option<&KnownAngle<T>>,
    ) -> Self::Rotation<T>;
    /// The turning of a revolute joint about its axis.
    fn axis<T: Real>(
        parent: &Self::Rotation<T>,
        mount: &Self::Mount<T>,
        turns_alone: bool,
        is_reversed: bool,
    ) -> Self::Turning<T>;
    /// A child that does not turn against its parent.
    fn fixed<T: Real>(parent: &Self::Rotation<T>, mount: &Self::Mount<T>) -> Self::Rotation<T>;
    /// The line of a prismatic joint.
    fn line<T: Real>(parent: &Self::Rotation<T>, mount: &Self::Mount<T>) -> Self::Vector<T>;
    /// The same line from the angle of the parent where there is one, not from its sine and cosine: where a motion starts.
    fn line_by_angle(parent: &Self::Rotation<f64>, mount: &Self::Mount<f64>) -> Self::Vector<f64> {
        Self::line(parent, mount)
    }
    /// The angle of a revolute joint and its rate, rad and rad/s: from the parent, or where it `turns_alone` from the ground.
    fn angle_between(
        rotations: [&Self::Rotation<f64>; 2],
        spins: [Self::Spin<f64>; 2],
        mount: &Self::Mount<f64>,
        turns_alone: bool,
    ) -> [f64; 2];
    /// An orientation of its own, by its coordinates: an angle, rad, or a unit quaternion (w, x, y, z).
    fn oriented<T: Real>(coordinates: &[T], near: Option<&KnownAngle<T>>) -> Self::Rotation<T>;
    /// The coordinates and speeds of an orientation with this spin.
    fn orientation(rotation: &Self::Rotation<f64>, spin: &Self::Spin<f64>, coordinates: &mut [f64], speeds: &mut [f64]);
    /// The turnings of the speeds of such an orientation: about the axes of the body.
    fn turnings<T: Real>(rotation: &Self::Rotation<T>) -> Self::Turnings<T>;
    /// Rates of the coordinates of such an orientation for its speeds.
    fn orientation_rates<T: Real>(coordinates: &[T], speeds: &[T], rates: &mut [T]);

    /// The unit vector along x, y, or in space z.
    fn unit<T: Real>(index: usize) -> Self::Vector<T>;
    /// The spin of a turning for a unit speed.
    fn spin<T: Real>(turning: Self::Turning<T>) -> Self::Spin<T>;
    /// No spin.
    fn at_rest<T: Real>() -> Self::Spin<T>;
    /// No turning.
    fn still<T: Real>() -> Self::Turning<T>;
    /// `spin + turning · speed`.
    fn turned<T: Real>(spin: Self::Spin<T>, turning: Self::Turning<T>, speed: T) -> Self::Spin<T>;
    /// `turning × arm`.
    fn swung<T: Real>(turning: Self::Turning<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `velocity + turning × arm`.
    fn moved<T: Real>(velocity: Self::Vector<T>, turning: Self::Turning<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `linear + spin × arm`.
    fn carried<T: Real>(linear: Self::Vector<T>, spin: Self::Spin<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `linear - spin × arm`.
    fn carried_back<T: Real>(linear: Self::Vector<T>, spin: Self::Spin<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `linear + spin × (spin × arm)`.
    fn centripetal<T: Real>(linear: Self::Vector<T>, spin: Self::Spin<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `linear - spin × (spin × arm)`.
    fn centrifugal<T: Real>(linear: Self::Vector<T>, spin: Self::Spin<T>, arm: Self::Vector<T>) -> Self::Vector<T>;
    /// `2 spin × line · speed`.
    fn coriolis<T: Real>(spin: Self::Spin<T>, line: Self::Vector<T>, speed: T) -> Self::Vector<T>;
    /// `change + spin × (turning · speed)`: an axis is carried round by its body.
    fn precessed<T: Real>(
        change: Self::Spin<T>,
        spin: Self::Spin<T>,
        turning: Self::Turning<T>,
        speed: T,
    ) -> Self::Spin<T>;
    /// `(spin × line) · arm`.
    fn triple<T: Real>(spin: Self::Spin<T>, line: Self::Vector<T>, arm: Self::Vector<T>) -> T;
    /// `arm × force`.
    fn moment<T: Real>(arm: Self::Vector<T>, force: Self::Vector<T>) -> Self::Spin<T>;
    /// `moment · turning + addend`.
    fn push<T: Real>(moment: Self::Spin<T>, turning: Self::Turning<T>, addend: T) -> T;

    /// The swing of a turning.
    fn swing<T: Real>(
        rotation: &Self::Rotation<T>,
        inertia: &Self::Inertia<T>,
        turning: Self::Turning<T>,
    ) -> Self::Swing<T>;
    /// The moment of inertia forces for the angular acceleration `change`, in the axes of swings.
    fn inertia_moment<T: Real>(
        rotation: &Self::Rotation<T>,
        inertia: &Self::Inertia<T>,
        change: Self::Spin<T>,
        spin: Self::Spin<T>,
    ) -> Self::Spin<T>;
    /// `moment · turning + addend` of such a moment.
    fn inertia_push<T: Real>(moment: Self::Spin<T>, swing: &Self::Swing<T>, addend: T) -> T;
    /// `turning · inertia · turning + addend`.
    fn coupled<T: Real>(first: &Self::Swing<T>, second: &Self::Swing<T>, addend: T) -> T;
}
