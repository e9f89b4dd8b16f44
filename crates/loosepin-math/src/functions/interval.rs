//! Intervals whose ends are rounded outwards: what is computed on them holds every value that exact arithmetic could give.

use crate::functions::angle::sin_cos;
use crate::real::Real;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// All numbers from `low` to `high`, both included.
///
/// Every operation gives an interval that holds the results of all numbers in its operands: sums, products, quotients and roots of the
/// ends are rounded to nearest by the processor, so the next number outwards is a bound. What is no number becomes the whole line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

/// The outcome of a comparison of intervals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Certainty {
    /// The relation holds for all numbers in them.
    Always,
    /// The relation holds for none.
    Never,
    /// The relation holds for some, or is undecided.
    Sometimes,
}

/// Bound of the absolute error of [`sin_cos`] for angles below [`FURTHEST_RAD`]: it is right to about one unit in the last place, which is
/// 1.1e-16 for numbers below 1; ten times as much here.
const SINE_ERROR: f64 = 1.2e-15;
/// Angles beyond have the sine [-1, 1], rad.
const FURTHEST_RAD: f64 = 1e6;

impl Interval {
    /// Every number.
    pub const WHOLE: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY };
    /// Zero alone.
    pub const ZERO: Self = Self { low: 0.0, high: 0.0 };

    /// From `low` to `high`; every number where they are in another order or no numbers.
    #[inline]
    pub fn new(low: f64, high: f64) -> Self {
        if low <= high { Self { low, high } } else { Self::WHOLE }
    }
    /// From `-radius` to `radius`.
    #[inline]
    pub fn around_zero(radius: f64) -> Self {
        Self::new(-radius, radius)
    }
    /// The least number.
    #[inline]
    pub fn low(self) -> f64 {
        self.low
    }
    /// The largest number.
    #[inline]
    pub fn high(self) -> f64 {
        self.high
    }
    /// A number near the middle.
    #[inline]
    pub fn middle(self) -> f64 {
        0.5 * self.low + 0.5 * self.high
    }
    /// The largest magnitude.
    #[inline]
    pub fn magnitude(self) -> f64 {
        f64::max(-self.low, self.high)
    }
    /// Whether both ends are numbers.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
    /// Whether it lies inside `other` and touches none of its ends.
    #[inline]
    pub fn is_inside(self, other: Self) -> bool {
        other.low < self.low && self.high < other.high
    }
    /// The smallest interval that holds both.
    #[inline]
    pub fn hull(self, other: Self) -> Self {
        Self { low: f64::min(self.low, other.low), high: f64::max(self.high, other.high) }
    }
    /// Rounded outwards; `low` and `high` are nearest to the exact ends.
    #[inline(always)]
    fn outwards(low: f64, high: f64) -> Self {
        Self::new(low.next_down(), high.next_up())
    }
    #[inline(always)]
    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }
    #[inline(always)]
    fn is_one(self) -> bool {
        self.low == 1.0 && self.high == 1.0
    }
    /// The whole line but for `value` if it is exact: for functions that nothing here needs over intervals.
    fn only_exact(self, value: impl Fn(f64) -> f64) -> Self {
        // The functions themselves are not exact: a relative error of 1e-12 is far above theirs.
        const ERROR: f64 = 1e-12;
        if self.low != self.high {
            return Self::WHOLE;
        }
        let value = value(self.low);
        Self::new(value - ERROR * value.abs(), value + ERROR * value.abs())
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        Self::outwards(self.low + other.low, self.high + other.high)
    }
}
impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}
impl Mul for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::ZERO;
        }
        if self.is_one() {
            return other;
        }
        if other.is_one() {
            return self;
        }
        let [a, b, c, d] = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        if (a + b + c + d).is_nan() {
            return Self::WHOLE;
        }
        Self::outwards(f64::min(f64::min(a, b), f64::min(c, d)), f64::max(f64::max(a, b), f64::max(c, d)))
    }
}
impl Div for Interval {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        if other.low <= 0.0 && other.high >= 0.0 {
            return Self::WHOLE;
        }
        self * Self::outwards(1.0 / other.high, 1.0 / other.low)
    }
}
impl AddAssign for Interval {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl SubAssign for Interval {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
impl MulAssign for Interval {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Real for Interval {
    type Mask = Certainty;

    const IS_SET: bool = true;
    fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }
    fn part(self, low: f64, high: f64) -> Option<Self> {
        let (low, high) = (f64::max(self.low, low), f64::min(self.high, high));
        (low <= high).then_some(Self { low, high })
    }
    fn joined(self, other: Self) -> Self {
        self.hull(other)
    }

    #[inline]
    fn from_f64(value: f64) -> Self {
        Self::new(value, value)
    }
    fn to_f64(self) -> f64 {
        self.middle()
    }
    #[inline]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn sqrt(self) -> Self {
        if self.low < 0.0 {
            return Self::WHOLE;
        }
        Self::new(self.low.sqrt().next_down().max(0.0), self.high.sqrt().next_up())
    }
    fn sin_cos(self) -> (Self, Self) {
        let everything = Self::new(-1.0, 1.0);
        if !(self.magnitude() < FURTHEST_RAD) {
            return (everything, everything);
        }
        let [(sine_a, cosine_a), (sine_b, cosine_b)] = [sin_cos(self.low), sin_cos(self.high)];
        // Where the interval may hold an extreme, of the sine at (2 k + 1/2) π ± and of the cosine at 2 k π or (2 k + 1) π.
        let turns = |angle_rad: f64, shift: f64| angle_rad / std::f64::consts::TAU - shift;
        let holds = |shift: f64| {
            // Ten thousand times the round-off of a quotient below 2e5.
            const SLACK: f64 = 1e-9;
            (turns(self.low, shift) - SLACK).ceil() <= turns(self.high, shift) + SLACK
        };
        let between = |a: f64, b: f64, highest: f64, lowest: f64| {
            let low = if holds(lowest) { -1.0 } else { f64::max(f64::min(a, b) - SINE_ERROR, -1.0) };
            let high = if holds(highest) { 1.0 } else { f64::min(f64::max(a, b) + SINE_ERROR, 1.0) };
            Self::new(low, high)
        };
        if self.is_zero() {
            return (Self::ZERO, Self::from_f64(1.0));
        }
        (between(sine_a, sine_b, 0.25, 0.75), between(cosine_a, cosine_b, 0.0, 0.5))
    }
    fn powf(self, exponent: f64) -> Self {
        self.only_exact(|value| value.powf(exponent))
    }
    fn exponential(self) -> Self {
        self.only_exact(crate::full_range_exponential)
    }
    fn logarithm(self) -> Self {
        self.only_exact(crate::full_range_logarithm)
    }
    fn power(self, exponent: Self) -> Self {
        if exponent.low != exponent.high {
            return Self::WHOLE;
        }
        self.only_exact(|value| crate::full_range_power(value, exponent.low))
    }
    fn min(self, other: Self) -> Self {
        Self { low: f64::min(self.low, other.low), high: f64::min(self.high, other.high) }
    }
    fn max(self, other: Self) -> Self {
        Self { low: f64::max(self.low, other.low), high: f64::max(self.high, other.high) }
    }
    fn abs(self) -> Self {
        if self.low >= 0.0 {
            self
        } else if self.high <= 0.0 {
            -self
        } else {
            Self { low: 0.0, high: self.magnitude() }
        }
    }
    fn less_than(self, other: Self) -> Certainty {
        if self.high < other.low {
            Certainty::Always
        } else if self.low >= other.high {
            Certainty::Never
        } else {
            Certainty::Sometimes
        }
    }
    fn select(mask: Certainty, chosen: Self, otherwise: Self) -> Self {
        match mask {
            Certainty::Always => chosen,
            Certainty::Never => otherwise,
            Certainty::Sometimes => chosen.hull(otherwise),
        }
    }
    fn nearest_whole(self) -> Self {
        Self::new(self.low.round_ties_even(), self.high.round_ties_even())
    }
    fn squared(self) -> Self {
        let magnitude = self.abs();
        Self::new((magnitude.low * magnitude.low).next_down().max(0.0), (magnitude.high * magnitude.high).next_up())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Dual;

    /// A formula with everything that mechanisms use, over any number.
    fn sample<T: Real>(x: T, y: T) -> T {
        let (sine, cosine) = (x * T::from_f64(3.0) + y).sin_cos();
        let chosen = T::select(x.less_than(y), sine * x, cosine - y);
        chosen / (y.squared() + T::from_f64(0.7)) + (x.abs() + T::from_f64(0.1)).sqrt() * x.max(y) - sine.min(cosine)
    }

    #[test]
    fn identity_what_is_computed_holds_every_value() {
        // Boxes of all sizes, and points in them that no rule repeats.
        for k in 0..400 {
            let part = |salt: f64| (f64::from(k) * salt + 0.377).fract();
            let (x, y) = (6.0 * part(0.618_033_988) - 3.0, 4.0 * part(0.754_877_666) - 2.0);
            let radius = 10f64.powf(-9.0 * part(0.569_840_290));
            let held = |middle: f64| Interval::new(middle - radius, middle + radius);
            let found = sample(held(x), held(y));
            for j in 0..40 {
                let at = |salt: f64| radius * (2.0 * (f64::from(j) * salt).fract() - 1.0);
                let value = sample(x + at(0.618_033_988), y + at(0.754_877_666));
                assert!(found.low() <= value && value <= found.high(), "{k} {value} {found:?}");
            }
        }
    }

    #[test]
    fn identity_derivatives_over_a_box_hold_all_derivatives_in_it() {
        let formula = |x: Dual<Dual<Interval>>| (x * x).sin_cos().0 / (x + Real::from_f64(3.0));
        let plain = |x: Dual<Dual<f64>>| (x * x).sin_cos().0 / (x + Real::from_f64(3.0));
        let box_ = Interval::new(0.4, 0.5);
        let one = Real::from_f64(1.0);
        let over = formula(Dual { value: Dual::variable(box_), derivative: one });
        for k in 0..=20 {
            let x = 0.4 + 0.1 * f64::from(k) / 20.0;
            let at = plain(Dual { value: Dual::variable(x), derivative: Real::from_f64(1.0) });
            for (held, value) in
                [(over.value.derivative, at.value.derivative), (over.derivative.derivative, at.derivative.derivative)]
            {
                assert!(held.low() <= value && value <= held.high(), "{x}: {value} {held:?}");
            }
        }
    }

    #[test]
    fn analytic_sines_over_their_extremes() {
        let quarter = std::f64::consts::FRAC_PI_2;
        for k in -9_i32..9 {
            let at = quarter * f64::from(k);
            let (sine, cosine) = Interval::new(at - 0.1, at + 0.2).sin_cos();
            let (high, low) =
                [(sine.high(), sine.low()), (cosine.high(), cosine.low())][usize::from(k.rem_euclid(2) == 0)];
            // One of the two has an extreme inside, and lies within 2 % of it.
            assert!((high == 1.0 && low > 0.98) || (low == -1.0 && high < -0.98), "{k}: {sine:?} {cosine:?}");
        }
        assert_eq!(Interval::new(0.0, 7.0).sin_cos(), (Interval::new(-1.0, 1.0), Interval::new(-1.0, 1.0)));
        assert_eq!(Interval::new(1e7, 1e7).sin_cos().0, Interval::new(-1.0, 1.0));
    }

    #[test]
    fn what_is_no_number_is_everything() {
        let zero = Interval::new(-0.1, 0.2);
        assert_eq!(Interval::from_f64(1.0) / zero, Interval::WHOLE);
        assert_eq!(Interval::new(f64::NAN, 1.0), Interval::WHOLE);
        assert_eq!(Interval::WHOLE * Interval::new(0.0, 1.0), Interval::WHOLE);
        assert_eq!(zero.sqrt(), Interval::WHOLE);
    }
}
