//! The two markers of a joint.

use crate::enclosure::jet::{Jet, Number};
use crate::enclosure::shift::EnclosedShift;
use crate::enclosure::step::Step;
use crate::enclosure::vector::{JetVector, constant, dot, exact, minus, plus, scaled};
use crate::kind::frames::Axis;
use crate::mechanism::joint::Joint;
use loosepin_math::{Interval, Rotation, Vec3};

/// As [`crate::kind::frames::JointFrames`], seen from the body from which the branches of both bodies come.
pub(crate) struct EnclosedJoint<T> {
    /// d = P_j - P_i, from the displaced marker.
    pub separation: JetVector<T>,
    /// x - w1 z, y - w2 z and z of marker i.
    pub constrained: [JetVector<T>; 3],
    /// Axes of marker i.
    pub bearing: [JetVector<T>; 3],
    /// Axes of marker j.
    pub journal: [JetVector<T>; 3],
}

/// A pose that does not move, known to round-off.
pub(crate) struct FixedPose {
    pub origin: Vec3<Interval>,
    pub axes: Rotation<Interval>,
}

impl FixedPose {
    /// A point of the body.
    pub(crate) fn point(&self, point_m: Vec3) -> Vec3<Interval> {
        self.origin + self.turned(point_m)
    }

    /// A direction of the body.
    pub(crate) fn turned(&self, direction: Vec3) -> Vec3<Interval> {
        self.axes.apply(exact(direction))
    }
}

impl<T: Number> EnclosedJoint<T> {
    pub(crate) fn new(
        joint: &Joint,
        poses: [&FixedPose; 2],
        steps: &[Vec<Step<T>>; 2],
        shift: &EnclosedShift<T>,
    ) -> Self {
        let markers = [&joint.bearing, &joint.journal];
        let fixed = [0, 1].map(|k: usize| {
            let Rotation { x, y, z } = markers[k].axes;
            [x, y, z].map(|axis| constant(poses[k].turned(axis)))
        });
        let moved = |k: usize| {
            fixed[k].each_ref().map(|axis| steps[k].iter().rev().fold(axis.clone(), |axis, step| step.axis(&axis)))
        };
        let (bearing, journal) = (moved(0), moved(1));
        let points = [0, 1].map(|k: usize| {
            let mut point = constant(poses[k].point(markers[k].point_m));
            if k == 0 {
                for (axis, shift) in fixed[0].iter().zip(&shift.shift_m) {
                    point = plus(point, &scaled(axis, shift));
                }
            }
            steps[k].iter().rev().fold(point, |point, step| step.point(point))
        });
        let [from, to] = points;
        let across = |k: usize| minus(bearing[k].clone(), &scaled(&bearing[2], &shift.slope[k]));
        Self { constrained: [across(0), across(1), bearing[2].clone()], separation: minus(to, &from), bearing, journal }
    }

    /// x_i·x_j and y_i·x_j: cosine and sine of the joint's angle.
    pub(crate) fn turn(&self) -> [Jet<T>; 2] {
        [0, 1].map(|k: usize| dot(&self.bearing[k], &self.journal[0]))
    }

    /// z_i·d, m.
    pub(crate) fn slide_m(&self) -> Jet<T> {
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
