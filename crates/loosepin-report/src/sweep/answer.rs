//! The answer of a sweep in sentences, the most important first; for pages and terminals alike.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::{count, counted};
use loosepin_result::sweep::SweepRecord;

use super::stretches::{Stretch, period_words, stretches, value_words};

/// All sentences of the answer; a page shows all of them.
pub(super) fn headline_sentences(record: &SweepRecord, writer: &NumberWriter) -> Vec<String> {
    let runs = record.points.len();
    let repeating = record.points.iter().filter(|point| point.period_turns.is_some()).count();
    let failed: Vec<&str> = record.points.iter().filter_map(|point| point.failure.as_deref()).collect();
    let irregular = runs - repeating - failed.len();
    let number = |of: &'static str, value: usize| count(value as u64, &writer.with_tag(&Tag::Count(of)));
    let all = number("values", runs);
    let first = if irregular == 0 && failed.is_empty() {
        format!("The motion repeats at all {all} values of {}.", record.path)
    } else if failed.len() == runs {
        format!("All {all} runs failed: no value of {} gives a motion.", record.path)
    } else if repeating == 0 && failed.is_empty() {
        format!(
            "The motion repeats at none of the {all} values of {}. Use statistics over many turns, not a single history.",
            record.path
        )
    } else {
        format!(
            "The motion repeats at {} of {all} values of {} and does not repeat at {}. Where it does not repeat, use statistics over many \
             turns, not a single history.",
            number("values with a period", repeating),
            record.path,
            number("values without a period", irregular)
        )
    };
    let mut sentences = vec![first];
    let mut parts: Vec<Stretch> = stretches(record).into_iter().filter(|stretch| stretch.period.is_ok()).collect();
    parts.sort_by_key(|stretch| std::cmp::Reverse(stretch.range[1] - stretch.range[0]));
    parts.truncate(4);
    parts.sort_by_key(|stretch| stretch.range[0]);
    let words: Vec<String> = parts
        .iter()
        .filter(|stretch| stretch.range[1] > stretch.range[0])
        .map(|stretch| {
            format!(
                "from {} to {} it {}",
                value_words(record, stretch.range[0], writer),
                value_words(record, stretch.range[1], writer),
                period_words(stretch.period, writer)
            )
        })
        .collect();
    if words.len() > 1 {
        sentences.push(format!("Longest ranges: {}.", words.join("; ")));
    }
    if let Some(reason) = failed.first() {
        let failed = counted(failed.len() as u64, "run", &writer.with_tag(&Tag::Count("failed runs")));
        sentences.push(format!("{failed} failed. The first reason: {reason}"));
    }
    sentences
}
