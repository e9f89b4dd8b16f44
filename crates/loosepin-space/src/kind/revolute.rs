//! A pin in its bearing: points coincide and z axes are parallel; one turn about z.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A pin in its bearing: points coincide and z axes are parallel; one turn about z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Revolute;

impl KindOfJoint for Revolute {
    fn word(&self) -> &'static str {
        "revolute"
    }
    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident, Row::Perpendicular(Axis::X, Axis::Z), Row::Perpendicular(Axis::Y, Axis::Z)]
    }
    fn turns(&self) -> bool {
        true
    }
    fn slides(&self) -> bool {
        false
    }
    fn play_keys(&self) -> &'static [&'static str] {
        &["radial_clearance", "bearing_length", "axial_clearance"]
    }
    fn sign(&self) -> JointSign {
        JointSign::Pin
    }
}
