//! A position that closes all loops.

use crate::closure::bordered::Borders;
use crate::closure::loops::Loops;
use crate::closure::step::Place;
use crate::mechanism::drive::DriveValue;
use loosepin_math::Pose;

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
    /// Smallest singular value that counts over the largest, to about 1 %; small near change points and dead positions.
    pub singular_ratio: f64,
    /// Whether the start poses lead to no closed position, so that the motion began at the nearest that was found around them.
    pub is_other_start: bool,
    pub(crate) borders: Borders,
}

impl Position {
    /// The position of a place on the way.
    pub(crate) fn new(loops: &Loops, drives: &[DriveValue], place: &Place) -> Self {
        Self {
            input: place.input,
            drives: drives.to_vec(),
            poses: place.poses.clone(),
            rank: loops.unknowns() - place.borders.right.len(),
            singular_ratio: place.singular_ratio,
            is_other_start: place.is_other_start,
            borders: place.borders.clone(),
        }
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
