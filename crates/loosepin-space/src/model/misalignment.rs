//! Errors of manufacture: where the bearing and the journal of a joint are on their bodies, against where they should be.
//!
//! A marker has its origin P and the axes A = (x, y, z), z along the axis of the joint, x along the direction across it. With the shift s and the
//! tilt θ, a rotation vector, both along these axes:
//!
//! ```text
//! P' = P + A s,   A' = A exp([θ]×)
//! ```

use super::body::LENGTHS;
use super::parts::ModelMisalignment;
use super::reader::SpaceReader;
use crate::mechanism::marker::Marker;
use loosepin_math::{Quaternion, Vec3};
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::{ReadsNumbers, Values};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// A rotation vector.
const ANGLES: Kind = Kind::Three(&quantity(D::ANGLE, Rule::Finite));

record! {
    /// errors of manufacture of both sides of a joint: their places
    pub(super) struct Shifts for ReadsNumbers;
    /// error of manufacture: displacement of the bearing from its point, along the direction across the axis, along that at right angles to both, and along the axis; none if omitted
    optional bearing_shift: Entry<'t> = LENGTHS, "[\"0.02 mm\", \"0 mm\", \"0 mm\"]";
    /// error of manufacture: displacement of the journal from its point, likewise
    optional journal_shift: Entry<'t> = LENGTHS, "[\"0 mm\", \"0.01 mm\", \"0 mm\"]";
}

record! {
    /// errors of manufacture of both sides of a joint: their directions
    pub(super) struct Tilts for ReadsNumbers;
    /// error of manufacture: rotation vector of the bearing on its body, along the same directions; the first two tilt the axis, the third turns about it; none if omitted, and an input of a study only where it is written
    optional bearing_tilt: Entry<'t> = ANGLES, "[\"0.2 mrad\", \"0 mrad\", \"0 mrad\"]";
    /// error of manufacture: rotation vector of the journal on its body, likewise
    optional journal_tilt: Entry<'t> = ANGLES, "[\"0 mrad\", \"0.2 mrad\", \"0 mrad\"]";
}

impl SpaceReader {
    /// Errors of the bearing and of the journal; absent after a diagnostic.
    pub fn misalignments(&mut self, shifts: &Shifts<'_>, tilts: Option<&Tilts<'_>>) -> Option<[ModelMisalignment; 2]> {
        let bearing = self.misalignment(&shifts.bearing_shift, tilts.and_then(|own| own.bearing_tilt.as_ref()));
        let journal = self.misalignment(&shifts.journal_shift, tilts.and_then(|own| own.journal_tilt.as_ref()));
        Some([bearing?, journal?])
    }

    fn misalignment(&mut self, shift: &Option<Entry<'_>>, tilt: Option<&Entry<'_>>) -> Option<ModelMisalignment> {
        let mut read = |entry: Option<&Entry<'_>>, dimension: D| match entry {
            None => Some(None),
            Some(entry) => self.numbers.three(entry, dimension).map(Some),
        };
        let (shift_m, tilt_rad) = (read(shift.as_ref(), D::LENGTH), read(tilt, D::ANGLE));
        Some(ModelMisalignment { shift_m: shift_m?, tilt_rad: tilt_rad? })
    }
}

impl ModelMisalignment {
    /// The marker with its errors; the marker itself, to the last bit, where they are zero.
    pub(super) fn applied_to(&self, marker: Marker, values: &Values) -> Marker {
        let value = |ids: Option<[_; 3]>| ids.map_or(Vec3::ZERO, |ids| super::direction::vector(ids, values));
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
