//! Coordinate of a joint.

use crate::geometry::pose::Frame;
use crate::kind::frames::{JointFrames, MarkerShift, within_half_a_turn};
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState};

/// Deviation of φ = atan2(y_i·x_j, x_i·x_j), rad, or of z_i·(P_j - P_i), m, between the two markers of a joint, whatever its kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointOutput {
    /// Number of the joint.
    pub joint: usize,
    /// Which coordinate.
    pub coordinate: JointCoordinate,
}

impl JointOutput {
    fn frames(&self, state: &OutputState) -> JointFrames {
        let joint = &state.mechanism.joints()[self.joint];
        let markers = [&joint.bearing, &joint.journal];
        let bodies = markers.map(|marker| Frame::from(&state.poses[marker.body]));
        let (points, axes) = (markers.map(|marker| marker.point_m), markers.map(|marker| &marker.axes));
        JointFrames::new(bodies.each_ref(), points, axes, &MarkerShift::default())
    }
}

impl KindOfOutput for JointOutput {
    fn word(&self) -> &'static str {
        "joint"
    }
    fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64 {
        let (ideal, actual) = (self.frames(ideal), self.frames(actual));
        match self.coordinate {
            JointCoordinate::Angle => within_half_a_turn(actual.angle_rad() - ideal.angle_rad()),
            JointCoordinate::Slide => actual.slide_m() - ideal.slide_m(),
        }
    }
    fn gradient(&self, _ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient> {
        let joint = &actual.mechanism.joints()[self.joint];
        let at = self.frames(actual);
        let columns = match self.coordinate {
            JointCoordinate::Angle => crate::kind::row::ScalarRow::DrivenAngle,
            JointCoordinate::Slide => crate::kind::row::ScalarRow::DrivenSlide,
        }
        .columns(&at);
        vec![
            BodyGradient { body: joint.bearing.body, by_displacement: columns.v_i, by_turning: columns.w_i },
            BodyGradient { body: joint.journal.body, by_displacement: columns.v_j, by_turning: columns.w_j },
        ]
    }
    fn fits(&self, mechanism: &SpatialMechanism) -> bool {
        self.joint < mechanism.joints().len()
    }
}
