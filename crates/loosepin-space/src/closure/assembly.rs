//! The first position.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::error::{ClosureError, OpenJoint};
use crate::closure::loops::Loops;
use crate::closure::newton::largest;
use crate::closure::other_starts::{closed_nearby, why_open};
use crate::closure::position::Position;
use crate::closure::singular::{RANK_THRESHOLD, singular_values};
use crate::closure::step::{CLOSED, Place, follow, nearest_values};
use crate::geometry::pose::Pose;
use crate::kind::frames::JointFrames;
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::row::is_reversed;
use crate::mechanism::drive::DriveValue;
use crate::mechanism::spatial_mechanism::SpatialMechanism;

/// Most steps from the start poses.
const MAX_STEPS: usize = 60;
/// Longest step, lengths over L and rad: what is farther is gone to in parts.
const LONGEST_STEP: f64 = 0.3;
/// A step below this is the last one but one.
const LAST_STEP: f64 = 1e-12;
/// Share of the residual below which a singular value cannot be told from zero: loops that are open have a higher rank.
const OPEN_SHARE: f64 = 10.0;
/// No singular value above this counts as zero, however open the loops are.
const LARGEST_THRESHOLD: f64 = 1e-3;
/// Smallest singular value over the largest, to about 1 %, that is above every threshold.
const REGULAR: f64 = 2.0 * LARGEST_THRESHOLD;

/// A residual below this is one of numbers with few digits, lengths over L and rad.
const FEW_DIGITS: f64 = 1e-4;

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
    Ok(Position::new(&loops, drives, &assembled(&loops, drives, Starts::Nearby)?))
}

/// Whether the start poses themselves lead to the position of [`assemble`], if there is one.
pub fn starts_as_given(mechanism: &SpatialMechanism, drives: &[DriveValue]) -> bool {
    assembled(&Loops::new(mechanism), drives, Starts::AsGiven).is_ok()
}

/// The place of [`assemble`], at the input 0.
pub(crate) fn assembled(loops: &Loops, drives: &[DriveValue], starts: Starts) -> Result<Place, ClosureError> {
    check_drives(loops.mechanism, drives)?;
    let start = loops.mechanism.start_poses();
    let mut measured = loops.driven_coordinates(&loops.frames(&start, &[]));
    let values: Vec<f64> = drives.iter().map(|drive| drive.value).collect();
    let target = nearest_values(loops, &measured, &values);
    let found = close_from_afar(loops, start.clone(), &measured).and_then(|poses| match reversed(loops, &poses) {
        Some(joint) => Err(ClosureError::Reversed { joint }),
        None => Ok(poses),
    });
    let poses = match found {
        Ok(poses) => poses,
        Err(error @ (ClosureError::FewDigits(_) | ClosureError::Reversed { .. })) => return Err(error),
        Err(error) if starts == Starts::AsGiven => return Err(error),
        Err(error) => {
            let nearby = closed_nearby(loops, &start, &target);
            measured.clone_from(&target);
            nearby.map_err(|nearly| nearly.unwrap_or_else(|| why_open(loops, &start, error)))?
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
    let place = if measured == target { place } else { follow(loops, &place, 1.0, &between)? };
    Ok(Place { input: 0.0, ..place })
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

/// The first joint whose axes point against each other though they are to be parallel.
fn reversed(loops: &Loops, poses: &[Pose]) -> Option<String> {
    let joints = loops.mechanism.joints().iter().zip(loops.frames(poses, &[]));
    let found = joints.into_iter().find(|(joint, at)| is_reversed(&joint.kind.rows(), at));
    found.map(|(joint, _)| joint.name.clone())
}

/// Whether there is such a joint.
pub(crate) fn is_any_reversed(loops: &Loops, poses: &[Pose]) -> bool {
    reversed(loops, poses).is_some()
}

/// Closes the loops with the drives at given values, by steps of least squares and least length.
pub(crate) fn close_from_afar(loops: &Loops, mut poses: Vec<Pose>, drives: &[f64]) -> Result<Vec<Pose>, ClosureError> {
    let mut is_last = false;
    let mut left = Vec::new();
    for _ in 0..MAX_STEPS {
        let frames = loops.frames(&poses, &[]);
        let residual: Vec<f64> = loops.residual(&frames, drives).iter().map(|value| -value).collect();
        let size = largest(&residual);
        let mut step = match regular(loops, &frames) {
            Some(system) => system.solve(&residual).0,
            None => {
                let values = singular_values(loops, &frames);
                let threshold = (OPEN_SHARE * size).clamp(RANK_THRESHOLD, LARGEST_THRESHOLD);
                values.solve(&residual, values.rank(threshold))
            }
        };
        let length = largest(&step);
        left = residual;
        if !length.is_finite() {
            break;
        }
        if length > LONGEST_STEP {
            step.iter_mut().for_each(|entry| *entry *= LONGEST_STEP / length);
        }
        poses = loops.moved(&poses, &step);
        if is_last {
            let open = open_joint(loops, &left);
            return match size {
                size if size <= CLOSED => Ok(poses),
                size if size <= FEW_DIGITS => Err(ClosureError::FewDigits(open)),
                _ => Err(ClosureError::Contradiction(open)),
            };
        }
        is_last = length < LAST_STEP;
    }
    Err(ClosureError::DoesNotClose(open_joint(loops, &left)))
}

/// The loop equations themselves, where they are as many as the unknowns and all singular values count, whatever the threshold.
fn regular(loops: &Loops, frames: &[JointFrames]) -> Option<Bordered> {
    if loops.rows.len() != loops.unknowns() {
        return None;
    }
    let system = Bordered::new(loops, frames, &Borders::default());
    (system.singular_ratio(loops, frames, &Borders::default()) > REGULAR).then_some(system)
}

/// The joint of the row that is farthest from closing.
fn open_joint(loops: &Loops, residual: &[f64]) -> OpenJoint {
    let worst = (0..residual.len()).max_by(|&a, &b| residual[a].abs().total_cmp(&residual[b].abs())).unwrap_or(0);
    let row = loops.rows.get(worst);
    OpenJoint {
        joint: row.map_or(String::new(), |row| loops.mechanism.joints()[row.joint].name.clone()),
        apart: row.map_or(0.0, |row| residual[worst].abs() * loops.scale(row)),
        is_length: row.is_some_and(|row| row.row.is_length()),
    }
}
