//! Names of the parts of a model and its numbers, as sentences have them.

use crate::model::ids::{Actuator, BodyId, JointId, PointId};
use loosepin_text::numbers::QuantityId;

/// Names of the parts of a model, as sentences have them.
pub trait PartNames {
    /// `rod.small_end`.
    fn point(&self, point: PointId) -> String;
    /// `rod`.
    fn body(&self, body: BodyId) -> &str;
    /// `gudgeon`.
    fn joint(&self, joint: JointId) -> &str;
    /// `drive crank`.
    fn actuator(&self, actuator: Actuator) -> String;
}

/// Names and numbers of a model as people read them.
pub trait Names: PartNames {
    /// Value, SI.
    fn value_si(&self, id: QuantityId) -> f64;
    /// A number with the unit of its dimension.
    fn quantity(&self, id: QuantityId) -> String;
    /// A length with its unit.
    fn length(&self, id: QuantityId) -> String;
    /// An angle with its unit.
    fn angle(&self, angle_rad: f64) -> String;
}
