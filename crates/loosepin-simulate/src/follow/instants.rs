//! The instants at which the readings of a run are asked for.

use loosepin_math::Quintic;
use std::sync::Arc;

/// Readings at the instants of a run; close together, since an instant costs little else than finding its place.
#[derive(Debug, Clone)]
pub(super) struct Instants {
    /// In order.
    instants_s: Arc<[f64]>,
    /// The next one, s; infinite where none is left.
    next_s: f64,
    /// Its index.
    next: usize,
    /// How many numbers are read at each.
    readings: usize,
    /// All readings at the first instant, then at the next.
    values: Vec<f64>,
    /// The readings over the current step, where it passes at an even pace and they are several.
    polynomials: Vec<Quintic>,
}

impl Default for Instants {
    fn default() -> Self {
        Self::new(Arc::default(), 0)
    }
}

impl Instants {
    /// An empty record.
    pub fn new(instants_s: Arc<[f64]>, readings: usize) -> Self {
        let values = vec![f64::NAN; instants_s.len() * readings];
        let polynomials = Vec::with_capacity(readings);
        let mut own = Self { instants_s, next_s: f64::INFINITY, next: 0, readings, values, polynomials };
        own.skip(0);
        own
    }

    /// Skips this number of instants.
    #[inline]
    fn skip(&mut self, instants: usize) {
        self.next += instants;
        self.next_s = self.instants_s.get(self.next).copied().unwrap_or(f64::INFINITY);
    }

    /// The next one, s; infinite where none is left.
    #[inline]
    pub fn next_s(&self) -> f64 {
        self.next_s
    }

    /// Whether the next one lies in a step that ends at `end_s`; any that is left does where that `is_last`. Without a branch.
    #[inline]
    pub fn is_within(&self, end_s: f64, is_last: bool) -> bool {
        (self.next_s <= end_s) | (is_last & (self.next_s < f64::INFINITY))
    }

    /// The next one with its index; then another one is the next.
    #[inline]
    pub fn take_next(&mut self) -> (usize, f64) {
        let taken = (self.next, self.next_s);
        self.skip(1);
        taken
    }

    /// Takes in each `reading`, by its number, at all instants in a step between two times, which passes at an even pace: share and time are one.
    #[inline]
    pub fn read(&mut self, [start_s, end_s]: [f64; 2], is_last: bool, reading: impl Fn(usize) -> Quintic) {
        let left_s = self.instants_s.get(self.next..).unwrap_or_default();
        let count = left_s.iter().take_while(|instant_s| **instant_s <= end_s || is_last).count();
        let length_s = end_s - start_s;
        // A step in which the time does not move is at its start: what is no number becomes zero.
        let share = |instant_s: f64| f64::max((instant_s - start_s) / length_s, 0.0).min(1.0);
        let within_s = &left_s[..count];
        let values = &mut self.values[self.next * self.readings..];
        if self.readings == 1 {
            let polynomial = reading(0);
            for (value, instant_s) in values.iter_mut().zip(within_s) {
                *value = without_negative_zero(polynomial.value(share(*instant_s)));
            }
        } else if self.readings > 0 {
            self.polynomials.clear();
            self.polynomials.extend((0..self.readings).map(reading));
            for (values, instant_s) in values.chunks_exact_mut(self.readings).zip(within_s) {
                let share = share(*instant_s);
                for (value, polynomial) in values.iter_mut().zip(&self.polynomials) {
                    *value = without_negative_zero(polynomial.value(share));
                }
            }
        }
        self.skip(count);
    }

    /// Takes in a reading at the instant of this index.
    #[inline]
    pub fn set(&mut self, index: usize, reading: usize, value: f64) {
        self.values[index * self.readings + reading] = without_negative_zero(value);
    }

    /// All readings at the first instant, then at the next; NaN if none was taken in.
    pub fn take_values(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.values)
    }
}

/// Programs leave out what is multiplied by zero, which may turn the sign of a zero.
fn without_negative_zero(value: f64) -> f64 {
    value + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_two_readings_at_all_instants_of_two_steps_and_behind_the_last_one() {
        let mut instants = Instants::new([0.0, 0.5, 1.0, 2.0, 3.0].into(), 2);
        let slopes = [4.0, -1.0];
        let reading = |[start_s, end_s]: [f64; 2]| {
            move |k: usize| {
                let [from, to] = [start_s, end_s].map(|time_s| [slopes[k] * time_s, slopes[k], 0.0]);
                Quintic::new(from, to, end_s - start_s)
            }
        };
        instants.read([0.0, 1.25], false, reading([0.0, 1.25]));
        assert_eq!(instants.next_s(), 2.0);
        assert!(!instants.is_within(1.9, false) && instants.is_within(1.9, true) && instants.is_within(2.0, false));
        // One that is read elsewhere, and one behind the end of the last step.
        assert_eq!(instants.take_next(), (3, 2.0));
        instants.set(3, 1, -0.0);
        instants.read([2.0, 2.9], true, reading([2.0, 2.9]));
        assert!(instants.next_s() == f64::INFINITY && !instants.is_within(9.0, true));
        let values = instants.take_values();
        let expected = [0.0, 0.0, 2.0, -0.5, 4.0, -1.0, f64::NAN, 0.0, 4.0 * 2.9, -2.9];
        for (value, expected) in values.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-14 || value.is_nan() && expected.is_nan(), "{values:?}");
        }
        assert!(values.iter().all(|value| *value != 0.0 || value.is_sign_positive()), "{values:?}");
    }
}
