//! A sweep on a terminal.

use crate::medium::article_text::terminal_text;
use crate::numbers::number::NumberWriter;
use loosepin_result::sweep::SweepRecord;
use loosepin_text::article::Section;

use super::answer::headline_sentences;
use super::stretches::stretches_section;

/// A sweep as text for a terminal: the answer, and what kind of motion there is where.
pub fn sweep_text(record: &SweepRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let answer = Section::of_sentences("answer", headline_sentences(record, writer));
    terminal_text(&record.model, [answer, stretches_section(record, writer)])
}
