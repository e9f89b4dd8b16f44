//! Held-out errors of a surrogate in a word.

use serde::{Deserialize, Serialize};

/// Verdict of the held-out errors of a surrogate: whether its residual falls with more runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SurrogateVerdict {
    /// All runs gave the same.
    Constant,
    /// The residual is negligible.
    Resolved,
    /// The error falls with more runs.
    Falling,
    /// Part of the response is learned, and the rest does not fall with more runs, or only to a limit not far below: noise, or chaos.
    Floor,
    /// Nothing is learned: the response is noise for this surrogate.
    Nothing,
    /// The response jumps: few errors are large, most are small.
    Jump,
    /// Too few runs for a verdict; the residual is kept as if it did not fall.
    Unknown,
}

impl SurrogateVerdict {
    /// Whether the rest is part of the surrogate.
    pub fn keeps_residual(self) -> bool {
        matches!(self, Self::Floor | Self::Nothing | Self::Jump | Self::Unknown)
    }
}
