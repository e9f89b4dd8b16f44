//! Names of the parts of a model, as sentences have them.

use super::ids::{Actuator, BodyId, JointId, PointId};

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
