//! The page of a study: first a whole page with the answer, the mechanism, the chart and the contributors, then sections that open.
//! What a terminal shows too stands in `sections`.

mod curves;
mod provenance;
mod what_if;

use maud::{Markup, html};

pub use curves::{KnownValue, known_values};

use crate::charts::figure::images;
use crate::charts::still_figures::orbit_chooser;
use crate::mechanism::figure::mechanism_figure;
use crate::medium::article_page::{blocks, page_section};
use crate::medium::page::{Frame, Page, Section};
use crate::motion::{joints_section, motion_figure};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::study::answer::{StudyAnswer, answer, verdict_headline};
use crate::study::repeat_section::study_repeat_section;
use crate::study::sections::{
    accuracy_section, allowed_section, answers_section, bounds_section, contributors_overview, contributors_section,
    degrees_section, percentiles_section, places_section, promise_section, rare_section, runs_section,
    surrogate_section, treatments_section,
};
use crate::words::limits::requirement_words;
use crate::words::wording::{
    UNKNOWN_INPUTS, counted, deviation_words, has_unknown, output_unit, place_words, verdict_words,
};
use loosepin_result::point_path::PointPath;
use loosepin_result::study::{RequirementOutcome, StudyResult, Verdict};
use loosepin_text::article::{self, Cell, Column, Content, Table, Text};

/// The page of a study as one HTML text that needs no network: what was asked, the bounds with their numerical errors
/// and witnesses, the deviation over the cycle, probability boxes, the three treatments, the moving mechanism, the
/// journals' paths, failed runs, energy residuals, and how all of it was computed. Text from files is escaped.
pub fn study_page(result: &StudyResult) -> String {
    page(result).into_html()
}

/// The first screen of [`study_page`] and its table of bounds, as a document for a frame in a notebook.
pub fn study_frame(result: &StudyResult) -> Frame {
    page(result).into_frame(&["bounds"], 0.0, &result.drawing)
}

fn page(result: &StudyResult) -> Page {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer(result, &writer);
    let first = curves::first_chart(result, &writer);
    let writer = &writer;
    let own = |id: &'static str, title: &'static str, is_there: bool, body: &dyn Fn() -> Markup| {
        is_there.then(|| Section::new(id, title, body()))
    };
    // A path in space is drawn with its mechanism.
    let is_planar = |path: &PointPath| !path.is_in_space();
    let has_path = result.paths.as_ref().is_some_and(|all| all.paths.iter().any(is_planar))
        || result.curves.iter().any(|curve| curve.path.is_some());
    let has_boxes = result.boxes.len() > first.boxes;
    let sections = [
        own("paths", "The path and its tolerance zone", has_path, &|| curves::zones(result, writer)),
        own("curves", "Other deviations over the cycle", result.curves.len() > 1, &|| {
            curves::other_charts(result, writer)
        }),
        own("orbits", "The journal in its bearing", !result.orbits.is_empty(), &|| orbits(result, writer)),
        page_section(contributors_section(result, writer)),
        page_section(result.motion.as_ref().and_then(|motion| joints_section(motion, writer))),
        page_section(allowed_section(result, writer)),
        page_section(answers_section(result, writer)),
        own("boxes", "Distribution", has_boxes, &|| curves::box_charts(result, first.boxes, writer)),
        page_section(requirements(result, writer)),
        page_section(bounds_section(result, writer)),
        page_section(places_section(result, writer)),
        page_section(treatments_section(result, writer)),
        page_section(promise_section(result, writer)),
        page_section(degrees_section(result, writer)),
        page_section(percentiles_section(result, writer)),
        page_section(rare_section(result, writer)),
        page_section(surrogate_section(result, writer)),
        page_section(accuracy_section(result, writer)),
        page_section(runs_section(result, writer)),
        own("energy", "Energy check", result.energy.is_some(), &|| {
            result.energy.as_ref().map(|energy| provenance::energy(energy, writer)).unwrap_or_default()
        }),
        page_section(provenance::method_section(result, writer)),
        study_repeat_section(result, writer),
    ];
    Page {
        title: result.name.clone(),
        kicker: "Accuracy study",
        subtitle: html! {
            "Mechanism " strong { (result.model) } " · " (counted(result.counts.runs, "run", &writer.with_tag(&Tag::Count("runs")))) " · study "
            code { (short_hash(&result.input_hash)) }
        },
        answer: answer_markup(&answer),
        is_answer_short: true,
        beside: mechanism(result),
        below: first.markup,
        more: contributors_overview(result, writer).unwrap_or_default(),
        is_folded: true,
        sections: sections.into_iter().flatten().collect(),
        identity: format!("study {}", short_hash(&result.input_hash)),
        version: result.version.clone(),
    }
}

/// The answer, the mechanism, the deviations over the cycle and the key table of [`study_page`] as HTML to stand inside another page, such as
/// a notebook; without styles and scripts. Text from files is escaped.
pub fn study_excerpt(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer_markup(&answer(result, &writer));
    let table = bounds_section(result, &writer).as_ref().map_or_else(Markup::default, blocks);
    let figures = images(html! {
        (mechanism(result))
        (curves::first_chart(result, &writer).markup)
        (curves::other_charts(result, &writer))
    });
    html! { (answer) (figures) (table) }.into_string()
}

/// The mechanism: in space turned by the reader, in the plane moving.
fn mechanism(result: &StudyResult) -> Markup {
    match &result.motion {
        Some(motion) => motion_figure(motion),
        None => mechanism_figure(&result.drawing, &result.cycle.drive),
    }
}

fn short_hash(hash: &str) -> String {
    hash.chars().take(8).collect()
}

/// Outputs besides the first one whose sentences the first page shows; it has four screens at most. The others open.
const MAX_FURTHER: usize = 3;

/// A sentence on each further output, and the condition of all of them last.
fn further_markup(answer: &StudyAnswer) -> Markup {
    let Some(conditions) = &answer.conditions else { return Markup::default() };
    let (shown, folded) = answer.further.split_at(answer.further.len().min(MAX_FURTHER));
    html! {
        ul.further {
            @for sentence in shown { li { (sentence) } }
            @if folded.is_empty() { li { (conditions) } }
        }
        @if !folded.is_empty() {
            details.fold open {
                summary { (folded.len()) @if folded.len() == 1 { " more output" } @else { " more outputs" } }
                ul.further { @for sentence in folded { li { (sentence) } } }
            }
            ul.further { li { (conditions) } }
        }
    }
}

fn answer_markup(answer: &StudyAnswer) -> Markup {
    let all: Vec<&String> = answer.overturns.iter().chain(&answer.caveats).collect();
    let caveats = html! { @if !all.is_empty() { ul.caveats { @for caveat in all { li { (caveat) } } } } };
    html! {
        @if let Some(verdict) = answer.verdict {
            p class={ "verdict " (verdict_class(verdict)) } {
                (verdict_headline(verdict))
            }
        }
        @if let Some(failed) = &answer.failed { p.headline { (failed) } }
        @for requirement in &answer.requirements { p { (requirement) } }
        @if answer.verdict.is_some() { (caveats) }
        p.headline { (answer.headline) }
        (further_markup(answer))
        @if answer.verdict.is_none() { (caveats) }
        p.error { (answer.error.all()) }
        details.fold open {
            summary { "Runs and assumptions" }
            ul.details { @for detail in &answer.details { li { (detail) } } }
        }
    }
}

fn verdict_class(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Met => "met",
        Verdict::Promised => "promised",
        Verdict::NotMet => "not-met",
        Verdict::Undecided => "undecided",
    }
}

fn requirements(result: &StudyResult, writer: &NumberWriter) -> Option<article::Section> {
    let of_unknown = match has_unknown(&result.inputs) {
        true => format!(", for all values of the {}", UNKNOWN_INPUTS),
        false => String::new(),
    };
    let row = |requirement: &RequirementOutcome| -> Vec<Cell> {
        let tag = |part: &str| Tag::requirement(requirement, part);
        let RequirementOutcome { output, of, at, probability: [lower, upper], verdict, .. } = requirement;
        let limits = requirement_words(result, requirement, &output_unit(result, output), writer);
        let asked = writer.with_tag(&Tag::Given("required share"));
        let share = Text::from(writer.with_tag(&tag("share")).percent_range(*lower, *upper));
        let promised = requirement.promised.map_or_else(Text::default, |least| {
            let least = writer.with_tag(&tag("promised")).percent(least, Rounding::Down);
            Text::from(" ").quiet(format!("promised: at least {least}"))
        });
        let word = verdict_words(*verdict);
        let html = html! { span class={ "verdict " (verdict_class(*verdict)) } { (word) } }.into_string();
        vec![
            format!("{output}, {} {limits}, {}", deviation_words(*of), place_words(*at, writer)).into(),
            format!("≥ {}", asked.percent(requirement.probability_at_least, Rounding::Nearest)).into(),
            share.then(promised).into(),
            writer.with_tag(&tag("witness")).witness(&requirement.witness, &result.inputs).into(),
            Cell::Drawn { html, text: word.to_owned() },
        ]
    };
    let columns = vec![
        Column::words("Requirement"),
        Column::numbers("Required share"),
        Column::numbers("Share inside"),
        Column::words("Smallest at"),
        Column::words("Verdict"),
    ];
    let mut section = article::Section::new("requirements", "Requirements");
    section.push(Content::Note(format!("Shares of mechanisms{of_unknown}.").into()));
    section.push(Content::Table(Table::new(columns, result.requirements.iter().map(row))));
    (!result.requirements.is_empty()).then_some(section)
}

fn orbits(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "The path of the pin centre relative to the hole, in the frame of the part with the hole. Inside the circle the pin \
             does not touch the hole. On the circle the parts are in contact."
        }
        (orbit_chooser(&result.orbits, writer))
    }
}
