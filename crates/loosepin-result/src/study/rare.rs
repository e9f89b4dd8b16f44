//! Small probabilities: how they were estimated.

use serde::{Deserialize, Serialize};

use super::bound::ResponsePoint;
use loosepin_terms::{Deviation, Statistic};
use loosepin_text::units::extended;

/// How the bounds of one small probability were estimated; the bounds themselves stand among the others.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RareRecord {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle.
    pub at: ResponsePoint,
    /// The probability.
    pub statistic: Statistic,
    /// The smallest probability.
    pub lower: RareEnd,
    /// The largest probability.
    pub upper: RareEnd,
}

/// One end.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RareEnd {
    /// The means.
    pub method: RareMethodUsed,
    /// The estimate.
    #[serde(with = "extended")]
    pub probability: f64,
    /// Its standard error.
    #[serde(with = "extended")]
    pub standard_error: f64,
    /// Reliability index: distance of the nearest design point, in standard deviations; `None` by subset simulation.
    #[serde(with = "extended")]
    pub reliability_index: Option<f64>,
    /// Runs of this estimate, without those of the search for where it is.
    pub runs: u64,
    /// Failed runs: no event at the lower end, the event at the upper one.
    pub failed: u64,
}

/// The means of an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RareMethodUsed {
    /// Sampling around design points.
    Importance,
    /// Subset simulation.
    Subset,
}
