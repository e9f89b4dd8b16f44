//! A body that hangs by a prismatic joint: the coordinate is the displacement s of the slider point along the guide's line, m.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates, carried};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::model::JointId;
use core::ops::Range;
use loosepin_math::{KnownAngle, Real, Vector};

/// By a prismatic joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Prismatic {
    /// The joint.
    pub joint: JointId,
    /// Whether the parent is the guide.
    pub forward: bool,
}

impl<G: TreeGeometry> FormOfAttachment<G> for Prismatic {
    fn joint(&self) -> Option<(JointId, bool)> {
        Some((self.joint, self.forward))
    }
    fn counts(&self) -> [usize; 2] {
        [1, 1]
    }
    fn lengths(&self) -> Range<usize> {
        0..1
    }
    fn turns(&self) -> bool {
        false
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Prismatic {
    #[inline(always)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        parent: &Pose<T, G>,
        coordinates: &[T],
        _: Option<&KnownAngle<T>>,
        Columns { linear, turnings }: Columns<'_, T, G>,
    ) -> Hung<T, G> {
        let numbers = place.link_numbers;
        let line = G::line(&parent.rotation, &numbers.mount);
        let line = if self.forward { line } else { -line };
        (linear[0], turnings[0]) = (line, G::still());
        let rotation = G::fixed(&parent.rotation, &numbers.mount);
        let at_joint_m = parent.position_m + parent.turn(numbers.parent_arm_m);
        let position_m =
            at_joint_m + line * coordinates[place.link.coordinates.start] - G::turn(&rotation, numbers.own_arm_m);
        Hung::with(parent, Pose { position_m, rotation })
    }
    #[inline(always)]
    fn bias<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        kinematics: &Kinematics<T, G>,
        rates: Rates<'_, T>,
    ) -> Twist<T, G> {
        let link = place.link;
        let line = kinematics.own_linear(place.slot, link);
        let Twist { linear, angular } = carried(place, kinematics);
        let spin = kinematics.twists[link.parent_slot].angular;
        let linear = linear + G::coriolis(spin, line, rates.rates[link.speeds.start]);
        let driven = rates.driven(place.tree, link);
        Twist { linear: driven.map_or(linear, |driven| linear + line * driven), angular }
    }
    fn coordinates_between(
        &self,
        numbers: &LinkNumbers<f64, G>,
        (parent, parent_twist): (&Pose<f64, G>, &Twist<f64, G>),
        (own, own_twist): (&Pose<f64, G>, &Twist<f64, G>),
        coordinates: &mut [f64],
        rates: &mut [f64],
    ) {
        let sign = if self.forward { 1.0 } else { -1.0 };
        let line = G::line_by_angle(&parent.rotation, &numbers.mount) * sign;
        let [own_arm_m, parent_arm_m] = [own.turn(numbers.own_arm_m), parent.turn(numbers.parent_arm_m)];
        let gap_m = own.position_m + own_arm_m - parent.position_m - parent_arm_m;
        let gap_rate_m_s = own_twist.at(own_arm_m) - parent_twist.at(parent_arm_m);
        coordinates[0] = line.inner(gap_m);
        // The line turns with the guide.
        rates[0] = line.inner(gap_rate_m_s) + G::triple(parent_twist.angular, line, gap_m);
    }
}
