//! The place of a journal's axis in a bearing of some length.

use crate::kind::frames::MarkerShift;
use crate::play::block::{Block, PlayPart};
use loosepin_math::Vec3;

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
    pub(crate) fn blocks(&self) -> Vec<Block> {
        [PlayPart::FirstEnd, PlayPart::SecondEnd].map(|part| Block { part, radius_m: self.radial_clearance_m }).to_vec()
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
