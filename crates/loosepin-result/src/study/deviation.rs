//! Deviations of an output from the ideal motion.

use serde::{Deserialize, Serialize};

/// Deviation of an output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Deviation {
    /// The output itself.
    Value,
    /// Actual minus ideal with nominal dimensions.
    Total,
    /// Sampled dimensions without clearance, minus nominal.
    Dimensional,
    /// Sampled dimensions with clearance, minus the same without.
    Clearance,
}

impl Deviation {
    /// Word in study files, results and tables.
    pub const fn word(self) -> &'static str {
        match self {
            Deviation::Value => "value",
            Deviation::Total => "total",
            Deviation::Dimensional => "dimensional",
            Deviation::Clearance => "clearance",
        }
    }
}
