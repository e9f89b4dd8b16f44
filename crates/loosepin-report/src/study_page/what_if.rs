//! What if the unknown values were known: the band at each value that was run, for the slider or map below the first chart.

use maud::{Markup, html};
use serde::Serialize;

use crate::number::NumberWriter;
use crate::script_data::script_json;
use crate::wording::capitalised;
use loosepin_result::study::{DeviationCurve, InputKind, StudyResult, WitnessValue};

/// Ends of bands are sent as whole numbers of this part of the height of all of them.
const LEVELS: f64 = 9999.0;

#[derive(Serialize)]
struct WhatIf {
    /// Name of the chart.
    chart: String,
    /// Place of the band that is replaced among its curves.
    entry: usize,
    inputs: Vec<Input>,
    /// What was run: a place from 0 to 1 for each input, and the values in words.
    points: Vec<Point>,
    /// Levels 0 and [`LEVELS`] in the unit of the chart.
    range: [f64; 2],
}

#[derive(Serialize)]
struct Input {
    name: String,
    from: String,
    to: String,
}

#[derive(Serialize)]
struct Point {
    at: Vec<f64>,
    words: String,
    runs: u64,
    lower: Vec<i32>,
    upper: Vec<i32>,
}

/// The control, or nothing where fewer than two values were run or an input is no interval.
pub(super) fn what_if(
    result: &StudyResult,
    curve: &DeviationCurve,
    chart: &str,
    entry: Option<usize>,
    writer: &NumberWriter,
) -> Markup {
    let (Some(entry), true) = (entry, curve.at_values.len() > 1) else { return html! {} };
    let Some(record) = record(result, curve, chart, entry, writer) else { return html! {} };
    html! {
        div.what-if data-what-if=(chart) hidden {
            p {
                strong {
                    "What if "
                    @for (index, input) in record.inputs.iter().enumerate() { @if index > 0 { " and " } (input.name) }
                    " were known?"
                }
            }
            p.quiet {
                "Choose one of " (record.points.len()) " values that were run: the inner band is that value's, counted from its runs. The outer \
                 band stays: it holds for all of them."
            }
            div.choice {}
            p.chosen role="status" {}
            script type="application/json" { (script_json(&record)) }
        }
    }
}

fn record(
    result: &StudyResult,
    curve: &DeviationCurve,
    chart: &str,
    entry: usize,
    writer: &NumberWriter,
) -> Option<WhatIf> {
    let intervals: Vec<(&str, [f64; 2], Input)> = result
        .inputs
        .iter()
        .filter_map(|input| {
            let InputKind::Interval { lower_si, upper_si } = input.kind else { return None };
            let name = crate::number::plain_name(&input.path, &result.inputs);
            let [from, to] = [lower_si, upper_si].map(|value_si| writer.value_trimmed(value_si, &input.unit));
            Some((input.path.as_str(), [lower_si, upper_si], Input { name, from, to }))
        })
        .collect();
    let ends = || curve.at_values.iter().flat_map(|value| value.band.lower_si.iter().chain(&value.band.upper_si));
    let finite = || ends().copied().filter(|value| value.is_finite());
    let (least, most) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if intervals.is_empty() || !(most > least) {
        return None;
    }
    let level = |value_si: &f64| {
        // A gap is a negative level.
        if value_si.is_finite() { (LEVELS * (value_si - least) / (most - least)).round() as i32 } else { -1 }
    };
    let point = |value: &loosepin_result::study::ValueBand| {
        let at: Option<Vec<f64>> = intervals
            .iter()
            .map(|(path, [from, to], _)| match value.at.get(*path)? {
                WitnessValue::Number(value_si) => Some((1e4 * (value_si - from) / (to - from)).round() / 1e4),
                WitnessValue::Choice(_) => None,
            })
            .collect();
        Some(Point {
            at: at?,
            words: capitalised(&writer.witness(&value.at, &result.inputs)),
            runs: value.runs,
            lower: value.band.lower_si.iter().map(level).collect(),
            upper: value.band.upper_si.iter().map(level).collect(),
        })
    };
    let points: Option<Vec<Point>> = curve.at_values.iter().map(point).collect();
    Some(WhatIf {
        chart: chart.to_owned(),
        entry,
        inputs: intervals.into_iter().map(|(_, _, input)| input).collect(),
        points: points?,
        range: [least, most].map(|value_si| writer.scaled(value_si, &curve.unit)),
    })
}
