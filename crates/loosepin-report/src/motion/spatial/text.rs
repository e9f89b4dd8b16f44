//! A motion in space on a terminal.

use super::scatter::scatter_section;
use super::tables::{contributors_on_terminal, outputs_section};
use crate::medium::article_text::terminal_text;
use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_text::article::Medium;

/// The ideal motion in space, its worst cases by play, and who contributes, as text for a terminal.
pub fn spatial_motion_text(record: &SpatialMotionRecord) -> String {
    let mut sections = vec![outputs_section(record, Medium::Terminal)];
    if record.has_play {
        sections.extend(record.outputs.iter().map(|output| contributors_on_terminal(record, output)));
    }
    sections.extend(scatter_section(record, Medium::Terminal));
    terminal_text(&record.model, sections)
}
