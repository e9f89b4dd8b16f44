//! All positions that the play allows around an ideal one.

use super::enclosure::{Enclosed, Encloser, NotEnclosed};
use super::slices::Sliced;

/// How they are enclosed.
pub(in super::super) enum Positions {
    InOneBox(Enclosed),
    /// Near a dead centre, where one box is too wide.
    InSlices(Sliced),
}

impl Positions {
    /// All positions around the ideal one `coordinates`, free coordinates first, then driven ones.
    ///
    /// # Errors
    /// The loops were not shown to be regular in all of them.
    pub fn around(encloser: &mut Encloser<'_>, coordinates: &[f64]) -> Result<Self, NotEnclosed> {
        match encloser.in_one_box(coordinates) {
            Ok(enclosed) => Ok(Self::InOneBox(enclosed)),
            Err(_) => encloser.in_slices(coordinates).map(Self::InSlices),
        }
    }
}
