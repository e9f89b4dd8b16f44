//! A slider in its guide: it moves along z and does not turn.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A slider in its guide: it moves along z and does not turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prismatic;

impl KindOfJoint for Prismatic {
    fn word(&self) -> &'static str {
        "prismatic"
    }
    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
            Row::Perpendicular(Axis::X, Axis::Y),
        ]
    }
    fn turns(&self) -> bool {
        false
    }
    fn slides(&self) -> bool {
        true
    }
    fn sign(&self) -> JointSign {
        JointSign::Guide
    }
}
