//! Rotation error of a body by the axial vector of its turn.

use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::Number;
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use crate::enclosure::vector::{constant, dot};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState, is_unit};
use crate::output::relative_turn::{enclosed_sines, relative_turn};
use loosepin_math::Vec3;

/// u·a, a the axial vector of (R - Rᵀ)/2 for the turn R_idealᵀR: sin θ times its axis. To first order it is the rotation vector; it is what
/// small-angle measurements of direction cosines give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationSineOutput {
    /// Number of the body.
    pub body: usize,
    /// The axis u in the axes of the ideal body, a unit vector.
    pub axis: Vec3,
}

impl KindOfOutput for RotationSineOutput {
    fn word(&self) -> &'static str {
        "rotation-sine"
    }
    fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64 {
        relative_turn(self.body, ideal, actual).1.axial_vector().dot(self.axis)
    }
    fn gradient(&self, ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient> {
        let (axes, turn) = relative_turn(self.body, ideal, actual);
        // d a = ½ (tr Q - Q) R_idealᵀω
        let by_turning = axes.apply((self.axis * turn.trace() - turn.apply_transposed(self.axis)) * 0.5);
        vec![BodyGradient { body: self.body, by_displacement: Vec3::ZERO, by_turning }]
    }
    fn fits(&self, mechanism: &SpatialMechanism) -> bool {
        self.body < mechanism.bodies().len() && is_unit(self.axis)
    }
}

impl EnclosedOutput for RotationSineOutput {
    fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T> {
        let (places, vector) = enclosed_sines(at, self.body);
        PlacedJet { places, jet: dot(&constant(at.centre.pose(self.body).turned(self.axis)), &vector) }
    }
}
