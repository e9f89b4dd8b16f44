//! Runs that failed: how many, why, and what they leave without a bound.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::bound::{finished_value, has_no_end};
use crate::words::few_samples::too_few_samples;
use crate::words::wording::{count, is_by_surrogate};
use loosepin_result::study::{BoundRecord, StudyResult};

/// From this share of failed runs on, an answer begins with them.
const MIN_LEADING_SHARE: f64 = 0.01;

/// "9.4 % of the runs failed (276 of 2944): the mechanism cannot be put together." Where this is a main fact of the study: many runs failed, or
/// they leave a statistic without a bound. `None` elsewhere.
pub(crate) fn failed_sentence(result: &StudyResult, writer: &NumberWriter) -> Option<String> {
    let counts = &result.counts;
    let share = counts.failed as f64 / counts.runs.max(1) as f64;
    let mixed = || result.bounds.iter().filter(|bound| bound.treatment.is_mixed());
    let leaves_no_bound = || mixed().any(|bound| why_no_end(result, bound, writer).is_some());
    if counts.failed == 0 || (share < MIN_LEADING_SHARE && !leaves_no_bound()) {
        return None;
    }
    let share = writer.with_tag(&Tag::whole("failed runs", "share")).percent(share, Rounding::Up);
    let failed = count(counts.failed, &writer.with_tag(&Tag::Count("failed runs")));
    let runs = count(counts.runs, &writer.with_tag(&Tag::Count("runs")));
    let reason = result.failures.first().and_then(|first| {
        let words = reason_words(&first.code)?;
        Some(match result.failures.len() {
            1 => format!(": {words}"),
            _ if 2 * first.count > counts.failed => format!(", most of them for one reason: {words}"),
            _ => format!(". The most frequent reason: {words}"),
        })
    });
    Some(format!("{share} of the runs failed ({failed} of {runs}){}.", reason.unwrap_or_default()))
}

/// The reason of a group of failed runs in a clause, where the parts of a mechanism do not go together; the table of failures has all reasons.
fn reason_words(code: &str) -> Option<&'static str> {
    match code {
        "cannot_be_put_together" => Some("the mechanism cannot be put together"),
        "cannot_close" => Some("the links cannot close"),
        "dead_centre" => Some("play takes the mechanism to a dead centre"),
        "singular_position" => Some("the mechanism comes to a singular position"),
        "no_position" => Some("the mechanism has no position"),
        "joint_jams" => Some("a joint jams"),
        "impossible_value" => Some("a value is impossible"),
        _ => None,
    }
}

/// Why failed runs leave a bound without an end; `None` where it has both, or where they are not the reason.
pub(crate) fn why_no_end(result: &StudyResult, bound: &BoundRecord, writer: &NumberWriter) -> Option<&'static str> {
    if bound.guarantee.is_of_finished_runs() {
        return Some("a failed run may have had any value");
    }
    let probability = bound.statistic.probability_of_quantile()?;
    if has_no_end(bound) { why_quantile_has_no_end(result, &[probability], writer) } else { None }
}

/// The same of quantiles at these probabilities, of which one has no end.
pub(crate) fn why_quantile_has_no_end(
    result: &StudyResult,
    probabilities: &[f64],
    writer: &NumberWriter,
) -> Option<&'static str> {
    if result.counts.failed == 0 || too_few_samples(result, probabilities, writer).is_some() {
        return None;
    }
    Some(match is_by_surrogate(result) {
        true => "runs failed, which a surrogate does not learn",
        false => "so many runs failed that the quantile may be among them",
    })
}

/// "finished runs: 0° to 0.0546°": the statistic of the finished runs, with its numerical error; `None` if it is not one of these alone.
pub(crate) fn finished_words(bound: &BoundRecord, between: [&str; 2], writer: &NumberWriter) -> Option<String> {
    let is_known = [&bound.lower, &bound.upper].iter().all(|end| end.value_si.is_finite());
    if !bound.guarantee.is_of_finished_runs() || !is_known {
        return None;
    }
    let lower = finished_value(&bound.lower, bound, Rounding::Down, writer);
    let upper = finished_value(&bound.upper, bound, Rounding::Up, writer);
    let [before, and] = between;
    Some(format!("{before}{lower}{and}{upper}"))
}
