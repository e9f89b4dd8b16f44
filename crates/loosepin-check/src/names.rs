//! Names and numbers of a model as people read them.

use loosepin_mechanics::model::{BodyId, JointId, Model, Names, PointId, QuantityId, Values};
use loosepin_text::units::{Dimension, format_value};

/// Angles in sentences are shown to this, rad: a hundredth of a degree picks an assembly well enough.
pub const SHOWN_ANGLE_RAD: f64 = 0.01 * std::f64::consts::PI / 180.0;

/// Names and numbers of a model for the words of its joints, couplings and drives.
pub struct NamesOf<'m> {
    /// The model.
    pub model: &'m Model,
    /// Its values.
    pub values: &'m Values,
}

impl Names for NamesOf<'_> {
    fn point(&self, id: PointId) -> String {
        let body = &self.model.bodies[id.body.0];
        format!("{}.{}", body.name, body.points[id.point].name)
    }

    fn body(&self, body: BodyId) -> &str {
        &self.model.bodies[body.0].name
    }

    fn joint(&self, joint: JointId) -> &str {
        &self.model.joints[joint.0].name
    }

    fn value_si(&self, id: QuantityId) -> f64 {
        self.values[id]
    }

    fn quantity(&self, id: QuantityId) -> String {
        format_value(self.values[id], self.model.quantities[id].dimension)
    }

    fn length(&self, id: QuantityId) -> String {
        format_value(self.values[id], Dimension::LENGTH)
    }

    fn angle(&self, angle_rad: f64) -> String {
        angle_words(angle_rad)
    }
}

/// An angle in degrees to a hundredth, within half a turn of zero.
pub fn angle_words(angle_rad: f64) -> String {
    let turn = std::f64::consts::TAU;
    let within = angle_rad - turn * (angle_rad / turn).round();
    format_value((within / SHOWN_ANGLE_RAD).round() * SHOWN_ANGLE_RAD, Dimension::ANGLE)
}
