//! Numbers for the scripts of a page.

use maud::{Markup, PreEscaped};
use serde::Serialize;

/// Digits of numbers in charts: finer than any screen.
pub(crate) const CHART_DIGITS: usize = 6;

/// A record as JSON that may stand inside a `script` element: `<` cannot occur in it, so nothing can end the element.
pub(crate) fn script_json<T: Serialize>(record: &T) -> Markup {
    // These records are lists of numbers and words, which always have a form in JSON.
    let text = serde_json::to_string(record).unwrap_or_else(|_| "null".to_owned());
    PreEscaped(text.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026"))
}

/// Digits that a number with all its places has at most, without round-off.
const MAX_DIGITS: usize = 15;
/// Values below this share of the largest one are round-off; neighbours that are closer differ by it.
const ROUND_OFF_SHARE: f64 = 1e-12;

/// Digits that distinguish all `values` from their neighbours, to a hundredth of the least distance; at least `fewest`.
pub(crate) fn distinguishing_digits(values: &[f64], fewest: usize) -> usize {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let largest = finite().fold(0.0, |most: f64, value| most.max(value.abs()));
    let gaps = finite().zip(finite().skip(1)).map(|(one, next)| (next - one).abs());
    let least = gaps.filter(|gap| *gap > ROUND_OFF_SHARE * largest).fold(f64::INFINITY, f64::min);
    let places = largest.log10().floor() - least.log10().floor();
    if places.is_finite() { (places.max(0.0) as usize + 3).clamp(fewest, MAX_DIGITS.max(fewest)) } else { fewest }
}

/// Values of a horizontal axis: to the digits of a chart, and to more where neighbours need them.
pub(crate) fn rounded_distinct(values: &[f64]) -> Vec<Option<f64>> {
    let digits = distinguishing_digits(values, CHART_DIGITS);
    values.iter().map(|value| round_to_digits(*value, digits)).collect()
}

/// Values to the digits of a chart; what is not finite is a gap, and what is nothing but round-off beside the largest of them is 0.
pub(crate) fn rounded(values: &[f64]) -> Vec<Option<f64>> {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let largest = finite.fold(0.0, |most: f64, value| most.max(value.abs()));
    let shown = |value: f64| if value.abs() < ROUND_OFF_SHARE * largest { 0.0 } else { value };
    values.iter().map(|value| round_to_digits(shown(*value), CHART_DIGITS)).collect()
}

/// The number nearest to `value` with `digits` significant digits; `None` if it is not finite.
pub(crate) fn round_to_digits(value: f64, digits: usize) -> Option<f64> {
    if !value.is_finite() {
        return None;
    }
    format!("{:.*e}", digits.saturating_sub(1), value).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{distinguishing_digits, rounded, rounded_distinct};

    #[test]
    fn analytic_round_off_beside_other_values_is_zero() {
        assert_eq!(rounded(&[5.551e-18, -3.0, f64::NAN, 0.25]), [Some(0.0), Some(-3.0), None, Some(0.25)]);
        assert_eq!(rounded(&[5.551e-18, 2e-17]), [Some(5.551e-18), Some(2e-17)]);
    }

    #[test]
    fn analytic_neighbours_stay_apart_and_have_no_noise() {
        // A record that begins late, with samples 0.1 ms apart.
        let late: Vec<f64> = (0..5000).map(|sample| 1000.0 + 1e-4 * f64::from(sample)).collect();
        let written: Vec<String> =
            rounded_distinct(&late).into_iter().flatten().map(|value| value.to_string()).collect();
        assert_eq!(written[..3], ["1000", "1000.0001", "1000.0002"]);
        assert!(written.windows(2).all(|pair| pair[0] != pair[1]));
        assert!(written.iter().all(|text| text.len() <= "1000.0001".len()), "no noise");
        // Six digits were enough before.
        let degrees: Vec<f64> = (0..180).map(|pose| f64::from(2 * pose) + 1.0 / 3.0).collect();
        assert_eq!(rounded_distinct(&degrees)[100], Some(200.333));
        assert_eq!(distinguishing_digits(&[], 4), 4);
        assert_eq!(distinguishing_digits(&[7.0], 4), 4);
        assert_eq!(distinguishing_digits(&[7.0, 7.0, f64::NAN, 7.0], 4), 4);
        // Two samples at one time, but for round-off.
        assert_eq!(distinguishing_digits(&[0.3, 0.1 + 0.2, 0.4], 4), 4);
    }
}
