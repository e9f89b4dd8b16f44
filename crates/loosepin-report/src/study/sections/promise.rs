//! Bounds that are promised for a share of the box.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::output_unit;
use crate::words::wording::{
    capitalised, count, counted, deviation_words, failed_words, output_words, place_words, statistic_words,
};
use loosepin_result::study::{InputKind, PromiseRecord, PromisedBand, PromisedEnd, ResponsePoint, Side, StudyResult};
use loosepin_text::article::{Content, Medium, Section};
use loosepin_text::units::SiUnit;

/// Promised ends in sentences, at most; the others stand in the file.
const MAX_ENDS: usize = 24;

/// The promise and its subject, then one sentence for each promised end; `None` if nothing is promised.
pub(crate) fn promise_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let promise = result.promise.as_ref()?;
    let share = writer.percent(promise.share, Rounding::Down);
    let mut section = Section::new("promise", format!("Promised for {share} of the box"));
    let head = [statement(result, promise, writer), cost(promise, writer)];
    section.push_on(Medium::Page, Content::sentences(head.clone()));
    section.push_on(Medium::Terminal, Content::points(head));
    section.push_close(Content::points(end_sentences(result, promise, writer)));
    Some(section)
}

fn end_sentences(result: &StudyResult, promise: &PromiseRecord, writer: &NumberWriter) -> Vec<String> {
    let is_shown = |end: &&PromisedEnd| !matches!(end.at, ResponsePoint::Curve { .. });
    let shown: Vec<&PromisedEnd> = promise.ends.iter().filter(is_shown).take(MAX_ENDS).collect();
    let left = promise.ends.len() - shown.len();
    let mut sentences: Vec<String> = shown.into_iter().map(|end| end_sentence(result, promise, end, writer)).collect();
    sentences.extend(promise.bands.iter().map(|band| band_sentence(result, promise, band, writer)));
    if left > 0 {
        sentences.push(format!(
            "{} more promised {} in summary.json.",
            count(left as u64, writer),
            if left == 1 { "bound is" } else { "bounds are" }
        ));
    }
    sentences
}

fn statement(result: &StudyResult, promise: &PromiseRecord, writer: &NumberWriter) -> String {
    let boxes = match promise.boxes {
        1 => "the box of the intervals".to_owned(),
        many => format!("each of the {}", counted_boxes(many, writer)),
    };
    let share = writer.percent(promise.share, Rounding::Down);
    let all = match promise.ends.len() + promise.bands.len() {
        1 => format!("this bound holds in at least {share} of {boxes}."),
        _ => format!(
            "each of these bounds holds in at least {share} of {boxes}. Different bounds may fail in different parts of it."
        ),
    };
    let each = if promise.boxes == 1 {
        String::new()
    } else {
        let of = match (has(result, is_list), has(result, is_evidence)) {
            (true, false) => "Each combination of the lists",
            (false, true) => "Each interval with its mass",
            _ => "Each combination of the lists and each interval with its mass",
        };
        format!(" {of} has its own box, and this is true for each box separately.")
    };
    format!(
        "With {} confidence, {all} This is a share of the volume of the box, in the coordinates of the file. \
         It is not a probability of the true values, and it does not hold for every value.{each}",
        writer.percent(promise.confidence, Rounding::Down),
    )
}

fn counted_boxes(boxes: u64, writer: &NumberWriter) -> String {
    format!("{} boxes of the intervals", count(boxes, writer))
}

fn is_list(kind: &InputKind) -> bool {
    matches!(kind, InputKind::Choice { .. })
}

fn is_evidence(kind: &InputKind) -> bool {
    matches!(kind, InputKind::Evidence { .. })
}

fn has(result: &StudyResult, is_meant: fn(&InputKind) -> bool) -> bool {
    result.inputs.iter().any(|input| is_meant(&input.kind))
}

fn cost(promise: &PromiseRecord, writer: &NumberWriter) -> String {
    let each = if promise.boxes == 1 { "" } else { " in each box" };
    let runs = counted(promise.runs, "run", writer);
    let values = count(promise.values, writer);
    if promise.miss == 0.0 {
        return format!(
            "No model and no search: {values} random values{each}, fixed beforehand, one run at each ({runs})."
        );
    }
    format!(
        "No model and no search: {values} random values{each}, fixed beforehand, and {} at each with their own random numbers ({runs}). \
         The limit at each value fails with a probability of at most {}; the furthest limit is the bound.",
        counted(promise.inner, "run", writer),
        writer.percent(promise.miss, Rounding::Up),
    )
}

fn end_sentence(result: &StudyResult, promise: &PromiseRecord, end: &PromisedEnd, writer: &NumberWriter) -> String {
    let unit = output_unit(result, &end.output);
    let subject = format!(
        "{} of {} ({}, {})",
        capitalised(&statistic_words(end.statistic, &unit, writer)),
        output_words(&end.output, &result.outputs),
        deviation_words(end.of),
        place_words(end.at, writer),
    );
    if end.failed_values > 0 {
        return format!(
            "{subject}: nothing is promised, because runs failed at {}.",
            failed_words(promise, end.failed_values, writer)
        );
    }
    let (at_most, extreme, rounding) = match end.side {
        Side::Lower => ("at least", "smallest", Rounding::Down),
        Side::Upper => ("at most", "largest", Rounding::Up),
    };
    let bound = if end.statistic.is_probability() {
        writer.percent(end.bound_si, rounding)
    } else {
        writer.rounded(end.bound_si, &end.unit, BOUND_DIGITS, rounding)
    };
    format!("{subject}: {at_most} {bound}; the limit is {extreme} at {}.", writer.witness(&end.witness, &result.inputs))
}

fn band_sentence(result: &StudyResult, promise: &PromiseRecord, band: &PromisedBand, writer: &NumberWriter) -> String {
    let subject = format!(
        "Band of {} for the whole cycle of {} ({})",
        writer.percent(band.share, Rounding::Nearest),
        output_words(&band.output, &result.outputs),
        deviation_words(band.of),
    );
    if band.failed_values > 0 {
        return format!(
            "{subject}: nothing is promised, because runs failed at {}.",
            failed_words(promise, band.failed_values, writer)
        );
    }
    format!(
        "{subject}: {} times the band at each angle; it is widest at {}.",
        writer.rounded(band.factor, &SiUnit::NONE, FACTOR_DIGITS, Rounding::Up),
        writer.witness(&band.witness, &result.inputs)
    )
}

/// Digits of the factor of a band.
const FACTOR_DIGITS: usize = 3;
/// Digits of a bound.
const BOUND_DIGITS: usize = 4;
