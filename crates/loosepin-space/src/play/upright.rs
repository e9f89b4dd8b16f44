//! Play of a pin that does not lean.

use crate::kind::frames::MarkerShift;
use crate::play::block::{Block, PlayPart};
use crate::play::kind_of_play::{KindOfPlay, clearance_mistake};
use loosepin_math::Vec3;

/// A journal whose axis stays parallel to the bearing's, between two stops: |e| <= c across, |α| <= c_a along. It is what a planar mechanism
/// knows of play.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UprightPlay {
    /// Radius of the bearing minus radius of the journal, c, m.
    pub radial_clearance_m: f64,
    /// How far the journal moves along the axis from the middle to either stop, c_a, m.
    pub axial_clearance_m: f64,
}

impl KindOfPlay for UprightPlay {
    fn word(&self) -> &'static str {
        "upright"
    }
    fn joint_word(&self) -> &'static str {
        "revolute"
    }
    fn blocks(&self) -> Vec<Block> {
        vec![
            Block { part: PlayPart::Across, radius_m: self.radial_clearance_m },
            Block { part: PlayPart::Axial, radius_m: self.axial_clearance_m },
        ]
    }
    fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
        let &[x, y, axial] = variables else { return MarkerShift::default() };
        MarkerShift { shift_m: Vec3::new(x, y, axial), slope: [0.0; 2] }
    }
    fn derivatives(&self, _variables: &[f64]) -> Vec<MarkerShift> {
        Vec3::AXES.map(|shift_m| MarkerShift { shift_m, slope: [0.0; 2] }).to_vec()
    }
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
            .or_else(|| clearance_mistake("axial clearance, m", self.axial_clearance_m))
    }
}
