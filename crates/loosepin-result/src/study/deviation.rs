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

    /// Whether it is the output itself, and no deviation.
    pub const fn is_value(self) -> bool {
        matches!(self, Deviation::Value)
    }

    /// Whether it counts from the ideal motion with the dimensions of the drawing, not from that of the same mechanism without clearance.
    pub const fn is_from_drawing(self) -> bool {
        matches!(self, Deviation::Total | Deviation::Dimensional)
    }

    /// What makes it, in words; `None` where all of it is meant.
    pub const fn cause(self) -> Option<&'static str> {
        match self {
            Deviation::Value | Deviation::Total => None,
            Deviation::Dimensional => Some("part scatter"),
            Deviation::Clearance => Some("play"),
        }
    }
}
