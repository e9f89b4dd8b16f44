//! Play of a pin in its bearing.

use crate::kind::frames::MarkerShift;
use crate::kind::joint_reader::JointReader;
use crate::play::bearing::{BearingKeys, EndPlanes};
use crate::play::block::Block;
use crate::play::kind_of_play::{KindOfPlay, PlayNumbers, PlayOfFile, clearance_mistake, length_mistake};
use loosepin_math::Vec3;
use loosepin_text::document::{Table, quantity};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule, format_value};

/// A journal longer than its bearing, between two stops. In axes of the bearing d = (e + α w, α) and the journal's axis is along (w, 1):
///
/// ```text
/// e = (u1 + u2)/2,  w = (u2 - u1)/l,  |u1| <= c,  |u2| <= c,  |α| <= c_a
/// ```
///
/// u1, u2 are the places of the journal's axis in the end planes of the bearing, α its displacement along the axis. The set is exact, not of
/// first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RevolutePlay<N = f64> {
    /// Length l of the bearing, its middle at the marker, m.
    pub bearing_length_m: N,
    /// Radius of the bearing minus radius of the journal, c, m.
    pub radial_clearance_m: N,
    /// How far the journal moves along the axis from the middle to either stop, c_a, m.
    pub axial_clearance_m: N,
}

impl RevolutePlay {
    fn ends(&self) -> EndPlanes {
        EndPlanes { length_m: self.bearing_length_m, radial_clearance_m: self.radial_clearance_m }
    }
}

record! {
    /// play of a pin between two stops
    pub(crate) struct RevolutePlayKeys for ReadsNumbers;
    include bearing: BearingKeys<'t>;
    /// how far the pin moves along the axis from the middle to either stop; 0 if omitted
    optional axial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.2 mm\"";
}

impl RevolutePlayKeys<'_> {
    /// The play; the outer option is absent after a diagnostic, the inner for an ideal joint.
    pub(crate) fn play(
        &self,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
    ) -> Option<Option<RevolutePlay<QuantityId>>> {
        if self.axial_clearance.is_some() && self.bearing.radial_clearance.is_none() {
            reader.report_missing(table, "axial_clearance", vec!["radial_clearance", "bearing_length"]);
            return None;
        }
        let bearing = self.bearing.clearance_and_length(reader, table)?;
        Some(bearing.map(|[radial_clearance_m, bearing_length_m]| {
            let path = &table.path.join("axial_clearance");
            let none = |reader: &mut dyn JointReader| reader.default_quantity(path, D::LENGTH, Rule::NonNegative, 0.0);
            let axial_clearance_m = self.axial_clearance.unwrap_or_else(|| none(reader));
            RevolutePlay { bearing_length_m, radial_clearance_m, axial_clearance_m }
        }))
    }
}

impl PlayOfFile for RevolutePlay<QuantityId> {
    const KEYS: &'static [&'static str] = &["radial_clearance", "bearing_length", "axial_clearance"];
}

impl<N: Copy> PlayNumbers<N> for RevolutePlay<N> {
    type With<M> = RevolutePlay<M>;

    fn with<M>(&self, number: impl Fn(N) -> M) -> RevolutePlay<M> {
        RevolutePlay {
            bearing_length_m: number(self.bearing_length_m),
            radial_clearance_m: number(self.radial_clearance_m),
            axial_clearance_m: number(self.axial_clearance_m),
        }
    }
    fn clearances_m(&self) -> [Option<N>; 2] {
        [Some(self.radial_clearance_m), Some(self.axial_clearance_m)]
    }
    fn bearing_length_m(&self) -> Option<N> {
        Some(self.bearing_length_m)
    }
}

impl KindOfPlay for RevolutePlay {
    const WORD: &'static str = "revolute";
    const JOINT: &'static str = "revolute";

    fn blocks(&self) -> Vec<Block> {
        let mut blocks = self.ends().blocks();
        blocks.push(Block::axial(self.axial_clearance_m));
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
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
            .or_else(|| clearance_mistake("axial clearance, m", self.axial_clearance_m))
            .or_else(|| length_mistake(self.bearing_length_m, self.radial_clearance_m))
    }
    fn words(&self) -> String {
        format!("{}; axial clearance {}", self.ends().words(), format_value(self.axial_clearance_m, D::LENGTH))
    }
}
