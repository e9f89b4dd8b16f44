//! A body that hangs by a revolute joint.
//!
//! Where it turns alone, the coordinate is the *absolute* angle of the body: the axes of all joints that turn its parent are parallel to its
//! own, so that angles from the ground leave no Coriolis terms and a constant diagonal inertia. Else it is the angle of the second body of the
//! joint from the first, as a drive gives it.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates, about_point};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::model::JointId;
use loosepin_math::{KnownAngle, Real};

/// By a revolute joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Revolute {
    /// The joint.
    pub joint: JointId,
    /// Whether the parent is the first body of the joint.
    pub forward: bool,
    /// Whether the coordinate is the angle from the ground.
    pub turns_alone: bool,
}

impl Revolute {
    #[inline(always)]
    fn is_reversed(self) -> bool {
        !(self.forward || self.turns_alone)
    }
}

impl<G: TreeGeometry> FormOfAttachment<G> for Revolute {
    fn joint(&self) -> Option<(JointId, bool)> {
        Some((self.joint, self.forward))
    }
    fn counts(&self) -> [usize; 2] {
        [1, 1]
    }
    fn angle(&self) -> Option<usize> {
        self.turns_alone.then_some(0)
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Revolute {
    #[inline(always)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        parent: &Pose<T, G>,
        coordinates: &[T],
        near: Option<&KnownAngle<T>>,
        Columns { linear, turnings }: Columns<'_, T, G>,
    ) -> Hung<T, G> {
        let numbers = place.link_numbers;
        let own_rad = coordinates[place.link.coordinates.start];
        let angle_rad = if self.is_reversed() { -own_rad } else { own_rad };
        let rotation = G::revolved(&parent.rotation, &numbers.mount, angle_rad, self.turns_alone, near);
        let (parent_arm_m, own_arm_m) = (parent.turn(numbers.parent_arm_m), G::turn(&rotation, numbers.own_arm_m));
        let turning = G::axis(&parent.rotation, &numbers.mount, self.turns_alone, self.is_reversed());
        (turnings[0], linear[0]) = (turning, G::swung(turning, -own_arm_m));
        let position_m = parent.position_m + parent_arm_m + numbers.eccentricity_m - own_arm_m;
        let pose = Pose { position_m, rotation };
        if self.turns_alone { Hung::alone(pose, parent_arm_m) } else { Hung::with(parent, pose) }
    }
    #[inline(always)]
    fn bias<T: Real>(
        &self,
        place: &Place<'_, T, G>,
        kinematics: &Kinematics<T, G>,
        rates: Rates<'_, T>,
    ) -> Twist<T, G> {
        let link = place.link;
        let spin = (!self.turns_alone).then(|| {
            let axis = kinematics.own_turning(place.slot, link);
            let (twist, bias) = (&kinematics.twists[link.parent_slot], &kinematics.biases[link.parent_slot]);
            let carried = G::precessed(bias.angular, twist.angular, axis, rates.rates[link.speeds.start]);
            rates.driven(place.tree, link).map_or(carried, |driven| G::turned(carried, axis, driven))
        });
        about_point(place, kinematics, spin)
    }
    fn coordinates_between(
        &self,
        numbers: &LinkNumbers<f64, G>,
        (parent, parent_twist): (&Pose<f64, G>, &Twist<f64, G>),
        (own, own_twist): (&Pose<f64, G>, &Twist<f64, G>),
        coordinates: &mut [f64],
        rates: &mut [f64],
    ) {
        let rotations = [&parent.rotation, &own.rotation];
        let spins = [parent_twist.angular, own_twist.angular];
        let [angle_rad, rate_rad_s] = G::angle_between(rotations, spins, &numbers.mount, self.turns_alone);
        let sign = if self.is_reversed() { -1.0 } else { 1.0 };
        (coordinates[0], rates[0]) = (sign * angle_rad, sign * rate_rad_s);
    }
}
