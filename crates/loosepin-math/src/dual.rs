//! Dual numbers: a value and its derivative in one direction, exact to round-off.

use super::Real;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// `value + derivative·ε` with ε² = 0: evaluating f on it gives f and its directional derivative.
///
/// Nests: `Dual<Dual<f64>>` gives second derivatives. Comparisons look at the value alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<T> {
    /// The value.
    pub value: T,
    /// The derivative in the chosen direction.
    pub derivative: T,
}

impl<T: Real> Dual<T> {
    /// A number that does not move.
    #[inline(always)]
    pub fn constant(value: T) -> Self {
        Self { value, derivative: T::zero() }
    }
    /// The number with respect to which one differentiates.
    #[inline(always)]
    pub fn variable(value: T) -> Self {
        Self { value, derivative: T::one() }
    }
}

impl<T: Real> Add for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, derivative: self.derivative + other.derivative }
    }
}
impl<T: Real> Sub for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, derivative: self.derivative - other.derivative }
    }
}
impl<T: Real> Mul for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            derivative: self.derivative * other.value + self.value * other.derivative,
        }
    }
}
impl<T: Real> Div for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, derivative: (self.derivative - value * other.derivative) / other.value }
    }
}
impl<T: Real> Neg for Dual<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, derivative: -self.derivative }
    }
}
impl<T: Real> AddAssign for Dual<T> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl<T: Real> SubAssign for Dual<T> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
impl<T: Real> MulAssign for Dual<T> {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<T: Real> Real for Dual<T> {
    type Mask = T::Mask;

    const IS_SET: bool = T::IS_SET;
    fn ends(self) -> [f64; 2] {
        self.value.ends()
    }
    fn part(self, low: f64, high: f64) -> Option<Self> {
        Some(Self { value: self.value.part(low, high)?, derivative: self.derivative })
    }
    fn joined(self, other: Self) -> Self {
        Self { value: self.value.joined(other.value), derivative: self.derivative.joined(other.derivative) }
    }

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::constant(T::from_f64(value))
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self {
            value: self.value.mul_add(factor.value, addend.value),
            derivative: self.derivative.mul_add(factor.value, self.value.mul_add(factor.derivative, addend.derivative)),
        }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Self { value, derivative: self.derivative / (value + value) }
    }
    #[inline(always)]
    fn nearest_whole(self) -> Self {
        Self::constant(self.value.nearest_whole())
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (
            Self { value: sine, derivative: cosine * self.derivative },
            Self { value: cosine, derivative: -sine * self.derivative },
        )
    }
    #[inline(always)]
    fn powf(self, exponent: f64) -> Self {
        let value = self.value.powf(exponent);
        Self { value, derivative: T::from_f64(exponent) * self.value.powf(exponent - 1.0) * self.derivative }
    }
    #[inline(always)]
    fn exponential(self) -> Self {
        let value = self.value.exponential();
        Self { value, derivative: value * self.derivative }
    }
    #[inline(always)]
    fn logarithm(self) -> Self {
        Self { value: self.value.logarithm(), derivative: self.derivative / self.value }
    }
    #[inline(always)]
    fn power(self, exponent: Self) -> Self {
        let value = self.value.power(exponent.value);
        let by_base = exponent.value * self.value.power(exponent.value - T::one()) * self.derivative;
        // Bases of zero and below go with exponents that stay as they are.
        let by_exponent = value * self.value.logarithm() * exponent.derivative;
        let by_exponent = T::select(T::zero().less_than(self.value), by_exponent, T::zero());
        Self { value, derivative: by_base + by_exponent }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.value.less_than(other.value), self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(other.value.less_than(self.value), self, other)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::select(self.value.less_than(T::zero()), -self, self)
    }
    #[inline(always)]
    fn less_than(self, other: Self) -> T::Mask {
        self.value.less_than(other.value)
    }
    #[inline(always)]
    fn select(mask: T::Mask, chosen: Self, otherwise: Self) -> Self {
        Self {
            value: T::select(mask, chosen.value, otherwise.value),
            derivative: T::select(mask, chosen.derivative, otherwise.derivative),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of a dozen operations on numbers of order one.
    const ROUND_OFF: f64 = 1e-14;

    #[inline(always)]
    fn sample<T: Real>(x: T) -> T {
        let (sine, cosine) = x.sin_cos();
        sine * x.sqrt() / (cosine + T::from_f64(2.0)) + x.powf(1.5)
    }

    #[test]
    #[inline(always)]
    fn analytic_first_and_second_derivatives() {
        let x: f64 = 0.7;
        let nested = sample(Dual { value: Dual::variable(x), derivative: Dual::constant(1.0) });
        let (s, c) = (x.sin(), x.cos());
        // f = s √x/(c+2) + x^1.5, differentiated by hand.
        let first = (c * x.sqrt() + s / (2.0 * x.sqrt())) / (c + 2.0)
            + s * x.sqrt() * s / ((c + 2.0) * (c + 2.0))
            + 1.5 * x.sqrt();
        assert!((nested.value.derivative - first).abs() < ROUND_OFF);
        assert!((nested.derivative.value - first).abs() < ROUND_OFF);
        let step = 1e-5;
        let slope = |x: f64| sample(Dual::variable(x)).derivative;
        let second = (slope(x + step) - slope(x - step)) / (2.0 * step);
        // Central difference: step² times a third derivative of order ten.
        assert!((nested.derivative.derivative - second).abs() < 1e-8);
    }

    #[test]
    fn analytic_derivatives_of_exponential_logarithm_and_power() {
        let nested = |x: f64| Dual { value: Dual::variable(x), derivative: Dual::constant(1.0) };
        let x: f64 = 1.7;
        let (e, l) = ((0.3 * x).exp(), x.ln());
        type Number = Dual<Dual<f64>>;
        let c = Number::from_f64;
        let power = x.powf(x);
        for (found, due) in [
            ((c(0.3) * nested(x)).exponential(), [e, 0.3 * e, 0.09 * e]),
            (nested(x).logarithm(), [l, 1.0 / x, -1.0 / (x * x)]),
            (nested(x).power(c(2.3)), [x.powf(2.3), 2.3 * x.powf(1.3), 2.99 * x.powf(0.3)]),
            (c(1.3).power(nested(x)), [1.0, 1.3_f64.ln(), 1.3_f64.ln().powi(2)].map(|share| share * 1.3_f64.powf(x))),
            (nested(x).power(nested(x)), [power, power * (l + 1.0), power * ((l + 1.0) * (l + 1.0) + 1.0 / x)]),
            (nested(-x).power(c(3.0)), [-x * x * x, 3.0 * x * x, -6.0 * x]),
            (nested(0.0).power(c(2.0)), [0.0, 0.0, 2.0]),
        ] {
            let found = [found.value.value, found.value.derivative, found.derivative.derivative];
            assert!(found.iter().zip(due).all(|(a, b)| (a - b).abs() < ROUND_OFF * 10.0), "{found:?} {due:?}");
        }
    }

    #[test]
    #[inline(always)]
    fn identity_choices_carry_the_derivative_of_the_chosen_branch() {
        let x = Dual::<f64>::variable(-0.3);
        assert_eq!(x.abs().derivative, -1.0);
        assert_eq!(x.max(Dual::constant(0.1)).derivative, 0.0);
        assert_eq!(x.min(Dual::constant(0.1)).derivative, 1.0);
    }
}
