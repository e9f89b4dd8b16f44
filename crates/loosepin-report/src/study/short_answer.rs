//! The answer in a few sentences, for who shows no page.

use crate::motion::headline_sentences;
use crate::numbers::number::NumberWriter;
use crate::study::answer::{answer, verdict_headline};
use loosepin_result::motion::MotionRecord;
use loosepin_result::study::StudyResult;

/// The answer of an ideal motion, the most important first.
pub fn motion_sentences(record: &MotionRecord) -> Vec<String> {
    headline_sentences(record, &NumberWriter::for_page(&record.display_units))
}

/// The answer of a study: the verdict where something is required, a sentence on every output that was asked about, and what could
/// overturn them.
pub fn study_sentences(result: &StudyResult) -> Vec<String> {
    let answer = answer(result, &NumberWriter::for_page(&result.display_units));
    let verdict = answer.verdict.map(|verdict| verdict_headline(verdict).to_owned());
    let outputs = [answer.headline].into_iter().chain(answer.further).chain(answer.conditions);
    verdict.into_iter().chain(answer.overturns).chain(answer.failed).chain(outputs).chain(answer.caveats).collect()
}
