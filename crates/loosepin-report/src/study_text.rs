//! The result of a study on a terminal.

use super::answer::{Answer, answer, verdict_headline};
use super::article_text::{article_text, as_shown};
use super::number::NumberWriter;
use super::percentile_words::percentile_sentences;
use super::study_sections::{
    accuracy_section, allowed_section, answers_section, bounds_section, contributors_section, promise_section,
    rare_section, surrogate_section, treatments_section,
};
use super::tag::Tag;
use super::terminal_table::TERMINAL_COLUMNS;
use super::trust_words::nominal_sentences;
use super::wording::counted;
use loosepin_result::study::{FailureGroup, StudyResult};
use loosepin_text::article::{Article, Content, Fact, Section};

/// The result of a study as text for a terminal: the answer, the bounds, the treatments, what failed.
pub fn study_text(result: &StudyResult) -> String {
    let writer = &NumberWriter::for_terminal(&result.display_units);
    let mut sections = vec![answer_section(&answer(result, writer))];
    let further = [
        bounds_section(result, writer),
        promise_section(result, writer),
        accuracy_section(result, writer),
        percentiles(result, writer),
        rare_section(result, writer),
        allowed_section(result, writer),
        answers_section(result, writer),
        surrogate_section(result, writer),
        contributors_section(result, writer),
        treatments_section(result, writer),
    ];
    sections.extend(further.into_iter().flatten());
    sections.push(trust(result, writer));
    as_shown(&article_text(&Article { title: result.name.clone(), sections }, Some(TERMINAL_COLUMNS)))
}

fn answer_section(answer: &Answer) -> Section {
    let mut section = Section::new("answer", "");
    if let Some(verdict) = answer.verdict {
        section.push(Content::sentences([verdict_headline(verdict)]));
        section.push_close(Content::points(answer.requirements.iter().chain(&answer.caveats).cloned()));
    }
    section.push(Content::sentences([&answer.headline].into_iter().chain(&answer.further).cloned()));
    section.push_close(Content::points(answer.details.iter().cloned()));
    section
}

/// A page has a table of these.
fn percentiles(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let sentences = percentile_sentences(result, writer);
    let are_random = !sentences.is_empty();
    let mut section = Section::new("percentiles", "Percentiles of the statistics");
    section.push(Content::points(sentences));
    are_random.then_some(section)
}

/// Which runs failed, and what the nominal one shows.
fn trust(result: &StudyResult, writer: &NumberWriter) -> Section {
    let mut section = Section::new("runs", "");
    section.push(Content::sentences([nominal_sentences(result, writer).join(" ")]));
    for failure in &result.failures {
        section.push(Content::sentences([failed_words(failure, writer)]));
        section.push_close(Content::Facts(vec![Fact::nameless(format!("again: {}", failure.example.command))]));
    }
    section
}

fn failed_words(failure: &FailureGroup, writer: &NumberWriter) -> String {
    let tag = Tag::whole("failed runs", &failure.code);
    format!("{} failed: {}", counted(failure.count, "run", &writer.about(&tag)), failure.words)
}
