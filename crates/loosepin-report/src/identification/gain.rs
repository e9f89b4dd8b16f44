//! Gain by narrower intervals: the study before and after, beside each other.

use crate::compare::{NOTHING_IN_COMMON, compare_studies};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{output_unit, response_words, statistic_words};
use loosepin_result::identification::{Gain, GainedBound};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};

/// Digits of a bound.
const DIGITS: usize = 4;

/// The bounds of the same study with its intervals before and after an identification.
pub fn identification_gain(before: &StudyResult, after: &StudyResult) -> Gain {
    let writer = NumberWriter::for_terminal(&before.display_units);
    let compared = compare_studies(before, after);
    let is_shown =
        |bound: &&BoundRecord| bound.treatment.is_mixed() && !matches!(bound.at, ResponsePoint::Curve { .. });
    let is_same = |a: &BoundRecord, b: &BoundRecord| {
        a.output == b.output && a.of == b.of && a.at == b.at && a.statistic == b.statistic && a.reading == b.reading
    };
    let gained = |bound: &BoundRecord| {
        let other = after.bounds.iter().filter(is_shown).find(|other| is_same(bound, other))?;
        let ends = |bound: &BoundRecord| [bound.lower.widened_si, bound.upper.widened_si];
        Some(GainedBound {
            response: response_words(before, (&bound.output, bound.of, bound.at), &writer),
            statistic: statistic_words(bound.statistic, &output_unit(before, &bound.output), &writer),
            unit: bound.unit.clone(),
            is_probability: bound.statistic.is_probability(),
            before_si: ends(bound),
            after_si: ends(other),
        })
    };
    // On a terminal a space that does not break is one that cannot be searched for.
    let plain = |text: &String| text.replace('\u{a0}', " ");
    let bounds: Vec<GainedBound> = before.bounds.iter().filter(is_shown).filter_map(gained).collect();
    let headline = match bounds.first() {
        Some(first) if compared.headline == NOTHING_IN_COMMON => {
            let [a, b] = [first.before_si, first.after_si].map(|ends_si| bound_words(ends_si, first, &writer));
            format!("The {} of {} is {a} in A, {b} in B.", first.statistic, first.response)
        }
        _ => plain(&compared.headline),
    };
    Gain {
        headline,
        bands: compared.bands.iter().map(|band| plain(&format!("{}. {}", band.title, band.words))).collect(),
        bounds,
        runs: [before.counts.runs, after.counts.runs],
    }
}

/// The bounds of the study before and after.
pub(super) fn gain_section(gain: &Gain, writer: &NumberWriter<'_>) -> Section {
    let heading = Text::by_medium("The study before and after", "The study before (A) and after (B)");
    let mut section = Section::new("gain", heading);
    let sentences = || std::iter::once(&gain.headline).chain(&gain.bands).cloned();
    section.push_on(Medium::Page, Content::sentences(sentences()));
    section.push_on(Medium::Terminal, Content::points(sentences()));
    let columns = vec![
        Column::words("of"),
        Column::words("statistic"),
        Column::words(Text::by_medium("before (A)", "before")),
        Column::words(Text::by_medium("after (B)", "after")),
        Column::words("change"),
    ];
    let row = |bound: &GainedBound| {
        vec![
            bound.response.clone(),
            bound.statistic.clone(),
            bound_words(bound.before_si, bound, writer),
            bound_words(bound.after_si, bound, writer),
            narrower_words(bound, writer),
        ]
    };
    section.push(Content::Table(Table::new(columns, gain.bounds.iter().map(row))));
    let [before, after] = gain.runs.map(|runs| writer.count(runs));
    section.push_on(Medium::Page, Content::Note(format!("Runs: {before} before, {after} after.").into()));
    section
}

/// Both ends of a bound, rounded outwards.
fn bound_words(ends_si: [f64; 2], bound: &GainedBound, writer: &NumberWriter<'_>) -> String {
    let [lower, upper] = [(ends_si[0], Rounding::Down), (ends_si[1], Rounding::Up)].map(|(value_si, rounding)| {
        if bound.is_probability {
            writer.percent(value_si, rounding)
        } else {
            writer.rounded(value_si, &bound.unit, DIGITS, rounding)
        }
    });
    format!("{lower} to {upper}")
}

/// How much narrower a bound is; empty if it is of one value.
fn narrower_words(bound: &GainedBound, writer: &NumberWriter<'_>) -> String {
    let [before, after] = [bound.before_si, bound.after_si].map(|ends| ends[1] - ends[0]);
    if !(before > 0.0) || !after.is_finite() {
        return String::new();
    }
    let change = 1.0 - after / before;
    let side = if change >= 0.0 { "narrower" } else { "wider" };
    format!("{} {side}", writer.percent(change.abs(), Rounding::Nearest))
}
