//! A quantity whose extremes are sought.

use crate::data::direction::{Direction, extreme};
use crate::estimators::index::index_resolution;
use crate::search::models::noise::Noise;

/// Resolution of a search as a share of the range of its target: gains below it are not pursued, so it is always conceded.
pub(crate) const SEARCH_RESOLUTION: f64 = 1e-6;

/// A quantity known at every point, whose extremes are sought.
#[derive(Debug, Clone)]
pub(crate) struct Target {
    /// Value at every point; NaN if it is undefined.
    pub values: Vec<f64>,
    /// How it is modelled.
    pub kind: TargetKind,
    /// Sampling noise of the values.
    pub noise: Noise,
    /// Gains below these are not worth a point: of the minimum, of the maximum; of an index, gains of its probability.
    pub resolutions: [f64; 2],
}

/// How a target is modelled.
#[derive(Debug, Clone)]
pub(crate) enum TargetKind {
    /// As it is.
    Plain,
    /// As the index of a probability.
    Index,
    /// As the index of either of two events that exclude each other, by the indices of both at every point: it has a kink or a ridge
    /// where one takes over from the other, which each of them alone has not.
    Either([Vec<f64>; 2]),
}

impl Target {
    /// Greatest less least value.
    pub fn range(&self) -> f64 {
        let range = extreme(&self.values, Direction::Maximum) - extreme(&self.values, Direction::Minimum);
        range.max(0.0)
    }

    /// The gain that is always conceded, with the sign of `direction`.
    pub fn conceded(&self, direction: Direction) -> f64 {
        direction.sign() * SEARCH_RESOLUTION * self.range()
    }

    /// The least gain that is worth a point where `attained` is the extreme.
    pub fn resolution(&self, direction: Direction, attained: f64) -> f64 {
        let least = self.resolutions[direction.index()];
        match self.kind {
            TargetKind::Plain => least,
            TargetKind::Index | TargetKind::Either(_) => index_resolution(attained, least),
        }
    }
}
