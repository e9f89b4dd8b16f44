//! The result of a study on a terminal: all of it, or what a first screen has room for.

use crate::medium::article_text::terminal_text;
use crate::motion::joints_text;
use crate::numbers::number::NumberWriter;
use crate::study::answer::{StudyAnswer, answer, verdict_headline};
use crate::study::sections::{
    accuracy_section, allowed_section, answers_section, bounds_excerpt, bounds_section, contributors_excerpt,
    contributors_section, failures_section, percentiles_section, promise_section, rare_section, runs_section,
    surrogate_section, treatments_section, what_narrows,
};
use crate::words::round_off::without_round_off;
use loosepin_result::study::{AccuracyStop, StudyResult, Verdict};
use loosepin_text::article::{Content, Medium, Section};

/// The result of a study as text for a terminal: all that [`short_study_text`] has, then every bound, the treatments, how it was computed.
pub fn study_text(result: &StudyResult) -> String {
    let result = &*without_round_off(result);
    let writer = &NumberWriter::for_terminal(&result.display_units);
    let answer = answer(result, writer);
    let sections = [
        Some(answer_section(&answer, answer.error.all(), answer.details.clone())),
        what_narrows(result, writer),
        warnings_section(&answer),
        bounds_section(result, writer),
        promise_section(result, writer),
        accuracy_section(result, writer),
        percentiles_section(result, writer),
        rare_section(result, writer),
        allowed_section(result, writer),
        answers_section(result, writer),
        surrogate_section(result, writer),
        contributors_section(result, writer),
        result.motion.as_ref().and_then(|motion| joints_text(motion, &result.outputs, writer)),
        treatments_section(result, writer),
        Some(runs_section(result, writer)),
    ];
    terminal_text(&result.name, sections.into_iter().flatten())
}

/// The first screen of [`study_text`]: verdicts, an answer to each question, what to do, warnings; then the bounds of the first answer, and what
/// makes its band wide.
pub fn short_study_text(result: &StudyResult) -> String {
    let result = &*without_round_off(result);
    let writer = &NumberWriter::for_terminal(&result.display_units);
    let answer = answer(result, writer);
    // What would make an error smaller matters unless all limits are kept with it; peaks that could be missed do, unless one is broken.
    let is_kept = matches!(answer.verdict, Some(Verdict::Met | Verdict::Promised));
    let error = if is_kept { answer.error.short() } else { answer.error.all() };
    let gaps = answer.gaps.clone().filter(|_| answer.verdict != Some(Verdict::NotMet));
    let is_accuracy_missed = result.accuracy.as_ref().is_some_and(|record| record.stop != AccuracyStop::Reached);
    let sections = [
        Some(answer_section(&answer, error, gaps.into_iter().collect())),
        allowed_section(result, writer),
        rare_section(result, writer),
        answers_section(result, writer),
        what_narrows(result, writer),
        warnings_section(&answer),
        // Bounds from a surrogate are weaker than computed ones.
        surrogate_section(result, writer),
        failures_section(result, writer),
        accuracy_section(result, writer).filter(|_| is_accuracy_missed),
        bounds_excerpt(result, writer),
        contributors_excerpt(result, writer),
    ];
    terminal_text(&result.name, sections.into_iter().flatten())
}

/// Verdicts, then a sentence on each output, its error and `details`.
fn answer_section(answer: &StudyAnswer, error: String, details: Vec<String>) -> Section {
    let mut section = Section::new("answer", "");
    if let Some(verdict) = answer.verdict {
        section.push(Content::sentences([verdict_headline(verdict)]));
        if let Some(failed) = &answer.failed {
            section.push(Content::sentences([failed.clone()]));
        }
        section.push_close(Content::points(answer.requirements.iter().chain(&answer.overturns).cloned()));
    }
    let failed = answer.failed.iter().filter(|_| answer.verdict.is_none());
    let outputs = failed.chain([&answer.headline]).chain(&answer.further).chain(&answer.conditions);
    section.push(Content::sentences(outputs.cloned()));
    section.push_close(Content::points([error].into_iter().chain(details)));
    section
}

/// What the runs contradict of what the answer takes for granted.
fn warnings_section(answer: &StudyAnswer) -> Option<Section> {
    let mut section = Section::new("warnings", "Warnings");
    section.push_close(Content::points(answer.caveats.iter().cloned()));
    section.blocks.iter().any(|block| !block.content.is_empty_on(Medium::Terminal)).then_some(section)
}
