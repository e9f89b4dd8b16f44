//! Between what the outputs move, and how far play moves them.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS};
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_result::round_off::round_off_si;
use loosepin_text::article::{Cell, Column, Content, Section, Table};

use super::charts::range;
use super::drawing::size_m;
use super::moved::has_clearance;
use super::play_effect::{play_effect, spread};
use super::searched::{found_words, notes, proven_words};

/// `None` if no output is a position or an angle.
pub(super) fn ranges_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    if record.outputs.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("outputs", "Outputs");
    let has_searched = record.outputs.iter().any(|output| !output.clearance.searched.is_empty());
    let found: &[&str] = if has_searched { &["found there"] } else { &[] };
    let numbers = [&["smallest", "largest", "worst by play", "at"], found, &["proven", "standard deviation"]].concat();
    let numbers = numbers.into_iter().map(|words| Column::numbers(head(words)));
    let columns = std::iter::once(Column::words(head("output"))).chain(numbers).collect();
    let rows = record.outputs.iter().map(|output| row(record, output, has_searched, writer));
    section.push(Content::Table(Table::new(columns, rows)));
    let notes = notes(record);
    if !notes.is_empty() {
        section.push(Content::sentences(notes));
    }
    Some(section)
}

fn row(record: &MotionRecord, output: &OutputMotion, has_searched: bool, writer: &NumberWriter) -> Vec<Cell> {
    let effect = play_effect(record, output);
    // The ideal motion has no error.
    let threshold_si = round_off_si(&output.unit, size_m(record));
    let without_round_off = |value_si: &f64| if value_si.abs() < threshold_si { 0.0 } else { *value_si };
    let values_si: Vec<f64> = output.value_si.iter().map(without_round_off).collect();
    let ends = range(output, "position", &values_si, &output.unit, writer);
    let [smallest, largest] = ends.map_or([None, None], |ends| ends.map(Some));
    let searched = output.clearance.searched.first();
    let proven = || match searched {
        Some(searched) => proven_words(output, searched, writer),
        None => Some(effect.proven(record, output, writer).unwrap_or_else(|| "not proven".to_owned())),
    };
    let mut play = [const { None }; 5];
    let is_known = has_clearance(output) || !output.clearance.worst_case_si.is_empty();
    if is_known && effect.largest_si.is_finite() {
        play = [
            Some(effect.written(output, writer)),
            Some(effect.place(record, output, PLAIN_DIGITS, writer)),
            searched.map(|searched| found_words(output, searched, writer)),
            proven(),
            spread(record, output, writer),
        ];
    }
    let [written, place, found, proven, spread] = play;
    let found = has_searched.then_some(found);
    let play = [written, place].into_iter().chain(found).chain([proven, spread]);
    let name = named_words(&output.name, &output.words);
    [Some(name), smallest, largest].into_iter().chain(play).map(Cell::from).collect()
}
