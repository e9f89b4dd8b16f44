//! Numbers with their first and second derivatives, on intervals.

use core::ops::{Add, Mul, Neg, Sub};
use loosepin_math::Interval;

/// The numbers that derivatives are by.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Variables {
    pub count: usize,
    /// Whether second derivatives are wanted.
    pub is_second_order: bool,
}

/// A number with its derivatives by all variables. One that does not move has none.
#[derive(Debug, Clone)]
pub(crate) struct Jet {
    pub value: Interval,
    pub slopes: Vec<Interval>,
    /// Row by row of the lower triangle; empty without second derivatives.
    pub curves: Vec<Interval>,
}

impl Variables {
    /// The number of this place.
    pub(crate) fn number(self, place: usize, value: Interval) -> Jet {
        let mut slopes = vec![Interval::ZERO; self.count];
        slopes[place] = Interval::new(1.0, 1.0);
        let pairs = if self.is_second_order { pair(self.count, 0) } else { 0 };
        Jet { value, slopes, curves: vec![Interval::ZERO; pairs] }
    }
}

/// The place of a pair of numbers among second derivatives.
pub(crate) fn pair(i: usize, j: usize) -> usize {
    let (larger, smaller) = if i > j { (i, j) } else { (j, i) };
    larger * (larger + 1) / 2 + smaller
}

impl Jet {
    pub(crate) fn constant(value: Interval) -> Self {
        Self { value, slopes: Vec::new(), curves: Vec::new() }
    }

    fn is_constant(&self) -> bool {
        self.slopes.is_empty()
    }

    pub(crate) fn times(mut self, factor: Interval) -> Self {
        self.value *= factor;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry *= factor);
        self
    }

    /// f of it, from f, f' and f'' over its value.
    pub(crate) fn function(&self, [value, first, second]: [Interval; 3]) -> Self {
        let mut own = self.clone().times(first);
        own.value = value;
        own.add_outer(&self.slopes, &self.slopes, |a, b| second * a * b);
        own
    }

    fn add_outer(&mut self, a: &[Interval], b: &[Interval], of: impl Fn(Interval, Interval) -> Interval) {
        if self.curves.is_empty() {
            return;
        }
        for (i, a) in a.iter().enumerate().filter(|(_, a)| **a != Interval::ZERO) {
            let row = i * (i + 1) / 2;
            for (entry, b) in self.curves[row..=row + i].iter_mut().zip(b) {
                *entry += of(*a, *b);
            }
        }
    }
}

impl Add<&Jet> for Jet {
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
impl Neg for Jet {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.value = -self.value;
        self.slopes.iter_mut().chain(&mut self.curves).for_each(|entry| *entry = -*entry);
        self
    }
}
impl Sub<&Jet> for Jet {
    type Output = Self;
    fn sub(self, other: &Self) -> Self {
        self + &-other.clone()
    }
}
impl Mul for &Jet {
    type Output = Jet;
    fn mul(self, other: Self) -> Jet {
        if self.is_constant() {
            return other.clone().times(self.value);
        }
        let mut product = self.clone().times(other.value);
        if !other.is_constant() {
            product = product + &other.clone().times(self.value);
            product.add_outer(&self.slopes, &other.slopes, |a, b| a * b);
            product.add_outer(&other.slopes, &self.slopes, |a, b| a * b);
        }
        product.value = self.value * other.value;
        product
    }
}
