//! Remaining range of the plays by readings of a rig.

use super::figures::{RangeRow, ranges};
use super::ranges::{range, range_digits, stated};
use super::readings_words::{headline, misfit_words, next_words, sums_words};
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::remark;
use loosepin_result::identification::{ConsistentPlays, Outcome, PlayBounds, Specimen, TestReading};
use loosepin_text::article::{Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::{SiUnit, counted};
use maud::{Markup, html};

/// Digits of a factor.
const FACTOR_DIGITS: usize = 4;
/// Digits of an error.
const ERROR_DIGITS: usize = 2;

/// Appends what the readings of a specimen leave, or why nothing explains them.
pub(super) fn push_readings(section: &mut Section, specimen: &Specimen, index: usize, writer: &NumberWriter<'_>) {
    let readings = &specimen.readings;
    match &specimen.outcome {
        Outcome::Consistent(known) => push_consistent(section, (known, readings), index, writer),
        Outcome::Misfit(misfit) => {
            let of_all = match readings.len() {
                1 => "the reading".to_owned(),
                count => format!("all {count} readings"),
            };
            let heading = format!("MISFIT: no values of the plays explain {of_all}");
            section.push_on(Medium::Terminal, Content::Heading(heading.into()));
            section.push(Content::points(misfit_words(misfit, readings, writer).into_iter().map(remark)));
            section.push_on(Medium::Terminal, Content::Heading("Readings".into()));
            section.push_on(Medium::Terminal, Content::Table(readings_table(readings, writer)));
        }
    }
}

fn push_consistent(
    section: &mut Section,
    (known, readings): (&ConsistentPlays, &[TestReading]),
    index: usize,
    writer: &NumberWriter<'_>,
) {
    section.push_on(Medium::Terminal, Content::sentences([headline(readings, known, writer)]));
    push_figure(section, writer, || plays_figure(&known.plays, index, writer));
    section.push(Content::Table(plays_table(&known.plays, writer)));
    let sums = sums_words(known, writer);
    if !sums.is_empty() {
        section.push(Content::Heading("Sums of plays that the readings determine".into()));
    }
    section.push(Content::points(sums.into_iter().map(|sum| Text::from(sum).on(Medium::Page, "."))));
    let next = next_words(known, readings, writer);
    if !next.is_empty() {
        section.push(Content::Heading("What to measure next".into()));
    }
    section.push(Content::points(next.into_iter().map(remark)));
    section.push_on(Medium::Terminal, Content::Heading("Readings and their sensitivity to each play".into()));
    section.push_on(Medium::Terminal, Content::Table(readings_table(readings, writer)));
    section.push_on(Medium::Terminal, Content::Table(factors_table(readings, &known.plays, writer)));
}

fn plays_figure(plays: &[PlayBounds], index: usize, writer: &NumberWriter<'_>) -> Markup {
    let row = |play: &PlayBounds| RangeRow {
        label: play.name.clone(),
        unit: play.unit.clone(),
        before_si: play.before_si,
        after_si: Some(play.after_si),
        measured_si: None,
    };
    let rows: Vec<RangeRow> = plays.iter().map(row).collect();
    let alternative = format!("Bars: {} before and after.", counted(rows.len(), "play"));
    let caption = html! { strong { "Each play before and after." } " Wide bar: the interval of the study; narrow bar: the interval after the readings." };
    ranges(&rows, format!("plays.{index}"), (alternative, caption), writer)
}

fn plays_table(plays: &[PlayBounds], writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column::words("play"),
        Column::words("before"),
        Column::words("after"),
        Column::words("fixed by itself"),
        Column { only: Some(Medium::Terminal), ..Column::words("narrowed") },
    ];
    let row = |play: &PlayBounds| {
        vec![
            play.name.clone(),
            stated(play.before_si, &play.unit, writer),
            range(play.after_si, &play.unit, writer),
            if play.is_identifiable { "yes" } else { "no" }.to_owned(),
            narrowed_words(play).to_owned(),
        ]
    };
    Table::new(columns, plays.iter().map(row))
}

/// Which ends of an interval are narrower than before.
pub(super) fn narrowed_words(play: &PlayBounds) -> &'static str {
    match play.is_narrowed() {
        [true, true] => "both ends",
        [true, false] => "lower end",
        [false, true] => "upper end",
        [false, false] => "no",
    }
}

fn readings_table(readings: &[TestReading], writer: &NumberWriter<'_>) -> Table {
    let columns = vec![
        Column::words("reading"),
        Column::words("output"),
        Column::numbers("drive"),
        Column::words("push"),
        Column::numbers("dead travel"),
        Column::numbers("common error"),
        Column::numbers("scatter"),
        Column::words("allowed before"),
    ];
    let row = |reading: &TestReading| {
        let unit = &reading.unit;
        let error = |error_si: f64| match error_si {
            0.0 => "none".to_owned(),
            error_si => format!("± {}", writer.rounded(error_si, unit, ERROR_DIGITS, Rounding::Up)),
        };
        vec![
            reading.name.clone(),
            reading.output.clone(),
            writer.value_trimmed(reading.pose_rad, &SiUnit::ANGLE),
            reading.push.clone(),
            writer.value(reading.dead_travel_si, unit),
            error(reading.common_error_si),
            error(reading.independent_error_si),
            range(reading.allowed_before_si, unit, writer),
        ]
    };
    Table::new(columns, readings.iter().map(row))
}

fn factors_table(readings: &[TestReading], plays: &[PlayBounds], writer: &NumberWriter<'_>) -> Table {
    let of_plays = plays.iter().map(|play| Column::numbers(play.name.as_str()));
    let columns = std::iter::once(Column::words("reading")).chain(of_plays).chain([Column::words("contacts give")]);
    let row = |reading: &TestReading| {
        let factor = |(factors, play): (&[f64; 3], &PlayBounds)| {
            let per = |factor: f64| {
                let is_plain = reading.unit == play.unit;
                let shown = if is_plain {
                    factor
                } else {
                    writer.scaled(factor, &reading.unit) / writer.scaled(1.0, &play.unit)
                };
                writer.rounded(shown, &SiUnit::NONE, FACTOR_DIGITS, Rounding::Nearest)
            };
            let unit = if reading.unit == play.unit {
                String::new()
            } else {
                format!(" {}/{}", writer.symbol(&reading.unit), writer.symbol(&play.unit))
            };
            if factors[0] == factors[2] {
                format!("{}{unit}", per(factors[1]))
            } else {
                format!("{} to {}{unit}", per(factors[0]), per(factors[2]))
            }
        };
        let mut row = vec![reading.name.clone()];
        row.extend(reading.factors.iter().zip(plays).map(factor));
        row.push(range_digits(reading.compliance_si, &reading.unit, ERROR_DIGITS, writer));
        row
    };
    Table::new(columns.collect(), readings.iter().map(row))
}
