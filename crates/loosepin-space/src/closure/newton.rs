//! Newton's method for the loops.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::loops::Loops;
use crate::kind::frames::{JointFrames, MarkerShift};
use loosepin_math::Pose;

/// Most steps; four are usual, with an old system seven.
const MAX_STEPS: usize = 40;
/// A step below this, lengths over L and rad, is round-off.
const LAST_STEP: f64 = 1e-14;
/// A step below this may be the last one, where the next is no smaller.
const SMALL_STEP: f64 = 1e-9;
/// Longest step, lengths over L and rad.
const LONGEST_STEP: f64 = 1.0;
/// A step above this changes the system by more than an old one is good for.
const LARGE_STEP: f64 = 0.03;
/// A step that is a larger share of the one before asks for a new system.
const CONTRACTION: f64 = 0.1;
/// Poses that are nearer to each other, lengths over L and rad, have one system.
const SAME_PLACE: f64 = 1e-13;

/// Poses that close the loops as far as they can.
#[derive(Debug, Clone)]
pub(crate) struct Closed {
    pub poses: Vec<Pose>,
    pub frames: Vec<JointFrames>,
    /// The system at these poses.
    pub system: Bordered,
    /// How far redundant rows are from closing, in the basis of the borders: lengths over L and rad.
    pub apart: Vec<f64>,
    /// Sum of the steps.
    pub way: f64,
}

/// Why no poses were found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct NotClosed;

/// Solves Φ(x) + N ν = 0, Vᵀ(x - x0) = 0 for poses x and the part ν of redundant rows that does not close, from poses close by. The system of
/// a position close by, if there is one, is used until it is not good enough.
pub(crate) fn close(
    loops: &Loops,
    poses: &[Pose],
    shifts: &[MarkerShift],
    drives: &[f64],
    borders: &Borders,
    known: Option<&Bordered>,
) -> Result<Closed, NotClosed> {
    let mut poses = poses.to_vec();
    let (mut bodies, mut frames, mut step) = (Vec::new(), Vec::new(), Vec::new());
    loops.frames_into(&poses, shifts, &mut bodies, &mut frames);
    // The system of a pose on the way, if there is one, and how far from there the poses are now.
    let (mut own, mut has_own, mut since) = (Bordered::default(), false, 0.0);
    if known.is_none() {
        own.factor(loops, &frames, borders);
        has_own = true;
    }
    let (mut way, mut before) = (0.0, f64::INFINITY);
    for _ in 0..MAX_STEPS {
        step.clear();
        step.extend(loops.residuals(&frames, drives).map(|value| -value));
        match known.filter(|_| !has_own) {
            Some(known) => known.solve_in_place(&mut step),
            None => own.solve_in_place(&mut step),
        }
        let size = largest(&step[..loops.unknowns()]);
        if !(size <= LONGEST_STEP) {
            if has_own {
                return Err(NotClosed);
            }
            own.factor(loops, &frames, borders);
            (has_own, since) = (true, 0.0);
            continue;
        }
        way += size;
        since += size;
        loops.move_poses(&mut poses, &step);
        loops.frames_into(&poses, shifts, &mut bodies, &mut frames);
        if size < LAST_STEP || (size < SMALL_STEP && size > 0.5 * before) {
            if !has_own || since > SAME_PLACE {
                own.factor(loops, &frames, borders);
            }
            let apart = step.split_off(loops.unknowns());
            return Ok(Closed { system: own, frames, poses, apart, way });
        }
        if size > CONTRACTION * before || size > LARGE_STEP {
            own.factor(loops, &frames, borders);
            (has_own, since) = (true, 0.0);
        }
        before = size;
    }
    Err(NotClosed)
}

/// The largest magnitude; NaN where an entry is.
pub(crate) fn largest(values: &[f64]) -> f64 {
    let larger = |largest: f64, value: &f64| {
        if largest.is_nan() || value.is_nan() { f64::NAN } else { largest.max(value.abs()) }
    };
    values.iter().fold(0.0, larger)
}
