//! Play of a shaft that slides in its bearing.

use crate::kind::frames::MarkerShift;
use crate::play::block::Block;
use crate::play::journal::EndPlanes;
use crate::play::kind_of_play::{KindOfPlay, clearance_mistake, length_mistake};

/// A shaft longer than its bearing, which slides in it: |u1| <= c and |u2| <= c for the places of its axis in both end planes; its place along
/// the axis is a coordinate of the joint. Also the bearing of a shaft that another bearing holds along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylindricalPlay {
    /// Length l of the bearing, its middle at the marker, m.
    pub bearing_length_m: f64,
    /// Radius of the bearing minus radius of the shaft, c, m.
    pub radial_clearance_m: f64,
}

impl CylindricalPlay {
    fn ends(&self) -> EndPlanes {
        EndPlanes { length_m: self.bearing_length_m, radial_clearance_m: self.radial_clearance_m }
    }
}

impl KindOfPlay for CylindricalPlay {
    fn word(&self) -> &'static str {
        "cylindrical"
    }
    fn joint_word(&self) -> &'static str {
        "cylindrical"
    }
    fn blocks(&self) -> Vec<Block> {
        self.ends().blocks()
    }
    fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
        let &[x1, y1, x2, y2] = variables else { return MarkerShift::default() };
        self.ends().marker_shift([x1, y1, x2, y2], 0.0)
    }
    fn derivatives(&self, _variables: &[f64]) -> Vec<MarkerShift> {
        self.ends().derivatives(0.0)
    }
    fn bearing_length_m(&self) -> Option<f64> {
        Some(self.bearing_length_m)
    }
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
            .or_else(|| length_mistake(self.bearing_length_m, self.radial_clearance_m))
    }
}
