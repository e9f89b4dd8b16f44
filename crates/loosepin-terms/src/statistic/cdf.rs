//! The whole distribution function, P(Y <= y) for every y.

use super::kind::{Description, Form, StatisticKind};

pub(super) struct Cdf;

impl Cdf {
    pub const DESCRIPTION: Description = Description {
        word: "cdf",
        with_article: "a distribution function",
        words: "distribution function",
        synonyms: &[],
        form: Form::DistributionFunction,
        number: None,
    };
}

impl StatisticKind for Cdf {
    fn of_sorted(&self, _: &[f64]) -> f64 {
        f64::NAN
    }
}
