//! Events: properties of a value that have a probability.

/// A property of a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event {
    /// The value exceeds this limit.
    Above(f64),
    /// The value falls short of this limit.
    Below(f64),
    /// The value does not exceed this limit.
    UpTo(f64),
    /// Its magnitude exceeds this limit.
    Beyond(f64),
}

impl Event {
    /// Whether `value` has the property; NaN has none.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Above(limit) => value > limit,
            Self::Below(limit) => value < limit,
            Self::UpTo(limit) => value <= limit,
            Self::Beyond(limit) => value.abs() > limit,
        }
    }

    /// The limit.
    pub fn limit(self) -> f64 {
        match self {
            Self::Above(limit) | Self::Below(limit) | Self::UpTo(limit) | Self::Beyond(limit) => limit,
        }
    }

    /// The limit state g of `value`: by how much it misses the event, below 0 inside.
    pub fn missed_by(self, value: f64) -> f64 {
        match self {
            Self::Above(limit) => limit - value,
            Self::Below(limit) | Self::UpTo(limit) => value - limit,
            Self::Beyond(limit) => limit - value.abs(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Event;

    #[test]
    fn identity_the_limit_state_is_negative_where_the_event_holds() {
        const LIMIT: f64 = 0.75;
        for event in [Event::Above(LIMIT), Event::Below(LIMIT), Event::UpTo(LIMIT), Event::Beyond(LIMIT)] {
            assert_eq!(event.limit(), LIMIT);
            for value in [-2.5, -0.5, 0.5, 0.875] {
                assert_eq!(event.holds(value), event.missed_by(value) < 0.0, "{event:?} {value}");
            }
            assert!(!event.holds(f64::NAN));
        }
        assert!(Event::UpTo(LIMIT).holds(LIMIT) && !Event::Below(LIMIT).holds(LIMIT));
    }
}
