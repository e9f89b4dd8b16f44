//! Both ends of an interval, as identifications show them.

use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_text::units::SiUnit;

/// Digits of a bound.
pub(super) const BOUND_DIGITS: usize = 4;

/// A stated interval, in the fewest digits that identify it.
pub(super) fn stated(ends_si: [f64; 2], unit: &SiUnit, writer: &NumberWriter<'_>) -> String {
    format!("{} to {}", writer.value_shortest(ends_si[0], unit), writer.value_shortest(ends_si[1], unit))
}

/// Both ends, rounded outwards.
pub(super) fn range(ends_si: [f64; 2], unit: &SiUnit, writer: &NumberWriter<'_>) -> String {
    range_digits(ends_si, unit, BOUND_DIGITS, writer)
}

/// Both ends, rounded outwards to some digits.
pub(super) fn range_digits(ends_si: [f64; 2], unit: &SiUnit, digits: usize, writer: &NumberWriter<'_>) -> String {
    let [lower, upper] = [(ends_si[0], Rounding::Down), (ends_si[1], Rounding::Up)];
    let shown = |(value_si, rounding): (f64, Rounding)| {
        if value_si == 0.0 { writer.value_trimmed(0.0, unit) } else { writer.rounded(value_si, unit, digits, rounding) }
    };
    format!("{} to {}", shown(lower), shown(upper))
}
