//! Numbers whose operations are calls.

use super::Real;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number whose operations are functions of their own instead of a part of what uses them.
///
/// The equations are inlined whole, once for each kind of number: over large numbers, as second derivatives on intervals are, that is most of what
/// a compiler has to do, and calls cost little beside what such an operation does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outlined<T>(pub T);

macro_rules! operators {
    ($($operator:ident $operation:ident, $assigning:ident $assignment:ident;)+) => {$(
        impl<T: Real> $operator for Outlined<T> {
            type Output = Self;
            #[inline(never)]
            fn $operation(self, other: Self) -> Self {
                Self(self.0.$operation(other.0))
            }
        }
        impl<T: Real> $assigning for Outlined<T> {
            #[inline]
            fn $assignment(&mut self, other: Self) {
                *self = $operator::$operation(*self, other);
            }
        }
    )+};
}

operators! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
}

impl<T: Real> Div for Outlined<T> {
    type Output = Self;
    #[inline(never)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl<T: Real> Neg for Outlined<T> {
    type Output = Self;
    #[inline(never)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Real> Real for Outlined<T> {
    type Mask = T::Mask;
    const IS_SET: bool = T::IS_SET;

    #[inline(never)]
    fn from_f64(value: f64) -> Self {
        Self(T::from_f64(value))
    }
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    #[inline(never)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(never)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }
    #[inline(never)]
    fn powf(self, exponent: f64) -> Self {
        Self(self.0.powf(exponent))
    }
    #[inline(never)]
    fn exponential(self) -> Self {
        Self(self.0.exponential())
    }
    #[inline(never)]
    fn logarithm(self) -> Self {
        Self(self.0.logarithm())
    }
    #[inline(never)]
    fn power(self, exponent: Self) -> Self {
        Self(self.0.power(exponent.0))
    }
    #[inline(never)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }
    #[inline(never)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0))
    }
    #[inline(never)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(never)]
    fn less_than(self, other: Self) -> T::Mask {
        self.0.less_than(other.0)
    }
    #[inline(never)]
    fn select(mask: T::Mask, chosen: Self, otherwise: Self) -> Self {
        Self(T::select(mask, chosen.0, otherwise.0))
    }
    #[inline(never)]
    fn nearest_whole(self) -> Self {
        Self(self.0.nearest_whole())
    }
    fn ends(self) -> [f64; 2] {
        self.0.ends()
    }
    fn part(self, low: f64, high: f64) -> Option<Self> {
        self.0.part(low, high).map(Self)
    }
    #[inline(never)]
    fn joined(self, other: Self) -> Self {
        Self(self.0.joined(other.0))
    }
}
