//! The page of the ideal motion: outputs, the quasi-static worst case and its contributors, the mechanism.

use maud::html;

use crate::medium::article_page::{overview, page_section};
use crate::medium::page::{Page, Section, changes};
use crate::medium::short_answer::ShortAnswer;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::study::repeat_section::repeat_section;
use crate::words::wording::count;
use loosepin_result::motion::MotionRecord;
use loosepin_text::article::{self, Fact};
use loosepin_text::units::SiUnit;

use super::answer::{all_said, singular_place};
use super::charts::{clearance, clearance_chart, ideal_motion, transmission};
use super::contributors::contributors_section;
use super::drawing::{motion_figure, motion_method, views_section};
use super::efforts::efforts_section;
use super::moved::{has_clearance, has_scatter};
use super::paths::{first_path_figure, paths_section};
use super::ranges::ranges_section;
use super::scatter::{scatter_chart, scatter_section};

/// The page of an ideal motion as one HTML text that needs no network: the answer in a few sentences, the mechanism, the chart that it is about and the
/// ranges of the outputs; then sections that open: what else was found, paths, the quasi-static worst case and standard deviations of the clearances, what each joint contributes,
/// position, velocity and acceleration of the outputs. Text from files is escaped.
pub fn motion_page(record: &MotionRecord) -> String {
    let writer = &NumberWriter::for_page(&record.display_units);
    let play = record.outputs.iter().find(|output| has_clearance(output));
    let scatter = record.outputs.iter().find(|output| play.is_none() && has_scatter(output));
    let below = match (play, scatter) {
        (Some(output), _) => clearance_chart(record, output, writer).figure(),
        (None, Some(output)) => scatter_chart(record, output, writer).figure(),
        (None, None) => first_path_figure(record, writer),
    };
    let short = ShortAnswer::of(&all_said(record, writer));
    let answer = short.markup();
    let (outputs, all_outputs) = overview(ranges_section(record, writer));
    let is_path_shown = play.is_none() && scatter.is_none();
    let sections = [
        page_section(short.further()),
        page_section(paths_section(record, usize::from(is_path_shown), writer)),
        all_outputs,
        play.map(|_| Section::new("clearance", "Effect of play", clearance(record, writer))),
        page_section(contributors_section(record, writer)),
        page_section(scatter_section(record, scatter, writer)),
        views_section(record, writer),
        Some(Section::new("motion", "Ideal motion", ideal_motion(record, writer))),
        transmission(record, writer).map(|body| Section::new("transmission", "Transmission", body)),
        page_section(efforts_section(record, writer)),
        page_section(method(record, writer)),
        repeat_section(&record.repeat),
    ];
    Page {
        title: record.model.clone(),
        kicker: "Ideal motion and quasi-static accuracy",
        subtitle: html! {
            (record.mobility)
            @if let Some(speed) = record.drive_speed_rad_s {
                " · " (record.drive) " at "
                (writer.with_tag(&Tag::Given("speed of the drive")).value_shortest(speed, &SiUnit::ANGULAR_VELOCITY))
            }
            (changes(&record.overrides))
        },
        answer,
        is_answer_short: true,
        beside: motion_figure(record),
        below,
        more: outputs,
        is_folded: true,
        sections: sections.into_iter().flatten().collect(),
        identity: "motion".to_owned(),
        version: record.version.clone(),
    }
    .into_html()
}

fn method(record: &MotionRecord, writer: &NumberWriter) -> article::Section {
    let positions = count(record.drive_angle_rad.len() as u64, &writer.with_tag(&Tag::Count("positions")));
    let mut facts = vec![Fact::new("Mobility", [record.mobility.as_str()])];
    facts.extend(motion_method(record, &positions, writer));
    if record.outputs.iter().any(|output| !output.clearance.worst_case_si.is_empty()) {
        facts.push(Fact::new("Worst case", [worst_case_method(record)]));
    }
    facts.extend(record.singular_positions.iter().map(|position| {
        Fact::new("Singular position", [format!("{}: {}", singular_place(record, position, writer), position.words)])
    }));
    facts.push(Fact::new("Version", [format!("loosepin {}", record.version)]));
    article::Section::of_facts("method", "How this was computed", facts)
}

fn worst_case_method(record: &MotionRecord) -> String {
    let proven = if record.is_proven_between_angles { "at all angles of the drive" } else { "at the angles shown" };
    format!(
        "found: searches from several starts over all positions within the play of the joints, with loops closed exactly, at each angle shown. Proven: no position of rigid parts within their play exceeds it; Taylor's formula of second degree with its remainder on intervals that are rounded \
         outwards, {proven}"
    )
}
