//! The motion of a body seen from the body that its branch of the tree comes from.

use crate::enclosure::jet::{Jet, Number, Variables};
use crate::enclosure::vector::{FixedVector, JetVector, constant, dot, minus, plus};
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// Numbers of a step.
pub(crate) const STEP_NUMBERS: usize = 6;

/// P ↦ c + L ξ + E(t)(P - c), about a centre c.
pub(crate) struct Step<T> {
    centre: FixedVector,
    displacement: JetVector<T>,
    /// E, row by row.
    turn: [JetVector<T>; 3],
}

impl<T: Number> Step<T> {
    /// By (ξ, t) in these ranges, whose derivatives begin at `first`.
    pub(crate) fn new(
        centre: FixedVector,
        numbers: &[Interval],
        first: usize,
        variables: Variables,
        length_m: f64,
    ) -> Self {
        let number =
            |k: usize| -> Jet<T> { variables.number(first + k, numbers.get(k).copied().unwrap_or(Interval::WHOLE)) };
        let [half, quarter] = [0.5, 0.25].map(Interval::from_f64);
        let one = || Jet::<T>::constant(Interval::from_f64(1.0));
        let displacement = from_fn(|k| number(k).times(Interval::from_f64(length_m)));
        let t: JetVector<T> = from_fn(|k| number(3 + k));
        let square = dot(&t, &t);
        let w = root(&(one() - &square.clone().times(quarter)));
        let axial: JetVector<T> = from_fn(|k| &t[k] * &w);
        // [t]²/2 = (t tᵀ - t·t)/2
        let turn = from_fn(|i| {
            from_fn(|j| {
                let outer = (&t[i] * &t[j]).times(half);
                match (3 + j - i) % 3 {
                    0 => one() + &outer - &square.clone().times(half),
                    1 => outer - &axial[3 - i - j],
                    _ => outer + &axial[3 - i - j],
                }
            })
        });
        Self { centre, displacement, turn }
    }

    /// A direction, turned.
    pub(crate) fn axis(&self, axis: &JetVector<T>) -> JetVector<T> {
        from_fn(|row| dot(&self.turn[row], axis))
    }

    /// A point, moved.
    pub(crate) fn point(&self, point: JetVector<T>) -> JetVector<T> {
        let centre = constant(&self.centre);
        let arm = minus(point, &centre);
        plus(plus(self.axis(&arm), &self.displacement), &centre)
    }
}

/// √a; every number where a may be below zero.
fn root<T: Number>(a: &Jet<T>) -> Jet<T> {
    let square = a.range();
    let value = square.sqrt();
    let first = Interval::from_f64(0.5) / value;
    let second = -(first / (square + square));
    a.function([value, first, second, -(Interval::from_f64(1.5) * second / square)])
}
