//! Purposes of runs.

use serde::{Deserialize, Serialize};

/// Purpose of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Purpose {
    /// The direct double loop: X sampled at a fixed u.
    #[serde(rename = "mixed")]
    DoubleLoop,
    /// The probability-only treatment: X and u sampled together.
    #[serde(rename = "probability_only")]
    Mixture,
    /// The interval-only treatment: a point of the joint box of X and u.
    #[serde(rename = "interval_only")]
    Extreme,
    /// Shares of the variance: X picked and frozen at a fixed u.
    Contributors,
    /// A small probability at a fixed u: X around design points or in chains.
    Rare,
    /// Training data of a surrogate: X and u together.
    Training,
    /// Comparison of a surrogate with the response: X sampled at the u of a bound.
    Confirming,
    /// The promise for a share of the box: X drawn by itself at a u that was drawn beforehand.
    Promise,
}

impl Purpose {
    /// Every purpose, in the order in which runs are counted in results.
    pub const ALL: [Self; 8] = [
        Self::DoubleLoop,
        Self::Mixture,
        Self::Extreme,
        Self::Contributors,
        Self::Rare,
        Self::Training,
        Self::Confirming,
        Self::Promise,
    ];

    /// Word in files and in Python.
    pub fn word(self) -> &'static str {
        match self {
            Self::DoubleLoop => "mixed",
            Self::Mixture => "probability_only",
            Self::Extreme => "interval_only",
            Self::Contributors => "contributors",
            Self::Rare => "rare",
            Self::Training => "training",
            Self::Confirming => "confirming",
            Self::Promise => "promise",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Purpose;

    #[test]
    fn identity_the_word_is_what_files_hold() {
        for purpose in Purpose::ALL {
            assert_eq!(serde_json::to_value(purpose).unwrap(), purpose.word());
        }
    }
}
