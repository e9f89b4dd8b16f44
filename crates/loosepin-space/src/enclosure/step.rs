//! The motion of a body seen from the body that its branch of the tree comes from.

use crate::enclosure::jet::{Jet, Variables};
use crate::enclosure::vector::{FixedVector, JetVector, constant, dot, minus, plus};
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// Numbers of a step.
pub(crate) const STEP_NUMBERS: usize = 6;

/// P ↦ c + L ξ + E(t)(P - c), about a centre c.
pub(crate) struct Step {
    centre: FixedVector,
    displacement: JetVector,
    /// E, row by row.
    turn: [JetVector; 3],
}

impl Step {
    /// By (ξ, t) in these ranges, whose derivatives begin at `first`.
    pub(crate) fn new(
        centre: FixedVector,
        numbers: &[Interval],
        first: usize,
        variables: Variables,
        length_m: f64,
    ) -> Self {
        let number = |k: usize| variables.number(first + k, numbers.get(k).copied().unwrap_or(Interval::WHOLE));
        let [half, quarter] = [0.5, 0.25].map(Interval::from_f64);
        let one = || Jet::constant(Interval::from_f64(1.0));
        let displacement = from_fn(|k| number(k).times(Interval::from_f64(length_m)));
        let t: JetVector = from_fn(|k| number(3 + k));
        let square = dot(&t, &t);
        let w = root(&(one() - &square.clone().times(quarter)));
        let axial: JetVector = from_fn(|k| &t[k] * &w);
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
    pub(crate) fn axis(&self, axis: &JetVector) -> JetVector {
        from_fn(|row| dot(&self.turn[row], axis))
    }

    /// A point, moved.
    pub(crate) fn point(&self, point: JetVector) -> JetVector {
        let centre = constant(&self.centre);
        let arm = minus(point, &centre);
        plus(plus(self.axis(&arm), &self.displacement), &centre)
    }
}

/// √a, of any sign where a may be: then every number.
fn root(a: &Jet) -> Jet {
    let value = a.value.sqrt();
    let first = Interval::from_f64(0.5) / value;
    a.function([value, first, -(first / (a.value + a.value))])
}
