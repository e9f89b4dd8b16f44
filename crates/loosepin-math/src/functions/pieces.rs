//! Functions in pieces, picked without a choice by value: on lanes every lane is in its own piece.

use crate::{Numbers, Real};

/// Pieces side by side along an argument, each with its N numbers.
#[derive(Debug, Clone)]
pub struct Pieces<T, const N: usize> {
    /// Boundaries between consecutive pieces: one less than there are pieces.
    breaks: Vec<T>,
    numbers: Vec<[T; N]>,
}

impl<T: Real, const N: usize> Numbers<T> for Pieces<T, N> {
    type Plain = Pieces<f64, N>;

    fn broadcast(plain: &Pieces<f64, N>) -> Self {
        Self { breaks: Numbers::<T>::broadcast(&plain.breaks), numbers: Numbers::<T>::broadcast(&plain.numbers) }
    }

    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.breaks.visit(visit);
        self.numbers.visit(visit);
    }
}

impl<T: Real, const N: usize> Pieces<T, N> {
    /// `breaks` are increasing.
    pub fn new(breaks: Vec<T>, numbers: Vec<[T; N]>) -> Self {
        Self { breaks, numbers }
    }

    /// The numbers of all pieces.
    pub fn all(&self) -> &[[T; N]] {
        &self.numbers
    }

    /// Boundaries between consecutive pieces.
    pub fn breaks(&self) -> &[T] {
        &self.breaks
    }

    /// The numbers of the piece that holds `argument`; beyond both ends those of the outer pieces.
    #[inline(always)]
    pub fn at(&self, argument: T) -> [T; N] {
        argument.piece(&self.breaks, &self.numbers)
    }

    /// What `value` makes of `argument` and the numbers of its piece; of a set, of each piece that it touches ([`Real::over_pieces`]).
    #[inline(always)]
    pub fn over<const M: usize>(&self, argument: T, value: impl Fn(T, [T; N]) -> [T; M]) -> [T; M] {
        argument.over_pieces(&self.breaks, &self.numbers, value)
    }
}
