//! The first position.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::error::{ClosureError, OpenJoint};
use crate::closure::loops::Loops;
use crate::closure::newton::largest;
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

/// Closes the loops from the start poses at the values of the drives.
///
/// First the loops are closed with all driven coordinates as the start poses have them, by steps of least squares and least length over the
/// singular values that count; then the drives are moved to their values along the motion, angles by less than half a turn. So the assembly is
/// that of the start poses.
///
/// # Errors
///
/// [`ClosureError::DoesNotClose`] if the steps do not come to an end, [`ClosureError::Contradiction`] if they end with rows open,
/// [`ClosureError::Reversed`] if axes that are to be parallel point against each other, and those of [`crate::cycle`].
pub fn assemble(mechanism: &SpatialMechanism, drives: &[DriveValue]) -> Result<Position, ClosureError> {
    let loops = Loops::new(mechanism);
    Ok(Position::new(&loops, drives, &assembled(&loops, drives)?))
}

/// The place of [`assemble`], at the input 0.
pub(crate) fn assembled(loops: &Loops, drives: &[DriveValue]) -> Result<Place, ClosureError> {
    let mechanism = loops.mechanism;
    check_drives(mechanism, drives)?;
    let start = mechanism.start_poses();
    let measured = loops.driven_coordinates(&loops.frames(&start, &[]));
    let poses = close_from_afar(loops, start, &measured)?;
    let joints = mechanism.joints().iter().zip(loops.frames(&poses, &[]));
    if let Some((joint, _)) = joints.into_iter().find(|(joint, at)| is_reversed(&joint.kind.rows(), at)) {
        return Err(ClosureError::Reversed { joint: joint.name.clone() });
    }
    let values: Vec<f64> = drives.iter().map(|drive| drive.value).collect();
    let target = nearest_values(loops, &measured, &values);
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

fn close_from_afar(loops: &Loops, mut poses: Vec<Pose>, drives: &[f64]) -> Result<Vec<Pose>, ClosureError> {
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
            return if size <= CLOSED { Ok(poses) } else { Err(ClosureError::Contradiction(open)) };
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
