//! A run on a terminal.

use crate::medium::article_text::terminal_text;
use crate::medium::short_answer::{Weight, of_weight};
use crate::numbers::number::NumberWriter;
use loosepin_result::simulation::{SimulationRecord, StopReason};
use loosepin_text::article::{Block, Content, Section};

use super::answer::all_said;
use super::contact::contact_section;
use super::extremes::extremes_section;
use super::measured::measured_section;
use super::method::method_section;
use super::spectra::spectrum_section;
use super::wear::wear_section;

/// One run as text for a terminal: all that [`short_simulation_text`] has, then contact laws, oscillations, wear, work.
pub fn simulation_text(record: &SimulationRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let said = all_said(record, writer);
    let sections = [
        Some(answer_section(record, of_weight(&said, Weight::Answer))),
        warnings_section(of_weight(&said, Weight::Caveat)),
        Some(Section::of_sentences("details", of_weight(&said, Weight::Detail))),
        extremes_section(record, writer),
        spectrum_section(record, writer),
        contact_section(record, writer),
        wear_section(record, writer),
        measured_section(record, writer),
        Some(method_section(record, writer)),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}

/// The first screen of [`simulation_text`]: the answer, warnings, extremes and joints.
pub fn short_simulation_text(record: &SimulationRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let said = all_said(record, writer);
    let sections = [
        Some(answer_section(record, of_weight(&said, Weight::Answer))),
        warnings_section(of_weight(&said, Weight::Caveat)),
        extremes_section(record, writer).map(short),
        contact_section(record, writer).map(short),
        measured_section(record, writer),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}

fn answer_section(record: &SimulationRecord, answers: Vec<String>) -> Section {
    let failed = match &record.stop {
        StopReason::Failed { words, .. } => Some(format!("the run failed: {words}")),
        StopReason::Finished => None,
    };
    Section::of_sentences("answer", failed.into_iter().chain(answers))
}

/// What puts the answer in doubt; `None` if nothing does.
fn warnings_section(warnings: Vec<String>) -> Option<Section> {
    let mut section = Section::new("warnings", "Warnings");
    let has_any = !warnings.is_empty();
    section.push_close(Content::points(warnings));
    has_any.then_some(section)
}

/// The first table of a section with its note and its first rows: the others stand in the whole text.
fn short(mut section: Section) -> Section {
    const ROWS: usize = 10;
    let is_table = |block: &Block| matches!(block.content, Content::Table(_));
    let mut tables = section.blocks.iter().enumerate().filter(|(_, block)| is_table(block)).map(|(place, _)| place);
    if let Some(second) = tables.nth(1) {
        section.blocks.truncate(second);
    }
    for block in &mut section.blocks {
        if let Content::Table(table) = &mut block.content {
            table.groups.iter_mut().for_each(|group| group.rows.truncate(ROWS));
        }
    }
    section
}

/// The wear of the joints of a run as text for a terminal.
pub fn wear_text(record: &SimulationRecord) -> String {
    terminal_text(&record.model, wear_section(record, &NumberWriter::for_terminal(&record.display_units)))
}
