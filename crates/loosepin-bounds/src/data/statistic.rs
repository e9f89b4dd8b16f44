//! Statistics of a scalar response, and the events whose probabilities some of them are.

pub use loosepin_terms::Statistic;

/// Whether failed runs leave `statistic` without any bound: it is then that of the finished runs.
pub(crate) fn is_over_finished(statistic: Statistic) -> bool {
    matches!(statistic, Statistic::Mean | Statistic::StandardDeviation)
}

/// A property of a value, whose probability is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Event {
    Above(f64),
    Below(f64),
    UpTo(f64),
    Beyond(f64),
}

impl Event {
    /// The event whose probability `statistic` is.
    pub fn of(statistic: Statistic) -> Option<Self> {
        match statistic {
            Statistic::ProbabilityAbove(limit) => Some(Self::Above(limit)),
            Statistic::ProbabilityBelow(limit) => Some(Self::Below(limit)),
            Statistic::ProbabilityBeyond(limit) => Some(Self::Beyond(limit)),
            _ => None,
        }
    }

    /// Whether `value` has the property.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Above(limit) => value > limit,
            Self::Below(limit) => value < limit,
            Self::UpTo(limit) => value <= limit,
            Self::Beyond(limit) => value.abs() > limit,
        }
    }
}
