//! Numbers with their first and second derivatives, on intervals; third ones by derivatives of these in one direction.

use core::ops::{Add, Mul, Neg, Sub};
use loosepin_math::{Dual, Interval, Real};

/// What derivatives are computed on: intervals, or these with their derivative by one of the variables.
pub(crate) trait Number: Real + PartialEq {
    /// A number that does not move.
    fn of(interval: Interval) -> Self;
    /// A variable; `is_direction` where it is the one of the further derivative.
    fn variable(interval: Interval, is_direction: bool) -> Self;
    /// All values of it.
    fn range(self) -> Interval;
    /// f, f' and f'' of it, from f, f', f'' and f''' over its range.
    fn function(self, derivatives: [Interval; 4]) -> [Self; 3];
}

impl Number for Interval {
    fn of(interval: Interval) -> Self {
        interval
    }
    fn variable(interval: Interval, _: bool) -> Self {
        interval
    }
    fn range(self) -> Interval {
        self
    }
    fn function(self, [value, first, second, _]: [Interval; 4]) -> [Self; 3] {
        [value, first, second]
    }
}

impl Number for Dual<Interval> {
    fn of(interval: Interval) -> Self {
        Self::constant(interval)
    }
    fn variable(interval: Interval, is_direction: bool) -> Self {
        if is_direction { Dual::variable(interval) } else { Self::constant(interval) }
    }
    fn range(self) -> Interval {
        self.value
    }
    fn function(self, derivatives: [Interval; 4]) -> [Self; 3] {
        core::array::from_fn(|k| Self { value: derivatives[k], derivative: derivatives[k + 1] * self.derivative })
    }
}

/// The numbers that derivatives are by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Variables {
    pub count: usize,
    /// Whether second derivatives are wanted.
    pub is_second_order: bool,
    /// The variable of the further derivative, if there is one.
    pub direction: Option<usize>,
}

/// A number with its derivatives by all variables. One that does not move has none.
#[derive(Debug, Clone)]
pub(crate) struct Jet<T = Interval> {
    pub value: T,
    pub slopes: Vec<T>,
    /// Row by row of the lower triangle; empty without second derivatives.
    pub curves: Vec<T>,
}

impl Variables {
    /// The number of this place.
    pub(crate) fn number<T: Number>(self, place: usize, value: Interval) -> Jet<T> {
        let mut slopes = vec![T::zero(); self.count];
        slopes[place] = T::one();
        let pairs = if self.is_second_order { pair(self.count, 0) } else { 0 };
        Jet { value: T::variable(value, self.direction == Some(place)), slopes, curves: vec![T::zero(); pairs] }
    }
}

/// The place of a pair of numbers among second derivatives.
pub(crate) fn pair(i: usize, j: usize) -> usize {
    let (larger, smaller) = if i > j { (i, j) } else { (j, i) };
    larger * (larger + 1) / 2 + smaller
}

impl<T: Number> Jet<T> {
    pub(crate) fn constant(value: Interval) -> Self {
        Self { value: T::of(value), slopes: Vec::new(), curves: Vec::new() }
    }

    fn is_constant(&self) -> bool {
        self.slopes.is_empty()
    }

    pub(crate) fn times(self, factor: Interval) -> Self {
        self.by(T::of(factor))
    }

    fn by(mut self, factor: T) -> Self {
        self.value *= factor;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry *= factor);
        self
    }

    /// All values of it.
    pub(crate) fn range(&self) -> Interval {
        self.value.range()
    }

    /// f of it, from f, f', f'' and f''' over its range.
    pub(crate) fn function(&self, derivatives: [Interval; 4]) -> Self {
        let [value, first, second] = self.value.function(derivatives);
        let mut own = self.clone().by(first);
        own.value = value;
        own.add_outer(&self.slopes, &self.slopes, |a, b| second * a * b);
        own
    }

    fn add_outer(&mut self, a: &[T], b: &[T], of: impl Fn(T, T) -> T) {
        if self.curves.is_empty() {
            return;
        }
        for (i, a) in a.iter().enumerate().filter(|(_, a)| **a != T::zero()) {
            let row = i * (i + 1) / 2;
            for (entry, b) in self.curves[row..=row + i].iter_mut().zip(b) {
                *entry += of(*a, *b);
            }
        }
    }
}

impl<T: Number> Add<&Self> for Jet<T> {
    type Output = Self;
    fn add(mut self, other: &Self) -> Self {
        let value = self.value + other.value;
        if self.is_constant() {
            self = other.clone();
        } else {
            self.slopes.iter_mut().zip(&other.slopes).for_each(|(own, other)| *own += *other);
            self.curves.iter_mut().zip(&other.curves).for_each(|(own, other)| *own += *other);
        }
        self.value = value;
        self
    }
}
impl<T: Number> Neg for Jet<T> {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.value = -self.value;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry = -*entry);
        self
    }
}
impl<T: Number> Sub<&Self> for Jet<T> {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        self + &-other.clone()
    }
}
impl<T: Number> Mul for &Jet<T> {
    type Output = Jet<T>;
    fn mul(self, other: Self) -> Jet<T> {
        if self.is_constant() {
            return other.clone().by(self.value);
        }
        let mut product = self.clone().by(other.value);
        if !other.is_constant() {
            product = product + &other.clone().by(self.value);
            product.add_outer(&self.slopes, &other.slopes, |a, b| a * b);
            product.add_outer(&other.slopes, &self.slopes, |a, b| a * b);
        }
        product.value = self.value * other.value;
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn holds(interval: Interval, value: f64) -> bool {
        interval.low() <= value && value <= interval.high() && interval.high() - interval.low() < 1e-12
    }

    #[test]
    fn analytic_derivatives_of_the_sine_of_a_product() {
        let (x, y) = (0.7_f64, -1.3_f64);
        let (sine, cosine) = (x * y).sin_cos();
        for (direction, thirds) in [
            (0, [-y * y * y * cosine, -2.0 * y * sine - x * y * y * cosine, -2.0 * x * sine - x * x * y * cosine]),
            (1, [-2.0 * y * sine - x * y * y * cosine, -2.0 * x * sine - x * x * y * cosine, -x * x * x * cosine]),
        ] {
            let variables = Variables { count: 2, is_second_order: true, direction: Some(direction) };
            let number = |place, value| variables.number::<Dual<Interval>>(place, Interval::from_f64(value));
            let product = &number(0, x) * &number(1, y);
            let (s, c) = product.range().sin_cos();
            // Zero and one do not change it.
            let one = Jet::constant(Interval::from_f64(1.0));
            let found = &(product.function([s, c, -s, -c]) - &Jet::constant(Interval::ZERO)) * &one;
            assert!(holds(found.value.value, sine));
            assert!(holds(found.slopes[0].value, y * cosine) && holds(found.slopes[1].value, x * cosine));
            let seconds = [-y * y * sine, cosine - x * y * sine, -x * x * sine];
            for (place, (i, j)) in [(0, 0), (1, 0), (1, 1)].into_iter().enumerate() {
                assert_eq!(pair(i, j), place);
                assert!(holds(found.curves[place].value, seconds[place]));
                assert!(holds(found.curves[place].derivative, thirds[place]), "{direction} {i} {j}");
            }
        }
    }

    #[test]
    fn identity_products_are_the_same_either_way() {
        let variables = Variables { count: 3, is_second_order: true, direction: None };
        let number = |place, value| variables.number::<Interval>(place, Interval::from_f64(value));
        // (a b + 2) c = a b c + 2 c
        let (a, b, c) = (number(0, 1.5), number(1, -0.5), number(2, 2.25));
        let two = Jet::constant(Interval::from_f64(2.0));
        let left = &(&a * &b + &two) * &c;
        let right = &(&a * &c) * &b - &-c.times(Interval::from_f64(2.0));
        for (left, right) in left.curves.iter().zip(&right.curves).chain(left.slopes.iter().zip(&right.slopes)) {
            assert!(holds(*left, right.middle()), "{left:?} {right:?}");
        }
    }
}
