//! A nut on its screw.

use crate::kind::frames::Axis;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::Row;
use crate::kind::sign::JointSign;

/// A nut on its screw: a shaft that turns about z and moves along it by the pitch for each turn, z_i·d = (p/2π) φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Screw {
    /// Advance p in one turn, m; negative for a left-hand thread.
    pub pitch_m: f64,
}

impl KindOfJoint for Screw {
    fn word(&self) -> &'static str {
        "screw"
    }
    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
            Row::Helix { pitch_m: self.pitch_m },
        ]
    }
    fn turns(&self) -> bool {
        true
    }
    fn slides(&self) -> bool {
        true
    }
    fn sign(&self) -> JointSign {
        JointSign::Sleeve
    }
}
