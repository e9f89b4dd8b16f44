//! The section at the tip of a beam in absolute nodal coordinates, on nothing: the coordinates are x and y of the tip, m, and the angle of the
//! body frame as this section carries it, rad. In the plane.

use super::form::FormOfAttachment;
use super::kind::{Columns, Hung, KindOfAttachment, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use loosepin_math::{Geometry, KnownAngle, Plane, Real, Vec2};

/// The tip of a beam in absolute nodal coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Node {
    /// Index in [`Tree::nodal_beams`](crate::mechanism::Tree::nodal_beams).
    pub beam: usize,
}

impl FormOfAttachment<Plane> for Node {
    fn counts(&self) -> [usize; 2] {
        [3, 3]
    }
}

impl KindOfAttachment<Plane> for Node {
    #[inline(always)]
    fn hang<T: Real>(
        &self,
        place: &Place<'_, T, Plane>,
        _: &Pose<T>,
        coordinates: &[T],
        near: Option<&KnownAngle<T>>,
        Columns { linear, turnings }: Columns<'_, T, Plane>,
    ) -> Hung<T, Plane> {
        let own = place.own(coordinates);
        let rotation = Plane::oriented(&own[2..], near);
        let arm = Plane::turn(&rotation, place.numbers.nodal_beams[self.beam].tip_m);
        (linear[0], linear[1], linear[2]) = (Plane::unit(0), Plane::unit(1), -arm.turned());
        turnings[2] = 1.0;
        Hung::alone(Pose { position_m: Vec2::new(own[0], own[1]) - arm, rotation }, Vec2::zero())
    }
    #[inline(always)]
    fn bias<T: Real>(&self, place: &Place<'_, T, Plane>, kinematics: &Kinematics<T>, _: Rates<'_, T>) -> Twist<T> {
        let arm = kinematics.poses[place.slot].turn(place.numbers.nodal_beams[self.beam].tip_m);
        Twist { linear: arm * kinematics.twists[place.slot].angular.squared(), angular: T::zero() }
    }
}
