//! Rotation error of a body.

use crate::geometry::rotation::Rotation;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState, is_unit};

/// u·θ, rad: θ is the rotation vector of R_idealᵀR, in the axes of the ideal body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationOutput {
    /// Number of the body.
    pub body: usize,
    /// The axis u in the axes of the ideal body, a unit vector.
    pub axis: Vec3,
}

impl KindOfOutput for RotationOutput {
    fn word(&self) -> &'static str {
        "rotation"
    }
    fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64 {
        relative_turn(self.body, ideal, actual).1.rotation_vector().dot(self.axis)
    }
    fn gradient(&self, ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient> {
        let (axes, turn) = relative_turn(self.body, ideal, actual);
        let (theta, u) = (turn.rotation_vector(), self.axis);
        // dθ = J⁻¹ R_idealᵀ ω, J⁻¹ = 1 - [θ]/2 + k [θ]², k = (1 - θ/2 cot θ/2)/θ² → 1/12; u J⁻¹ has the sign of [θ] changed.
        let half = 0.5 * theta.length();
        let k = if half > 1e-3 { (1.0 - half / libm::tan(half)) / (4.0 * half * half) } else { 1.0 / 12.0 };
        let by_turning = axes.apply(u + theta.cross(u) * 0.5 + theta.cross(theta.cross(u)) * k);
        vec![BodyGradient { body: self.body, by_displacement: Vec3::ZERO, by_turning }]
    }
    fn fits(&self, mechanism: &SpatialMechanism) -> bool {
        self.body < mechanism.bodies().len() && is_unit(self.axis)
    }
}

/// Axes of the ideal body, and R_idealᵀR.
pub(crate) fn relative_turn(body: usize, ideal: &OutputState, actual: &OutputState) -> (Rotation, Rotation) {
    let axes = ideal.poses[body].orientation.rotation();
    (axes, axes.transposed_times(&actual.poses[body].orientation.rotation()))
}
