//! Play of a ball in its socket.

use crate::kind::frames::MarkerShift;
use crate::play::block::{Block, PlayPart};
use crate::play::kind_of_play::{KindOfPlay, clearance_mistake};
use loosepin_math::Vec3;

/// A ball with radial clearance c in its socket: its centre is anywhere with |e| <= c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphericalPlay {
    /// Radius of the socket minus radius of the ball, c, m.
    pub radial_clearance_m: f64,
}

impl KindOfPlay for SphericalPlay {
    fn word(&self) -> &'static str {
        "spherical"
    }
    fn joint_word(&self) -> &'static str {
        "spherical"
    }
    fn blocks(&self) -> Vec<Block> {
        vec![Block { part: PlayPart::Ball, radius_m: self.radial_clearance_m }]
    }
    fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
        let &[x, y, z] = variables else { return MarkerShift::default() };
        MarkerShift { shift_m: Vec3::new(x, y, z), slope: [0.0; 2] }
    }
    fn derivatives(&self, _variables: &[f64]) -> Vec<MarkerShift> {
        Vec3::AXES.map(|shift_m| MarkerShift { shift_m, slope: [0.0; 2] }).to_vec()
    }
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
    }
}
