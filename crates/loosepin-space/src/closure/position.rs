//! A position that closes all loops.

use crate::closure::bordered::Borders;
use crate::closure::loops::Loops;
use crate::geometry::pose::Pose;
use crate::kind::frames::JointFrames;
use crate::mechanism::drive::DriveValue;
use loosepin_math::SingularValues;

/// Singular values below this, relative to the largest, count as zero.
pub const RANK_THRESHOLD: f64 = 1e-9;

/// A closed position of the ideal mechanism, with what the loop equations are there.
#[derive(Debug, Clone)]
pub struct Position {
    /// The input of the cycle.
    pub input: f64,
    /// What the drives prescribe.
    pub drives: Vec<DriveValue>,
    /// Pose of each body.
    pub poses: Vec<Pose>,
    /// Rank of the loop equations, drives included.
    pub rank: usize,
    /// Smallest singular value that counts over the largest; small near change points and dead positions.
    pub singular_ratio: f64,
    pub(crate) borders: Borders,
}

impl Position {
    /// The position at closed poses, with null spaces from singular values.
    pub(crate) fn new(loops: &Loops, input: f64, drives: &[DriveValue], poses: Vec<Pose>) -> Self {
        let values = singular_values(loops, &loops.frames(&poses, &[]));
        let rank = values.rank(RANK_THRESHOLD);
        let borders = Borders::new(&values, rank);
        Self { input, drives: drives.to_vec(), poses, rank, singular_ratio: ratio(&values, rank), borders }
    }

    /// Number of rows that repeat others here.
    pub fn redundant_rows(&self) -> usize {
        self.borders.left.len()
    }

    /// Dimensions of the motions that are left with the drives held; of a driven mechanism those of idle parts.
    pub fn free_motions(&self) -> usize {
        self.borders.right.len()
    }

    /// f of each drive.
    pub fn drive_values(&self) -> Vec<f64> {
        self.drives.iter().map(|drive| drive.value).collect()
    }
}

/// Singular values of the loop equations, drives included.
pub(crate) fn singular_values(loops: &Loops, frames: &[JointFrames]) -> SingularValues {
    SingularValues::new(&loops.jacobian(frames), loops.rows.len(), loops.unknowns())
}

/// The smallest singular value that counts over the largest.
pub(crate) fn ratio(values: &SingularValues, rank: usize) -> f64 {
    let smallest = rank.checked_sub(1).and_then(|k| values.values().get(k));
    smallest.zip(values.values().first()).map_or(1.0, |(smallest, largest)| smallest / largest)
}
