//! What if the unknown values were known: the band at each tested value, for the choice below the first chart: a slider over one interval,
//! a map of two; and before it a choice among the members of lists, whose values are never mixed.

use maud::{Markup, html};
use serde::Serialize;

use crate::medium::script_data::script_json;
use crate::numbers::number::{NumberWriter, plain_name};
use crate::numbers::tag::Tag;
use crate::words::wording::{capitalised, listed};
use loosepin_result::study::{DeviationCurve, InputDescription, InputKind, StudyResult, Witness, WitnessValue};

/// Ends of bands are sent as whole numbers of this part of the height of all of them.
const LEVELS: f64 = 9999.0;
/// Ranges that a map shows.
const MAPPED: usize = 2;

#[derive(Serialize)]
struct WhatIf {
    /// Name of the chart.
    chart: String,
    /// Place of the band that is replaced among its curves.
    entry: usize,
    /// Which share of mechanisms is in the band, in words.
    share: String,
    /// Inputs with a range.
    inputs: Vec<Input>,
    /// Names of the inputs with a list.
    lists: String,
    /// Combinations of members of lists, in words; one without words where nothing is a list.
    groups: Vec<String>,
    /// The combination of the picture as it is stored.
    start: usize,
    /// What was run.
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
    /// Place of its combination.
    group: usize,
    /// A place from 0 to 1 for each input with a range.
    at: Vec<f64>,
    /// All values in words.
    words: String,
    runs: u64,
    lower: Vec<i32>,
    upper: Vec<i32>,
}

/// Ends of what an input with a range may be.
fn range_si(kind: &InputKind) -> Option<[f64; 2]> {
    match kind {
        InputKind::Interval { lower_si, upper_si } | InputKind::Periodic { lower_si, upper_si } => {
            Some([*lower_si, *upper_si])
        }
        // The first cut is the widest.
        InputKind::Fuzzy { cuts } => cuts.first().map(|cut| [cut.lower_si, cut.upper_si]),
        InputKind::Random
        | InputKind::DrawnPlay
        | InputKind::Play
        | InputKind::Choice { .. }
        | InputKind::Evidence { .. }
        | InputKind::SecondOrder { .. } => None,
    }
}

fn is_list(input: &InputDescription) -> bool {
    matches!(input.kind, InputKind::Choice { .. })
}

fn list_names(result: &StudyResult) -> Vec<String> {
    let lists = result.inputs.iter().filter(|input| is_list(input));
    lists.map(|input| plain_name(&input.path, &result.inputs)).collect()
}

/// The members of lists alone.
fn members(at: &Witness, inputs: &[InputDescription]) -> Witness {
    let is_member = |path: &str| inputs.iter().any(|input| input.path == path && is_list(input));
    at.iter().filter(|(path, _)| is_member(path)).map(|(path, value)| (path.clone(), value.clone())).collect()
}

/// The control, or nothing where fewer than two values were run, or an input is neither a range nor a list. `share`: which share of
/// mechanisms the band holds, in words.
pub(super) fn what_if(
    result: &StudyResult,
    curve: &DeviationCurve,
    chart: &str,
    (entry, share): (Option<usize>, &str),
    writer: &NumberWriter,
) -> Markup {
    let (Some(entry), true) = (entry, curve.at_values.len() > 1) else { return html! {} };
    let Some(record) = record(result, curve, chart, (entry, share), writer) else { return html! {} };
    let names = list_names(result).into_iter().chain(record.inputs.iter().map(|input| input.name.clone()));
    let names: Vec<String> = names.collect();
    html! {
        div.what-if data-what-if=(chart) hidden {
            p { strong { "What if " (listed(&names)) " were known?" } }
            p.quiet {
                "Choose one of " (writer.with_tag(&Tag::Count("values that are offered")).count(record.points.len() as u64)) " values that were run: the inner band is that value's, counted from its runs. The outer \
                 band stays: it holds for all of them."
                @if record.inputs.len() > MAPPED {
                    " The map shows the first two ranges; the line below it names all values."
                }
                " Saved pictures and numbers show the band for the middle values."
            }
            div.choice {}
            p.chosen role="status" {}
            button.reset type="button" hidden { "Back to the middle" }
            script type="application/json" { (script_json(&record)) }
        }
    }
}

fn record(
    result: &StudyResult,
    curve: &DeviationCurve,
    chart: &str,
    (entry, share): (usize, &str),
    writer: &NumberWriter,
) -> Option<WhatIf> {
    let is_known =
        |input: &InputDescription| input.kind.is_random() || is_list(input) || range_si(&input.kind).is_some();
    if !result.inputs.iter().all(is_known) {
        return None;
    }
    let ranges: Vec<(&str, [f64; 2], Input)> = result
        .inputs
        .iter()
        .filter_map(|input| {
            let ends_si = range_si(&input.kind)?;
            let name = plain_name(&input.path, &result.inputs);
            let [from, to] = ends_si.map(|value_si| writer.value_trimmed(value_si, &input.unit));
            Some((input.path.as_str(), ends_si, Input { name, from, to }))
        })
        .collect();
    let ends = || curve.at_values.iter().flat_map(|value| value.band.lower_si.iter().chain(&value.band.upper_si));
    let finite = || ends().copied().filter(|value| value.is_finite());
    let (least, most) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if !(most > least) {
        return None;
    }
    let level = |value_si: &f64| {
        // A gap is a negative level.
        if value_si.is_finite() { (LEVELS * (value_si - least) / (most - least)).round() as i32 } else { -1 }
    };
    let mut groups: Vec<Witness> = Vec::new();
    let mut points = Vec::new();
    for value in &curve.at_values {
        let own = members(&value.at, &result.inputs);
        let group = groups.iter().position(|group| *group == own).unwrap_or(groups.len());
        if group == groups.len() {
            groups.push(own);
        }
        let at: Option<Vec<f64>> = ranges
            .iter()
            .map(|(path, [from, to], _)| match value.at.get(*path)? {
                WitnessValue::Number(value_si) => Some((1e4 * (value_si - from) / (to - from)).round() / 1e4),
                WitnessValue::Choice(_) => None,
            })
            .collect();
        points.push(Point {
            group,
            at: at?,
            words: writer.witness(&value.at, &result.inputs),
            runs: value.runs,
            lower: value.band.lower_si.iter().map(level).collect(),
            upper: value.band.upper_si.iter().map(level).collect(),
        });
    }
    let centre = members(&curve.centre, &result.inputs);
    Some(WhatIf {
        chart: chart.to_owned(),
        entry,
        share: share.to_owned(),
        inputs: ranges.into_iter().map(|(_, _, input)| input).collect(),
        lists: listed(&list_names(result)),
        start: groups.iter().position(|group| *group == centre).unwrap_or(0),
        groups: groups.iter().map(|group| capitalised(&writer.witness(group, &result.inputs))).collect(),
        points,
        range: [least, most].map(|value_si| writer.scaled(value_si, &curve.unit)),
    })
}
