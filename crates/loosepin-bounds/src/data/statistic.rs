//! Statistics of a scalar response, and the events whose probabilities some of them are.

pub use loosepin_terms::Statistic;

/// Whether failed runs leave `statistic` without any bound: it is then that of the finished runs. Shares of runs, and quantiles, are bounded
/// whatever the failed ones would have given.
pub(crate) fn is_over_finished(statistic: Statistic) -> bool {
    let is_by_shares = matches!(statistic, Statistic::Cdf | Statistic::Quantile(_) | Statistic::SimultaneousBand(_));
    !is_by_shares && !statistic.is_probability()
}

/// f where the statistic is the mean of f(Y).
pub(crate) fn function_averaged(statistic: Statistic) -> Option<Box<dyn Fn(f64) -> f64>> {
    match (statistic, Event::of(statistic)) {
        (Statistic::Mean, _) => Some(Box::new(|value| value)),
        (_, Some(event)) => Some(Box::new(move |value| if event.holds(value) { 1.0 } else { 0.0 })),
        _ => None,
    }
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
