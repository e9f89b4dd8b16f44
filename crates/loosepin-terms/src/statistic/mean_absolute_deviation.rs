//! The mean absolute deviation about the mean, E|Y - E Y|.

use super::kind::{Description, ErrorEffect, Form, StatisticKind, as_kind};
use super::mean::Mean;
use super::standard_deviation::StandardDeviation;

pub(super) struct MeanAbsoluteDeviation;

impl MeanAbsoluteDeviation {
    pub const DESCRIPTION: Description = Description {
        word: "mean_absolute_deviation",
        with_article: "a mean absolute deviation",
        words: "mean absolute deviation",
        synonyms: &[("mean_deviation", "\"mean_absolute_deviation\"")],
        form: Form::Number,
        number: None,
    };
}

impl StatisticKind for MeanAbsoluteDeviation {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        let mean = Mean.of_sorted(sorted);
        sorted.iter().map(|value| (value - mean).abs()).sum::<f64>() / sorted.len() as f64
    }

    /// With a share p of the mechanisms at the upper end and the others at the lower one it is 2 p (1 - p) (b - a), and no law has more.
    fn range_within(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        [0.0, 0.5 * (high - low)]
    }

    /// (E|Z|)² <= E Z², Z = Y - E Y.
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind::<StandardDeviation>(other).is_some()
    }

    /// The mean absolute deviation is a norm of Y - E Y: |S(Y + e) - S(Y)| <= S(e) <= √E(e²).
    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::RootMeanSquare
    }
}
