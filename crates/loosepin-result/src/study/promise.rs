//! Bounds that a share of the box of the epistemic inputs keeps, without a model.

use serde::{Deserialize, Serialize};

use super::bound::{ResponsePoint, Witness};
use super::figures::CurveRange;
use loosepin_terms::{Deviation, Side, Statistic};
use loosepin_text::units::{SiUnit, extended};

/// The promise: with `confidence`, each of the ends is kept by at least `share` of the box. That is the same share for each, not of values
/// at which all are kept.
///
/// The box is that of the intervals in the coordinates of the file, and its share one of volume: no probability of the true values.
/// Every combination of the members of lists and every focal element has a box of its own, of which this holds by itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PromiseRecord {
    /// Share of the volume of each box, in (0, 1).
    #[serde(with = "extended")]
    pub share: f64,
    /// Confidence that it is so for all ends together, in (0, 1).
    #[serde(with = "extended")]
    pub confidence: f64,
    /// Boxes.
    pub boxes: u64,
    /// Values of the epistemic inputs in each box: fixed beforehand, independent and uniform.
    pub values: u64,
    /// Runs at each value; 1 where nothing is random.
    pub inner: u64,
    /// Probability that the limit at one value fails, at most; 0 where nothing is random.
    #[serde(with = "extended")]
    pub miss: f64,
    /// All runs.
    pub runs: u64,
    /// The promised ends.
    pub ends: Vec<PromisedEnd>,
    /// The promised bands over curves, each one end more.
    pub bands: Vec<PromisedBand>,
}

/// One promised band over a whole curve.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PromisedBand {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Share of mechanisms that stay inside for the whole cycle, in (0, 1).
    #[serde(with = "extended")]
    pub share: f64,
    /// How many times as wide it is as the band of the same share at each pose by itself.
    #[serde(with = "extended")]
    pub factor: f64,
    /// The band, pose by pose of the curve.
    pub band: CurveRange,
    /// The epistemic inputs with the largest factor.
    pub witness: Witness,
    /// Values at which a run failed, so that nothing is promised.
    pub failed_values: u64,
}

/// One promised end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PromisedEnd {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle: `whole` means everywhere.
    pub at: ResponsePoint,
    /// The statistic.
    pub statistic: Statistic,
    /// Unit of the bound: that of the output, or `1` for a probability.
    pub unit: SiUnit,
    /// Which end of it.
    pub side: Side,
    /// The bound: the furthest of the limits at all values.
    #[serde(with = "extended")]
    pub bound_si: f64,
    /// The epistemic inputs with the furthest limit.
    pub witness: Witness,
    /// Values at which a run failed, so that nothing is promised.
    pub failed_values: u64,
}
