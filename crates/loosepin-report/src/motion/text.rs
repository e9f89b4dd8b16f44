//! An ideal motion on a terminal.

use crate::medium::article_text::terminal_text;
use crate::numbers::number::NumberWriter;
use loosepin_result::motion::MotionRecord;
use loosepin_text::article::{Content, Section};

use super::answer::headline_sentences;
use super::contributors::contributors_section;
use super::efforts::efforts_section;
use super::paths::paths_section;
use super::ranges::ranges_section;
use super::scatter::scatter_section;

/// The ideal motion and the quasi-static answer as text for a terminal.
pub fn motion_text(record: &MotionRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let mut answer = Section::new("answer", "");
    answer.push_close(Content::sentences([record.mobility.as_str()]));
    answer.push(Content::sentences(headline_sentences(record, writer)));
    let sections = [
        Some(answer),
        ranges_section(record, writer),
        paths_section(record, 0, writer),
        efforts_section(record, writer),
        contributors_section(record, writer),
        scatter_section(record, None, writer),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}
