//! A face on a face: z axes are parallel, and the points have the same place along z.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A face on a face: z axes are parallel, and the points have the same place along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planar;

impl KindOfJoint for Planar {
    fn word(&self) -> &'static str {
        "planar"
    }
    fn rows(&self) -> Vec<Row> {
        vec![Row::Perpendicular(Axis::X, Axis::Z), Row::Perpendicular(Axis::Y, Axis::Z), Row::Across(Axis::Z)]
    }
    fn turns(&self) -> bool {
        true
    }
    fn slides(&self) -> bool {
        false
    }
    fn sign(&self) -> JointSign {
        JointSign::Plate
    }
}
