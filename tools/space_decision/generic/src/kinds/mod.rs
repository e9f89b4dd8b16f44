//! The kinds of joint, one file each: how a body hangs on another. The kernel names none.

mod ball;
mod free;
mod prismatic;
mod revolute;
mod rigid;

use crate::geometry::{Geometry, Vector};
use crate::numbers::LinkNumbers;
use loosepin_math::Real;
use parts::Attachment;

/// Position of the origin of a body, and its orientation.
#[derive(Debug, Clone, Copy)]
pub struct Pose<T: Real, G: Geometry<T>> {
    pub position: G::Vector,
    pub rotation: G::Rotation,
}

/// A velocity of a body, or an acceleration.
#[derive(Debug, Clone, Copy)]
pub struct Twist<T: Real, G: Geometry<T>> {
    pub linear: G::Vector,
    pub spin: G::Spin,
}

impl<T: Real, G: Geometry<T>> Twist<T, G> {
    #[inline(always)]
    pub fn zero() -> Self {
        Self { linear: G::Vector::zero(), spin: G::at_rest() }
    }
}

/// Velocity of a body for a unit speed.
#[derive(Debug, Clone, Copy)]
pub struct Column<T: Real, G: Geometry<T>> {
    pub linear: G::Vector,
    pub turning: G::Turning,
}

impl<T: Real, G: Geometry<T>> Column<T, G> {
    /// A turning about a point from which the origin lies at `arm`.
    #[inline(always)]
    pub fn turning(turning: G::Turning, arm: G::Vector) -> Self {
        Self { linear: G::moved(G::Vector::zero(), turning, arm), turning }
    }

    #[inline(always)]
    pub fn sliding(linear: G::Vector) -> Self {
        Self { linear, turning: G::still() }
    }
}

/// How a body moves.
#[derive(Debug, Clone, Copy)]
pub struct Moving<T: Real, G: Geometry<T>> {
    pub pose: Pose<T, G>,
    pub twist: Twist<T, G>,
    /// Acceleration when the free speeds do not change.
    pub bias: Twist<T, G>,
}

impl<T: Real, G: Geometry<T>> Moving<T, G> {
    pub fn ground() -> Self {
        let pose = Pose { position: G::Vector::zero(), rotation: G::unturned() };
        Self { pose, twist: Twist::zero(), bias: Twist::zero() }
    }

    /// Acceleration of the point at `arm` that the speeds alone cause.
    #[inline(always)]
    pub fn acceleration_at(&self, arm: G::Vector) -> G::Vector {
        G::pulled(G::swept(self.bias.linear, self.bias.spin, arm), self.twist.spin, arm)
    }
}

/// Speeds of a joint, and the acceleration of its drive.
#[derive(Debug, Clone, Copy)]
pub struct Speeds<'s, T> {
    pub own: &'s [T],
    pub driven: Option<T>,
}

/// How a body hangs on its parent by a kind of joint.
pub trait Kind<T: Real, G: Geometry<T>> {
    /// Whether its spin does not depend on that of its parent.
    fn turns_alone(&self) -> bool;

    /// Where it is, for coordinates of its own.
    fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &[T]) -> Pose<T, G>;

    /// Its velocities for unit speeds of its own, while the parent stands still.
    fn columns(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &Pose<T, G>, columns: &mut [Column<T, G>]);

    /// Its acceleration when the free speeds do not change.
    fn bias(
        &self,
        numbers: &LinkNumbers<T, G>,
        parent: &Moving<T, G>,
        own: &Moving<T, G>,
        columns: &[Column<T, G>],
        speeds: Speeds<'_, T>,
    ) -> Twist<T, G>;

    /// Rates of its coordinates.
    fn rates(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        let _ = own;
        rates.copy_from_slice(speeds);
    }
}

/// Acceleration of a body that turns about a point of its parent.
#[inline(always)]
fn bias_about_point<T: Real, G: Geometry<T>>(
    numbers: &LinkNumbers<T, G>,
    parent: &Moving<T, G>,
    own: &Moving<T, G>,
    spin: Option<G::Spin>,
) -> Twist<T, G> {
    let parent_arm = G::turn(&parent.pose.rotation, numbers.parent_arm);
    let own_arm = G::turn(&own.pose.rotation, numbers.own_arm);
    let mut linear = parent.acceleration_at(parent_arm);
    if let Some(spin) = spin {
        linear = G::swept_back(linear, spin, own_arm);
    }
    Twist { linear: G::pulled_back(linear, own.twist.spin, own_arm), spin: spin.unwrap_or(G::at_rest()) }
}

/// Hands every question on to the kind.
macro_rules! kinds {
    ($($pattern:pat => $kind:expr),* $(,)?) => {
        macro_rules! ask {
            ($own:expr, $name:ident => $answer:expr) => {
                match *$own { $($pattern => { let $name = $kind; $answer })* }
            };
        }
        impl<T: Real, G: Geometry<T>> Kind<T, G> for Attachment {
            #[inline(always)]
            fn turns_alone(&self) -> bool {
                ask!(self, kind => Kind::<T, G>::turns_alone(&kind))
            }
            #[inline(always)]
            fn pose(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &[T]) -> Pose<T, G> {
                ask!(self, kind => kind.pose(numbers, parent, own))
            }
            #[inline(always)]
            fn columns(&self, numbers: &LinkNumbers<T, G>, parent: &Pose<T, G>, own: &Pose<T, G>, columns: &mut [Column<T, G>]) {
                ask!(self, kind => kind.columns(numbers, parent, own, columns))
            }
            #[inline(always)]
            fn bias(
                &self,
                numbers: &LinkNumbers<T, G>,
                parent: &Moving<T, G>,
                own: &Moving<T, G>,
                columns: &[Column<T, G>],
                speeds: Speeds<'_, T>,
            ) -> Twist<T, G> {
                ask!(self, kind => kind.bias(numbers, parent, own, columns, speeds))
            }
            fn rates(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
                ask!(self, kind => Kind::<T, G>::rates(&kind, own, speeds, rates))
            }
        }
    };
}

kinds! {
    Attachment::Revolute { forward, turns_alone } => revolute::Revolute { forward, turns_alone },
    Attachment::Prismatic { forward } => prismatic::Prismatic { forward },
    Attachment::Rigid => rigid::Rigid,
    Attachment::Ball => ball::Ball,
    Attachment::Free => free::Free,
}
