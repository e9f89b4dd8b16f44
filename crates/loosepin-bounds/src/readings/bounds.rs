//! All answers of a problem together.

use super::probability_box::ProbabilityBox;
use super::second_order::StatisticPercentiles;
use super::treatment::TreatmentComparison;
use crate::data::bound::{BoundPair, CutBounds};
use crate::data::gaps::Gaps;
use crate::data::problem::Reading;

/// Everything that the runs of a problem say.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// How the epistemic intervals are read.
    pub reading: Reading,
    /// One entry for each request but those for a whole distribution function, in their order.
    pub pairs: Vec<BoundPair>,
    /// Bounds over every α-cut, degrees increasing, if an input is a fuzzy number; else empty.
    pub levels: Vec<CutBounds>,
    /// Percentiles of bounds where a parameter of a distribution has a distribution itself: one entry for each of `pairs`; else empty.
    pub percentiles: Vec<StatisticPercentiles>,
    /// One entry for each request for a whole distribution function, in their order.
    pub boxes: Vec<ProbabilityBox>,
    /// One entry for each compared column, in their order.
    pub comparisons: Vec<TreatmentComparison>,
    /// Values of the epistemic inputs at every outer point, in the order of the outer index.
    pub outer_points: Vec<Vec<f64>>,
    /// Outer index of the centre of the epistemic box, discrete inputs at their first members.
    pub centre_point: u32,
    /// The gaps between these points, and between all values of the epistemic inputs that were run; `None` if there is one value.
    pub gaps: Option<Gaps>,
    /// Runs in the table.
    pub runs: usize,
    /// Failed runs in the table.
    pub failed_runs: usize,
    /// Rounds that the runs were made in.
    pub rounds: u32,
}
