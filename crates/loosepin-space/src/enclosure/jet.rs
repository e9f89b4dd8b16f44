//! Numbers with their first and second derivatives, on intervals.

use core::ops::{Add, Mul, Neg, Sub};
use loosepin_math::Interval;

/// Numbers that derivatives are by: displacement and turn of bearing's and journal's body, and at most five of their play.
pub(crate) const NUMBERS: usize = 17;
/// The first of the journal's body.
pub(crate) const JOURNAL: usize = 6;
/// The first of the play.
pub(crate) const PLAY: usize = 12;
/// Pairs of numbers: second derivatives.
pub(crate) const PAIRS: usize = NUMBERS * (NUMBERS + 1) / 2;

/// A number with its derivatives; `C` is [`PAIRS`], or 0 without second derivatives.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet<const C: usize> {
    pub value: Interval,
    pub slopes: [Interval; NUMBERS],
    /// Row by row of the lower triangle.
    pub curves: [Interval; C],
}

impl<const C: usize> Jet<C> {
    pub(crate) fn constant(value: Interval) -> Self {
        Self { value, slopes: [Interval::ZERO; NUMBERS], curves: [Interval::ZERO; C] }
    }

    /// The number by which one differentiates.
    pub(crate) fn variable(number: usize, value: Interval) -> Self {
        let mut own = Self::constant(value);
        own.slopes[number] = Interval::new(1.0, 1.0);
        own
    }

    pub(crate) fn times(mut self, factor: Interval) -> Self {
        self.value *= factor;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry *= factor);
        self
    }

    /// f of it, from f, f' and f'' over its value.
    pub(crate) fn function(&self, [value, first, second]: [Interval; 3]) -> Self {
        let mut own = self.times(first);
        own.value = value;
        for_pairs::<C>(|place, i, j| own.curves[place] += second * self.slopes[i] * self.slopes[j]);
        own
    }
}

/// Each pair of numbers with its place; none without second derivatives.
fn for_pairs<const C: usize>(mut each: impl FnMut(usize, usize, usize)) {
    if C == 0 {
        return;
    }
    let mut place = 0;
    for i in 0..NUMBERS {
        for j in 0..=i {
            each(place, i, j);
            place += 1;
        }
    }
}

/// The place of a pair of numbers.
pub(crate) fn pair(i: usize, j: usize) -> usize {
    let (larger, smaller) = if i > j { (i, j) } else { (j, i) };
    larger * (larger + 1) / 2 + smaller
}

impl<const C: usize> Add for Jet<C> {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self.value += other.value;
        self.slopes.iter_mut().zip(&other.slopes).for_each(|(own, other)| *own += *other);
        self.curves.iter_mut().zip(&other.curves).for_each(|(own, other)| *own += *other);
        self
    }
}
impl<const C: usize> Neg for Jet<C> {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.value = -self.value;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry = -*entry);
        self
    }
}
impl<const C: usize> Sub for Jet<C> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl<const C: usize> Mul for Jet<C> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut product = self.times(other.value) + other.times(self.value);
        product.value = self.value * other.value;
        for_pairs::<C>(|place, i, j| {
            product.curves[place] += self.slopes[i] * other.slopes[j];
            product.curves[place] += self.slopes[j] * other.slopes[i];
        });
        product
    }
}
