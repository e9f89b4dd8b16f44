//! Probabilities of leaving a limit: P(Y > limit), P(Y < limit) and P(|Y| > limit).

use super::event::Event;
use super::kind::{Description, ErrorEffect, Estimation, Form, Number, NumberKind, StatisticKind, as_kind};

/// Name of the number of each in results.
const LIMIT: &str = "limit_si";

pub(super) struct ProbabilityAbove(pub f64);
pub(super) struct ProbabilityBelow(pub f64);
pub(super) struct ProbabilityBeyond(pub f64);

impl ProbabilityAbove {
    pub const DESCRIPTION: Description = Description {
        word: "probability_above",
        with_article: "a probability",
        words: "probability above {}",
        synonyms: &[],
        form: Form::Number,
        number: Some(Number {
            name: LIMIT,
            kind: NumberKind::Limit,
            example: "\"0.4 mm\"",
            meaning: "probability of a value above this limit",
        }),
    };
}

impl ProbabilityBelow {
    pub const DESCRIPTION: Description = Description {
        word: "probability_below",
        with_article: "a probability",
        words: "probability below {}",
        synonyms: &[],
        form: Form::Number,
        number: Some(Number {
            name: LIMIT,
            kind: NumberKind::Limit,
            example: "\"-0.4 mm\"",
            meaning: "probability of a value below this limit",
        }),
    };
}

impl ProbabilityBeyond {
    pub const DESCRIPTION: Description = Description {
        word: "probability_beyond",
        with_article: "a probability",
        words: "probability beyond ±{}",
        synonyms: &[],
        form: Form::Number,
        number: Some(Number {
            name: LIMIT,
            kind: NumberKind::LimitOfMagnitude,
            example: "\"0.4 mm\"",
            meaning: "probability of a magnitude above this limit",
        }),
    };
}

impl StatisticKind for ProbabilityAbove {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        share(sorted, Event::Above(self.0))
    }

    fn estimation(&self) -> Estimation {
        Estimation::Counted(Event::Above(self.0))
    }

    fn range_within(&self, _: [f64; 2]) -> [f64; 2] {
        [0.0, 1.0]
    }

    /// Whether the event here implies the other one: a >= b gives P(Y > a) <= P(Y > b) and P(Y > a) <= P(|Y| > b).
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind(other).is_some_and(|Self(other)| self.0 >= *other)
            || as_kind(other).is_some_and(|ProbabilityBeyond(other)| self.0 >= *other)
    }

    fn grows_with_variable(&self) -> bool {
        true
    }

    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Shifts
    }
}

impl StatisticKind for ProbabilityBelow {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        share(sorted, Event::Below(self.0))
    }

    fn estimation(&self) -> Estimation {
        Estimation::Counted(Event::Below(self.0))
    }

    fn range_within(&self, _: [f64; 2]) -> [f64; 2] {
        [0.0, 1.0]
    }

    /// a <= b: P(Y < a) <= P(Y < b);   -a >= b: P(Y < a) <= P(|Y| > b).
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind(other).is_some_and(|Self(other)| self.0 <= *other)
            || as_kind(other).is_some_and(|ProbabilityBeyond(other)| -self.0 >= *other)
    }

    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Shifts
    }
}

impl StatisticKind for ProbabilityBeyond {
    fn of_sorted(&self, sorted: &[f64]) -> f64 {
        share(sorted, Event::Beyond(self.0))
    }

    fn estimation(&self) -> Estimation {
        Estimation::Counted(Event::Beyond(self.0))
    }

    fn range_within(&self, _: [f64; 2]) -> [f64; 2] {
        [0.0, 1.0]
    }

    /// a >= b: P(|Y| > a) <= P(|Y| > b).
    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind(other).is_some_and(|Self(other)| self.0 >= *other)
    }

    // Errors that go outwards on either side raise it above both shifts. Values on both sides of zero and near both limits at once are
    // rare, and the shifts are what bounds by surrogates take.
    fn effect_of_errors(&self) -> ErrorEffect {
        ErrorEffect::Shifts
    }
}

/// The share of `values` for which `event` holds.
fn share(values: &[f64], event: Event) -> f64 {
    values.iter().filter(|&&value| event.holds(value)).count() as f64 / values.len() as f64
}
