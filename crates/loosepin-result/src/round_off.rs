//! Numbers of answers that are nothing but round-off.

use loosepin_text::units::SiUnit;

/// A number below this share of the size of the mechanism, or of a radian, is round-off: positions of closed loops have 16 digits, and what their
/// derivatives lose of them is less than the rest.
const SHARE: f64 = 1e-12;

/// Size below which a number of an output of a mechanism of `size_m` is round-off, in the unit of the output; 0 of what is no length and no angle:
/// how large that is otherwise is not known.
pub fn round_off_si(unit: &SiUnit, size_m: f64) -> f64 {
    if *unit == SiUnit::LENGTH {
        SHARE * size_m
    } else if *unit == SiUnit::ANGLE {
        SHARE
    } else {
        0.0
    }
}

/// Puts 0 in the place of numbers below `threshold_si`.
pub fn drop_round_off<'n>(numbers: impl IntoIterator<Item = &'n mut f64>, threshold_si: f64) {
    for number in numbers.into_iter().filter(|number| number.abs() < threshold_si) {
        *number = 0.0;
    }
}
