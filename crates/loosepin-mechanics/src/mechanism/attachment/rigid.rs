//! A body that a rigid joint makes one with its parent.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, KindOfAttachment, Place, Rates, carried};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::JointId;
use core::ops::Range;
use loosepin_math::Real;

/// By a rigid joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rigid {
    /// The joint.
    pub joint: JointId,
    /// Whether the parent is the first body of the joint.
    pub forward: bool,
}

impl<G: TreeGeometry> FormOfAttachment<G> for Rigid {
    fn joint(&self) -> Option<(JointId, bool)> {
        Some((self.joint, self.forward))
    }
    fn counts(&self) -> [usize; 2] {
        [0, 0]
    }
    fn lengths(&self) -> Range<usize> {
        0..0
    }
    fn angle(&self) -> Option<usize> {
        None
    }
    fn turns(&self) -> bool {
        false
    }
    fn turns_alone(&self) -> bool {
        false
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Rigid {
    #[inline(always)]
    fn pose<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        parent: &Pose<T, G>,
        _: &[T],
        _: &[T],
        _: impl Fn(T) -> (T, T),
    ) -> Pose<T, G> {
        let numbers = place.of_link();
        let rotation = G::fixed(&parent.rotation, &numbers.mount);
        let at_joint_m = parent.position_m + parent.turn(numbers.parent_arm_m);
        Pose { position_m: at_joint_m - G::turn(&rotation, numbers.own_arm_m), rotation }
    }
    #[inline(always)]
    fn columns<T: Real>(&self, _: &Place<'_, T, G>, _: [&Pose<T, G>; 2], _: &[T], _: Columns<'_, T, G>) {}
    #[inline(always)]
    fn bias<T: Real>(&self, place: &Place<'_, T, G>, kinematics: &Kinematics<T, G>, _: Rates<'_, T>) -> Twist<T, G> {
        carried(place, kinematics)
    }
    fn coordinates_between(
        &self,
        _: &LinkNumbers<f64, G>,
        _: (&Pose<f64, G>, &Twist<f64, G>),
        _: (&Pose<f64, G>, &Twist<f64, G>),
        _: &mut [f64],
        _: &mut [f64],
    ) {
    }
    fn first_turnings<T: Real>(&self, _: &Tree<G>) -> Vec<G::Turning<T>> {
        Vec::new()
    }
}
