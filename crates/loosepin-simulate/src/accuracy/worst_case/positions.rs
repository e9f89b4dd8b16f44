//! All positions that the play allows around an ideal one.

use super::enclosure::{Enclosed, Encloser, NotEnclosed};
use super::slices::Sliced;

/// Ends of deviations around the ideal position `coordinates`, as `ends_of` finds them in the positions there; infinite where they stay open.
///
/// # Errors
/// The loops were not shown to be regular in all of them.
pub(in super::super) fn ends_around(
    encloser: &mut Encloser<'_>,
    coordinates: &[f64],
    ends_of: impl Fn(&Positions) -> Vec<[f64; 2]>,
) -> Result<Vec<[f64; 2]>, NotEnclosed> {
    let is_known = |ends: &[f64; 2]| ends.iter().all(|end| end.is_finite());
    let positions = Positions::around(encloser, coordinates)?;
    let mut all = ends_of(&positions);
    // Second derivatives over one box may leave an end open that slices close.
    if let Positions::InOneBox(_) = positions
        && !all.iter().all(is_known)
        && let Ok(sliced) = encloser.in_slices(coordinates)
    {
        let of_slices = ends_of(&Positions::InSlices(sliced));
        for (ends, sliced) in all.iter_mut().zip(of_slices).filter(|(ends, _)| !is_known(ends)) {
            *ends = sliced;
        }
    }
    Ok(all)
}

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
    fn around(encloser: &mut Encloser<'_>, coordinates: &[f64]) -> Result<Self, NotEnclosed> {
        match encloser.in_one_box(coordinates) {
            Ok(enclosed) => Ok(Self::InOneBox(enclosed)),
            Err(_) => encloser.in_slices(coordinates).map(Self::InSlices),
        }
    }
}
