//! Answers of questions that have no layout of their own.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use loosepin_result::study::{AnswerPart, QuestionAnswer, StudyResult};
use loosepin_text::article::{Content, Section};

/// Digits of a quantity in a sentence.
const DIGITS: usize = 3;

/// `None` if no such question is asked.
pub(crate) fn answers_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let mut section = Section::new("answers", "Further questions");
    for answer in &result.answers {
        section.push(Content::Heading(answer.heading.as_str().into()));
        section.push_close(Content::points(answer.sentences.iter().map(|parts| sentence(answer, parts, writer))));
    }
    (!result.answers.is_empty()).then_some(section)
}

fn sentence(answer: &QuestionAnswer, parts: &[AnswerPart], writer: &NumberWriter) -> String {
    let word = |part: &AnswerPart| match part {
        AnswerPart::Words(words) => words.clone(),
        AnswerPart::Count { of, count } => writer.with_tag(&Tag::whole(&answer.question, of)).count(*count),
        AnswerPart::Quantity { of, value_si, unit } => {
            writer.with_tag(&Tag::whole(&answer.question, of)).rounded(*value_si, unit, DIGITS, Rounding::Nearest)
        }
    };
    parts.iter().map(word).collect()
}
