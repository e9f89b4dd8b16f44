//! The place of a journal's axis in a bearing of some length.

use crate::kind::frames::MarkerShift;
use crate::kind::joint_reader::JointReader;
use crate::play::block::Block;
use crate::play::clearance::fits_in_radius;
use loosepin_math::Vec3;
use loosepin_text::document::{Table, quantity};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule, format_number, format_value};

record! {
    /// play of a pin
    pub(crate) struct BearingKeys for ReadsNumbers;
    /// radius of the hole minus radius of the pin; without it the joint is ideal
    optional radial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// radius of the hole; the motion does not depend on it, a clearance is compared with it
    optional bearing_radius: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// length of the bearing, its middle at the point: the pin leans by up to 2 clearances over it
    optional bearing_length: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"20 mm\"";
}

impl BearingKeys<'_> {
    /// Radial clearance and length of a bearing; the outer option is absent after a diagnostic, the inner for an ideal joint.
    pub(crate) fn clearance_and_length(
        &self,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
    ) -> Option<Option<[QuantityId; 2]>> {
        if !fits_in_radius(reader, table, self.radial_clearance, self.bearing_radius) {
            return None;
        }
        let (key, needs) = match (self.radial_clearance, self.bearing_length) {
            (Some(clearance), Some(length)) => return Some(Some([clearance, length])),
            (None, None) => return Some(None),
            (Some(_), None) => ("radial_clearance", "bearing_length"),
            (None, Some(_)) => ("bearing_length", "radial_clearance"),
        };
        reader.report_missing(table, key, vec![needs]);
        None
    }
}

/// Both end planes of a bearing, in which the journal's axis is anywhere with |u1| <= c and |u2| <= c, exactly:
///
/// ```text
/// e = (u1 + u2)/2 at mid-plane,  slope w = (u2 - u1)/l
/// ```
///
/// This is a circular hole cut by both planes. A journal is a circle there but for 1/cos of its lean: 2 R_j c²/l² at most.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EndPlanes {
    pub length_m: f64,
    pub radial_clearance_m: f64,
}

impl EndPlanes {
    /// Clearance, length, and how far the journal leans.
    pub(crate) fn words(&self) -> String {
        let slope = 2.0 * self.radial_clearance_m / self.length_m;
        let lean = format!("{} mrad", format_number(1e-3 * (1e6 * slope).round()));
        let [clearance, length] =
            [self.radial_clearance_m, self.length_m].map(|length_m| format_value(length_m, D::LENGTH));
        format!("radial clearance {clearance} in a bearing of length {length}; the journal leans by up to {lean}")
    }

    pub(crate) fn blocks(&self) -> Vec<Block> {
        Block::end_planes(self.radial_clearance_m).to_vec()
    }

    /// The shift for u1, u2 and the axial displacement α: (e + α w, α), with the slope w.
    pub(crate) fn marker_shift(&self, [x1, y1, x2, y2]: [f64; 4], axial_m: f64) -> MarkerShift {
        let slope = [(x2 - x1) / self.length_m, (y2 - y1) / self.length_m];
        let shift_m = Vec3::new(0.5 * (x1 + x2) + axial_m * slope[0], 0.5 * (y1 + y2) + axial_m * slope[1], axial_m);
        MarkerShift { shift_m, slope }
    }

    /// Its derivatives by the four numbers of u1 and u2.
    pub(crate) fn derivatives(&self, axial_m: f64) -> Vec<MarkerShift> {
        [-1.0, 1.0]
            .into_iter()
            .flat_map(|sign| {
                let (slope, shift) = (sign / self.length_m, 0.5 + axial_m * sign / self.length_m);
                [
                    MarkerShift { shift_m: Vec3::new(shift, 0.0, 0.0), slope: [slope, 0.0] },
                    MarkerShift { shift_m: Vec3::new(0.0, shift, 0.0), slope: [0.0, slope] },
                ]
            })
            .collect()
    }
}
