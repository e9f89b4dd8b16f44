//! Numbers as text for people.

/// Significant digits shown: more than a person reads, fewer than round-off reaches.
pub(super) const SHOWN_DIGITS: usize = 7;
/// Digits that distinguish any two numbers.
pub(super) const ALL_DIGITS: usize = 17;

/// Decimal exponents outside this range are written with an exponent.
const PLAIN_EXPONENTS: std::ops::RangeInclusive<i32> = -4..=6;

/// A number with up to seven significant digits and no trailing zeros, for example `0.05`, `6.61e10`.
pub fn format_number(value: f64) -> String {
    format_digits(value, SHOWN_DIGITS)
}

/// A number with up to `digits` significant digits and no trailing zeros.
pub(super) fn format_digits(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return if value.is_nan() {
            "NaN".to_owned()
        } else if value > 0.0 {
            "infinity".to_owned()
        } else {
            "-infinity".to_owned()
        };
    }
    let scientific = format!("{value:.*e}", digits - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if PLAIN_EXPONENTS.contains(&exponent) {
        let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
        without_trailing_zeros(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", without_trailing_zeros(mantissa))
    }
}

/// The exponent of the leading digit: n of 1.23e(n). None for zero and for what is not finite.
pub fn decimal_exponent(value: f64) -> Option<i32> {
    if value == 0.0 || !value.is_finite() {
        return None;
    }
    // Written by the formatter, so that the exponent is exact where a logarithm may be off by one.
    format!("{value:e}").split_once('e').and_then(|(_, exponent)| exponent.parse().ok())
}

/// 10 to this power, the same on every machine: parsed, since powers of the platform may differ in their last digit.
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

fn without_trailing_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_those_of_the_leading_digit() {
        for (value, exponent) in [(1e-5, -5), (9.999e-6, -6), (-123.0, 2), (1.0, 0), (1e22, 22)] {
            assert_eq!(decimal_exponent(value), Some(exponent), "{value:e}");
        }
        assert_eq!([0.0, f64::NAN, f64::INFINITY].map(decimal_exponent), [None; 3]);
        assert_eq!([-5, 0, 3].map(power_of_ten), [1e-5, 1.0, 1e3]);
    }

    #[test]
    fn numbers_show_what_was_written() {
        for (value, text) in [
            (0.5, "0.5"),
            (-0.05, "-0.05"),
            (1e-4, "0.0001"),
            (1e-5, "1e-5"),
            (120.0, "120"),
            (6.610198e10, "6.610198e10"),
            (1_234_567.0, "1234567"),
            (1e7, "1e7"),
            (1.0 / 3.0, "0.3333333"),
            (f64::NAN, "NaN"),
            (0.0, "0"),
            (-0.0, "0"),
        ] {
            assert_eq!(format_number(value), text);
        }
    }
}
