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

    /// Of a sample, with the confidence of its sampling error.
    pub const fn of_sample(confidence: f64) -> Self {
        Self::Sampled { confidence }
    }

    /// Of a search over the epistemic inputs.
    pub const fn of_search() -> Self {
        Self::Optimised
    }

    /// Of runs in which inputs are random, epistemic, both or neither.
    pub fn of_inputs(has_random: bool, has_epistemic: bool, confidence: f64) -> Self {
        match (has_random, has_epistemic) {
            (false, false) => Self::Enclosure,
            (false, true) => Self::of_search(),
            (true, _) => Self::of_sample(confidence),
        }
    }

    /// Of what nothing confirms.
    pub const fn unconfirmed() -> Self {
        Self::Inner
    }

    /// Of finished runs, where others failed.
    pub const fn of_finished_runs() -> Self {
        Self::FinishedRuns
    }

    /// Whether nothing confirms the bound, so that it may be too narrow.
    pub const fn is_unconfirmed(self) -> bool {
        matches!(self, Self::Inner)
    }

    /// Whether it is that of the finished runs alone, since others failed.
    pub const fn is_of_finished_runs(self) -> bool {
        matches!(self, Self::FinishedRuns)
    }

    /// Confidence of its sampling error, where it has one.
    pub fn confidence(self) -> Option<f64> {
        self.word_and_confidence().1
    }

    /// The same with the confidence of `of`, which is asked only where it has one.
    #[must_use]
    pub fn with_confidence(self, of: impl FnOnce() -> f64) -> Self {
        self.confidence().map_or(self, |_| Self::of_sample(of()))
    }

    /// In a table, with {} where its confidence stands.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Enclosure => "proven, rounding errors included",
            Self::Optimised => "found by a search over the intervals, not proven",
            Self::Sampled { .. } => "estimated from samples, with {} confidence in this statistic by itself",
            Self::Inner => "may be too narrow: not confirmed",
            Self::FinishedRuns => "none: found over the finished runs only",
        }
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

#[cfg(test)]
mod tests {
    use super::Guarantee;

    /// The strongest first.
    const ALL: [Guarantee; 5] = [
        Guarantee::Enclosure,
        Guarantee::of_search(),
        Guarantee::of_sample(0.95),
        Guarantee::unconfirmed(),
        Guarantee::of_finished_runs(),
    ];

    #[test]
    fn identity_the_word_is_what_files_hold() {
        for guarantee in ALL {
            let (word, confidence) = guarantee.word_and_confidence();
            let stored = serde_json::to_value(guarantee).unwrap();
            assert_eq!(
                (&stored["kind"], stored.get("confidence")),
                (&word.into(), confidence.map(Into::into).as_ref())
            );
        }
    }

    #[test]
    fn the_weaker_of_two_is_the_later_one() {
        for (k, one) in ALL.into_iter().enumerate() {
            for (l, other) in ALL.into_iter().enumerate() {
                assert_eq!(one.weaker(other), ALL[k.max(l)], "{one:?} {other:?}");
            }
        }
    }

    #[test]
    fn a_confidence_belongs_to_a_sample_alone() {
        for guarantee in ALL {
            let is_of_sample = guarantee == Guarantee::of_sample(0.95);
            assert_eq!(guarantee.confidence(), is_of_sample.then_some(0.95), "{guarantee:?}");
            assert_eq!(guarantee.words().contains("{}"), is_of_sample, "{guarantee:?}");
            let changed = if is_of_sample { Guarantee::of_sample(0.8) } else { guarantee };
            assert_eq!(guarantee.with_confidence(|| 0.8), changed);
        }
    }

    #[test]
    fn random_inputs_need_samples_and_unknown_ones_a_search() {
        let of = |has_random, has_epistemic| Guarantee::of_inputs(has_random, has_epistemic, 0.95);
        assert_eq!([of(false, false), of(false, true)], [Guarantee::Enclosure, Guarantee::of_search()]);
        assert_eq!([of(true, false), of(true, true)], [Guarantee::of_sample(0.95); 2]);
    }
}
