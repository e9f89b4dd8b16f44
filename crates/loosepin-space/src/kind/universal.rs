//! Two shafts and a cross: points coincide, and the z axes, which are the two pins of the cross, stay at a right angle.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// Two shafts and a cross: points coincide, and the z axes, which are the two pins of the cross, stay at a right angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Universal;

impl KindOfJoint for Universal {
    fn word(&self) -> &'static str {
        "universal"
    }
    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident, Row::Perpendicular(Axis::Z, Axis::Z)]
    }
    fn turns(&self) -> bool {
        false
    }
    fn slides(&self) -> bool {
        false
    }
    fn sign(&self) -> JointSign {
        JointSign::Cross
    }
}
