//! The page of a study: the answer, the bounds, the curves, the treatments, the mechanism, and how it was computed.

mod curves;
mod cuts;
mod provenance;
mod what_if;

use maud::{Markup, html};

pub use curves::{KnownValue, known_values};

use super::answer::{Answer, answer, requirement_words, verdict_headline};
use super::article_page::{blocks, page_section};
use super::figure::figures;
use super::mechanism_figure::mechanism_figure;
use super::number::{NumberWriter, Rounding};
use super::page::{Page, Section};
use super::repeat_section::study_repeat_section;
use super::still_figures::orbit_figure;
use super::study_sections::{
    accuracy_section, allowed_section, answers_section, bounds_section, contributors_section, promise_section,
    rare_section, surrogate_section, treatments_section,
};
use super::tag::Tag;
use super::wording::{counted, has_unknown, output_unit, place_words, unknown_words, verdict_words};
use loosepin_result::study::{StudyResult, Verdict};
use loosepin_text::article;

/// The page of a study as one HTML text that needs no network: what was asked, the bounds with their numerical errors
/// and witnesses, the deviation over the cycle, probability boxes, the three treatments, the moving mechanism, the
/// journals' paths, failed runs, energy residuals, and how all of it was computed. Text from files is escaped.
pub fn study_page(result: &StudyResult) -> String {
    let writer = NumberWriter::for_page(&result.display_units);
    let answer = answer(result, &writer);
    let first = curves::first_chart(result, &writer);
    let writer = &writer;
    let mut sections = Vec::new();
    let has_path = result.curves.iter().any(|curve| curve.path.is_some());
    let own = |id: &'static str, title: &'static str, is_there: bool, body: &dyn Fn() -> Markup| {
        is_there.then(|| Section::new(id, title, body()))
    };
    let both = |section: Option<article::Section>| section.as_ref().map(page_section);
    sections.extend(own("paths", "The path and its tolerance zone", has_path, &|| curves::zones(result, writer)));
    sections.extend(own("curves", "Other deviations over the cycle", result.curves.len() > 1, &|| {
        curves::other_charts(result, writer)
    }));
    sections.extend(own("orbits", "The journal in its bearing", !result.orbits.is_empty(), &|| orbits(result, writer)));
    sections.extend(both(contributors_section(result, writer)));
    sections.extend(both(allowed_section(result, writer)));
    sections.extend(both(answers_section(result, writer)));
    sections.extend(own("boxes", "Distribution", result.boxes.len() > first.boxes, &|| {
        curves::box_charts(result, first.boxes, writer)
    }));
    sections.extend(both(treatments_section(result, writer)));
    sections
        .extend(own("requirements", "Requirements", !result.requirements.is_empty(), &|| requirements(result, writer)));
    sections.extend(both(bounds_section(result, writer)));
    sections.extend(both(promise_section(result, writer)));
    sections.extend(own("degrees", "Bounds by degree of possibility", !result.cuts.is_empty(), &|| {
        cuts::cuts(result, writer)
    }));
    sections.extend(own("percentiles", "Percentiles of the statistics", !result.percentiles.is_empty(), &|| {
        cuts::percentiles(result, writer)
    }));
    sections.extend(both(rare_section(result, writer)));
    sections.extend(both(surrogate_section(result, writer)));
    sections.extend(both(accuracy_section(result, writer)));
    sections.extend(own("runs", "Runs, failures and impacts", true, &|| provenance::runs(result, writer)));
    sections.extend(
        result.energy.as_ref().map(|energy| Section::new("energy", "Energy check", provenance::energy(energy, writer))),
    );
    sections.extend(own("method", "How this was computed", true, &|| provenance::method(result, writer)));
    sections.extend(study_repeat_section(result, writer));
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
    let table = bounds_section(result, &writer).as_ref().map_or_else(Markup::default, blocks);
    let first = curves::first_chart(result, &writer).markup.into_string();
    html! { (answer) @for figure in figures(&first).iter().take(1) { (figure.image()) } (table) }.into_string()
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
