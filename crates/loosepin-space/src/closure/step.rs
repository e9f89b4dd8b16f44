//! From one input to another along the motion, never onto another branch.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::error::{ClosureError, DrivePlace};
use crate::closure::loops::{Loops, PlacedRow};
use crate::closure::newton::{close, largest};
use crate::closure::singular::{RANK_THRESHOLD, ratio, singular_values};
use crate::kind::frames::within_half_a_turn;
use crate::mechanism::drive::JointCoordinate;
use crate::stop::IsStopped;
use loosepin_math::Pose;

/// Longest prediction, lengths over L and rad.
const LONGEST_PREDICTION: f64 = 0.3;
/// Most steps of such a length along a cycle: 1000 turns of a drive, and about 20 s of an arm with six axes.
const MAX_STEPS: usize = 21_000;
/// What Newton's method may add to a prediction, as a share of it: more is a hint at another branch.
const LARGEST_CORRECTION: f64 = 0.2;
/// A correction that is round-off.
const SMALL_CORRECTION: f64 = 1e-10;
/// Shortest step, as a share of the whole: 2^-26.
const SHORTEST_SHARE: f64 = 1.5e-8;
/// Largest part of the drive's own rows in a self-stress that does not stop the drive, relative to its rate.
const SILENT_DRIVE: f64 = 1e-3;
/// A singular position: positions beside it cannot be told from those of another branch.
const SINGULAR: f64 = 1e-8;
/// Singular values below this relative to the largest are those of a singular position close by.
const NEARLY_SINGULAR: f64 = 1e-3;

/// Where a motion is.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    pub input: f64,
    pub poses: Vec<Pose>,
    pub borders: Borders,
    /// Sign of the bordered determinant, the same along a branch.
    pub sign: f64,
    /// Smallest singular value of the bordered equations over the largest.
    pub singular_ratio: f64,
    /// Whether the motion began elsewhere than the start poses lead to.
    pub is_other_start: bool,
}

impl Place {
    pub(crate) fn new(loops: &Loops, input: f64, poses: Vec<Pose>, borders: Borders) -> Self {
        let frames = loops.frames(&poses, &[]);
        let system = Bordered::new(loops, &frames, &borders);
        let singular_ratio = system.singular_ratio(loops, &frames, &borders);
        Self { input, poses, borders, sign: system.sign(), singular_ratio, is_other_start: false }
    }
}

/// Values of all drives over the input.
pub(crate) type DriveFunction<'a> = &'a dyn Fn(f64) -> Vec<f64>;

/// Refuses a way of the drives, from each of these values to the next, that takes too many steps.
pub(crate) fn check_way(loops: &Loops, mut values: impl Iterator<Item = Vec<f64>>) -> Result<(), ClosureError> {
    let mut ways = vec![0.0; loops.rows.len()];
    let Some(mut before) = values.next() else { return Ok(()) };
    for after in values {
        let changes = drive_changes(loops, &before, &after);
        ways.iter_mut().zip(changes).for_each(|(way, change)| *way += change.abs());
        before = after;
    }
    let longest = (0..ways.len()).max_by(|a, b| ways[*a].total_cmp(&ways[*b]));
    let Some(row) = longest else { return Ok(()) };
    let steps = ways[row] / LONGEST_PREDICTION;
    if steps <= MAX_STEPS as f64 {
        return Ok(());
    }
    let joint = loops.mechanism.joints()[loops.rows[row].joint].name.clone();
    Err(ClosureError::TooLong { joint, steps, most: MAX_STEPS })
}

/// Follows the motion from `from` to the input `target`, until it is stopped.
pub(crate) fn follow(
    loops: &Loops,
    from: &Place,
    target: f64,
    drives: DriveFunction,
    is_stopped: IsStopped,
) -> Result<Place, ClosureError> {
    let whole = target - from.input;
    let (here, there) = (drives(from.input), drives(target));
    let change = drive_changes(loops, &here, &there);
    let work = |stress: &Vec<f64>| stress.iter().zip(&change).map(|(a, b)| a * b).sum::<f64>().abs();
    if from.borders.left.iter().any(|stress| work(stress) > SILENT_DRIVE * largest(&change)) {
        return Err(ClosureError::DriveHeld { place: place_of(loops, from.input, &here, &there) });
    }
    let (mut at, mut step) = (from.clone(), whole);
    while at.input != target {
        if is_stopped() {
            return Err(ClosureError::Stopped);
        }
        // What is left is no more than round-off beyond the step: then it is the last one.
        let next = if (target - at.input).abs() <= step.abs() * (1.0 + 1e-9) { target } else { at.input + step };
        if let Some(place) = attempt(loops, &at, next, drives) {
            at = place;
            step *= 2.0;
        } else {
            step = 0.5 * (next - at.input);
            if !(step.abs() > SHORTEST_SHARE * whole.abs()) {
                return Err(diagnose(loops, &at, next, drives));
            }
        }
    }
    Ok(at)
}

/// One step: along the tangent, then Newton's method. `None` if it may have left the branch.
fn attempt(loops: &Loops, at: &Place, next: f64, drives: DriveFunction) -> Option<Place> {
    let frames = loops.frames(&at.poses, &[]);
    let system = Bordered::new(loops, &frames, &at.borders);
    let (before, after) = (drives(at.input), drives(next));
    let (prediction, _) = system.solve(&drive_changes(loops, &before, &after));
    let length = largest(&prediction);
    if !(length <= LONGEST_PREDICTION) {
        return None;
    }
    let closed = close(loops, &loops.moved(&at.poses, &prediction), &[], &after, &at.borders, None).ok()?;
    let is_near = closed.way <= LARGEST_CORRECTION * length + SMALL_CORRECTION;
    let is_closed = largest(&closed.apart) <= CLOSED;
    if !is_near || !is_closed || closed.system.sign() != at.sign {
        return None;
    }
    let singular_ratio = closed.system.singular_ratio(loops, &closed.frames, &at.borders);
    let borders = closed.system.null_spaces()?;
    (singular_ratio > SINGULAR).then_some(Place {
        input: next,
        poses: closed.poses,
        borders,
        sign: at.sign,
        singular_ratio,
        is_other_start: at.is_other_start,
    })
}

/// What redundant rows may be apart: round-off of the numbers of a model with nine digits.
pub(crate) const CLOSED: f64 = 1e-8;

/// Change of the right-hand sides, the drives' rows alone.
fn drive_changes(loops: &Loops, before: &[f64], after: &[f64]) -> Vec<f64> {
    let rows = loops.rows.iter();
    rows.map(|row| match row.drive {
        Some(drive) => (after[drive] - before[drive]) / loops.scale(row),
        None => 0.0,
    })
    .collect()
}

/// Why the motion cannot be followed beyond `at`.
fn diagnose(loops: &Loops, at: &Place, next: f64, drives: DriveFunction) -> ClosureError {
    let frames = loops.frames(&at.poses, &[]);
    let place = place_of(loops, at.input, &drives(at.input), &drives(next));
    let values = singular_values(loops, &frames);
    let (counted, rank) = (values.rank(RANK_THRESHOLD), loops.unknowns() - at.borders.right.len());
    if counted > rank {
        return ClosureError::RankChanges { place, before: rank, here: counted };
    }
    if rank == 0 || ratio(&values, rank) > NEARLY_SINGULAR {
        if at.borders.left.is_empty() {
            return ClosureError::NotFollowed { place };
        }
        let is_of_drive = |(row, entry): (&PlacedRow, &f64)| row.drive.is_some() && entry.abs() > SILENT_DRIVE;
        let is_of_drives = at.borders.left.iter().any(|stress| loops.rows.iter().zip(stress).any(is_of_drive));
        return ClosureError::Diverges { place, is_of_drives };
    }
    // A self-stress of the nearly singular position: where the drive does work in it, the drive stops.
    let stress = values.left(rank - 1);
    let change = drive_changes(loops, &drives(at.input), &drives(next));
    let work: f64 = stress.iter().zip(&change).map(|(a, b)| a * b).sum();
    let motion = values.right(rank - 1);
    let joint = loops.mechanism.joints()[loops.most_moving_joint(&frames, motion)].name.clone();
    if work.abs() > SILENT_DRIVE * largest(&change) {
        ClosureError::Locked { place, joint }
    } else {
        ClosureError::ChangePoint { place, joint }
    }
}

/// A place in words' ingredients: the first drive that moves, and its value.
fn place_of(loops: &Loops, input: f64, here: &[f64], next: &[f64]) -> DrivePlace {
    let moving = here.iter().zip(next).position(|(a, b)| a != b).or_else(|| (!here.is_empty()).then_some(0));
    let drive = moving.and_then(|number| loops.mechanism.drives().get(number).zip(here.get(number)));
    let driven_joint = drive.map_or(String::new(), |(drive, _)| loops.mechanism.joints()[drive.joint].name.clone());
    let is_length = drive.is_some_and(|(drive, _)| drive.coordinate == JointCoordinate::Slide);
    DrivePlace { input, driven_joint, value: drive.map_or(0.0, |(_, value)| *value), is_length }
}

/// A target that is the nearest to `from` of those that differ by whole turns, for drives that are angles.
pub(crate) fn nearest_values(loops: &Loops, from: &[f64], target: &[f64]) -> Vec<f64> {
    let drives = loops.mechanism.drives().iter();
    drives
        .zip(from.iter().zip(target))
        .map(|(drive, (from, target))| match drive.coordinate {
            JointCoordinate::Angle => from + within_half_a_turn(target - from),
            JointCoordinate::Slide => *target,
        })
        .collect()
}
