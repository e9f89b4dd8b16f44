//! Displacement of a point.

use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::Number;
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use crate::enclosure::vector::{constant, dot, exact, minus};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{BodyGradient, KindOfOutput, OutputState, is_unit};
use loosepin_math::Vec3;

/// n·(P - P_ideal): displacement of a point of a body along a direction of the ground, m. With n the tangent, the normal or the binormal of
/// the ideal path it is the displacement along or across the path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointOutput {
    /// Number of the body.
    pub body: usize,
    /// The point in body axes, m.
    pub point_m: Vec3,
    /// The direction n in ground axes, a unit vector.
    pub direction: Vec3,
}

impl KindOfOutput for PointOutput {
    fn word(&self) -> &'static str {
        "point"
    }
    fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64 {
        let point = |state: &OutputState| state.poses[self.body].point_m(self.point_m);
        (point(actual) - point(ideal)).dot(self.direction)
    }
    fn gradient(&self, _ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient> {
        let arm = actual.poses[self.body].orientation.rotation().apply(self.point_m);
        let by_turning = arm.cross(self.direction);
        vec![BodyGradient { body: self.body, by_displacement: self.direction, by_turning }]
    }
    fn fits(&self, mechanism: &SpatialMechanism) -> bool {
        self.body < mechanism.bodies().len() && self.point_m.is_finite() && is_unit(self.direction)
    }
}

impl EnclosedOutput for PointOutput {
    fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T> {
        let (places, steps) = at.branch::<T>(self.body);
        let pose = at.centre.pose(self.body);
        let ideal = constant(pose.point(self.point_m));
        let moved = steps.iter().rev().fold(ideal.clone(), |point, step| step.point(point));
        PlacedJet { places, jet: dot(&constant(exact(self.direction)), &minus(moved, &ideal)) }
    }
}
