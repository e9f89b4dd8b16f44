//! The motion of a body seen from the body that its branch of the tree comes from.

use crate::enclosure::jet::{Jet, Number, Variables};
use crate::enclosure::vector::{JetVector, constant, dot, minus, plus};
use core::array::from_fn;
use loosepin_math::{Interval, Real, Vec3};

/// Numbers of a step.
pub(crate) const STEP_NUMBERS: usize = 6;

/// P ↦ c + L ξ + E(t)(P - c), about a centre c.
pub(crate) struct Step<T> {
    centre: Vec3<Interval>,
    displacement: JetVector<T>,
    /// E, row by row.
    turn: [JetVector<T>; 3],
}

impl<T: Number> Step<T> {
    /// By (ξ, t) in these ranges, whose derivatives begin at `first`.
    pub(crate) fn new(
        centre: Vec3<Interval>,
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
        let centre = constant(self.centre);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::enclosure::vector::exact;
    use loosepin_math::Quaternion;

    #[test]
    fn identity_a_step_turns_as_its_quaternion_does() {
        let (t, displacement) = (Vec3::new(0.3, -0.4, 0.5), Vec3::new(0.02, -0.01, 0.03));
        let (centre, point, length_m) = (Vec3::new(0.1, 0.2, 0.3), Vec3::new(-0.4, 0.6, 0.9), 0.7);
        let numbers: Vec<Interval> =
            [displacement, t].into_iter().flat_map(Vec3::to_array).map(Interval::from_f64).collect();
        let variables = Variables { count: STEP_NUMBERS, is_second_order: false, direction: None };
        let step = Step::<Interval>::new(exact(centre), &numbers, 0, variables, length_m);
        let half = t * 0.5;
        let turn = Quaternion::new((1.0 - half.dot(half)).sqrt(), half.x, half.y, half.z).rotation();
        let expected = centre + displacement * length_m + turn.apply(point - centre);
        let found = step.point(constant(exact(point)));
        for (found, expected) in found.iter().zip(expected.to_array()) {
            assert!((found.value.middle() - expected).abs() < 1e-15 && found.value.magnitude() < 2.0);
        }
        // To first order a displacement is L ξ, a turn about the centre t × (P - c).
        let at_rest = Step::<Interval>::new(exact(centre), &[Interval::ZERO; STEP_NUMBERS], 0, variables, length_m);
        let found = at_rest.point(constant(exact(point)));
        for (k, axis) in Vec3::AXES.into_iter().enumerate() {
            let turned = axis.cross(point - centre).to_array();
            for row in 0..3 {
                assert!((found[row].slopes[3 + k].middle() - turned[row]).abs() < 1e-15);
                assert_eq!(found[row].slopes[k].middle(), if row == k { length_m } else { 0.0 });
            }
        }
    }
}
