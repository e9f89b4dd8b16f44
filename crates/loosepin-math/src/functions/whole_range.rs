//! Exponential, logarithm and powers of all numbers, for expressions that people write.
//!
//! The functions of [`super::exponential`] serve contact laws, whose numbers are known to keep within limits. These here give an
//! infinity where the result is too large, and no number at all where there is none, so that it shows.

use crate::Real;
use crate::functions::exponential::{DOWNWARDS, exponential_between, parts_from_scaled, scaled_up};

/// Arguments of the exponential: below the first the result is zero, from the second on it is infinite.
const ARGUMENTS: [f64; 2] = [-700.0, 709.0];

/// eˣ to about one unit in the last place; zero below -700, infinite from 709 on.
#[inline(never)]
pub fn full_range_exponential<T: Real>(x: T) -> T {
    let [least, most] = ARGUMENTS.map(T::from_f64);
    let value = exponential_between(x, ARGUMENTS, &DOWNWARDS);
    let value = T::select(x.less_than(least), T::zero(), value);
    // What is no number is not below the limit either, and stays none.
    T::select(x.less_than(most), value, x + T::from_f64(f64::INFINITY))
}

/// ln x to about one unit in the last place; a positive number below 1e-300 counts as 1e-300. Not a number for zero and below.
#[inline(never)]
pub fn full_range_logarithm<T: Real>(x: T) -> T {
    let (scaled, twos) = scaled_up(x);
    let [logarithm, _] = parts_from_scaled(scaled, twos, &DOWNWARDS);
    T::select(T::zero().less_than(x), logarithm, T::from_f64(f64::NAN))
}

/// xʸ by exp(y ln x), to two units in the last place for exponents up to 4 in size and to ten for all: an error of the logarithm
/// counts y times. Not a number for a base below zero with an exponent that is not whole,
/// and for the base zero with an exponent below zero.
#[inline(never)]
pub fn full_range_power<T: Real>(x: T, y: T) -> T {
    let (zero, one, none) = (T::zero(), T::one(), T::from_f64(f64::NAN));
    let (scaled, twos) = scaled_up(x.abs());
    let [logarithm, missing] = parts_from_scaled(scaled, twos, &DOWNWARDS);
    let product = y * logarithm;
    let rest = y.mul_add(missing, y.mul_add(logarithm, -product));
    let rounded = full_range_exponential(product);
    let size = T::select(rounded.less_than(T::from_f64(f64::MAX)), rounded.mul_add(rest, rounded), rounded);

    let tiny = T::from_f64(f64::MIN_POSITIVE);
    let half = T::from_f64(0.5) * y;
    let is_whole = (y - y.nearest_whole()).abs().less_than(tiny);
    let is_even = (half - half.nearest_whole()).abs().less_than(tiny);
    let of_negative = T::select(is_whole, T::select(is_even, size, -size), none);
    let of_zero = T::select(zero.less_than(y), zero, T::select(y.less_than(zero), none, y + one));
    // What is no number stays none.
    let of_others = T::select(x.less_than(zero), of_negative, x + of_zero);
    T::select(zero.less_than(x), size, of_others)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two units in the last place.
    const RELATIVE: f64 = 4.5e-16;

    #[test]
    fn peer_exponential_agrees_with_libm_over_all_numbers() {
        let mut x = -699.9;
        while x < 709.0 {
            let (ours, theirs) = (full_range_exponential(x), libm::exp(x));
            assert!((ours - theirs).abs() <= RELATIVE * theirs, "exp {x}: {ours} {theirs}");
            x += 0.007_31;
        }
        for (x, due) in
            [(-701.0, 0.0), (f64::NEG_INFINITY, 0.0), (709.0, f64::INFINITY), (f64::INFINITY, f64::INFINITY)]
        {
            assert_eq!(full_range_exponential(x), due, "exp {x}");
        }
        assert_eq!(full_range_exponential(0.0), 1.0);
        assert!(full_range_exponential(f64::NAN).is_nan());
    }

    #[test]
    fn peer_logarithm_agrees_with_libm_over_all_numbers() {
        let mut x = 1.3e-300;
        while x < 1e308 {
            for value in [x, x * 1.000_013, x * 1.41] {
                let (ours, theirs) = (full_range_logarithm(value), libm::log(value));
                assert!((ours - theirs).abs() <= RELATIVE * theirs.abs(), "ln {value}: {ours} {theirs}");
            }
            x *= 1.037;
        }
        assert_eq!(full_range_logarithm(1.0), 0.0);
        for x in [0.0, -0.0, -1e-300, -3.0, f64::NEG_INFINITY, f64::NAN] {
            assert!(full_range_logarithm(x).is_nan(), "ln {x}");
        }
    }

    #[test]
    fn peer_power_agrees_with_libm_in_its_last_places() {
        let mut largest = [0.0_f64; 2];
        for y in [-31.4, -2.7, -1.0, -0.3, 0.0, 0.5, 1.0, 1.3, 2.0, 3.0, 17.9, 101.0] {
            for x in (-330..330).map(|k| 10_f64.powf(f64::from(k) / 110.0 + 1e-3)) {
                for x in [x, -x] {
                    let (ours, theirs) = (full_range_power(x, y), libm::pow(x, y));
                    assert_eq!(ours.is_nan(), theirs.is_nan(), "{x} ^ {y}: {ours} {theirs}");
                    if theirs.is_nan() || theirs == 0.0 || theirs.is_infinite() {
                        continue;
                    }
                    let unit = theirs.abs().next_up() - theirs.abs();
                    let worst = &mut largest[usize::from(y.abs() > 4.0)];
                    *worst = worst.max((ours - theirs).abs() / unit);
                }
            }
        }
        assert!(largest[0] <= 2.0 && largest[1] <= 10.0, "{largest:?} units in the last place");
    }

    #[test]
    fn analytic_powers_at_the_ends() {
        for (x, y, due) in
            [(0.0, 0.3, 0.0), (0.0, 0.0, 1.0), (1.0, 1e9, 1.0), (2.0, 1e9, f64::INFINITY), (2.0, -1e9, 0.0)]
        {
            assert_eq!(full_range_power(x, y), due, "{x} ^ {y}");
        }
        for (x, y) in [(0.0, -1.0), (-2.0, 0.5), (f64::NAN, 2.0), (2.0, f64::NAN), (0.0, f64::NAN), (-2.0, f64::NAN)] {
            assert!(full_range_power(x, y).is_nan(), "{x} ^ {y}");
        }
    }
}
