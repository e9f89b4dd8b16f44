//! A body that a rigid joint makes one with its parent.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates, carried};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::model::JointId;
use loosepin_math::{KnownAngle, Real};

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
    fn turns(&self) -> bool {
        false
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Rigid {
    #[inline(always)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        parent: &Pose<T, G>,
        _: &[T],
        _: Option<&KnownAngle<T>>,
        _: Columns<'_, T, G>,
    ) -> Hung<T, G> {
        let numbers = place.link_numbers;
        let rotation = G::fixed(&parent.rotation, &numbers.mount);
        let at_joint_m = parent.position_m + parent.turn(numbers.parent_arm_m);
        Hung::with(parent, Pose { position_m: at_joint_m - G::turn(&rotation, numbers.own_arm_m), rotation })
    }
    #[inline(always)]
    fn bias<T: Real>(&self, place: &Place<'_, T, G>, kinematics: &Kinematics<T, G>, _: Rates<'_, T>) -> Twist<T, G> {
        carried(place, kinematics)
    }
}
