//! The result of a study on a terminal.

use crate::medium::article_text::terminal_text;
use crate::motion::spatial::joints_text;
use crate::numbers::number::NumberWriter;
use crate::study::answer::{StudyAnswer, answer, verdict_headline};
use crate::study::sections::{
    accuracy_section, allowed_section, answers_section, bounds_section, contributors_section, percentiles_section,
    promise_section, rare_section, runs_section, surrogate_section, treatments_section,
};
use loosepin_result::study::StudyResult;
use loosepin_text::article::{Content, Section};

/// The result of a study as text for a terminal: the answer, the bounds, the treatments, what failed.
pub fn study_text(result: &StudyResult) -> String {
    let writer = &NumberWriter::for_terminal(&result.display_units);
    let sections = [
        Some(answer_section(&answer(result, writer))),
        bounds_section(result, writer),
        promise_section(result, writer),
        accuracy_section(result, writer),
        percentiles_section(result, writer),
        rare_section(result, writer),
        allowed_section(result, writer),
        answers_section(result, writer),
        surrogate_section(result, writer),
        contributors_section(result, writer),
        result.spatial.as_ref().and_then(|motion| joints_text(motion, &result.outputs)),
        treatments_section(result, writer),
        Some(runs_section(result, writer)),
    ];
    terminal_text(&result.name, sections.into_iter().flatten())
}

fn answer_section(answer: &StudyAnswer) -> Section {
    let mut section = Section::new("answer", "");
    if let Some(verdict) = answer.verdict {
        section.push(Content::sentences([verdict_headline(verdict)]));
        if let Some(failed) = &answer.failed {
            section.push(Content::sentences([failed.clone()]));
        }
        section.push_close(Content::points(answer.requirements.iter().chain(&answer.caveats).cloned()));
    }
    let caveats = if answer.verdict.is_some() { &[][..] } else { &answer.caveats };
    let failed = answer.failed.iter().filter(|_| answer.verdict.is_none());
    let outputs = failed.chain([&answer.headline]).chain(&answer.further).chain(&answer.conditions);
    section.push(Content::sentences(outputs.cloned()));
    let details = caveats.iter().chain([&answer.error]).chain(&answer.details);
    section.push_close(Content::points(details.cloned()));
    section
}
