//! The first position.

use crate::closure::bordered::Borders;
use crate::closure::error::ClosureError;
use crate::closure::from_afar::{close_from_afar, regular, reversed};
use crate::closure::loops::Loops;
use crate::closure::other_starts::{closed_nearby, why_open};
use crate::closure::position::Position;
use crate::closure::singular::{RANK_THRESHOLD, singular_values};
use crate::closure::step::{Place, check_way, follow, nearest_values};
use crate::mechanism::drive::DriveValue;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::stop::{IsStopped, NEVER};

/// What is done where the start poses do not lead to a closed position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Starts {
    /// Nothing: another assembly may not be taken.
    AsGiven,
    /// Others around them are tried.
    Nearby,
}

/// Closes the loops from the start poses at the values of the drives.
///
/// First the loops are closed with all driven coordinates as the start poses have them, by steps of least squares and least length over the
/// singular values that count; then the drives are moved to their values along the motion, angles by less than half a turn. So the assembly is
/// that of the start poses. Where they lead to none, other poses around them are tried, and the nearest assembly is taken that these lead to.
///
/// # Errors
///
/// [`ClosureError::DoesNotClose`] if the steps do not come to an end, [`ClosureError::Contradiction`] if they end with rows open,
/// [`ClosureError::FewDigits`] if these are nearly closed, [`ClosureError::DrivesDoNotFit`] if they are closed without the drives,
/// [`ClosureError::Reversed`] if axes that are to be parallel point against each other, and those of [`crate::cycle`].
pub fn assemble(mechanism: &SpatialMechanism, drives: &[DriveValue]) -> Result<Position, ClosureError> {
    let loops = Loops::new(mechanism);
    Ok(Position::new(&loops, drives, &assembled(&loops, drives, Starts::Nearby, NEVER)?))
}

/// The place of [`assemble`], at the input 0, until it is stopped.
pub(crate) fn assembled(
    loops: &Loops,
    drives: &[DriveValue],
    starts: Starts,
    is_stopped: IsStopped,
) -> Result<Place, ClosureError> {
    check_drives(loops.mechanism, drives)?;
    let start = loops.mechanism.start_poses();
    let mut measured = loops.driven_coordinates(&loops.frames(&start, &[]));
    let values: Vec<f64> = drives.iter().map(|drive| drive.value).collect();
    let target = nearest_values(loops, &measured, &values);
    let found =
        close_from_afar(loops, start.clone(), &measured, is_stopped).and_then(|poses| match reversed(loops, &poses) {
            Some(joint) => Err(ClosureError::Reversed { joint }),
            None => Ok(poses),
        });
    let is_other_start = found.is_err();
    let poses = match found {
        Ok(poses) => poses,
        Err(error @ (ClosureError::FewDigits(_) | ClosureError::Reversed { .. } | ClosureError::Stopped)) => {
            return Err(error);
        }
        Err(error) if starts == Starts::AsGiven => return Err(error),
        Err(error) => {
            let nearby = closed_nearby(loops, &start, &target, is_stopped);
            measured.clone_from(&target);
            nearby.map_err(|nearly| nearly.unwrap_or_else(|| why_open(loops, &start, error, is_stopped)))?
        }
    };
    let frames = loops.frames(&poses, &[]);
    let borders = match regular(loops, &frames) {
        Some(_) => Borders::default(),
        None => {
            let singular = singular_values(loops, &frames);
            Borders::new(&singular, singular.rank(RANK_THRESHOLD))
        }
    };
    let place = Place::new(loops, 0.0, poses, borders);
    let between = |share: f64| -> Vec<f64> {
        // Both ends exactly.
        let pairs = measured.iter().zip(&target);
        pairs.map(|(from, to)| if share >= 1.0 { *to } else { from + share * (to - from) }).collect()
    };
    check_way(loops, [&measured, &target].into_iter().cloned())?;
    let place = if measured == target { place } else { follow(loops, &place, 1.0, &between, is_stopped)? };
    Ok(Place { input: 0.0, is_other_start, ..place })
}

/// One finite value for each drive.
pub(crate) fn check_drives(mechanism: &SpatialMechanism, drives: &[DriveValue]) -> Result<(), ClosureError> {
    let is_finite =
        |drive: &&DriveValue| drive.value.is_finite() && drive.rate.is_finite() && drive.acceleration.is_finite();
    let (expected, values) = (mechanism.drives().len(), drives.iter().filter(is_finite).count());
    if expected == values && drives.len() == expected {
        return Ok(());
    }
    Err(ClosureError::BadDrives { drives: expected, values })
}
