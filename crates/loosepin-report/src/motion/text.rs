//! An ideal motion on a terminal.

use crate::medium::article_text::terminal_text;
use crate::numbers::number::NumberWriter;
use loosepin_result::motion::MotionRecord;
use loosepin_text::article::{Content, Group, Medium, Section};

use super::answer::headline_sentences;
use super::contributors::contributors_section;
use super::efforts::efforts_section;
use super::paths::paths_section;
use super::ranges::ranges_section;
use super::scatter::scatter_section;

/// The ideal motion and the quasi-static answer as text for a terminal: all that [`short_motion_text`] has, then efforts, and every row.
pub fn motion_text(record: &MotionRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let sections = [
        Some(answer_section(record, writer)),
        ranges_section(record, writer),
        paths_section(record, 0, writer),
        efforts_section(record, writer),
        contributors_section(record, writer),
        scatter_section(record, None, writer),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}

/// The first screen of [`motion_text`]: the answer, outputs, paths, and what contributes most.
pub fn short_motion_text(record: &MotionRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let sections = [
        Some(answer_section(record, writer)),
        ranges_section(record, writer).map(short),
        paths_section(record, 0, writer),
        contributors_section(record, writer).map(short),
        scatter_section(record, None, writer).map(short),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}

fn answer_section(record: &MotionRecord, writer: &NumberWriter) -> Section {
    let mut answer = Section::new("answer", "");
    answer.push_close(Content::sentences([record.mobility.as_str()]));
    answer.push(Content::sentences(headline_sentences(record, writer)));
    answer
}

/// The first group of each table with its first rows: the others stand in the whole text.
fn short(mut section: Section) -> Section {
    const ROWS: usize = 5;
    for block in &mut section.blocks {
        if let Content::Table(table) = &mut block.content {
            let is_own_table = |group: &Group| !group.heading.is_empty_on(Medium::Terminal);
            let next = table.groups.iter().skip(1).position(is_own_table);
            table.groups.truncate(next.map_or(table.groups.len(), |place| place + 1));
            let mut left = ROWS;
            for group in &mut table.groups {
                group.rows.truncate(left);
                left -= group.rows.len();
            }
        }
    }
    section
}
