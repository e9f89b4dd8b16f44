//! A body that hangs by a ball in a socket: its coordinates are an orientation of its own. Its speeds are the spin in the axes of the body, so that
//! nothing is singular. In the plane it would be the revolute joint that turns alone.

use super::form::{FormOfAttachment, TreeGeometry};
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates, about_point};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::model::JointId;
use loosepin_math::{KnownAngle, Real};

/// By a ball.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ball {
    /// The joint.
    pub joint: JointId,
    /// Whether the parent is the first body of the joint.
    pub forward: bool,
}

impl<G: TreeGeometry> FormOfAttachment<G> for Ball {
    fn joint(&self) -> Option<(JointId, bool)> {
        Some((self.joint, self.forward))
    }
    fn counts(&self) -> [usize; 2] {
        [G::ORIENTATION_COORDINATES, G::ORIENTATION_SPEEDS]
    }
    fn angle(&self) -> Option<usize> {
        (G::ORIENTATION_COORDINATES == 1).then_some(0)
    }
}

impl<G: TreeGeometry> KindOfAttachment<G> for Ball {
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
        let rotation = G::oriented(place.own(coordinates), near);
        let (reach_m, own_arm_m) = (parent.turn(numbers.parent_arm_m), G::turn(&rotation, numbers.own_arm_m));
        turnings.copy_from_slice(G::turnings(&rotation).as_ref());
        for (linear, turning) in linear.iter_mut().zip(turnings) {
            *linear = G::swung(*turning, -own_arm_m);
        }
        let position_m = parent.position_m + reach_m + numbers.eccentricity_m - own_arm_m;
        Hung::alone(Pose { position_m, rotation }, reach_m)
    }
    #[inline(always)]
    fn bias<T: Real>(&self, place: &Place<'_, T, G>, kinematics: &Kinematics<T, G>, _: Rates<'_, T>) -> Twist<T, G> {
        about_point(place, kinematics, None)
    }
    fn coordinates_between(
        &self,
        _: &LinkNumbers<f64, G>,
        _: (&Pose<f64, G>, &Twist<f64, G>),
        (own, twist): (&Pose<f64, G>, &Twist<f64, G>),
        coordinates: &mut [f64],
        rates: &mut [f64],
    ) {
        G::orientation(&own.rotation, &twist.angular, coordinates, rates);
    }
    #[inline(always)]
    fn coordinate_rates<T: Real>(&self, own: &[T], speeds: &[T], rates: &mut [T]) {
        G::orientation_rates(own, speeds, rates);
    }
}
