//! Followed quantities and their findings.

use crate::ideal::curve::IdealCurve;
use loosepin_mechanics::model::Reading;
use loosepin_result::study::Deviation;
use std::sync::Arc;

/// Quantities followed in every run of a batch.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Follow {
    /// Numbers that are read at both ends of every step. Those whose deviations are followed, or that are asked for at instants, must be
    /// positions or angles.
    pub readings: Vec<Reading>,
    /// Deviations that are reduced over the recorded part.
    pub deviations: Vec<FollowedDeviation>,
    /// Errors of points from their ideal paths that are reduced over the recorded part.
    pub paths: Vec<FollowedPath>,
    /// Readings of any kind whose values are reduced over the recorded part; of a motion that is integrated.
    pub inside: Vec<Reading>,
}

/// A deviation that is reduced over the recorded part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedDeviation {
    /// Index in [`Follow::readings`].
    pub reading: usize,
    /// Which deviation.
    pub deviation: Deviation,
    /// Whether its integrals are asked for as well, not its extremes alone.
    pub is_integrated: bool,
}

/// The error of a point from its ideal path, reduced over the recorded part. [`Deviation::Value`] has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FollowedPath {
    /// Indices in [`Follow::readings`] of x and y of the point.
    pub readings: [usize; 2],
    /// From which ideal path.
    pub deviation: Deviation,
    /// Whether each part is asked for, in the order of [`loosepin_result::study::PathError::ALL`].
    pub parts: [bool; 4],
    /// Whether integrals are asked for as well, not extremes alone.
    pub is_integrated: bool,
}

/// References of one followed run.
#[derive(Debug, Clone, Default)]
pub struct FollowedRun {
    /// Instants in the recorded part at which all readings are asked for, in order, s; runs with the same ones share them.
    pub instants_s: Arc<[f64]>,
    /// The nominal ideal motion, with which total and dimensional deviations compare, and the own one of the sample, with which dimensional
    /// and clearance deviations do: by reading, over the recorded part. Both have the same nodes.
    pub nominal: Option<Arc<IdealCurve>>,
    /// The own one.
    pub own: Option<Arc<IdealCurve>>,
}

/// Findings of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Findings {
    /// All readings at the first instant, then at the next.
    pub at_instants: Vec<f64>,
    /// Deviations, in the order of [`Follow::deviations`].
    pub deviations: Vec<DeviationRange>,
    /// The parts of each path, in the order of [`Follow::paths`] and [`loosepin_result::study::PathError::ALL`].
    pub paths: Vec<[DeviationRange; 4]>,
    /// Values, in the order of [`Follow::inside`].
    pub inside: Vec<DeviationRange>,
}

/// A deviation over the recorded part of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeviationRange {
    /// Its largest value.
    pub largest: f64,
    /// Its smallest value.
    pub smallest: f64,
    /// Its integral over time; zero where that is not asked for.
    pub integral: f64,
    /// The integral of its square.
    pub integral_of_square: f64,
}

impl DeviationRange {
    /// Of no step yet.
    pub const NONE: Self =
        Self { largest: f64::NEG_INFINITY, smallest: f64::INFINITY, integral: 0.0, integral_of_square: 0.0 };
}

impl Follow {
    /// Reads these at both ends of every step, and nothing more.
    pub fn readings(readings: &[Reading]) -> Self {
        Self { readings: readings.to_vec(), ..Self::default() }
    }
}
