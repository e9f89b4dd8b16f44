//! The record of what narrower intervals gain: the bounds of a study with its intervals before and after an identification.

use loosepin_text::units::SiUnit;
use serde::{Deserialize, Serialize};

/// Bounds of the study before and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Gain {
    /// The main answer of both, in a sentence.
    pub headline: String,
    /// How far the band of each curve reaches in both, in a sentence each.
    pub bands: Vec<String>,
    /// Bounds of single statistics.
    pub bounds: Vec<GainedBound>,
    /// Runs behind each of the two.
    pub runs: [u64; 2],
}

/// The bound of a statistic, before and after.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GainedBound {
    /// The response, in words.
    pub response: String,
    /// Which statistic, in words.
    pub statistic: String,
    /// Its unit.
    pub unit: SiUnit,
    /// Whether it is a probability.
    pub is_probability: bool,
    /// The smallest and the largest value that it may have, numerical error included, SI: with the intervals of the study.
    pub before_si: [f64; 2],
    /// The same with the narrower ones.
    pub after_si: [f64; 2],
}
