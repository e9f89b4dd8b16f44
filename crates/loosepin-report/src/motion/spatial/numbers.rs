//! Numbers of a motion in space in the unit that fits their size.

use crate::numbers::number::within_turn_rad;
use crate::spatial::turn::is_whole_turn;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::Medium;
use loosepin_text::units::{Dimension, DisplayUnit, SiUnit, format_number, format_value};
use std::f64::consts::PI;

/// Digits of deviations.
const DIGITS: i32 = 4;
/// Digits of proven ends, which lie a little beyond what was found.
const END_DIGITS: i32 = 5;
/// A number below this share of those that it stands with is round-off.
const ROUND_OFF: f64 = 1e-12;
/// Below these sizes, m and rad, smaller units are used.
const SMALL_M: f64 = 1e-3;
const SMALL_RAD: f64 = 1e-2;

/// The unit in which numbers of the size of `scale_si` are shown.
pub(super) fn unit_of_size(unit: &SiUnit, scale_si: f64, medium: Medium) -> DisplayUnit {
    let size = scale_si.abs();
    let is_small = |limit: f64| size > 0.0 && size < limit;
    let (symbol, per_si) = match (*unit == SiUnit::LENGTH, *unit == SiUnit::ANGLE) {
        (true, _) if is_small(SMALL_M) => ("µm", 1e6),
        (true, _) => ("mm", 1e3),
        (_, true) if is_small(SMALL_RAD) => ("mrad", 1e3),
        (_, true) => (if medium == Medium::Page { "°" } else { "deg" }, 180.0 / PI),
        _ => (unit.symbol(), 1.0),
    };
    DisplayUnit { symbol: symbol.to_owned(), per_si }
}

/// A deviation in the unit that fits the worst case of its output.
pub(super) fn shown_deviation(value_si: f64, output: &SpatialOutputRecord, medium: Medium) -> String {
    let scale_si = output.first_order_si.get(output.worst.sample).copied().unwrap_or(value_si);
    shown(value_si, &output.unit, scale_si, medium)
}

/// An end that no deviation passes, rounded away from the deviations: -1 for the lower one, 1 for the upper one.
pub(super) fn shown_end(value_si: f64, side: f64, output: &SpatialOutputRecord, medium: Medium) -> String {
    let scale_si = output.first_order_si.get(output.worst.sample).copied().unwrap_or(value_si);
    let unit = unit_of_size(&output.unit, scale_si, medium);
    let value = side * value_si * unit.per_si;
    let step = if value == 0.0 { 1.0 } else { 10_f64.powi(value.abs().log10().floor() as i32 - END_DIGITS + 1) };
    let steps = value / step;
    // What the conversion of units has lost counts too.
    with_symbol(side * ((steps + 4.0 * f64::EPSILON * steps.abs()).ceil() * step), &unit, medium)
}

/// What the record is over, in words.
pub(super) fn span_words(record: &SpatialMotionRecord) -> &'static str {
    if is_whole_turn(record) { "turn" } else { "cycle" }
}

/// The input at a position. On a page an angle of a whole turn counts from 0° to 360°, as in charts.
pub(super) fn shown_input(record: &SpatialMotionRecord, sample: usize, medium: Medium) -> String {
    let own = record.inputs_si.get(sample).copied().unwrap_or_default();
    let is_within = medium == Medium::Page && is_whole_turn(record);
    let input = if is_within { within_turn_rad(own) } else { own };
    shown(input, &record.input_unit, input, medium)
}

/// A number with the unit that fits a number of the size of `scale_si`.
pub(super) fn shown(value_si: f64, unit: &SiUnit, scale_si: f64, medium: Medium) -> String {
    if *unit == SiUnit::TIME {
        let text = format_value(rounded(value_si), Dimension::TIME);
        return if medium == Medium::Page { text.replace(' ', "\u{a0}") } else { text };
    }
    let unit = unit_of_size(unit, scale_si, medium);
    let value_si = if value_si.abs() < ROUND_OFF * scale_si.abs() { 0.0 } else { value_si };
    with_symbol(rounded(value_si * unit.per_si), &unit, medium)
}

fn with_symbol(value: f64, DisplayUnit { symbol, .. }: &DisplayUnit, medium: Medium) -> String {
    let number = format_number(value);
    match (medium, symbol.as_str()) {
        (Medium::Page, "°") => format!("{}°", number.replace('-', "−")),
        (Medium::Page, _) => format!("{}\u{a0}{symbol}", number.replace('-', "−")),
        _ => format!("{number} {symbol}"),
    }
}

fn rounded(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let digits = DIGITS - 1 - value.abs().log10().floor() as i32;
    let scale = 10_f64.powi(digits);
    // Text that is read back has no digits of round-off.
    if digits >= 0 { (value * scale).round() / scale } else { value.round() }
}
