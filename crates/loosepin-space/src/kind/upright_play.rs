//! Play of a pin that does not lean.

use crate::kind::frames::MarkerShift;
use crate::play::block::Block;
use crate::play::kind_of_play::{KindOfPlay, PlayNumbers, clearance_mistake};
use loosepin_math::Vec3;
use loosepin_text::units::{Dimension as D, format_value};

/// A journal whose axis stays parallel to the bearing's, between two stops: |e| <= c across, |α| <= c_a along. It is what a planar mechanism
/// knows of play.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UprightPlay<N = f64> {
    /// Radius of the bearing minus radius of the journal, c, m.
    pub radial_clearance_m: N,
    /// How far the journal moves along the axis from the middle to either stop, c_a, m.
    pub axial_clearance_m: N,
}

impl<N: Copy> PlayNumbers<N> for UprightPlay<N> {
    type With<M> = UprightPlay<M>;

    fn with<M>(&self, number: impl Fn(N) -> M) -> UprightPlay<M> {
        UprightPlay {
            radial_clearance_m: number(self.radial_clearance_m),
            axial_clearance_m: number(self.axial_clearance_m),
        }
    }
    fn clearances_m(&self) -> [Option<N>; 2] {
        [Some(self.radial_clearance_m), Some(self.axial_clearance_m)]
    }
}

impl KindOfPlay for UprightPlay {
    const WORD: &'static str = "upright";
    const JOINT: &'static str = "revolute";

    fn blocks(&self) -> Vec<Block> {
        vec![Block::across(self.radial_clearance_m), Block::axial(self.axial_clearance_m)]
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
    fn words(&self) -> String {
        let [radial, axial] =
            [self.radial_clearance_m, self.axial_clearance_m].map(|own_m| format_value(own_m, D::LENGTH));
        format!("radial clearance {radial} without a lean; axial clearance {axial}")
    }
}
