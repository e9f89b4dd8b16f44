//! The journal's marker in the bearing's.

use crate::kind::frames::MarkerShift;
use loosepin_math::{Frame, Rotation, Vec3};

/// Angle and slide of a joint, with the sine and cosine of the angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct JointPlace {
    pub sine: f64,
    pub cosine: f64,
    pub slide_m: f64,
}

/// Angles and slides of the joints of a chain.
#[derive(Debug, Clone)]
pub struct ChainPose {
    pub(crate) places: Vec<JointPlace>,
}

/// What of play does not change with the angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lean {
    /// Slope (w1, w2) of the journal's axis.
    slope: [f64; 2],
    /// The journal's axis, (w1, w2, 1) made a unit vector.
    axis: Vec3,
    /// Displacement of the origin, m.
    shift_m: Vec3,
}

impl Lean {
    pub(crate) fn new(shift: &MarkerShift) -> Self {
        let [w1, w2] = shift.slope;
        let axis = Vec3::new(w1, w2, 1.0) / (1.0 + w1 * w1 + w2 * w2).sqrt();
        Self { slope: shift.slope, axis, shift_m: shift.shift_m }
    }

    /// The journal's marker at an angle φ and a slide s: z along (w, 1); x across it with atan2(y_i·x_j, x_i·x_j) = φ, so along
    /// (cos φ, sin φ, -(w1 cos φ + w2 sin φ)); the origin at e + s (w, 1).
    #[inline(always)]
    pub(crate) fn journal(&self, place: &JointPlace) -> Frame {
        let [w1, w2] = self.slope;
        let rise = -(w1 * place.cosine + w2 * place.sine);
        let x = Vec3::new(place.cosine, place.sine, rise) * (1.0 / (1.0 + rise * rise).sqrt());
        let origin_m = self.shift_m + Vec3::new(w1, w2, 1.0) * place.slide_m;
        Frame { axes: Rotation { x, y: self.axis.cross(x), z: self.axis }, origin_m }
    }
}
