//! The page of a study: the answer, the bounds, the curves, the treatments, the mechanism, and how it was computed.

mod bounds_table;
mod contributors;
mod curves;
mod cuts;
mod provenance;
mod surrogate;
mod treatments;
mod what_if;

use maud::{Markup, html};

pub(super) use contributors::{band_probability, band_share, known as known_share, share as share_range};
pub use curves::{KnownValue, known_values};

use super::accuracy_text::accuracy_sentences;
use super::answer::{Answer, answer, requirement_words, verdict_headline};
use super::figure::figures;
use super::inverse::{inverse_sentences, rare_sentences};
use super::mechanism_figure::mechanism_figure;
use super::number::{NumberWriter, Rounding};
use super::page::{Page, Section};
use super::promise_text::{promise_sentences, promise_title};
use super::repeat_section::study_repeat_section;
use super::still_figures::orbit_figure;
use super::tag::Tag;
use super::together::frontier;
use super::wording::{counted, has_unknown, output_unit, place_words, unknown_words, verdict_words};
use loosepin_result::study::{StudyResult, Verdict};

/// The page of a study as one HTML text that needs no network: what was asked, the bounds with their numerical errors
/// and witnesses, the deviation over the cycle, probability boxes, the three treatments, the moving mechanism, the
/// journals' paths, failed runs, energy residuals, and how all of it was computed. Text from files is escaped.
pub fn study_page(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer(result, &writer);
    let first = curves::first_chart(result, &writer);
    let mut sections = Vec::new();
    let mut add = |id: &'static str, title: &str, is_there: bool, body: &dyn Fn() -> Markup| {
        if is_there {
            sections.push(Section::new(id, title, body()));
        }
    };
    let has_path = result.curves.iter().any(|curve| curve.path.is_some());
    add("paths", "The path and its tolerance zone", has_path, &|| curves::zones(result, &writer));
    add("curves", "Other deviations over the cycle", result.curves.len() > 1, &|| {
        curves::other_charts(result, &writer)
    });
    add("orbits", "The journal in its bearing", !result.orbits.is_empty(), &|| orbits(result, &writer));
    let is_explained = !result.contributors.is_empty();
    add("contributors", "Sensitivity", is_explained, &|| contributors::contributors(result, &writer));
    let allowed = inverse_sentences(result, &writer);
    let frontier = || result.together.as_ref().and_then(|one| frontier(result, one, &writer));
    add("allowed", "Loosest values that meet the requirements", !allowed.is_empty(), &|| {
        html! { (list(&allowed)) @if let Some(chart) = frontier() { (chart.figure()) } }
    });
    add("boxes", "Distribution", result.boxes.len() > first.boxes, &|| {
        curves::box_charts(result, first.boxes, &writer)
    });
    let are_treated = !result.treatments.is_empty();
    add("treatments", "Three treatments of the unknown inputs", are_treated, &|| {
        treatments::treatments(result, &writer)
    });
    add("requirements", "Requirements", !result.requirements.is_empty(), &|| requirements(result, &writer));
    add("bounds", "Bounds", !result.bounds.is_empty(), &|| bounds_table::bounds_table(result, &writer));
    if let Some(record) = &result.promise {
        add("promise", &promise_title(record, &writer), true, &|| promise(result, &writer));
    }
    add("degrees", "Bounds by degree of possibility", !result.cuts.is_empty(), &|| cuts::cuts(result, &writer));
    let has_percentiles = !result.percentiles.is_empty();
    add("percentiles", "Percentiles of the statistics", has_percentiles, &|| cuts::percentiles(result, &writer));
    let rare = rare_sentences(result, &writer);
    add("rare", "Small probabilities", !rare.is_empty(), &|| list(&rare));
    if let Some(record) = &result.surrogate {
        let title = super::surrogate_text::title(record);
        add("surrogate", title, true, &|| surrogate::surrogate(result, record, &writer));
    }
    let accuracy = accuracy_sentences(result, &writer);
    add("accuracy", "Accuracy of the bounds", !accuracy.is_empty(), &|| list(&accuracy));
    add("runs", "Runs, failures and impacts", true, &|| provenance::runs(result, &writer));
    if let Some(energy) = &result.energy {
        add("energy", "Energy check", true, &|| provenance::energy(energy, &writer));
    }
    add("method", "How this was computed", true, &|| provenance::method(result, &writer));
    sections.extend(study_repeat_section(result, &writer));
    Page {
        title: result.name.clone(),
        kicker: "Accuracy study",
        subtitle: html! {
            "Mechanism " strong { (result.model) } " · " (counted(result.counts.runs, "run", &writer.about(&Tag::Count("runs")))) " · study "
            code { (short_hash(&result.input_hash)) }
        },
        answer: answer_markup(&answer),
        is_answer_short: false,
        beside: mechanism_figure(&result.drawing, &result.cycle.drive),
        below: first.markup,
        sections,
        identity: format!("study {}", short_hash(&result.input_hash)),
        version: result.version.clone(),
    }
    .into_html()
}

/// The answer, the first chart and the key table of [`study_page`] as HTML to stand inside another page, such as a notebook; without styles.
/// Text from files is escaped.
pub fn study_excerpt(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer_markup(&answer(result, &writer));
    let table = if result.bounds.is_empty() {
        html! {}
    } else {
        bounds_table::bounds_table(result, &writer)
    };
    let first = curves::first_chart(result, &writer).markup.into_string();
    html! { (answer) @for figure in figures(&first).iter().take(1) { (figure.image()) } (table) }.into_string()
}

fn list(sentences: &[String]) -> Markup {
    html! { ul { @for sentence in sentences { li { (sentence) } } } }
}

fn promise(result: &StudyResult, writer: &NumberWriter) -> Markup {
    let sentences = promise_sentences(result, writer);
    let (head, ends) = sentences.split_at(sentences.len().min(2));
    html! {
        @for sentence in head { p { (sentence) } }
        (list(ends))
    }
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
                            "≥ "
                            (writer.about(&Tag::Given("required share")).percent(requirement.probability_at_least, Rounding::Nearest))
                        }
                        td.number data-label="Share inside" {
                            (writer
                                .about(&Tag::requirement(requirement, "share"))
                                .percent_range(requirement.probability[0], requirement.probability[1]))
                            @if let Some(least) = requirement.promised {
                                " " span.quiet { "promised: at least "
                                    (writer.about(&Tag::requirement(requirement, "promised")).percent(least, Rounding::Down))
                                }
                            }
                        }
                        td data-label="Smallest at" { (writer.about(&Tag::requirement(requirement, "witness")).witness(&requirement.witness, &result.inputs)) }
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
