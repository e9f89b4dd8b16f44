//! The ends of a step, and deviations there.

use loosepin_math::Real;
use loosepin_result::study::Deviation;

/// Gauss's points and weights on [0, 1] for integrals over a step: exact to degree five.
pub const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
/// The ends of a step: its length, time and derivatives, and those of the readings, over the variable of integration.
pub(crate) struct StepEnds<'s, T> {
    /// Length.
    pub length: T,
    /// Time at the start and at the end.
    pub time: [[T; 3]; 2],
    /// All readings at the start and at the end, three numbers each.
    pub readings: [&'s [T]; 2],
}

impl<T: Copy> StepEnds<'_, T> {
    pub fn reading(&self, reading: usize, side: usize) -> [T; 3] {
        array(&self.readings[side][3 * reading..])
    }
}

/// A deviation at an end of a step with its derivatives over the variable of integration; `reference`: those of its reference, over time.
pub(super) fn deviation_at<T: Real>(
    of: Deviation,
    reading: impl FnOnce() -> [T; 3],
    reference: [T; 3],
    time: [T; 3],
) -> [T; 3] {
    // d/ds = w d/dt, d²/ds² = w² d²/dt² + w' d/dt.
    let [value, rate, acceleration] = reference;
    let over_step = [value, rate * time[1], acceleration * time[1] * time[1] + rate * time[2]];
    if !of.has_play() {
        return over_step;
    }
    let actual = reading();
    if of.is_value() { actual } else { [0, 1, 2].map(|k| actual[k] - over_step[k]) }
}

/// The first numbers.
pub(super) fn array<T: Copy, const N: usize>(numbers: &[T]) -> [T; N] {
    std::array::from_fn(|k| numbers[k])
}
