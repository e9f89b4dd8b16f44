//! The two markers of a joint in ground axes.

use crate::enclosure::jet::Jet;
use crate::enclosure::moved_body::MovedBody;
use crate::enclosure::shift::EnclosedShift;
use crate::enclosure::vector::{
    FixedAxes, FixedVector, JetVector, dot, exact, minus, plus, scaled, turned, turned_axes,
};
use crate::kind::frames::Axis;
use crate::mechanism::joint::Joint;
use core::array::from_fn;

/// As [`crate::kind::frames::JointFrames`].
pub(crate) struct EnclosedJoint<const C: usize> {
    /// d = P_j - P_i, from the displaced marker.
    pub separation: JetVector<C>,
    /// x - w1 z, y - w2 z and z of marker i.
    pub constrained: [JetVector<C>; 3],
    /// Axes of marker i.
    pub bearing: [JetVector<C>; 3],
    /// Axes of marker j.
    pub journal: [JetVector<C>; 3],
}

/// A pose that does not move, known to round-off.
pub(crate) struct FixedPose {
    pub origin: FixedVector,
    pub axes: FixedAxes,
}

impl<const C: usize> EnclosedJoint<C> {
    pub(crate) fn new(
        joint: &Joint,
        poses: [&FixedPose; 2],
        bodies: &[MovedBody<C>; 2],
        shift: &EnclosedShift<C>,
    ) -> Self {
        let markers = [&joint.bearing, &joint.journal];
        let axes = |k: usize| turned_axes(&poses[k].axes, &markers[k].axes).map(|axis| bodies[k].apply(&axis));
        let (bearing, journal) = (axes(0), axes(1));
        // In this order what is fixed stays exact.
        let point = |k: usize| {
            let arm = bodies[k].apply(&turned(&poses[k].axes, exact(markers[k].point_m)));
            plus(&arm, &bodies[k].displacement)
        };
        let origins: FixedVector = from_fn(|k| poses[1].origin[k] - poses[0].origin[k]);
        let mut separation = minus(&point(1), &point(0));
        for (own, apart) in separation.iter_mut().zip(origins) {
            *own = *own + Jet::constant(apart);
        }
        for (axis, shift) in bearing.iter().zip(&shift.shift_m) {
            separation = minus(&separation, &scaled(axis, shift));
        }
        let across = |k: usize| minus(&bearing[k], &scaled(&bearing[2], &shift.slope[k]));
        Self { constrained: [across(0), across(1), bearing[2]], separation, bearing, journal }
    }

    /// x_i·x_j and y_i·x_j: cosine and sine of the joint's angle.
    pub(crate) fn turn(&self) -> [Jet<C>; 2] {
        [0, 1].map(|k: usize| dot(&self.bearing[k], &self.journal[0]))
    }

    /// z_i·d, m.
    pub(crate) fn slide_m(&self) -> Jet<C> {
        dot(&self.bearing[2], &self.separation)
    }
}

/// The number of an axis.
pub(crate) fn number_of(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}
