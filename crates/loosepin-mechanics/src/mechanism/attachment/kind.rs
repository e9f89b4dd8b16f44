//! How every kind of attachment moves.

use super::form::{FormOfAttachment, TreeGeometry};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::{LinkNumbers, TreeNumbers};
use crate::mechanism::tree::spanning_tree::{Link, Tree};
use loosepin_math::{Geometry, KnownAngle, Real};

/// A geometry whose attachments move.
pub trait MovingGeometry: TreeGeometry<Attachment: KindOfAttachment<Self>> {}

impl<G: TreeGeometry<Attachment: KindOfAttachment<G>>> MovingGeometry for G {}

/// A body in the tree, with the numbers of a sample.
pub struct Place<'a, T: Real, G: TreeGeometry> {
    /// The tree.
    pub tree: &'a Tree<G>,
    /// The numbers.
    pub numbers: &'a TreeNumbers<T, G>,
    /// Slot of the body.
    pub slot: usize,
    /// Its link.
    pub link: &'a Link<G>,
    /// The numbers of its link.
    pub link_numbers: &'a LinkNumbers<T, G>,
}

impl<'a, T: Real, G: TreeGeometry> Place<'a, T, G> {
    /// All bodies of a tree, parents first.
    #[inline(always)]
    pub fn all(tree: &'a Tree<G>, numbers: &'a TreeNumbers<T, G>) -> impl Iterator<Item = Self> {
        let links = tree.links.iter().zip(&numbers.links).enumerate();
        links.map(move |(index, (link, link_numbers))| Self { tree, numbers, slot: index + 1, link, link_numbers })
    }

    /// The coordinates of the body, of those of all.
    #[inline(always)]
    pub fn own<'c>(&self, coordinates: &'c [T]) -> &'c [T] {
        &coordinates[self.link.coordinates.clone()]
    }
}

/// Rates of all coordinates, and the accelerations of those that drives hold, in the order of the tree's drives.
#[derive(Debug, Clone, Copy)]
pub struct Rates<'a, T> {
    /// m/s and rad/s.
    pub rates: &'a [T],
    /// m/s² and rad/s².
    pub driven_accelerations: &'a [T],
}

impl<'a, T: Real> Rates<'a, T> {
    /// The acceleration of the drive of a link's coordinate, if there is one.
    #[inline(always)]
    pub fn driven<G: TreeGeometry>(&self, tree: &Tree<G>, link: &Link<G>) -> Option<T> {
        link.is_driven.then(|| self.driven_accelerations[link.speeds.start - tree.free_speeds])
    }
}

/// Velocities for unit rates: of the origin of a body, and its turning.
pub struct Columns<'a, T: Real, G: Geometry> {
    /// m per unit of the coordinate.
    pub linear: &'a mut [G::Vector<T>],
    /// Angular velocity for unit rates.
    pub turnings: &'a mut [G::Turning<T>],
}

/// Where a body is, and how it moves with its parent.
pub struct Hung<T: Real, G: Geometry> {
    /// Its pose.
    pub pose: Pose<T, G>,
    /// The way from the origin of its parent to the point that the parent carries, in the ground's frame, m: where it turns alone that of the
    /// joint, else its own origin. A body that hangs on nothing has none.
    pub reach_m: G::Vector<T>,
    /// Whether its spin does not depend on that of its parent: the columns that it inherits turn it no more.
    pub turns_alone: bool,
}

impl<T: Real, G: Geometry> Hung<T, G> {
    /// As part of its parent, with which it turns.
    #[inline(always)]
    pub(super) fn with(parent: &Pose<T, G>, pose: Pose<T, G>) -> Self {
        Self { pose, reach_m: pose.position_m - parent.position_m, turns_alone: false }
    }

    /// With a spin of its own; `reach_m` is the way to the point of the joint.
    #[inline(always)]
    pub(super) fn alone(pose: Pose<T, G>, reach_m: G::Vector<T>) -> Self {
        Self { pose, reach_m, turns_alone: true }
    }
}

/// How a body hangs on its parent: a kind of attachment.
pub trait KindOfAttachment<G: TreeGeometry>: FormOfAttachment<G> {
    /// Where the body is; into `columns` go its velocities for unit rates of its own coordinates, while the parent stands still. `coordinates`
    /// are those of all of the tree; `near` is an angle close to its own, where one is known.
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        parent: &Pose<T, G>,
        coordinates: &[T],
        near: Option<&KnownAngle<T>>,
        columns: Columns<'_, T, G>,
    ) -> Hung<T, G>;

    /// Its acceleration when the free coordinates have none.
    fn bias<T: Real>(&self, place: &Place<'_, T, G>, kinematics: &Kinematics<T, G>, rates: Rates<'_, T>)
    -> Twist<T, G>;

    /// Its own coordinates and their rates where child and parent stand as said; what it does not know it leaves.
    fn coordinates_between(
        &self,
        numbers: &LinkNumbers<f64, G>,
        parent: (&Pose<f64, G>, &Twist<f64, G>),
        own: (&Pose<f64, G>, &Twist<f64, G>),
        coordinates: &mut [f64],
        rates: &mut [f64],
    ) {
        let _ = (numbers, parent, own, coordinates, rates);
    }

    /// Rates of its own coordinates for its speeds: the speeds themselves but for a quaternion.
    fn coordinate_rates<T: Real>(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        let _ = own;
        rates.copy_from_slice(speeds);
    }

    /// Turnings for unit rates of its own coordinates where [`Self::hang`] leaves them, since they are the same in all positions.
    fn first_turnings<T: Real>(&self, tree: &Tree<G>) -> Vec<G::Turning<T>> {
        let _ = tree;
        vec![G::still(); self.counts()[1]]
    }
}

/// Acceleration of a body that turns about a point of its parent: with its own angular acceleration where `spin` is one.
#[inline(always)]
pub(super) fn about_point<T: Real, G: TreeGeometry>(
    place: &Place<'_, T, G>,
    kinematics: &Kinematics<T, G>,
    spin: Option<G::Spin<T>>,
) -> Twist<T, G> {
    let (numbers, parent_slot) = (place.link_numbers, place.link.parent_slot);
    let parent_arm = kinematics.poses[parent_slot].turn(numbers.parent_arm_m);
    let own_arm = kinematics.poses[place.slot].turn(numbers.own_arm_m);
    let mut linear = kinematics.bias_at(parent_slot, parent_arm);
    if let Some(spin) = spin {
        linear = G::carried_back(linear, spin, own_arm);
    }
    let linear = G::centrifugal(linear, kinematics.twists[place.slot].angular, own_arm);
    Twist { linear, angular: spin.unwrap_or(G::at_rest()) }
}

/// Acceleration of the origin of a body as part of its parent, with which it turns.
#[inline(always)]
pub(super) fn carried<T: Real, G: TreeGeometry>(place: &Place<'_, T, G>, kinematics: &Kinematics<T, G>) -> Twist<T, G> {
    let parent_slot = place.link.parent_slot;
    let reach = kinematics.poses[place.slot].position_m - kinematics.poses[parent_slot].position_m;
    Twist { linear: kinematics.bias_at(parent_slot, reach), angular: kinematics.biases[parent_slot].angular }
}
