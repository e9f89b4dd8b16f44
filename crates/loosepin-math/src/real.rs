//! The one trait over which every equation of the physics wing is written.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number that the equations of motion, kinematics and contact laws can be evaluated on.
///
/// `f64`, a number that writes down what is done with it (for machine code and lanes), and [`crate::Dual`] of both.
/// Comparisons give a [`Real::Mask`] and choices go through [`Real::select`], never through `if`: what is written down has
/// no branches.
pub trait Real:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The result of a comparison: `bool` for plain numbers.
    type Mask: Copy;

    /// The constant `value`, with zero derivative.
    fn from_f64(value: f64) -> Self;
    /// The number without its derivatives; NaN if it is only written down.
    fn to_f64(self) -> f64;
    /// `self · factor + addend` with one rounding: a fused multiply-add on every processor.
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// `self` raised to `exponent`, for `self > 0`; zero where `self` is zero. Other exponents than 1 and 3/2: within the limits
    /// of [`crate::power`].
    fn powf(self, exponent: f64) -> Self;
    /// eˣ, of any number: [`crate::full_range_exponential`].
    fn exponential(self) -> Self;
    /// The natural logarithm; NaN for zero and below: [`crate::full_range_logarithm`].
    fn logarithm(self) -> Self;
    /// `self` raised to any exponent: [`crate::full_range_power`].
    fn power(self, exponent: Self) -> Self;
    /// The smaller of the two.
    fn min(self, other: Self) -> Self;
    /// The larger of the two.
    fn max(self, other: Self) -> Self;
    /// The magnitude.
    fn abs(self) -> Self;
    /// `self < other`.
    fn less_than(self, other: Self) -> Self::Mask;
    /// `chosen` where `mask` holds, else `otherwise`.
    fn select(mask: Self::Mask, chosen: Self, otherwise: Self) -> Self;
    /// The nearest whole number, for magnitudes below 2⁵¹: adding and taking away 1.5 · 2⁵² rounds. It does not move with the
    /// number.
    #[inline(always)]
    fn nearest_whole(self) -> Self {
        const ROUNDER: f64 = 6_755_399_441_055_744.0;
        self + Self::from_f64(ROUNDER) - Self::from_f64(ROUNDER)
    }

    /// Of `pieces` side by side, which meet at `breaks`, increasing and one less than there are pieces: the numbers of the piece that
    /// holds `self`. A break belongs to the piece behind it.
    #[inline(always)]
    fn piece<const N: usize>(self, breaks: &[Self], pieces: &[[Self; N]]) -> [Self; N] {
        let last = pieces.len() - 1;
        let mut found = pieces[last];
        for k in (0..last).rev() {
            let is_before = self.less_than(breaks[k]);
            for (found, number) in found.iter_mut().zip(&pieces[k]) {
                *found = Self::select(is_before, *number, *found);
            }
        }
        found
    }

    /// Whether it stands for many numbers at once, as an interval does: several pieces of a function may then hold it.
    const IS_SET: bool = false;
    /// The least and the largest number of a set; twice the number itself otherwise.
    #[inline(always)]
    fn ends(self) -> [f64; 2] {
        [self.to_f64(); 2]
    }
    /// The part of a set from `low` to `high`; `None` where there is none. It moves as the whole does.
    #[inline(always)]
    fn part(self, _low: f64, _high: f64) -> Option<Self> {
        Some(self)
    }
    /// The smallest set that holds both.
    #[inline(always)]
    fn joined(self, _other: Self) -> Self {
        self
    }

    /// What `at` makes of `self` and the numbers of the piece that holds it, as [`Self::piece`] has them. Of a set: of each piece with the
    /// part of the set that lies in it, joined. The numbers of two pieces joined before would be those of many more functions.
    #[inline(always)]
    fn over_pieces<const N: usize, const M: usize>(
        self,
        breaks: &[Self],
        pieces: &[[Self; N]],
        at: impl Fn(Self, [Self; N]) -> [Self; M],
    ) -> [Self; M] {
        let plain = || at(self, self.piece(breaks, pieces));
        if !Self::IS_SET {
            return plain();
        }
        let parts = pieces.iter().enumerate().filter_map(|(k, piece)| {
            let low = if k == 0 { f64::NEG_INFINITY } else { breaks[k - 1].ends()[0] };
            let high = breaks.get(k).map_or(f64::INFINITY, |end| end.ends()[1]);
            Some(at(self.part(low, high)?, *piece))
        });
        parts.reduce(joined_all).unwrap_or_else(plain)
    }

    /// Zero.
    #[inline(always)]
    fn zero() -> Self {
        Self::from_f64(0.0)
    }
    /// One.
    #[inline(always)]
    fn one() -> Self {
        Self::from_f64(1.0)
    }
    /// The square of the number.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
}

/// [`Real::joined`] of each with its counterpart.
pub fn joined_all<T: Real, const M: usize>(all: [T; M], other: [T; M]) -> [T; M] {
    std::array::from_fn(|k| all[k].joined(other[k]))
}
