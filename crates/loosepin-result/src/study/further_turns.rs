//! Turns after the recorded ones, where the motion does not repeat itself.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

use loosepin_terms::{Deviation, Reduction};

/// How much further outputs go in turns after the recorded ones: measured on some of the runs whose motion does not repeat itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FurtherTurns {
    /// Turns after the recorded ones.
    pub turns: u32,
    /// Runs that were continued and came to their end, spread evenly over those whose motion does not repeat itself.
    pub runs: u64,
    /// The examined outputs: every largest or smallest value of the study.
    pub outputs: Vec<FurtherOutput>,
    /// Number of these runs that keep the limit in the recorded turns and leave it in the turns after them, for each of
    /// [`super::StudyResult::requirements`]; `None` if it is not of the whole cycle.
    pub broken_later: Vec<Option<u64>>,
}

/// A largest or smallest value, or a range, with more turns recorded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FurtherOutput {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Largest, smallest, or largest magnitude over the turns, or the range.
    pub reduction: Reduction,
    /// Mean excess in the turns after the recorded ones over the runs, SI, >= 0.
    #[serde(with = "extended")]
    pub mean_excess_si: f64,
    /// Largest excess, SI, >= 0.
    #[serde(with = "extended")]
    pub largest_excess_si: f64,
}
