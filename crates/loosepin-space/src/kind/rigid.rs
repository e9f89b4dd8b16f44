//! Both bodies move as one.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// Both bodies move as one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid;

impl KindOfJoint for Rigid {
    fn word(&self) -> &'static str {
        "rigid"
    }
    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Coincident,
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Perpendicular(Axis::X, Axis::Y),
        ]
    }
    fn turns(&self) -> bool {
        false
    }
    fn slides(&self) -> bool {
        false
    }
    fn sign(&self) -> JointSign {
        JointSign::Weld
    }
}
