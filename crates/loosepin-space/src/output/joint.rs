//! Coordinate of a joint.

use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::{Jet, Number};
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use crate::kind::frames::{JointFrames, MarkerShift, within_half_a_turn};
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState};
use loosepin_math::{Frame, Interval, Real};

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

impl EnclosedOutput for JointOutput {
    fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T> {
        let (places, moved) = at.joint::<T>(self.joint, true);
        let nowhere = vec![Interval::ZERO; at.numbers.len()];
        let at_rest = PositionBox { numbers: &nowhere, is_second_order: false, direction: None, ..*at };
        let (_, ideal) = at_rest.joint::<Interval>(self.joint, true);
        let jet = match self.coordinate {
            JointCoordinate::Slide => moved.slide_m() - &Jet::constant(ideal.slide_m().value),
            JointCoordinate::Angle => {
                let [cosine, sine] = moved.turn();
                let [of_cosine, of_sine] = ideal.turn().map(|own| Jet::constant(own.value));
                arctangent(&(&sine * &of_cosine - &(&cosine * &of_sine)), &(&cosine * &of_cosine + &(&sine * &of_sine)))
            }
        };
        PlacedJet { places, jet }
    }
}

/// The angle with this sine and cosine, whatever the radius; every number where the cosine may not be above zero.
fn arctangent<T: Number>(sine: &Jet<T>, cosine: &Jet<T>) -> Jet<T> {
    if !(cosine.range().low() > 0.0) {
        return sine.function([Interval::WHOLE; 4]);
    }
    let one = Interval::from_f64(1.0);
    let inverse = one / cosine.range();
    let square = inverse * inverse;
    let tangent = sine
        * &cosine.function([
            inverse,
            -square,
            (square + square) * inverse,
            -(Interval::from_f64(6.0) * square * square),
        ]);
    let x = tangent.range();
    let first = one / (one + x.squared());
    // Between zero and its tangent.
    let second = -((x + x) * first * first);
    let two = Interval::from_f64(2.0);
    let third = (Interval::from_f64(6.0) * x.squared() - two) * first * first * first;
    tangent.function([x.hull(Interval::ZERO), first, second, third])
}
