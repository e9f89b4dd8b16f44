//! An extreme deviation, and how it is searched.

use loosepin_math::Pose;

/// How a worst case is searched.
#[derive(Debug, Clone, PartialEq)]
pub struct SearchOptions {
    /// Starts in addition to the middle, the worst case of first order and two that take the loops away from, and to, their nearest dead position:
    /// worst cases of random outputs. Default 8.
    pub random_starts: usize,
    /// Seed of the random outputs. Default 1.
    pub seed: u64,
    /// Further starts: variables of play, m, such as those of the extremes at a neighbouring position. Those of another length are left out.
    pub starts_m: Vec<Vec<f64>>,
}

impl Default for SearchOptions {
    fn default() -> Self {
        Self { random_starts: 8, seed: 1, starts_m: Vec::new() }
    }
}

/// An extreme deviation with the places of the journals that make it.
#[derive(Debug, Clone, PartialEq)]
pub struct Extreme {
    /// The deviation, m or rad.
    pub deviation: f64,
    /// Variables of play, m: the witness.
    pub variables_m: Vec<f64>,
    /// Poses of all bodies there.
    pub poses: Vec<Pose>,
}
