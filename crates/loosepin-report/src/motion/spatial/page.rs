//! The page of a motion in space: the answer, the mechanism to be turned, worst cases over the turn and by output; then sections that open.

use super::answer::all_said;
use super::charts::{ideal_chart, worst_case_chart};
use super::numbers::{shown_input, span_words};
use super::scatter::scatter_section;
use super::tables::{contributors_on_page, outputs_overview, outputs_section};
use crate::charts::figure::figures;
use crate::medium::article_page::{overview, page_section};
use crate::medium::page::{Page, Section};
use crate::medium::short_answer::{ShortAnswer, words};
use crate::spatial::figure::{SpaceDrawing, space_drawing, spatial_figure};
use crate::spatial::views::views_figure;
use crate::study::repeat_section::repeat_section;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::VERSION;
use loosepin_text::article::{self, Fact, Medium};
use loosepin_text::units::counted;
use maud::{Markup, html};

/// Without play the picture shows the position at this fraction of the turn (one over it) first: not a dead centre.
const FIRST_POSITION: usize = 6;

/// The page of a motion in space as one HTML text that needs no network. Text from files is escaped.
pub fn spatial_motion_page(record: &SpatialMotionRecord) -> String {
    let sample = first_sample(record);
    let at = format!("{} {}", record.input, shown_input(record, sample, Medium::Page));
    let main = record.main_output();
    let others: Vec<&SpatialOutputRecord> = record
        .outputs
        .iter()
        .filter(|output| record.has_play && main.is_none_or(|main| main.name != output.name))
        .collect();
    let chart = |output: &SpatialOutputRecord| match record.has_play {
        true => Some(worst_case_chart(record, output)),
        false => ideal_chart(record, output),
    };
    let others_body = html! { @for output in &others { (worst_case_chart(record, output)) } };
    let short = ShortAnswer::of(&all_said(record));
    let answer = short.markup();
    let views = views_figure(record, sample, &at);
    let sections = [
        page_section(short.further()),
        page_section(contributors_on_page(record)),
        page_section(scatter_section(record, Medium::Page)),
        (!others.is_empty()).then(|| Section::new("worst-cases", "Worst cases of the other outputs", others_body)),
        page_section(outputs_section(record, Medium::Page)),
        (!views.0.is_empty()).then(|| Section::new("three-views", "Front, side and top", views)),
        ideal_section(record),
        page_section(method(record)),
        repeat_section(&record.repeat),
    ];
    let play = record.picture.joints.iter().filter(|joint| joint.has_play).count();
    let joints = counted(record.picture.joints.len(), "joint");
    Page {
        title: record.model.clone(),
        kicker: "Motion in space and worst cases of play",
        subtitle: html! {
            (counted(record.inputs_si.len(), "position")) " over a " (span_words(record)) " · " (joints)
            @if play > 0 { ", " (play) " with play" }
        },
        answer,
        is_answer_short: true,
        beside: spatial_figure(record, sample),
        below: main.and_then(chart).unwrap_or_default(),
        more: overview(outputs_overview(record)).0,
        is_folded: true,
        sections: sections.into_iter().flatten().collect(),
        identity: "motion".to_owned(),
        version: VERSION.to_owned(),
    }
    .into_html()
}

/// The isometric picture as an SVG file of its own in light colours; empty where the record has no positions.
pub fn spatial_motion_picture(record: &SpatialMotionRecord) -> String {
    let figure = spatial_figure(record, first_sample(record));
    figures(&figure.into_string()).first().map(|figure| figure.to_svg(None)).unwrap_or_default()
}

/// The mechanism to be turned, in the position that matters most.
pub(crate) fn spatial_motion_figure(record: &SpatialMotionRecord) -> Markup {
    spatial_figure(record, first_sample(record))
}

/// The mechanism for a page that turns and moves it by itself; `None` where the record has no positions.
pub fn spatial_motion_drawing(record: &SpatialMotionRecord) -> Option<SpaceDrawing> {
    space_drawing(record, first_sample(record))
}

/// The answer in sentences. The page begins with some of them.
pub fn spatial_motion_sentences(record: &SpatialMotionRecord) -> Vec<String> {
    words(all_said(record))
}

/// The position that pictures show first: that of the largest worst case of the main output, where there is play.
fn first_sample(record: &SpatialMotionRecord) -> usize {
    let worst = record.main_output().map(|output| output.worst.sample).filter(|_| record.has_play);
    worst.unwrap_or(record.inputs_si.len() / FIRST_POSITION)
}

/// Ideal values over the turn; with play only, since the chart of the first screen is one of them without.
fn ideal_section(record: &SpatialMotionRecord) -> Option<Section> {
    let main = record.main_output().filter(|_| !record.has_play);
    let outputs = record.outputs.iter().filter(|output| main.is_none_or(|main| main.name != output.name));
    let charts: Vec<Markup> = outputs.filter_map(|output| ideal_chart(record, output)).collect();
    let body = html! { div.charts { @for chart in &charts { (chart) } } };
    (!charts.is_empty()).then(|| Section::new("motion", "Ideal motion", body))
}

fn method(record: &SpatialMotionRecord) -> article::Section {
    let mut facts = vec![Fact::new(
        "Positions",
        [format!(
            "loops closed at {} over the {}; between them nothing is looked at",
            counted(record.inputs_si.len(), "position"),
            span_words(record)
        )],
    )];
    if record.has_play {
        facts.push(Fact::new(
            "Worst case, first order",
            ["the largest g·p over all places p of the journals in their bearings and sockets, offsets, leans and axial displacements at once; g are \
              the derivatives of the output in the ideal position"],
        ));
        facts.push(Fact::new(
            "Found",
            ["in the position with the largest worst case: a search over all places of the journals with loops closed exactly. The values are \
              reached; that none is larger is not proven"],
        ));
        if record.picture.traces.iter().any(|trace| !trace.zones.is_empty()) {
            facts.push(Fact::new(
                "Zones",
                ["where play takes a point to first order: the hull of the displacements that go farthest in directions spread over the sphere"],
            ));
        }
    }
    facts.push(Fact::new("Without", ["inertia, forces and impacts"]));
    facts.push(Fact::new("Version", [format!("loosepin {VERSION}")]));
    article::Section::of_facts("method", "How this was computed", facts)
}
