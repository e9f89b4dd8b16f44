//! Newton's method for the loops.

use crate::closure::bordered::{Bordered, Borders};
use crate::closure::loops::Loops;
use crate::geometry::pose::Pose;
use crate::kind::frames::{JointFrames, MarkerShift};

/// Most steps; four are usual.
const MAX_STEPS: usize = 25;
/// A step below this, lengths over L and rad, is the last one: the next would be its square.
const LAST_STEP: f64 = 1e-9;
/// Longest step, lengths over L and rad.
const LONGEST_STEP: f64 = 1.0;

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

/// Solves Φ(x) + N ν = 0, Vᵀ(x - x0) = 0 for poses x and the part ν of redundant rows that does not close, from poses close by.
pub(crate) fn close(
    loops: &Loops,
    poses: &[Pose],
    shifts: &[MarkerShift],
    drives: &[f64],
    borders: &Borders,
) -> Result<Closed, NotClosed> {
    let mut poses = poses.to_vec();
    let mut way = 0.0;
    let mut is_last = false;
    for _ in 0..MAX_STEPS {
        let frames = loops.frames(&poses, shifts);
        let system = Bordered::new(&loops.jacobian(&frames), loops.rows.len(), loops.unknowns(), borders);
        let residual: Vec<f64> = loops.residual(&frames, drives).iter().map(|value| -value).collect();
        let (step, apart) = system.solve(&residual);
        let size = largest(&step);
        if !(size <= LONGEST_STEP) {
            return Err(NotClosed);
        }
        if is_last {
            // The system is one step old, a round-off away.
            let poses = loops.moved(&poses, &step);
            return Ok(Closed { frames: loops.frames(&poses, shifts), poses, system, apart, way });
        }
        way += size;
        is_last = size < LAST_STEP;
        poses = loops.moved(&poses, &step);
    }
    Err(NotClosed)
}

/// The largest magnitude; NaN where an entry is.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| if value.is_nan() { *value } else { largest.max(value.abs()) })
}
