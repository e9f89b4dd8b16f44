//! The standard deviation, √E((Y - E Y)²).

use super::kind::{Description, ErrorEffect, Estimation, Form, StatisticKind};
use super::mean::Mean;

pub(super) struct StandardDeviation;

impl StandardDeviation {
    pub const DESCRIPTION: Description = Description {
        word: "standard_deviation",
        with_article: "a standard deviation",
        words: "standard deviation",
        synonyms: &[("std", "\"standard_deviation\"")],
        form: Form::Number,
        number: None,
    };
}

impl StatisticKind for StandardDeviation {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        let mean = Mean.of_sorted(sorted);
        let squares = sorted.iter().map(|value| (value - mean) * (value - mean));
        (squares.sum::<f64>() / sorted.len() as f64).sqrt()
    }

    fn estimation(&self) -> Estimation {
        Estimation::RootOfVariance
    }

    /// The variance is greatest where half of the mechanisms is at either end: (T. Popoviciu 1935) Var <= (b - a)²/4.
    fn range_within(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        [0.0, 0.5 * (high - low)]
    }

    /// The standard deviation is a norm of Y - E Y: |S(Y + e) - S(Y)| <= S(e) <= √E(e²).
    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::RootMeanSquare
    }
}
