//! How long the positions of a history can be trusted.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// How long the positions of a history can be trusted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Trust {
    /// Not measured: it was left out, the run failed, or the record is from an older version.
    #[default]
    NotMeasured,
    /// The motion is not integrated: all positions follow from the drives at each instant.
    Solved,
    /// Measured by a second run.
    Measured(MeasuredTrust),
}

/// Comparison with a second run, with a smaller tolerance and by a method of another order: positions of the first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeasuredTrust {
    /// Tolerance of the second run.
    #[serde(with = "extended")]
    pub tolerance_m: f64,
    /// Name of its method.
    pub method: String,
    /// Evaluations of the equations of motion that it took; absent where it was not run to its end.
    pub evaluations: Option<u64>,
    /// A position counts as right to a length while the runs differ by at most this share of it.
    #[serde(with = "extended")]
    pub share: f64,
    /// By length, largest first.
    pub horizons: Vec<TrustHorizon>,
    /// Accuracy of all positions of the history; absent if the runs part by more than `share` of the largest length, or if the second run
    /// did not finish.
    #[serde(with = "extended")]
    pub whole_m: Option<f64>,
    /// Why the second run did not finish; absent if it did, or if it was ended because the runs had parted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// Instants at which the runs were compared.
    #[serde(with = "extended")]
    pub time_s: Vec<f64>,
    /// The largest distance between two places of a point at these instants, or since the one before.
    #[serde(with = "extended")]
    pub difference_m: Vec<f64>,
}

/// How long positions can be trusted to a length.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TrustHorizon {
    /// The length.
    #[serde(with = "extended")]
    pub length_m: f64,
    /// The last instant before the runs part by more than they may; absent where they do so at the start of the history.
    #[serde(with = "extended")]
    pub until_s: Option<f64>,
    /// Turns from the start of the history to it.
    #[serde(with = "extended")]
    pub turns: Option<f64>,
    /// Whether that is the end of the history.
    pub is_end: bool,
}
