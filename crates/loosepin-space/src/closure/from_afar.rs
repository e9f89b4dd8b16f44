//! Loops closed from poses that are far from closed.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::error::{ClosureError, OpenJoint};
use crate::closure::loops::Loops;
use crate::closure::newton::largest;
use crate::closure::singular::{RANK_THRESHOLD, singular_values};
use crate::closure::step::CLOSED;
use crate::kind::frames::JointFrames;
use crate::kind::row::is_reversed;
use crate::stop::IsStopped;
use loosepin_math::Pose;

/// Most steps from the start poses.
const MAX_STEPS: usize = 60;
/// Longest step, lengths over L and rad: what is farther is gone to in parts.
const LONGEST_STEP: f64 = 0.3;
/// A step below this is the last one but one.
const LAST_STEP: f64 = 1e-12;
/// Share of the residual below which a singular value counts as zero: loops that are open have a higher rank.
const OPEN_SHARE: f64 = 10.0;
/// No singular value above this counts as zero, however open the loops are.
const LARGEST_THRESHOLD: f64 = 1e-3;
/// Smallest singular value over the largest, to about 1 %, that is above every threshold.
const REGULAR: f64 = 2.0 * LARGEST_THRESHOLD;
/// A residual below this is one of numbers with few digits, lengths over L and rad.
const FEW_DIGITS: f64 = 1e-4;

/// The first joint whose axes point against each other though they are to be parallel.
pub(crate) fn reversed(loops: &Loops, poses: &[Pose]) -> Option<String> {
    let joints = loops.mechanism.joints().iter().zip(loops.frames(poses, &[]));
    let found = joints.into_iter().find(|(joint, at)| is_reversed(&joint.kind.rows(), at));
    found.map(|(joint, _)| joint.name.clone())
}

/// Closes the loops with the drives at given values, by steps of least squares and least length.
pub(crate) fn close_from_afar(
    loops: &Loops,
    poses: Vec<Pose>,
    drives: &[f64],
    is_stopped: IsStopped,
) -> Result<Vec<Pose>, ClosureError> {
    close_within(loops, poses, drives, MAX_STEPS, is_stopped)
}

/// The same with at most so many steps.
pub(crate) fn close_within(
    loops: &Loops,
    mut poses: Vec<Pose>,
    drives: &[f64],
    max_steps: usize,
    is_stopped: IsStopped,
) -> Result<Vec<Pose>, ClosureError> {
    let mut is_last = false;
    let mut left = Vec::new();
    for _ in 0..max_steps {
        if is_stopped() {
            return Err(ClosureError::Stopped);
        }
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
                size if size <= FEW_DIGITS && has_redundant_rows(loops, &poses) => Err(ClosureError::FewDigits(open)),
                _ => Err(ClosureError::Contradiction(open)),
            };
        }
        is_last = length < LAST_STEP;
    }
    Err(ClosureError::DoesNotClose(open_joint(loops, &left)))
}

fn has_redundant_rows(loops: &Loops, poses: &[Pose]) -> bool {
    let values = singular_values(loops, &loops.frames(poses, &[]));
    values.rank(LARGEST_THRESHOLD) < loops.rows.len()
}

/// The loop equations themselves, where they are as many as the unknowns and all singular values count, whatever the threshold.
pub(crate) fn regular(loops: &Loops, frames: &[JointFrames]) -> Option<Bordered> {
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
