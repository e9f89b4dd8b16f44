//! Singular values of the loop equations.

use crate::closure::loops::Loops;
use crate::kind::frames::JointFrames;
use loosepin_math::SingularValues;

/// Singular values below this, relative to the largest, count as zero.
pub const RANK_THRESHOLD: f64 = 1e-9;

/// Singular values of the loop equations, drives included.
pub(crate) fn singular_values(loops: &Loops, frames: &[JointFrames]) -> SingularValues {
    SingularValues::new(&loops.jacobian(frames), loops.rows.len(), loops.unknowns())
}

/// The smallest singular value that counts over the largest.
pub(crate) fn ratio(values: &SingularValues, rank: usize) -> f64 {
    let smallest = rank.checked_sub(1).and_then(|k| values.values().get(k));
    smallest.zip(values.values().first()).map_or(1.0, |(smallest, largest)| smallest / largest)
}
