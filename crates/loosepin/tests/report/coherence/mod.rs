//! No two numbers contradict each other: every number of a result that page, terminal, `summary.json` and `bounds.csv` show is read back with what
//! it is, and what is the same must have the same value to the digits that are shown.

mod held;
mod motion;
mod planted;
mod run;
mod shown;
mod stored;
mod sweep;

use loosepin::report::{TaggedText, study_page, study_text, tagged};
use loosepin::result::json::Stored;
use loosepin::study::files::bounds_csv;
use loosepin::study::result::StudyResult;

use super::report_fixture::study;
use held::{Reader, SECTIONS_LEFT, TITLES_LEFT, Writer, faults};
use shown::{Names, page_numbers, terminal_numbers};

/// The four texts of a study.
struct Texts {
    page: TaggedText,
    terminal: TaggedText,
    summary: String,
    table: String,
}

impl Texts {
    fn of(result: &StudyResult) -> Self {
        Self {
            page: tagged(|| study_page(result)),
            terminal: tagged(|| study_text(result)),
            summary: result.to_json().unwrap(),
            table: String::from_utf8(bounds_csv(result).unwrap()).unwrap(),
        }
    }

    /// What is wrong with them, in words.
    fn faults(&self) -> Vec<String> {
        let reader = Reader::of(&self.summary);
        faults(&[
            reader.page(&self.page),
            reader.terminal(&self.terminal),
            reader.summary(&self.summary),
            reader.table(&self.table),
        ])
    }
}

fn fixtures() -> Vec<StudyResult> {
    vec![study::worn_pin(), study::with_list(), study::with_failed_runs()]
}

#[test]
fn identity_every_number_of_a_study_has_one_value_in_all_its_texts() {
    for result in fixtures() {
        let texts = Texts::of(&result);
        let faults = texts.faults();
        assert!(faults.is_empty(), "{}: {} faults\n{}", result.name, faults.len(), faults.join("\n"));
        let (shown, _) = page_numbers(&texts.page, &Names::of(&texts.summary), &SECTIONS_LEFT);
        assert!(shown.len() > 100, "the page has {} tagged numbers", shown.len());
    }
}

#[test]
fn texts_have_no_marks_but_for_this_test() {
    let result = study::worn_pin();
    let is_mark = |c: char| matches!(c, '\u{e000}'..='\u{f8ff}' | '\u{f0000}'..='\u{10ffff}');
    let marked = tagged(|| study_text(&result)).text;
    assert!(marked.contains(is_mark));
    for text in [study_page(&result), study_text(&result)] {
        assert!(!text.contains(is_mark));
    }
}

#[test]
fn what_is_left_to_tag_has_untagged_numbers() {
    let result = study::worn_pin();
    let texts = Texts::of(&result);
    let names = Names::of(&texts.summary);
    for section in SECTIONS_LEFT.into_iter().filter(|section| *section != "paths") {
        let others: Vec<&str> = SECTIONS_LEFT.into_iter().filter(|other| *other != section).collect();
        let (_, untagged) = page_numbers(&texts.page, &names, &others);
        assert!(!untagged.is_empty(), "take '{section}' out of the list: all its numbers are tagged");
    }
    for title in TITLES_LEFT {
        let others: Vec<&str> = TITLES_LEFT.into_iter().filter(|other| *other != title).collect();
        let (_, untagged) = terminal_numbers(&texts.terminal, &names, &others);
        assert!(!untagged.is_empty(), "take '{title}' out of the list: all its numbers are tagged");
    }
}
