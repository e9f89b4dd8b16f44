//! The loosest values that meet the requirements, and small probabilities.

use crate::medium::article_page::push_figure;
use crate::numbers::number::NumberWriter;
use crate::study::inverse::{inverse_sentences, rare_sentences};
use crate::study::together::frontier;
use loosepin_result::study::StudyResult;
use loosepin_text::article::{Content, Section};
use maud::Markup;

/// `None` if no input may be loosened.
pub(crate) fn allowed_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let sentences = inverse_sentences(result, writer);
    if sentences.is_empty() {
        return None;
    }
    let mut section = Section::new("allowed", "Loosest values that meet the requirements");
    section.push(Content::points(sentences));
    push_figure(&mut section, writer, || {
        let chart = result.together.as_ref().and_then(|one| frontier(result, one, writer));
        chart.map_or_else(Markup::default, |chart| chart.figure())
    });
    Some(section)
}

/// `None` if no small probability was asked for.
pub(crate) fn rare_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let sentences = rare_sentences(result, writer);
    let mut section = Section::new("rare", "Small probabilities");
    let is_asked = !sentences.is_empty();
    section.push(Content::points(sentences));
    is_asked.then_some(section)
}
