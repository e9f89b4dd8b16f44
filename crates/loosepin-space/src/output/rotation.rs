//! Rotation error of a body.

use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::Number;
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use crate::enclosure::vector::{constant, dot};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState, is_unit};
use crate::output::relative_turn::{enclosed_sines, relative_turn};
use loosepin_math::{Interval, Real, Vec3};

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

impl EnclosedOutput for RotationOutput {
    fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T> {
        // θ = a asin(|a|)/|a| with the axial vector a, its length sin |θ|.
        let (places, sines) = enclosed_sines(at, self.body);
        let axis = constant(at.centre.pose(self.body).turned(self.axis));
        let square = dot(&sines, &sines);
        let jet = &dot(&axis, &sines) * &square.function(arcsine_over_sine(square.range().high()));
        PlacedJet { places, jet }
    }
}

/// asin(h)/h and its three derivatives by m = h², for 0 <= m <= `most`; every number where that is not small.
///
/// The series is 1 + m/6 + 3m²/40 + ..., its coefficients positive and decreasing: from m² on it is between zero and 3m²/40/(1 - m), and its
/// derivatives are between zero and those of this.
fn arcsine_over_sine(most: f64) -> [Interval; 4] {
    if !(most < 0.25) {
        return [Interval::WHOLE; 4];
    }
    let number = Interval::from_f64;
    let (m, third) = (Interval::new(0.0, most.max(0.0)), number(3.0) / number(40.0));
    let rest = number(1.0) / (number(1.0) - number(m.high()));
    let up_to = |end: Interval| Interval::new(0.0, end.high());
    let sixth = number(1.0) / number(6.0);
    [
        number(1.0) + m * sixth + m * m * up_to(third * rest),
        sixth + m * up_to(number(2.0) * third * rest * rest),
        up_to(number(2.0) * third * rest * rest * rest),
        // The coefficient of m³ is 5/112.
        up_to(number(30.0) / number(112.0) * rest * rest * rest * rest),
    ]
}
