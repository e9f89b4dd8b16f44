//! The page of one run: outputs over time, deviation, impacts, contact force, journal paths, energy, the mechanism.

use maud::{Markup, html};

use crate::charts::figure::images;
use crate::charts::still_figures::orbit_chooser;
use crate::mechanism::figure::mechanism_figure;
use crate::medium::article_page::{overview, page_section};
use crate::medium::page::{Frame, Page, Section, changes};
use crate::medium::short_answer::ShortAnswer;
use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::study::answer::turns;
use crate::study::repeat_section::repeat_section;
use loosepin_result::simulation::{SimulationRecord, StopReason};
use loosepin_text::units::SiUnit;

use super::answer::{all_said, trusted_run};
use super::charts::{
    before_rad, controls, deviation_chart, energy, other_deviations, outputs, outputs_with_deviation, paths,
};
use super::contact::contact_section;
use super::extremes::extremes_section;
use super::kind::kind_section;
use super::measured::measured_section;
use super::method::method_section;
use super::spectra::spectrum_section;
use super::wear::wear_section;

/// The page of one run as one HTML text that needs no network: the answer in a few sentences, the moving mechanism, the deviation of the first output and
/// the extremes of all; then sections that open: what else was found, journal paths, outputs, impacts and contact forces, the energy account, and how
/// all of it was computed. Text from files is escaped.
pub fn simulation_page(record: &SimulationRecord) -> String {
    page(record).into_html()
}

/// The first screen of [`simulation_page`] and its extremes, as a document for a frame in a notebook.
pub fn simulation_frame(record: &SimulationRecord) -> Frame {
    page(record).into_frame(&["extremes"], before_rad(record).to_degrees(), &record.drawing)
}

/// The mechanism and the first chart of [`simulation_page`] as HTML to stand inside another page, such as a notebook; without scripts.
pub fn simulation_excerpt(record: &SimulationRecord) -> String {
    let Page { beside, below, .. } = page(record);
    images(html! { (beside) (below) }).into_string()
}

fn page(record: &SimulationRecord) -> Page {
    let writer = &NumberWriter::for_page(&record.display_units);
    let first = outputs_with_deviation(record).next();
    let short = ShortAnswer::of(&all_said(record, writer));
    let answer = answer(record, &short);
    let (extremes, all_extremes) = overview(extremes_section(record, writer));
    let own =
        |id: &'static str, title: &'static str, body: Option<Markup>| body.map(|body| Section::new(id, title, body));
    let sections = [
        page_section(short.further()),
        own("orbits", "The journal in its bearing", (!record.orbits.is_empty()).then(|| orbits(record, writer))),
        own("paths", "Paths of points", paths(record, writer)),
        all_extremes,
        own("outputs", "Outputs", Some(outputs(record, writer))),
        own(
            "deviation",
            "Other deviations from the ideal motion",
            (outputs_with_deviation(record).count() > 1).then(|| other_deviations(record, writer)),
        ),
        page_section(measured_section(record, writer)),
        page_section(spectrum_section(record, writer)),
        page_section(contact_section(record, writer)),
        page_section(wear_section(record, writer)),
        own("control", "Controls", (!record.controls.is_empty()).then(|| controls(record, writer))),
        own("kind", "Kind of motion", kind_section(record, writer)),
        own("trust", "How long the positions can be trusted", trusted_run(record).section(writer)),
        own("energy", "Energy balance", Some(energy(record, writer))),
        page_section(method_section(record, writer)),
        repeat_section(&record.repeat),
    ];
    Page {
        title: record.model.clone(),
        kicker: "Simulation",
        subtitle: html! {
            @if let Some(speed) = record.settings.drive_speed_rad_s {
                (record.settings.drive) " at "
                (writer.with_tag(&Tag::Given("speed of the drive")).value_shortest(speed, &SiUnit::ANGULAR_VELOCITY)) ", "
            }
            (turns(record.settings.recorded_turns, record.settings.drive_speed_rad_s, writer))
            (changes(&record.overrides))
        },
        answer,
        is_answer_short: true,
        beside: mechanism_figure(&record.drawing, &record.settings.drive),
        below: first.map(|output| deviation_chart(record, output, writer).figure()).unwrap_or_default(),
        more: extremes,
        is_folded: true,
        sections: sections.into_iter().flatten().collect(),
        identity: "simulation".to_owned(),
        version: record.version.clone(),
    }
}

fn answer(record: &SimulationRecord, short: &ShortAnswer) -> Markup {
    html! {
        @if let StopReason::Failed { words, .. } = &record.stop {
            p.verdict.not-met { "The run failed" }
            p { (words) ". This page shows what was computed." }
        }
        (short.markup())
    }
}

fn orbits(record: &SimulationRecord, writer: &NumberWriter) -> Markup {
    html! {
        p { "The path of the pin centre relative to the hole, in the frame of the part with the hole." }
        (orbit_chooser(&record.orbits, writer))
    }
}
