//! What both formats are written from.

use loosepin_space::{BodyTree, Frame, PointId, SpatialMechanism, SpatialModel};
use loosepin_text::numbers::Values;

/// A model with its nominal values, closed at the start.
pub(super) struct Export<'m> {
    pub model: &'m SpatialModel,
    pub values: &'m Values,
    pub mechanism: &'m SpatialMechanism,
    pub tree: &'m BodyTree,
    /// Frames of the bodies at time zero.
    pub frames: &'m [Frame],
}

impl Export<'_> {
    /// The name of a further joint that a joint of the model becomes: no other joint has it.
    pub fn second(&self, joint: &str, what: &str) -> String {
        let mut name = format!("{joint}_{what}");
        while self.model.joints.iter().any(|other| other.name == name) {
            name.push('_');
        }
        name
    }

    /// Points that outputs read, each once, in their order.
    pub fn output_points(&self) -> Vec<PointId> {
        let mut points = Vec::new();
        for output in &self.model.outputs {
            if let Some(point) = output.kind.point()
                && !points.contains(&point)
            {
                points.push(point);
            }
        }
        points
    }
}
