//! Play of a pin in its bearing.

use crate::kind::frames::MarkerShift;
use crate::play::block::{Block, PlayPart};
use crate::play::journal::EndPlanes;
use crate::play::kind_of_play::{KindOfPlay, clearance_mistake, length_mistake};
use loosepin_math::Vec3;

/// A journal longer than its bearing, between two stops. In axes of the bearing d = (e + α w, α) and the journal's axis is along (w, 1):
///
/// ```text
/// e = (u1 + u2)/2,  w = (u2 - u1)/l,  |u1| <= c,  |u2| <= c,  |α| <= c_a
/// ```
///
/// u1, u2 are the places of the journal's axis in the end planes of the bearing, α its displacement along the axis. The set is exact, not of
/// first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RevolutePlay {
    /// Length l of the bearing, its middle at the marker, m.
    pub bearing_length_m: f64,
    /// Radius of the bearing minus radius of the journal, c, m.
    pub radial_clearance_m: f64,
    /// How far the journal moves along the axis from the middle to either stop, c_a, m.
    pub axial_clearance_m: f64,
}

impl RevolutePlay {
    fn ends(&self) -> EndPlanes {
        EndPlanes { length_m: self.bearing_length_m, radial_clearance_m: self.radial_clearance_m }
    }
}

impl KindOfPlay for RevolutePlay {
    fn word(&self) -> &'static str {
        "revolute"
    }
    fn joint_word(&self) -> &'static str {
        "revolute"
    }
    fn blocks(&self) -> Vec<Block> {
        let mut blocks = self.ends().blocks();
        blocks.push(Block { part: PlayPart::Axial, radius_m: self.axial_clearance_m });
        blocks
    }
    fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
        let &[x1, y1, x2, y2, axial] = variables else { return MarkerShift::default() };
        self.ends().marker_shift([x1, y1, x2, y2], axial)
    }
    fn derivatives(&self, variables: &[f64]) -> Vec<MarkerShift> {
        let &[x1, y1, x2, y2, axial] = variables else { return Vec::new() };
        let mut derivatives = self.ends().derivatives(axial);
        let slope = self.ends().marker_shift([x1, y1, x2, y2], axial).slope;
        derivatives.push(MarkerShift { shift_m: Vec3::new(slope[0], slope[1], 1.0), slope: [0.0; 2] });
        derivatives
    }
    fn second_derivatives(&self) -> Vec<(usize, usize, MarkerShift)> {
        // Of α w.
        const AXIAL: usize = 4;
        let slopes = self.ends().derivatives(0.0).into_iter().map(|by| Vec3::new(by.slope[0], by.slope[1], 0.0));
        slopes.enumerate().map(|(k, shift_m)| (k, AXIAL, MarkerShift { shift_m, slope: [0.0; 2] })).collect()
    }
    fn bearing_length_m(&self) -> Option<f64> {
        Some(self.bearing_length_m)
    }
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
            .or_else(|| clearance_mistake("axial clearance, m", self.axial_clearance_m))
            .or_else(|| length_mistake(self.bearing_length_m, self.radial_clearance_m))
    }
}
