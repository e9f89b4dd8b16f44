//! Names and numbers of a model as people read them.

use loosepin_mechanics::model::{Actuator, BodyId, JointId, Model, Names, PartNames, PointId, QuantityId, Values};
use loosepin_text::units::{Dimension, format_value};

/// Angles in sentences are shown to this, rad: a hundredth of a degree picks an assembly well enough.
pub const SHOWN_ANGLE_RAD: f64 = 0.01 * std::f64::consts::PI / 180.0;

/// Names and numbers of a model for the words of its joints, couplings and drives.
pub struct ModelNames<'m> {
    /// The model.
    pub model: &'m Model,
    /// Its values.
    pub values: &'m Values,
}

impl PartNames for ModelNames<'_> {
    fn point(&self, point: PointId) -> String {
        self.model.point(point)
    }

    fn body(&self, body: BodyId) -> &str {
        self.model.body(body)
    }

    fn joint(&self, joint: JointId) -> &str {
        self.model.joint(joint)
    }

    fn actuator(&self, actuator: Actuator) -> String {
        self.model.actuator(actuator)
    }
}

impl Names for ModelNames<'_> {
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
