//! A body that is moved by numbers in intervals.

use crate::enclosure::jet::Jet;
use crate::enclosure::vector::{FixedVector, JetVector, along};
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// Its displacement, m, and the matrix of its turn E, row by row.
pub(crate) struct MovedBody<const C: usize> {
    pub displacement: JetVector<C>,
    turn: [JetVector<C>; 3],
    /// w t: the axial vector of (E - Eᵀ)/2.
    pub axial: JetVector<C>,
    /// t.
    pub vector: JetVector<C>,
}

fn number<const C: usize>(value: f64) -> Jet<C> {
    Jet::constant(Interval::from_f64(value))
}

impl<const C: usize> MovedBody<C> {
    /// A body that is not moved.
    pub(crate) fn held() -> Self {
        let zero = || from_fn(|_| number(0.0));
        let turn = from_fn(|i| from_fn(|j| number(f64::from(u8::from(i == j)))));
        Self { displacement: zero(), turn, axial: zero(), vector: zero() }
    }

    /// Moved by x over L and t, of which the derivatives begin at `first`.
    pub(crate) fn new(numbers: &[Interval; 6], first: usize, length_m: f64) -> Self {
        let variable = |k: usize| Jet::variable(first + k, numbers[k]);
        let displacement = from_fn(|k| variable(k).times(Interval::from_f64(length_m)));
        let t: JetVector<C> = from_fn(|k| variable(3 + k));
        let square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
        let w = root(&(number(1.0) - square.times(Interval::from_f64(0.25))));
        let axial: JetVector<C> = from_fn(|k| t[k] * w);
        let half = Interval::from_f64(0.5);
        // [t]²/2 = (t tᵀ - t·t)/2
        let turn = from_fn(|i| {
            from_fn(|j| {
                let outer = (t[i] * t[j]).times(half);
                match (3 + j - i) % 3 {
                    0 => number(1.0) + outer - square.times(half),
                    1 => outer - axial[3 - i - j],
                    _ => outer + axial[3 - i - j],
                }
            })
        });
        Self { displacement, turn, axial, vector: t }
    }

    /// E v.
    pub(crate) fn apply(&self, vector: &FixedVector) -> JetVector<C> {
        from_fn(|row| along(vector, &self.turn[row]))
    }
}

/// √a, of any sign where a may be: then every number.
fn root<const C: usize>(a: &Jet<C>) -> Jet<C> {
    let value = a.value.sqrt();
    let first = Interval::from_f64(0.5) / value;
    a.function([value, first, -(first / (a.value + a.value))])
}
