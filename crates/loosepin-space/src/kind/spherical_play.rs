//! Play of a ball in its socket.

use crate::kind::frames::MarkerShift;
use crate::kind::joint_reader::JointReader;
use crate::play::block::Block;
use crate::play::clearance::fits_in_radius;
use crate::play::kind_of_play::{KindOfPlay, PlayNumbers, PlayOfFile, clearance_mistake};
use loosepin_math::Vec3;
use loosepin_text::document::{Table, quantity};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule, format_value};

/// A ball with radial clearance c in its socket: its centre is anywhere with |e| <= c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphericalPlay<N = f64> {
    /// Radius of the socket minus radius of the ball, c, m.
    pub radial_clearance_m: N,
}

record! {
    /// play of a ball
    pub(crate) struct SphericalPlayKeys for ReadsNumbers;
    /// radius of the socket minus radius of the ball; without it the joint is ideal
    optional radial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// radius of the socket; the motion does not depend on it, a clearance is compared with it
    optional bearing_radius: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
}

impl SphericalPlayKeys<'_> {
    /// The play; the outer option is absent after a diagnostic, the inner for an ideal joint.
    pub(crate) fn play(
        &self,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
    ) -> Option<Option<SphericalPlay<QuantityId>>> {
        let play = self.radial_clearance.map(|radial_clearance_m| SphericalPlay { radial_clearance_m });
        fits_in_radius(reader, table, self.radial_clearance, self.bearing_radius).then_some(play)
    }
}

impl PlayOfFile for SphericalPlay<QuantityId> {
    const KEYS: &'static [&'static str] = &["radial_clearance"];
}

impl<N: Copy> PlayNumbers<N> for SphericalPlay<N> {
    type With<M> = SphericalPlay<M>;

    fn with<M>(&self, number: impl Fn(N) -> M) -> SphericalPlay<M> {
        SphericalPlay { radial_clearance_m: number(self.radial_clearance_m) }
    }
    fn clearances_m(&self) -> [Option<N>; 2] {
        [Some(self.radial_clearance_m), None]
    }
}

impl KindOfPlay for SphericalPlay {
    const WORD: &'static str = "spherical";
    const JOINT: &'static str = "spherical";

    fn blocks(&self) -> Vec<Block> {
        vec![Block::ball(self.radial_clearance_m)]
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
    fn words(&self) -> String {
        format!("radial clearance {}", format_value(self.radial_clearance_m, D::LENGTH))
    }
}
