//! Guarantees of bounds.

use serde::{Deserialize, Serialize};

/// Promise of a bound, the strongest first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Guarantee {
    /// The exact number, or certainly beyond it.
    Enclosure,
    /// Found by a search over the epistemic inputs; no sampling is involved.
    Optimised,
    /// Estimated from a sample; its sampling error has this confidence.
    Sampled {
        /// Confidence in (0, 1).
        confidence: f64,
    },
    /// Not confirmed everywhere, or by too few samples: the true range is at least about this wide.
    Inner,
    /// None: runs failed, and each of them may have had any value. The number is that of the finished runs.
    FinishedRuns,
}

impl Guarantee {
    /// Of two bounds that are added, or of both ends, what is promised together.
    #[must_use]
    pub fn weaker(self, other: Self) -> Self {
        let rank = |guarantee: Self| match guarantee {
            Self::Enclosure => 0,
            Self::Optimised => 1,
            Self::Sampled { .. } => 2,
            Self::Inner => 3,
            Self::FinishedRuns => 4,
        };
        if rank(other) > rank(self) { other } else { self }
    }

    /// Word in files and in Python, and the confidence where there is one.
    pub fn word_and_confidence(self) -> (&'static str, Option<f64>) {
        match self {
            Self::Enclosure => ("enclosure", None),
            Self::Optimised => ("optimised", None),
            Self::Sampled { confidence } => ("sampled", Some(confidence)),
            Self::Inner => ("inner", None),
            Self::FinishedRuns => ("finished_runs", None),
        }
    }
}
