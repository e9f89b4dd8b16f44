//! What is known of a study before it is finished, in a line.

use super::number::{NumberWriter, Rounding};
use super::wording::{statistic_words, verdict_words};
use loosepin_result::study::{BoundRecord, Deviation, Draft, Reduction, ResponsePoint, Statistic};

/// A line on what is known so far: how far the main output goes at most, with its numerical error, and the verdict. Empty where nothing
/// is known yet.
pub fn draft_text(draft: &Draft) -> String {
    let writer = NumberWriter::for_terminal(&draft.display_units);
    let verdict = draft.verdict().map(|verdict| format!("requirements {}", verdict_words(verdict)));
    let parts: Vec<String> = main_bound(draft).map(|bound| words(bound, &writer)).into_iter().chain(verdict).collect();
    if parts.is_empty() { String::new() } else { format!("so far: {}", parts.join("; ")) }
}

/// The quantile of the largest deviation as on the page; where none is asked for, the first bound that is known.
fn main_bound(draft: &Draft) -> Option<&BoundRecord> {
    let mut known = draft.bounds.iter().filter(|bound| bound.upper.widened_si.is_finite());
    known.clone().find(|bound| is_within(bound)).or_else(|| known.next())
}

fn is_within(bound: &BoundRecord) -> bool {
    let is_largest = bound.at == ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute };
    bound.of == Deviation::Total
        && is_largest
        && matches!(bound.statistic, Statistic::Quantile(probability) if probability > 0.5)
}

fn words(bound: &BoundRecord, writer: &NumberWriter) -> String {
    let error_si = bound.upper.error.total_si();
    let error = writer.for_sentence(error_si, error_si, &bound.unit, Rounding::Up);
    let most = writer.for_sentence(bound.upper.widened_si, error_si, &bound.unit, Rounding::Up);
    match bound.statistic {
        Statistic::Quantile(probability) if is_within(bound) => {
            let share = writer.percent(probability, Rounding::Down);
            format!("{} within ±{most} in {share} of mechanisms (error {error})", bound.output)
        }
        statistic => {
            format!(
                "{} of {} at most {most} (error {error})",
                statistic_words(statistic, &bound.unit, writer),
                bound.output
            )
        }
    }
}
