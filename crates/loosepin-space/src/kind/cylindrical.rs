//! A shaft that turns about z and slides along it.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A shaft that turns about z and slides along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylindrical;

impl KindOfJoint for Cylindrical {
    fn word(&self) -> &'static str {
        "cylindrical"
    }
    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
        ]
    }
    fn turns(&self) -> bool {
        true
    }
    fn slides(&self) -> bool {
        true
    }
    fn play_keys(&self) -> &'static [&'static str] {
        &["radial_clearance", "bearing_length"]
    }
    fn sign(&self) -> JointSign {
        JointSign::Sleeve
    }
}
