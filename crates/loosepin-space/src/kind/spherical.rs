//! A ball in its socket: points coincide.

use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A ball in its socket: points coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spherical;

impl KindOfJoint for Spherical {
    fn word(&self) -> &'static str {
        "spherical"
    }
    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident]
    }
    fn turns(&self) -> bool {
        false
    }
    fn slides(&self) -> bool {
        false
    }
    fn play_keys(&self) -> &'static [&'static str] {
        &["radial_clearance"]
    }
    fn sign(&self) -> JointSign {
        JointSign::Ball
    }
}
