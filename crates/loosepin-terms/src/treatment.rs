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

    /// That of bounds: what is unknown stays unknown.
    pub const fn of_bounds() -> Self {
        Self::Mixed
    }

    /// Whether random inputs are random and epistemic inputs unknown, as in bounds.
    pub const fn is_mixed(self) -> bool {
        matches!(self, Self::Mixed)
    }

    /// Whether it is the worst case of all inputs, without probabilities.
    pub const fn is_worst_case(self) -> bool {
        matches!(self, Self::IntervalOnly)
    }

    /// Name for people, as a heading has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::ProbabilityOnly => "Probability only",
            Self::IntervalOnly => "Interval only",
            Self::Mixed => "Mixed",
        }
    }

    /// What it assumes: a sentence without its end.
    pub fn assumption(self) -> &'static str {
        match self {
            Self::ProbabilityOnly => "Probability only takes every unknown value as random",
            Self::IntervalOnly => "Interval only takes the worst case of all inputs, random ones included",
            Self::Mixed => "Mixed keeps random inputs random and unknown values unknown",
        }
    }

    /// Word for its colour in figures.
    pub fn colour(self) -> &'static str {
        match self {
            Self::ProbabilityOnly => "probability",
            Self::IntervalOnly => "worst",
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
            assert_eq!(treatment.name().to_lowercase().replace(' ', "_"), treatment.word());
            assert!(treatment.assumption().starts_with(treatment.name()), "{treatment:?}");
            assert_eq!(treatment.is_mixed(), treatment == Treatment::of_bounds());
        }
    }
}
