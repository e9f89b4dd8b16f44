//! The page of a study: the answer, the bounds, the curves, the treatments, the mechanism, and how it was computed.

mod bounds_table;
mod contributors;
mod curves;
mod cuts;
mod provenance;
mod surrogate;
mod treatments;

use maud::{Markup, html};

pub(super) use contributors::{band_share, known as known_share, share as share_range};

use super::accuracy_text::accuracy_sentences;
use super::answer::{Answer, answer, requirement_words, verdict_headline};
use super::inverse::{inverse_sentences, rare_sentences};
use super::mechanism_figure::mechanism_figure;
use super::number::{NumberWriter, Rounding};
use super::page::{Page, Section};
use super::promise_text::{promise_sentences, promise_title};
use super::still_figures::orbit_figure;
use super::together::frontier;
use super::wording::{counted, has_unknown, output_unit, place_words, unknown_words, verdict_words};
use loosepin_result::study::{StudyResult, Verdict};

/// The page of a study as one HTML text that needs no network: what was asked, the bounds with their numerical errors
/// and witnesses, the deviation over the cycle, probability boxes, the three treatments, the moving mechanism, the
/// journals' paths, failed runs, energy residuals, and how all of it was computed. Text from files is escaped.
pub fn study_page(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer(result, &writer);
    let mut sections = Vec::new();
    if !result.requirements.is_empty() {
        sections.push(Section::new("requirements", "Requirements", requirements(result, &writer)));
    }
    for (id, title, sentences) in [
        ("accuracy", "Accuracy of the bounds", accuracy_sentences(result, &writer)),
        ("allowed", "Loosest values that meet the requirements", inverse_sentences(result, &writer)),
        ("rare", "Small probabilities", rare_sentences(result, &writer)),
    ] {
        if !sentences.is_empty() {
            let figure =
                result.together.as_ref().filter(|_| id == "allowed").and_then(|one| frontier(result, one, &writer));
            let markup = html! {
                ul { @for sentence in &sentences { li { (sentence) } } }
                @if let Some(chart) = figure { (chart.figure()) }
            };
            sections.push(Section::new(id, title, markup));
        }
    }
    if !result.bounds.is_empty() {
        sections.push(Section::new("bounds", "Bounds", bounds_table::bounds_table(result, &writer)));
    }
    if let Some(promise) = &result.promise {
        let sentences = promise_sentences(result, &writer);
        let (head, ends) = sentences.split_at(2);
        let markup = html! {
            @for sentence in head { p { (sentence) } }
            ul { @for sentence in ends { li { (sentence) } } }
        };
        sections.push(Section::new("promise", promise_title(promise, &writer), markup));
    }
    if let Some(record) = &result.surrogate {
        let markup = surrogate::surrogate(result, record, &writer);
        sections.push(Section::new("surrogate", super::surrogate_text::title(record), markup));
    }
    if !result.cuts.is_empty() {
        sections.push(Section::new("degrees", "Bounds by degree of possibility", cuts::cuts(result, &writer)));
    }
    if !result.percentiles.is_empty() {
        sections.push(Section::new("percentiles", "Percentiles of the statistics", cuts::percentiles(result, &writer)));
    }
    if !result.curves.is_empty() {
        sections.push(Section::new("curves", "Deviation over the cycle", curves::deviation_charts(result, &writer)));
    }
    if !result.boxes.is_empty() {
        sections.push(Section::new("boxes", "Probability boxes", curves::box_charts(result, &writer)));
    }
    if !result.contributors.is_empty() {
        sections.push(Section::new("contributors", "Sensitivity", contributors::contributors(result, &writer)));
    }
    if !result.treatments.is_empty() {
        sections.push(Section::new(
            "treatments",
            "Three treatments of the unknown inputs",
            treatments::treatments(result, &writer),
        ));
    }
    if !result.drawing.bodies.is_empty() {
        sections.push(Section::new(
            "mechanism",
            "The mechanism",
            mechanism_figure(&result.drawing, &result.cycle.drive, "mechanism-figure"),
        ));
    }
    if !result.orbits.is_empty() {
        sections.push(Section::new("orbits", "The journal in its bearing", orbits(result, &writer)));
    }
    sections.push(Section::new("runs", "Runs, failures and impacts", provenance::runs(result, &writer)));
    if let Some(energy) = &result.energy {
        sections.push(Section::new("energy", "Energy check", provenance::energy(energy, &writer)));
    }
    sections.push(Section::new("method", "How this was computed", provenance::method(result, &writer)));
    Page {
        title: result.name.clone(),
        kicker: "Accuracy study",
        subtitle: html! {
            "Mechanism " strong { (result.model) } " · " (counted(result.counts.runs, "run", &writer)) " · study "
            code { (short_hash(&result.input_hash)) }
        },
        answer: answer_markup(&answer),
        sections,
        version: result.version.clone(),
    }
    .into_html()
}

/// The answer and the key table of [`study_page`] as HTML to stand inside another page, such as a notebook; without styles.
/// Text from files is escaped.
pub fn study_excerpt(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer_markup(&answer(result, &writer));
    let table = if result.bounds.is_empty() {
        html! {}
    } else {
        bounds_table::bounds_table(result, &writer)
    };
    html! { (answer) (table) }.into_string()
}

fn short_hash(hash: &str) -> String {
    hash.chars().take(8).collect()
}

fn answer_markup(answer: &Answer) -> Markup {
    html! {
        @if let Some(verdict) = answer.verdict {
            p class={ "verdict " (verdict_class(verdict)) } {
                (verdict_headline(verdict))
            }
        }
        @for requirement in &answer.requirements { p { (requirement) } }
        @if !answer.caveats.is_empty() { ul.caveats { @for caveat in &answer.caveats { li { (caveat) } } } }
        p.headline { (answer.headline) }
        @if !answer.further.is_empty() { ul.further { @for sentence in &answer.further { li { (sentence) } } } }
        ul.details { @for detail in &answer.details { li { (detail) } } }
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

fn requirements(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        table.cards {
            caption.quiet {
                "Shares of mechanisms, numerical error included"
                @if has_unknown(&result.inputs) { ", for all values of the " (unknown_words(&result.inputs)) }
                "."
            }
            thead {
                tr {
                    th scope="col" { "Requirement" }
                    th.number scope="col" { "Required share" }
                    th.number scope="col" { "Share inside" }
                    th scope="col" { "Smallest at" }
                    th scope="col" { "Verdict" }
                }
            }
            tbody {
                @for requirement in &result.requirements {
                    @let unit = output_unit(result, &requirement.output);
                    tr {
                        th scope="row" {
                            (requirement.output) ", " (super::wording::deviation_words(requirement.of)) " "
                            (requirement_words(result, requirement, &unit, writer)) ", "
                            (place_words(requirement.at, writer))
                        }
                        td.number data-label="Required share" {
                            "≥ " (writer.percent(requirement.probability_at_least, Rounding::Nearest))
                        }
                        td.number data-label="Share inside" {
                            (writer.percent_range(requirement.probability[0], requirement.probability[1]))
                            @if let Some(least) = requirement.promised {
                                " " span.quiet { "promised: at least " (writer.percent(least, Rounding::Down)) }
                            }
                        }
                        td data-label="Smallest at" { (writer.witness(&requirement.witness, &result.inputs)) }
                        td data-label="Verdict" {
                            span class={ "verdict " (verdict_class(requirement.verdict)) } {
                                (verdict_words(requirement.verdict))
                            }
                        }
                    }
                }
            }
        }
    }
}

fn orbits(result: &StudyResult, writer: &NumberWriter) -> Markup {
    html! {
        p {
            "The path of the pin centre relative to the hole, in the frame of the part with the hole. Inside the circle the pin \
             does not touch the hole. On the circle the parts are in contact."
        }
        div.orbits { @for orbit in &result.orbits { (orbit_figure(orbit, writer)) } }
    }
}
