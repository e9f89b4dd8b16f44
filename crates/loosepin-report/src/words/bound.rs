//! One bound in figures: its ends, rounded outwards, and the parts of its numerical error.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use loosepin_result::study::{BoundEnd, BoundRecord};

/// Ends of an interval are written to this share of its width, or to their error where it is larger.
const RESOLVED_SHARE: f64 = 0.01;

/// What stands for the error or the place of an end that is infinite.
pub(crate) const NO_ERROR: &str = "-";

/// The widened end, rounded outwards.
pub(crate) fn bound_value(end: &BoundEnd, bound: &BoundRecord, rounding: Rounding, writer: &NumberWriter) -> String {
    let part = match rounding {
        Rounding::Down => "lower",
        Rounding::Up => "upper",
        Rounding::Nearest => "value",
    };
    let tag = Tag::bound(bound, part).within(writer.tag());
    let writer = writer.with_tag(&tag);
    if bound.statistic.is_probability() {
        writer.percent(end.widened_si, rounding)
    } else {
        let width_si = bound.upper.widened_si - bound.lower.widened_si;
        resolved(end.widened_si, width_si, end, bound, rounding, &writer)
    }
}

/// The value that was found at an end, moved outwards by its error: of the finished runs, where failed ones leave no bound.
pub(crate) fn finished_value(end: &BoundEnd, bound: &BoundRecord, rounding: Rounding, writer: &NumberWriter) -> String {
    let [lower_si, upper_si] = finished_ends_si(bound);
    let (part, value_si) = match rounding {
        Rounding::Down => ("finished lower", lower_si),
        Rounding::Up | Rounding::Nearest => ("finished upper", upper_si),
    };
    let tag = Tag::bound(bound, part).within(writer.tag());
    resolved(value_si, upper_si - lower_si, end, bound, rounding, &writer.with_tag(&tag))
}

fn finished_ends_si(bound: &BoundRecord) -> [f64; 2] {
    let BoundRecord { lower, upper, .. } = bound;
    [lower.value_si - lower.error.total_si(), upper.value_si + upper.error.total_si()]
}

/// Whether an end of a bound is infinite.
pub(crate) fn has_no_end(bound: &BoundRecord) -> bool {
    bound.lower.widened_si.is_infinite() || bound.upper.widened_si.is_infinite()
}

/// Finer digits than an interval of this width resolves are noise, however small the error is.
fn resolved(
    value_si: f64,
    width_si: f64,
    end: &BoundEnd,
    bound: &BoundRecord,
    rounding: Rounding,
    writer: &NumberWriter,
) -> String {
    let resolved_si = if width_si.is_finite() { RESOLVED_SHARE * width_si } else { 0.0 };
    writer.down_to_error(value_si, end.error.total_si().max(resolved_si), &bound.unit, rounding)
}

/// The value that was found at an end, with its numerical error.
pub(crate) fn found_value(end: &BoundEnd, bound: &BoundRecord, writer: &NumberWriter) -> String {
    let error_si = end.error.total_si();
    let value = if bound.statistic.is_probability() {
        writer.percent(end.value_si, Rounding::Nearest)
    } else {
        writer.down_to_error(end.value_si, error_si, &bound.unit, Rounding::Nearest)
    };
    if error_si == 0.0 { value } else { format!("{value} ± {}", part(error_si, bound, writer)) }
}

/// The larger error of both ends; a dash where an end has none, since it is infinite.
pub(crate) fn bound_error(bound: &BoundRecord, writer: &NumberWriter) -> String {
    let error_si = bound.lower.error.total_si().max(bound.upper.error.total_si());
    if has_no_end(bound) && error_si.is_finite() {
        return NO_ERROR.to_owned();
    }
    error_found(bound, writer)
}

/// The larger error of what was found at both ends, also where failed runs leave no bound.
pub(crate) fn error_found(bound: &BoundRecord, writer: &NumberWriter) -> String {
    let tag = Tag::bound(bound, "error").within(writer.tag());
    part(bound.lower.error.total_si().max(bound.upper.error.total_si()), bound, &writer.with_tag(&tag))
}

fn part(error_si: f64, bound: &BoundRecord, writer: &NumberWriter) -> String {
    if bound.statistic.is_probability() {
        writer.percent(error_si, Rounding::Up)
    } else {
        writer.error(error_si, &bound.unit)
    }
}

/// Which parts of the error are not zero, at the end where it is larger.
pub(crate) fn error_parts(bound: &BoundRecord, writer: &NumberWriter) -> String {
    let error = if bound.upper.error.total_si() >= bound.lower.error.total_si() {
        bound.upper.error
    } else {
        bound.lower.error
    };
    let parts = [("sampling", error.sampling_si), ("search", error.optimisation_si), ("surrogate", error.surrogate_si)];
    let words: Vec<String> = parts
        .into_iter()
        .filter(|(_, value_si)| *value_si != 0.0)
        .map(|(name, value_si)| {
            let tag = Tag::bound(bound, &format!("error {name}"));
            format!("{name} {}", part(value_si, bound, &writer.with_tag(&tag)))
        })
        .collect();
    words.join(", ")
}
