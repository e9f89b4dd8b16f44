//! A run on a terminal.

use crate::medium::article_text::terminal_text;
use crate::numbers::number::NumberWriter;
use loosepin_result::simulation::{SimulationRecord, StopReason};
use loosepin_text::article::Section;

use super::answer::headline_sentences;
use super::contact::contact_section;
use super::extremes::extremes_section;
use super::measured::measured_section;
use super::method::method_section;
use super::spectra::spectrum_section;
use super::wear::wear_section;

/// One run as text for a terminal: the answer, extremes, joints, counters.
pub fn simulation_text(record: &SimulationRecord) -> String {
    let writer = &NumberWriter::for_terminal(&record.display_units);
    let failed = match &record.stop {
        StopReason::Failed { words, .. } => Some(format!("the run failed: {words}")),
        StopReason::Finished => None,
    };
    let answer = failed.into_iter().chain(headline_sentences(record, writer));
    let sections = [
        Some(Section::of_sentences("answer", answer)),
        extremes_section(record, writer),
        spectrum_section(record, writer),
        contact_section(record, writer),
        wear_section(record, writer),
        measured_section(record, writer),
        Some(method_section(record, writer)),
    ];
    terminal_text(&record.model, sections.into_iter().flatten())
}

/// The wear of the joints of a run as text for a terminal.
pub fn wear_text(record: &SimulationRecord) -> String {
    terminal_text(&record.model, wear_section(record, &NumberWriter::for_terminal(&record.display_units)))
}
