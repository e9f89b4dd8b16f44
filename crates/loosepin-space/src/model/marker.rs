//! Where a joint is on its bodies, and errors of manufacture: where its bearing and its journal are, against where they should be.
//!
//! A marker has its origin P and the axes A = (x, y, z), z along the axis of the joint, x along the direction across it. With the shift s and the
//! tilt θ, a rotation vector, both along these axes:
//!
//! ```text
//! P' = P + A s,   A' = A exp([θ]×)
//! ```

use super::direction::{Direction, vector};
use crate::mechanism::marker::Marker;
use loosepin_math::{Quaternion, Vec3};
use loosepin_text::numbers::{QuantityId, Values};

/// A point of a body, by their places in the lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PointId {
    /// The body; 0 is the ground.
    pub body: usize,
    /// The point of it.
    pub point: usize,
}

/// Where a joint is on a body.
#[derive(Debug, Clone, Copy)]
pub struct ModelMarker {
    /// The point.
    pub point: PointId,
    /// z of the marker: the axis of the joint.
    pub axis: Direction,
    /// x of the marker, as far as it is across the axis; `None` for the default.
    pub across: Option<Direction>,
    /// Errors of manufacture.
    pub misalignment: ModelMisalignment,
}

/// How far a marker is from where it should be on its body, along its own axes x, y and z; nothing where the file does not say it.
#[derive(Debug, Clone, Copy, Default)]
pub struct ModelMisalignment {
    /// Displacement of its point, m.
    pub shift_m: Option<[QuantityId; 3]>,
    /// Rotation vector about its point, rad.
    pub tilt_rad: Option<[QuantityId; 3]>,
}

impl ModelMisalignment {
    /// The marker with its errors; the marker itself, to the last bit, where they are zero.
    pub(crate) fn applied_to(&self, marker: Marker, values: &Values) -> Marker {
        let value = |ids: Option<[_; 3]>| ids.map_or(Vec3::ZERO, |ids| vector(ids, values));
        let (shift_m, tilt_rad) = (value(self.shift_m), value(self.tilt_rad));
        let mut off = marker;
        if shift_m != Vec3::ZERO {
            off.point_m += marker.axes.apply(shift_m);
        }
        if tilt_rad != Vec3::ZERO {
            off.axes = marker.axes.compose(&Quaternion::from_rotation_vector(tilt_rad).rotation());
        }
        off
    }
}
