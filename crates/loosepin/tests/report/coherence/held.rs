//! What is held against what: the texts of a study, read back.

use loosepin::report::{TaggedText, study_page, study_text, tagged};
use loosepin::result::json::Stored;
use loosepin::study::files::bounds_csv;
use loosepin::study::result::StudyResult;

use super::shown::{Names, Shown, page_numbers, terminal_numbers};
use super::stored;

/// Sections of a study's page whose numbers are not all tagged yet. The list can only shrink: a section that is here has such numbers.
pub const SECTIONS_LEFT: [&str; 3] = ["allowed", "orbits", "paths"];
/// Parts of a study's text for a terminal, by their first line, whose numbers are not all tagged yet.
pub const TITLES_LEFT: [&str; 1] = ["Loosest values that meet the requirements"];

/// What writes a text of a study.
#[derive(Debug, Clone, Copy)]
pub enum Writer {
    Page,
    Terminal,
    Summary,
    Table,
}

/// What is read of one text: its numbers, and what is wrong with it by itself.
pub type Read = (Vec<Shown>, Vec<String>);

/// What is known of a study before its texts are read: names that stand in them, units.
pub struct Reader {
    pub names: Names,
    result: StudyResult,
}

impl Reader {
    pub fn of(summary: &str) -> Self {
        Self { names: Names::of(summary), result: StudyResult::from_json(summary).unwrap() }
    }

    pub fn page(&self, page: &TaggedText) -> Read {
        page_numbers(page, &self.names, &SECTIONS_LEFT)
    }

    pub fn terminal(&self, terminal: &TaggedText) -> Read {
        terminal_numbers(terminal, &self.names, &TITLES_LEFT)
    }

    pub fn summary(&self, summary: &str) -> Read {
        let result = StudyResult::from_json(summary).unwrap();
        (stored::summary_numbers(&result), stored::unknown_keys(summary))
    }

    pub fn table(&self, table: &str) -> Read {
        stored::table_numbers(table, &self.result)
    }

    /// What is read of the text of one writer.
    pub fn written(&self, writer: Writer, result: &StudyResult) -> Read {
        match writer {
            Writer::Page => self.page(&tagged(|| study_page(result))),
            Writer::Terminal => self.terminal(&tagged(|| study_text(result))),
            Writer::Summary => self.summary(&result.to_json().unwrap()),
            Writer::Table => self.table(&String::from_utf8(bounds_csv(result).unwrap()).unwrap()),
        }
    }
}

/// What is wrong with texts by themselves and beside each other.
pub fn faults(read: &[Read]) -> Vec<String> {
    let shown: Vec<&Shown> = read.iter().flat_map(|(shown, _)| shown).collect();
    read.iter().flat_map(|(_, faults)| faults.clone()).chain(contradictions(shown)).collect()
}

/// Numbers of one tag that have no common value.
fn contradictions(mut ordered: Vec<&Shown>) -> Vec<String> {
    const ROUND_OFF: f64 = 1e-9;
    ordered.sort_by(|a, b| a.tag.cmp(&b.tag));
    let mut faults = Vec::new();
    for same in ordered.chunk_by(|a, b| a.tag == b.tag) {
        let low = same.iter().max_by(|a, b| a.low.total_cmp(&b.low)).unwrap();
        let high = same.iter().min_by(|a, b| a.high.total_cmp(&b.high)).unwrap();
        if low.low > high.high + ROUND_OFF * high.high.abs().max(low.low.abs()) {
            faults.push(format!("{:?}: {} and {}", low.tag, low.words(), high.words()));
        }
    }
    faults
}
