//! One line on a study before it is finished.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::study::output_summary::main_bound;
use crate::words::wording::{statistic_words, verdict_words};
use loosepin_result::study::{BoundRecord, Draft};

/// A line on the intermediate results: the largest deviation of the main output so far, with its numerical error, and the verdict. Empty
/// where nothing is known yet.
pub fn draft_text(draft: &Draft) -> String {
    let writer = NumberWriter::for_terminal(&draft.display_units);
    let verdict = draft.verdict().map(|verdict| format!("requirements {}", verdict_words(verdict)));
    let parts: Vec<String> = bound_words(draft, &writer).into_iter().chain(verdict).collect();
    if parts.is_empty() { String::new() } else { format!("so far: {}", parts.join("; ")) }
}

/// The bound that the page begins with; where that is not asked for, the first that is known.
fn bound_words(draft: &Draft, writer: &NumberWriter) -> Option<String> {
    if let Some((bound, probability)) = main_bound(&draft.bounds) {
        let share = writer.percent(probability, Rounding::Down);
        let [most, error] = ends(bound, writer);
        return Some(format!("{} within ±{most} in {share} of mechanisms (error {error})", bound.output));
    }
    let bound = draft.bounds.iter().find(|bound| bound.upper.widened_si.is_finite())?;
    let [most, error] = ends(bound, writer);
    let statistic = statistic_words(bound.statistic, &bound.unit, writer);
    Some(format!("{statistic} of {} at most {most} (error {error})", bound.output))
}

/// The upper end of `bound` and its numerical error.
fn ends(bound: &BoundRecord, writer: &NumberWriter) -> [String; 2] {
    let error_si = bound.upper.error.total_si();
    [bound.upper.widened_si, error_si]
        .map(|value_si| writer.for_sentence(value_si, error_si, &bound.unit, Rounding::Up))
}
