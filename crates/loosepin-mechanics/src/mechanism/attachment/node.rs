//! The section at the tip of a beam in absolute nodal coordinates, on nothing: the coordinates are x and y of the tip, m, and the angle of the
//! body frame as this section carries it, rad. In the plane.

use super::form::FormOfAttachment;
use super::kind::{Columns, KindOfAttachment, Place, Rates};
use crate::mechanism::tree::kinematics::{Kinematics, Pose, Twist};
use crate::mechanism::tree::numbers::LinkNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::JointId;
use core::ops::Range;
use loosepin_math::{Geometry, Plane, Real, Vec2};

/// The tip of a beam in absolute nodal coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Node {
    /// Index in [`Tree::nodal_beams`](crate::mechanism::Tree::nodal_beams).
    pub beam: usize,
}

impl FormOfAttachment<Plane> for Node {
    fn joint(&self) -> Option<(JointId, bool)> {
        None
    }
    fn counts(&self) -> [usize; 2] {
        [3, 3]
    }
    /// Those of all nodes are told by the beam.
    fn lengths(&self) -> Range<usize> {
        0..0
    }
    fn angle(&self) -> Option<usize> {
        None
    }
    fn turns(&self) -> bool {
        true
    }
    fn turns_alone(&self) -> bool {
        true
    }
}

impl KindOfAttachment<Plane> for Node {
    #[inline(always)]
    fn pose<T: Real>(
        &self,
        place: &Place<'_, T, Plane>,
        _: &Pose<T>,
        own: &[T],
        _: &[T],
        sin_cos: impl Fn(T) -> (T, T),
    ) -> Pose<T> {
        let rotation = Plane::oriented(&own[2..], sin_cos);
        let arm = Plane::turn(&rotation, place.numbers.nodal_beams[self.beam].tip_m);
        Pose { position_m: Vec2::new(own[0], own[1]) - arm, rotation }
    }
    #[inline(always)]
    fn columns<T: Real>(
        &self,
        place: &Place<'_, T, Plane>,
        [_, own]: [&Pose<T>; 2],
        _: &[T],
        Columns { linear, turnings }: Columns<'_, T, Plane>,
    ) {
        let arm = own.turn(place.numbers.nodal_beams[self.beam].tip_m);
        (linear[0], linear[1], linear[2]) = (Plane::unit(0), Plane::unit(1), -arm.turned());
        turnings[2] = 1.0;
    }
    #[inline(always)]
    fn bias<T: Real>(&self, place: &Place<'_, T, Plane>, kinematics: &Kinematics<T>, _: Rates<'_, T>) -> Twist<T> {
        let arm = kinematics.poses[place.slot].turn(place.numbers.nodal_beams[self.beam].tip_m);
        Twist { linear: arm * kinematics.twists[place.slot].angular.squared(), angular: T::zero() }
    }
    /// Where a beam is undeformed, its nodes are set together.
    fn coordinates_between(
        &self,
        _: &LinkNumbers<f64>,
        _: (&Pose<f64>, &Twist<f64>),
        _: (&Pose<f64>, &Twist<f64>),
        _: &mut [f64],
        _: &mut [f64],
    ) {
    }
    fn first_turnings<T: Real>(&self, _: &Tree) -> Vec<f64> {
        vec![0.0; 3]
    }
}
