//! Treatments of uncertainty.

use serde::{Deserialize, Serialize};

/// Treatment of the two kinds of uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Treatment {
    /// Every interval taken as a uniform distribution, every member of a list as equally probable.
    ProbabilityOnly,
    /// Every random input cut to an interval; every combination of the members of lists.
    IntervalOnly,
    /// Random inputs random, epistemic inputs unknown within their intervals and lists.
    Mixed,
}

impl Treatment {
    /// Word in files and in Python.
    pub fn word(self) -> &'static str {
        match self {
            Self::ProbabilityOnly => "probability_only",
            Self::IntervalOnly => "interval_only",
            Self::Mixed => "mixed",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Treatment;

    #[test]
    fn identity_the_word_is_what_files_hold() {
        for treatment in [Treatment::ProbabilityOnly, Treatment::IntervalOnly, Treatment::Mixed] {
            assert_eq!(serde_json::to_value(treatment).unwrap(), treatment.word());
        }
    }
}
