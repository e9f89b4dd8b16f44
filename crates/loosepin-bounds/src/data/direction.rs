//! Minimum and maximum.

use loosepin_terms::Side;

/// Which end is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Direction {
    Minimum,
    Maximum,
}

impl From<Side> for Direction {
    fn from(side: Side) -> Self {
        match side {
            Side::Lower => Self::Minimum,
            Side::Upper => Self::Maximum,
        }
    }
}

impl Direction {
    /// Both ends.
    pub const BOTH: [Self; 2] = [Self::Minimum, Self::Maximum];

    /// 0 for the minimum, 1 for the maximum.
    pub fn index(self) -> usize {
        self as usize
    }

    /// -1 for the minimum, +1 for the maximum.
    pub fn sign(self) -> f64 {
        self.of(-1.0, 1.0)
    }

    /// The first for the minimum, the second for the maximum.
    pub fn of<T>(self, low: T, high: T) -> T {
        match self {
            Self::Minimum => low,
            Self::Maximum => high,
        }
    }

    /// The other one.
    pub fn opposite(self) -> Self {
        self.of(Self::Maximum, Self::Minimum)
    }

    /// Whether `value` lies beyond `other`.
    pub fn is_beyond(self, value: f64, other: f64) -> bool {
        self.sign() * value > self.sign() * other
    }

    /// The number that lies further out; `value` where they are equal or not comparable.
    pub fn further(self, value: f64, other: f64) -> f64 {
        if self.is_beyond(other, value) { other } else { value }
    }
}

/// The extreme of the finite values; infinite where there are none.
pub(crate) fn extreme(values: &[f64], direction: Direction) -> f64 {
    extreme_point(values, direction).map_or(-direction.sign() * f64::INFINITY, |point| values[point])
}

/// Position of the extreme of the finite values.
pub(crate) fn extreme_point(values: &[f64], direction: Direction) -> Option<usize> {
    extreme_among(values, 0..values.len(), direction)
}

/// Position of the extreme of the finite values at `points`.
pub(crate) fn extreme_among(
    values: &[f64],
    points: impl Iterator<Item = usize>,
    direction: Direction,
) -> Option<usize> {
    let mut best: Option<usize> = None;
    for point in points {
        let value = values[point];
        if value.is_finite() && best.is_none_or(|best| direction.is_beyond(value, values[best])) {
            best = Some(point);
        }
    }
    best
}

/// Least and greatest of all values, not-a-numbers left out; the least is the larger one where there are none.
pub(crate) fn range_of(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    values.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}
