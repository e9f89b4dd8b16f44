//! Closed positions where the start poses lead to none: from other poses around them, and why there is none.

use crate::closure::error::ClosureError;
use crate::closure::from_afar::{close_from_afar, close_within, reversed};
use crate::closure::loops::Loops;
use crate::closure::singular::{RANK_THRESHOLD, singular_values};
use crate::random::random;
use crate::stop::IsStopped;
use loosepin_math::{Pose, Vec3};

/// How far bodies are turned, rad, and moved, over the characteristic length, in each round: at most so far along each axis.
const ROUNDS: [f64; 4] = [0.3, 0.8, 1.6, 3.0];
/// Poses that are tried in each round, and fewer of large mechanisms, whose steps take milliseconds.
const STARTS: usize = 6;
const STARTS_OF_LARGE: usize = 2;
/// Number of unknowns of a large mechanism.
const LARGE: usize = 60;
/// Most steps from each.
const MAX_STEPS: usize = 30;
/// Part of a turn that a body is moved as well.
const MOVED: f64 = 0.2;

/// Closed poses near the start poses with the drives at `drives`: of those that some starts around them lead to, the nearest. The same ones at each
/// call.
///
/// # Errors
/// What is open where the joints nearly close, if they do anywhere; that it was stopped.
pub(crate) fn closed_nearby(
    loops: &Loops,
    start: &[Pose],
    drives: &[f64],
    is_stopped: IsStopped,
) -> Result<Vec<Pose>, Option<ClosureError>> {
    let (mut state, mut nearly) = (1, None);
    let starts = if loops.unknowns() > LARGE { STARTS_OF_LARGE } else { STARTS };
    for size in ROUNDS {
        let mut closed: Vec<Vec<Pose>> = Vec::new();
        for _ in 0..starts {
            let other = changed(loops, start, size, &mut state);
            match close_within(loops, other, drives, MAX_STEPS, is_stopped) {
                Ok(poses) if reversed(loops, &poses).is_none() => closed.push(poses),
                Err(error @ ClosureError::FewDigits(_)) => nearly = nearly.or(Some(error)),
                Err(ClosureError::Stopped) => return Err(Some(ClosureError::Stopped)),
                _ => {}
            }
        }
        let distance = |poses: &[Pose]| distance(loops, start, poses);
        let nearest = closed.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
        if let Some(poses) = nearest {
            return Ok(poses);
        }
    }
    Err(nearly)
}

fn changed(loops: &Loops, start: &[Pose], size: f64, state: &mut u64) -> Vec<Pose> {
    let mut vector = || Vec3::new(random(state), random(state), random(state)) * size;
    let mut poses = start.to_vec();
    for pose in poses.iter_mut().skip(1) {
        let turn = vector();
        *pose = pose.moved(vector() * (MOVED * loops.length_m), turn);
    }
    poses
}

/// Sum of squares of turns, rad, and of displacements over the characteristic length.
fn distance(loops: &Loops, from: &[Pose], to: &[Pose]) -> f64 {
    let each = from.iter().zip(to).map(|(from, to)| {
        let (a, b) = (from.orientation, to.orientation);
        let half = libm::acos((a.w * b.w + a.vector.dot(b.vector)).abs().min(1.0));
        let moved = (to.position_m - from.position_m).length() / loops.length_m;
        4.0 * half * half + moved * moved
    });
    each.sum()
}

/// The error to be reported: if the joints close without the drives, it is the drives that contradict them.
pub(crate) fn why_open(loops: &Loops, start: &[Pose], found: ClosureError, is_stopped: IsStopped) -> ClosureError {
    let mut joints = loops.clone();
    joints.rows.retain(|row| row.drive.is_none());
    let drives = loops.mechanism.drives();
    let Some(first) = drives.first() else { return found };
    match close_from_afar(&joints, start.to_vec(), &[], is_stopped) {
        Ok(poses) if reversed(&joints, &poses).is_none() => {
            let rank = |own: &Loops| singular_values(own, &own.frames(&poses, &[])).rank(RANK_THRESHOLD);
            let joint = loops.mechanism.joints()[first.joint].name.clone();
            ClosureError::DrivesDoNotFit { joint, repeated: (rank(&joints) + drives.len()).saturating_sub(rank(loops)) }
        }
        Err(ClosureError::Stopped) => ClosureError::Stopped,
        _ => found,
    }
}
