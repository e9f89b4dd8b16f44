//! Readings of any kind, reduced over the recorded part by their values at points inside the steps.
//!
//! A velocity, an acceleration or a force has no polynomial over a step that its ends fix. It is evaluated at Lobatto's five points of the
//! dense output, in all lanes at once; extremes are located lane by lane, where the values allow a new one.

use crate::stepping::search::ROOM;
use loosepin_math::{Quintic, Real};

/// Points of a step, ends included.
const POINTS: usize = 5;

/// Lobatto's points and weights on [0, 1]: integrals over a step are exact to degree seven.
pub(crate) const LOBATTO: [(f64, f64); POINTS] = [
    (0.0, 0.05),
    (0.172_673_164_646_011_43, 49.0 / 180.0),
    (0.5, 16.0 / 45.0),
    (0.827_326_835_353_988_6, 49.0 / 180.0),
    (1.0, 0.05),
];

/// Layout of the readings inside the steps.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct InsideLayout {
    /// Offset of their numbers among those of the followed quantities.
    pub first: usize,
    /// How many readings there are.
    pub count: usize,
}

impl InsideLayout {
    /// Numbers of a reading: the largest and the smallest value so far, the integrals over time of the value and of its square.
    const PER_READING: usize = 4;

    /// How many numbers there are.
    pub fn length(&self) -> usize {
        Self::PER_READING * self.count
    }

    /// Offset of the numbers of a reading.
    pub fn reading(&self, reading: usize) -> usize {
        self.first + Self::PER_READING * reading
    }

    /// Place of a value among those of a step: of a reading at a point.
    pub fn value(&self, point: usize, reading: usize) -> usize {
        point * self.count + reading
    }

    /// Values of a step: of all readings at the first point, then at the next.
    pub fn values(&self) -> usize {
        POINTS * self.count
    }

    /// Takes in the `values` of a step over which the time is `time`, where `is_chosen`. Gives 1 where a value between the points may be a
    /// new extreme, else 0.
    pub fn take<T: Real>(&self, numbers: &mut [T], values: &[T], time: &Quintic<T>, is_chosen: T::Mask) -> T {
        let (zero, one) = (T::zero(), T::one());
        let weights_s = LOBATTO.map(|(share, weight)| T::from_f64(weight) * time.slope(T::from_f64(share)));
        let mut may_be_extreme = zero;
        for reading in 0..self.count {
            let own = &mut numbers[self.reading(reading)..][..Self::PER_READING];
            let at: [T; POINTS] = std::array::from_fn(|point| values[self.value(point, reading)]);
            let (mut high, mut low) = (at[0], at[0]);
            for value in &at[1..] {
                (high, low) = (high.max(*value), low.min(*value));
            }
            let [mut largest, mut smallest, mut integral, mut integral_of_square] = [own[0], own[1], own[2], own[3]];
            (largest, smallest) = (largest.max(high), smallest.min(low));
            for (value, weight_s) in at.iter().zip(weights_s) {
                integral += weight_s * *value;
                integral_of_square += weight_s * *value * *value;
            }
            let room = T::from_f64(ROOM) * (high - low);
            may_be_extreme = T::select(largest.less_than(high + room), one, may_be_extreme);
            may_be_extreme = T::select((low - room).less_than(smallest), one, may_be_extreme);
            for (own, new) in own.iter_mut().zip([largest, smallest, integral, integral_of_square]) {
                *own = T::select(is_chosen, new, *own);
            }
        }
        may_be_extreme
    }

    /// Limits of a reading between its values at the points of a step.
    pub fn limits(values: &[(f64, f64); POINTS]) -> [f64; 2] {
        let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.1), h.max(p.1)));
        let room = ROOM * (high - low);
        [low - room, high + room]
    }
}

#[cfg(test)]
mod tests {
    use super::{InsideLayout, LOBATTO};
    use loosepin_math::Quintic;

    #[test]
    fn analytic_integrals_of_degree_seven_are_exact_and_extremes_are_told() {
        // Over a step of 2 s in which the time is 3 + 2 σ: the value 1 + σ⁷ has the integral 2 (1 + 1/8).
        let layout = InsideLayout { first: 1, count: 1 };
        let mut numbers = [f64::NAN, f64::NEG_INFINITY, f64::INFINITY, 0.0, 0.0];
        let time = Quintic::new([3.0, 1.0, 0.0], [5.0, 1.0, 0.0], 2.0);
        let values = LOBATTO.map(|(share, _)| 1.0 + share.powi(7));
        assert_eq!(layout.take(&mut numbers, &values, &time, true), 1.0);
        assert!((numbers[3] - 2.25).abs() < 1e-14, "{}", numbers[3]);
        assert_eq!(numbers[1..3], [2.0, 1.0]);
        // A later step well within what is known holds no extreme, and one that is not chosen changes nothing.
        let before = numbers;
        assert_eq!(layout.take(&mut numbers, &[1.5, 1.6, 1.5, 1.4, 1.5], &time, false), 0.0);
        assert_eq!(numbers[1..], before[1..]);
    }
}
