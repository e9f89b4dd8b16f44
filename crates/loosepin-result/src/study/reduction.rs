//! Curves over the recorded turns as one number.

use serde::{Deserialize, Serialize};

/// How a curve over the recorded turns becomes one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reduction {
    /// The largest value, located between the samples.
    Maximum,
    /// The smallest value, located between the samples.
    Minimum,
    /// The largest magnitude, located between the samples.
    MaximumAbsolute,
    /// The root of the mean square.
    #[serde(rename = "rms")]
    RootMeanSquare,
    /// The mean over time.
    Mean,
    /// Maximum minus minimum.
    Range,
}

impl Reduction {
    /// Every reduction, in the order in which study files name them.
    pub const ALL: [Self; 6] =
        [Self::Maximum, Self::Minimum, Self::MaximumAbsolute, Self::RootMeanSquare, Self::Mean, Self::Range];

    /// The word used in study files and in results.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Maximum => "maximum",
            Self::Minimum => "minimum",
            Self::MaximumAbsolute => "maximum_absolute",
            Self::RootMeanSquare => "rms",
            Self::Mean => "mean",
            Self::Range => "range",
        }
    }

    /// Whether no curve gives a negative number.
    pub const fn is_never_negative(self) -> bool {
        matches!(self, Self::MaximumAbsolute | Self::RootMeanSquare | Self::Range)
    }
}
