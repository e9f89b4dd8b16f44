//! Logarithm and exponential with the same bits on every processor.
//!
//! A [`Real`] cannot take its exponent apart, so the powers of two are found by multiplications that are exact: one for each
//! binary digit of the exponent, made or not made by a choice. The functions are long and used at many places, so that they are
//! compiled out of line, unlike other equations.

use crate::Real;

/// ln 2 as the sum of two numbers; the first has zeros at its end, so that its multiples are exact.
const LN_2_PARTS: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

// Minimax coefficients of fdlibm's `e_log.c`, for √½ to √2, and of its `e_exp.c`, for -½ ln 2 to ½ ln 2.
const LOGARITHM: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];
const EXPONENTIAL: [f64; 5] = [
    1.666_666_666_666_660_2e-1,
    -2.777_777_777_701_559_3e-3,
    6.613_756_321_437_934e-5,
    -1.653_390_220_546_525_2e-6,
    4.138_136_797_057_238_5e-8,
];

/// Binary digits of exponents, from the largest: up to 2¹⁰²³ downwards and up to 2⁶³ upwards.
pub(crate) const DOWNWARDS: [i32; 10] = [512, 256, 128, 64, 32, 16, 8, 4, 2, 1];
const UPWARDS: [i32; 6] = [32, 16, 8, 4, 2, 1];

/// The smallest number that [`natural_logarithm`] distinguishes from smaller ones.
const SMALLEST: f64 = 1e-300;
/// The smallest and largest argument of [`exponential`].
const ARGUMENTS: [f64; 2] = [-700.0, 43.0];

/// ln x for x from 1e-300 to 2⁶⁴, to about one unit in the last place, on any [`Real`]. A smaller x counts as 1e-300, a larger
/// one means nothing.
#[inline(never)]
pub fn natural_logarithm<T: Real>(x: T) -> T {
    let (scaled, exponent) = scaled_up(x);
    from_scaled(scaled, exponent)
}

/// x as 2^exponent · scaled with `scaled` at least 1: the scaled number and the exponent, which is zero or less.
#[inline(always)]
pub(crate) fn scaled_up<T: Real>(x: T) -> (T, T) {
    let (mut scaled, mut exponent) = (x.max(T::from_f64(SMALLEST)), T::zero());
    for digits in DOWNWARDS {
        // The largest power of two with which x stays below 2.
        let larger = scaled * T::from_f64(power_of_two(digits));
        let fits = larger.less_than(T::from_f64(2.0));
        scaled = T::select(fits, larger, scaled);
        exponent = T::select(fits, exponent - T::from_f64(f64::from(digits)), exponent);
    }
    (scaled, exponent)
}

/// ln x for x from 1 to 2⁶⁴, with less work than [`natural_logarithm`].
#[inline(never)]
pub fn logarithm_above_one<T: Real>(x: T) -> T {
    from_scaled(x, T::zero())
}

/// ln(2^exponent · scaled) with `scaled` at least 1.
#[inline(always)]
fn from_scaled<T: Real>(scaled: T, exponent: T) -> T {
    let [logarithm, _] = parts_from_scaled(scaled, exponent, &UPWARDS);
    logarithm
}

/// ln(2^exponent · scaled) with `scaled` from 1 to twice two to the power of all of `upwards`, and what is missing in that number.
#[inline(always)]
pub(crate) fn parts_from_scaled<T: Real>(mut scaled: T, mut exponent: T, upwards: &[i32]) -> [T; 2] {
    for &digits in upwards {
        let smaller = scaled * T::from_f64(power_of_two(-digits));
        let keeps = smaller.less_than(T::one());
        scaled = T::select(keeps, scaled, smaller);
        exponent = T::select(keeps, exponent, exponent + T::from_f64(f64::from(digits)));
    }
    // From [1, 2) to [√½, √2).
    let is_low = scaled.less_than(T::from_f64(std::f64::consts::SQRT_2));
    scaled = T::select(is_low, scaled, scaled * T::from_f64(0.5));
    exponent = T::select(is_low, exponent, exponent + T::one());
    let f = scaled - T::one();
    let half_square = T::from_f64(0.5) * f * f;
    let s = f / (T::from_f64(2.0) + f);
    let square = s * s;
    let series = square * polynomial(square, &LOGARITHM);
    let tail = exponent.mul_add(T::from_f64(LN_2_PARTS[1]), s * (half_square + series));
    // The first part of ln 2 has room for the exponent: the product is exact.
    let (whole, small) = (exponent * T::from_f64(LN_2_PARTS[0]), tail - half_square);
    let rest = f + small;
    let sum = exponent.mul_add(T::from_f64(LN_2_PARTS[0]), rest);
    [sum, (whole - sum + rest) + (f - rest + small)]
}

/// x^n for x from 1e-300 to 2⁶⁴ and n ln x from -700 to 43, to about two units in the last place, on any [`Real`]; beyond these
/// limits about as at them, and zero where x is zero or less.
///
/// exp(n ln x) with the logarithm and its product as sums of two numbers: n ln x may be 30, and so would be the error.
#[inline(never)]
pub fn power<T: Real>(x: T, exponent: f64) -> T {
    let exponent = T::from_f64(exponent);
    let (scaled, twos) = scaled_up(x);
    let [logarithm, missing] = parts_from_scaled(scaled, twos, &UPWARDS);
    let product = exponent * logarithm;
    let rest = exponent.mul_add(missing, exponent.mul_add(logarithm, -product));
    let value = exponential(product);
    T::select(T::zero().less_than(x), value.mul_add(rest, value), T::zero())
}

/// eˣ for x from -700 to 43, to about one unit in the last place, on any [`Real`]; beyond them as at them.
#[inline(never)]
pub fn exponential<T: Real>(x: T) -> T {
    exponential_between(x, ARGUMENTS, &UPWARDS)
}

/// eˣ for x between two limits, beyond them as at them; two to the power of all of `upwards` is about the result at the upper one.
#[inline(always)]
pub(crate) fn exponential_between<T: Real>(x: T, limits: [f64; 2], upwards: &[i32]) -> T {
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    let x = x.max(T::from_f64(limits[0])).min(T::from_f64(limits[1]));
    // Adding and taking away 1.5 · 2⁵² rounds to the nearest whole number.
    let rounder = T::from_f64(ROUNDER);
    let mut exponent = x * T::from_f64(std::f64::consts::LOG2_E) + rounder - rounder;
    let high = exponent.mul_add(T::from_f64(-LN_2_PARTS[0]), x);
    let low = exponent * T::from_f64(LN_2_PARTS[1]);
    let reduced = high - low;
    let square = reduced * reduced;
    let c = reduced - square * polynomial(square, &EXPONENTIAL);
    let mut value = T::one() + (reduced * c / (T::from_f64(2.0) - c) - low + high);
    for digits in DOWNWARDS {
        let is_set = exponent.less_than(T::from_f64(0.5 - f64::from(digits)));
        value = T::select(is_set, value * T::from_f64(power_of_two(-digits)), value);
        exponent = T::select(is_set, exponent + T::from_f64(f64::from(digits)), exponent);
    }
    for &digits in upwards {
        let is_clear = exponent.less_than(T::from_f64(f64::from(digits) - 0.5));
        value = T::select(is_clear, value, value * T::from_f64(power_of_two(digits)));
        exponent = T::select(is_clear, exponent, exponent - T::from_f64(f64::from(digits)));
    }
    value
}

/// tanh x, to about one unit in the last place of 1, on any [`Real`].
#[inline(always)]
pub fn hyperbolic_tangent<T: Real>(x: T) -> T {
    let decay = exponential(x.abs() * T::from_f64(-2.0));
    let size = (T::one() - decay) / (T::one() + decay);
    T::select(x.less_than(T::zero()), -size, size)
}

/// 2^exponent, exactly, for exponents from -1022 to 1023.
const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}

/// Σ c_k xᵏ by Horner's rule.
#[inline(always)]
fn polynomial<T: Real, const N: usize>(x: T, coefficients: &[f64; N]) -> T {
    let mut sum = T::from_f64(coefficients[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.mul_add(x, T::from_f64(coefficients[k]));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two units in the last place.
    const RELATIVE: f64 = 4.5e-16;

    #[test]
    fn peer_logarithm_agrees_with_libm_over_its_range() {
        let mut x = 1.3e-300;
        while x < 1.8e19 {
            for value in [x, x * 1.000_013, x * 1.41] {
                let (ours, theirs) = (natural_logarithm(value), libm::log(value));
                assert!((ours - theirs).abs() <= RELATIVE * theirs.abs(), "ln {value}: {ours} {theirs}");
                if value >= 1.0 {
                    assert_eq!(logarithm_above_one(value), ours);
                }
            }
            x *= 1.037;
        }
        for offset in [1e-15, 3e-9, 2e-4, 0.1] {
            let (ours, theirs) = (natural_logarithm(1.0 - offset), libm::log(1.0 - offset));
            assert!((ours - theirs).abs() <= RELATIVE * theirs.abs(), "ln 1 - {offset}: {ours} {theirs}");
        }
    }

    #[test]
    fn analytic_special_values() {
        assert_eq!(natural_logarithm(1.0), 0.0);
        assert_eq!(natural_logarithm(0.0), natural_logarithm(1e-300));
        assert_eq!(exponential(0.0), 1.0);
        assert_eq!(exponential(-1e9), exponential(-700.0));
        assert_eq!(exponential(1e9), exponential(43.0));
        assert_eq!(hyperbolic_tangent(0.0), 0.0);
        assert_eq!(hyperbolic_tangent(-1e3), -1.0);
    }

    #[test]
    fn peer_exponential_agrees_with_libm_over_its_range() {
        let mut x = -699.9;
        while x < 42.9 {
            let (ours, theirs) = (exponential(x), libm::exp(x));
            assert!((ours - theirs).abs() <= RELATIVE * theirs, "exp {x}: {ours} {theirs}");
            x += 0.007_31;
        }
    }

    #[test]
    fn peer_power_agrees_with_libm_within_two_units_in_the_last_place() {
        let mut largest: f64 = 0.0;
        for exponent in [-0.7, 0.1, 0.3, 1.0 / 3.0, 1.07, 1.1, 1.3, 2.0, 2.2, 3.7] {
            let mut x = 1e-12;
            while x < 1e3 {
                let (ours, theirs) = (power(x, exponent), libm::pow(x, exponent));
                let unit = theirs.abs().next_up() - theirs.abs();
                largest = largest.max((ours - theirs).abs() / unit);
                x *= 1.003_7;
            }
        }
        assert!(largest <= 2.0, "{largest} units in the last place");
    }

    #[test]
    fn analytic_powers_at_the_ends() {
        for exponent in [0.3, 1.3, 2.7] {
            assert_eq!(power(0.0, exponent), 0.0);
            assert_eq!(power(1.0, exponent), 1.0);
        }
        // Beyond the limits what the product was rounded by still counts.
        let (ours, limit) = (power(1e-290, 3.0), exponential(-700.0));
        assert!((ours / limit - 1.0).abs() < 1e-12, "{ours}");
    }

    #[test]
    fn peer_hyperbolic_tangent_agrees_with_libm() {
        let mut x = -21.0;
        while x < 21.0 {
            let (ours, theirs) = (hyperbolic_tangent(x), libm::tanh(x));
            assert!((ours - theirs).abs() <= RELATIVE, "tanh {x}: {ours} {theirs}");
            x += 0.001_37;
        }
    }
}
