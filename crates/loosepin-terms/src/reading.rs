//! Readings of an interval.

use serde::{Deserialize, Serialize};

/// Reading of an epistemic interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reading {
    /// One value, the same for every sample, fixed but unknown (A): the envelope over u.
    #[serde(rename = "fixed")]
    FixedButUnknown,
    /// A distribution within the interval, unknown, independent of the random inputs (A2).
    UnknownDistribution,
    /// Any value, another for each sample, in any relation to the random inputs (B).
    RandomSet,
}

impl Reading {
    /// Every reading, in the order in which study files name them.
    pub const ALL: [Self; 3] = [Self::FixedButUnknown, Self::UnknownDistribution, Self::RandomSet];

    /// Word in results.
    pub fn word(self) -> &'static str {
        match self {
            Self::FixedButUnknown => "fixed",
            Self::UnknownDistribution => "unknown_distribution",
            Self::RandomSet => "random_set",
        }
    }

    /// Word in study files and in Python.
    pub const fn file_word(self) -> &'static str {
        match self {
            Self::FixedButUnknown => "fixed",
            Self::UnknownDistribution => "unknown-distribution",
            Self::RandomSet => "random-set",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Reading;

    #[test]
    fn identity_the_word_is_what_files_hold() {
        for reading in Reading::ALL {
            assert_eq!(serde_json::to_value(reading).unwrap(), reading.word());
        }
    }
}
