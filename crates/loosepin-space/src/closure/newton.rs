//! Newton's method for the loops.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::loops::Loops;
use crate::geometry::pose::Pose;
use crate::kind::frames::{JointFrames, MarkerShift};

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
    let system_at =
        |frames: &[JointFrames]| Bordered::new(&loops.jacobian(frames), loops.rows.len(), loops.unknowns(), borders);
    let mut poses = poses.to_vec();
    let mut own: Option<Bordered> = None;
    let (mut way, mut before) = (0.0, f64::INFINITY);
    for _ in 0..MAX_STEPS {
        let frames = loops.frames(&poses, shifts);
        if own.is_none() && known.is_none() {
            own = Some(system_at(&frames));
        }
        let Some(system) = own.as_ref().or(known) else { return Err(NotClosed) };
        let residual: Vec<f64> = loops.residual(&frames, drives).iter().map(|value| -value).collect();
        let (step, apart) = system.solve(&residual);
        let size = largest(&step);
        let is_known = own.is_none();
        if !(size <= LONGEST_STEP) {
            if !is_known {
                return Err(NotClosed);
            }
            own = Some(system_at(&frames));
            continue;
        }
        way += size;
        poses = loops.moved(&poses, &step);
        if size < LAST_STEP || (size < SMALL_STEP && size > 0.5 * before) {
            let frames = loops.frames(&poses, shifts);
            return Ok(Closed { system: system_at(&frames), frames, poses, apart, way });
        }
        if size > CONTRACTION * before || size > LARGE_STEP {
            own = Some(system_at(&loops.frames(&poses, shifts)));
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
