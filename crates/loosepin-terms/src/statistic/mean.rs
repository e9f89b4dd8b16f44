//! The mean, E(Y).

use super::kind::{Description, ErrorEffect, Estimation, Form, Mirrored, StatisticKind};

pub(super) struct Mean;

impl Mean {
    pub const DESCRIPTION: Description = Description {
        word: "mean",
        with_article: "a mean",
        words: "mean",
        synonyms: &[],
        form: Form::Number,
        number: None,
    };
}

impl StatisticKind for Mean {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        sorted.iter().sum::<f64>() / sorted.len() as f64
    }

    fn estimation(&self) -> Estimation {
        Estimation::Mean
    }

    fn range_within(&self, values: [f64; 2]) -> [f64; 2] {
        values
    }

    // Nothing is stated of its order against quantiles: the mean of a rare large number lies beyond nearly all of them.

    fn grows_with_variable(&self) -> bool {
        true
    }

    fn mirrored(&self) -> Mirrored {
        Mirrored::Opposite
    }

    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Shifts
    }
}
