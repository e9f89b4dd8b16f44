//! Numbers for the scripts of a page.

use maud::{Markup, PreEscaped};
use serde::Serialize;

/// Digits of numbers in charts: finer than any screen.
const CHART_DIGITS: usize = 6;

/// A record as JSON that may stand inside a `script` element: `<` cannot occur in it, so nothing can end the element.
pub(super) fn script_json<T: Serialize>(record: &T) -> Markup {
    // These records are lists of numbers and words, which always have a form in JSON.
    let text = serde_json::to_string(record).unwrap_or_else(|_| "null".to_owned());
    PreEscaped(text.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026"))
}

/// Values to the digits of a chart; what is not finite is a gap.
pub(super) fn rounded(values: &[f64]) -> Vec<Option<f64>> {
    values.iter().map(|value| round_to_digits(*value, CHART_DIGITS)).collect()
}

/// The number nearest to `value` with so many significant digits; `None` for what is not finite.
pub(super) fn round_to_digits(value: f64, digits: usize) -> Option<f64> {
    if !value.is_finite() {
        return None;
    }
    format!("{:.*e}", digits.saturating_sub(1), value).parse().ok()
}
