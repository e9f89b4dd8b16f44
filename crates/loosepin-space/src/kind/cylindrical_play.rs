//! Play of a shaft that slides in its bearing.

use crate::kind::frames::MarkerShift;
use crate::kind::joint_reader::JointReader;
use crate::play::bearing::{BearingKeys, EndPlanes};
use crate::play::block::Block;
use crate::play::kind_of_play::{KindOfPlay, PlayNumbers, PlayOfFile, clearance_mistake, length_mistake};
use loosepin_text::document::Table;
use loosepin_text::numbers::QuantityId;

/// A shaft longer than its bearing, which slides in it: |u1| <= c and |u2| <= c for the places of its axis in both end planes; its place along
/// the axis is a coordinate of the joint. Also the bearing of a shaft that another bearing holds along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CylindricalPlay<N = f64> {
    /// Length l of the bearing, its middle at the marker, m.
    pub bearing_length_m: N,
    /// Radius of the bearing minus radius of the shaft, c, m.
    pub radial_clearance_m: N,
}

impl CylindricalPlay {
    fn ends(&self) -> EndPlanes {
        EndPlanes { length_m: self.bearing_length_m, radial_clearance_m: self.radial_clearance_m }
    }
}

impl CylindricalPlay<QuantityId> {
    /// The play; the outer option is absent after a diagnostic, the inner for an ideal joint.
    pub(crate) fn read(
        keys: &BearingKeys<'_>,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
    ) -> Option<Option<Self>> {
        let bearing = keys.clearance_and_length(reader, table)?;
        Some(bearing.map(|[radial_clearance_m, bearing_length_m]| Self { bearing_length_m, radial_clearance_m }))
    }
}

impl PlayOfFile for CylindricalPlay<QuantityId> {
    const KEYS: &'static [&'static str] = &["radial_clearance", "bearing_length"];
}

impl<N: Copy> PlayNumbers<N> for CylindricalPlay<N> {
    type With<M> = CylindricalPlay<M>;

    fn with<M>(&self, number: impl Fn(N) -> M) -> CylindricalPlay<M> {
        CylindricalPlay {
            bearing_length_m: number(self.bearing_length_m),
            radial_clearance_m: number(self.radial_clearance_m),
        }
    }
    fn clearances_m(&self) -> [Option<N>; 2] {
        [Some(self.radial_clearance_m), None]
    }
    fn bearing_length_m(&self) -> Option<N> {
        Some(self.bearing_length_m)
    }
}

impl KindOfPlay for CylindricalPlay {
    const WORD: &'static str = "cylindrical";
    const JOINT: &'static str = "cylindrical";

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
    fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        clearance_mistake("radial clearance, m", self.radial_clearance_m)
            .or_else(|| length_mistake(self.bearing_length_m, self.radial_clearance_m))
    }
    fn words(&self) -> String {
        self.ends().words()
    }
}
