//! [`Real`] for plain numbers.

use super::fused::multiply_add;
use super::real::Real;
use crate::functions::angle::sin_cos;
use crate::functions::exponential::power;
use crate::functions::whole_range::{full_range_exponential, full_range_logarithm, full_range_power};

impl Real for f64 {
    type Mask = bool;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        multiply_add(self, factor, addend)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos(self)
    }
    #[inline(always)]
    fn powf(self, exponent: f64) -> Self {
        // Metals have n = 3/2 and linear springs n = 1: both are exact without a logarithm.
        if exponent == 1.5 {
            self * f64::sqrt(self)
        } else if exponent == 1.0 {
            self
        } else {
            power(self, exponent)
        }
    }
    #[inline(always)]
    fn exponential(self) -> Self {
        full_range_exponential(self)
    }
    #[inline(always)]
    fn logarithm(self) -> Self {
        full_range_logarithm(self)
    }
    #[inline(always)]
    fn power(self, exponent: Self) -> Self {
        full_range_power(self, exponent)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn piece<const N: usize>(self, breaks: &[Self], pieces: &[[Self; N]]) -> [Self; N] {
        // The same piece, found by halving. What is no number is before no break.
        pieces[breaks.partition_point(|at| !(self < *at))]
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, chosen: Self, otherwise: Self) -> Self {
        if mask { chosen } else { otherwise }
    }
}
