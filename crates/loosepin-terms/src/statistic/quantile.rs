//! The quantile at p, the value that Y stays below with this probability.

use super::kind::{Description, ErrorEffect, Estimation, Form, Mirrored, Number, NumberKind, StatisticKind, as_kind};

pub(super) struct Quantile(pub f64);

impl Quantile {
    pub const DESCRIPTION: Description = Description {
        word: "quantile",
        with_article: "a quantile",
        words: "{} quantile",
        synonyms: &[("median", "{ quantile = 0.5 }")],
        form: Form::Number,
        number: Some(Number {
            name: "probability",
            kind: NumberKind::Share,
            example: "0.975",
            meaning: "the value that is not exceeded with this probability",
        }),
    };
}

impl StatisticKind for Quantile {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        if sorted.is_empty() {
            return f64::NAN;
        }
        between_order_statistics(sorted.len(), self.0 * sorted.len() as f64, |place| sorted[place])
    }

    fn estimation(&self) -> Estimation {
        Estimation::Ordered(self.0)
    }

    fn range_within(&self, values: [f64; 2]) -> [f64; 2] {
        values
    }

    /// p <= q: Q_p <= Q_q, since a distribution function does not fall.
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind(other).is_some_and(|Self(other)| self.0 <= *other)
    }

    fn grows_with_variable(&self) -> bool {
        true
    }

    fn mirrored(&self) -> Mirrored {
        Mirrored::OppositeWith(1.0 - self.0)
    }

    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Shifts
    }
}

/// The value at `rank` = N p between `count` order statistics, y_(k) at (k - 1/2)/N (A. Hazen 1914), of which `at` gives each from 0 on;
/// infinite where the rank lies beyond them.
pub fn between_order_statistics(count: usize, rank: f64, mut at: impl FnMut(usize) -> f64) -> f64 {
    if rank <= 0.0 {
        return f64::NEG_INFINITY;
    }
    if rank >= count as f64 {
        return f64::INFINITY;
    }
    let position = (rank - 0.5).clamp(0.0, count as f64 - 1.0);
    let index = position as usize;
    let fraction = position - index as f64;
    let (own, next) = (at(index), at((index + 1).min(count - 1)));
    own + fraction * (next - own)
}
