//! Between what the outputs move, and how far play moves them.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS};
use crate::words::round_off::size_m;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_result::round_off::round_off_si;
use loosepin_text::article::{Cell, Column, Content, Section, Table};

use super::charts::range;
use super::play_effect::{play_effect, spread_on_rims};

/// `None` if no output is a position or an angle.
pub(super) fn ranges_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    if record.outputs.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("outputs", "Outputs");
    let numbers = ["smallest", "largest", "worst by play", "at", "proven", "standard deviation"];
    let numbers = numbers.map(|words| Column::numbers(head(words)));
    let columns = std::iter::once(Column::words(head("output"))).chain(numbers).collect();
    section.push(Content::Table(Table::new(columns, record.outputs.iter().map(|output| row(record, output, writer)))));
    Some(section)
}

fn row(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Vec<Cell> {
    let effect = play_effect(record, output);
    // The ideal motion has no error.
    let threshold_si = round_off_si(&output.unit, size_m(&record.drawing));
    let without_round_off = |value_si: &f64| if value_si.abs() < threshold_si { 0.0 } else { *value_si };
    let values_si: Vec<f64> = output.value_si.iter().map(without_round_off).collect();
    let ends = range(output, "position", &values_si, &output.unit, writer);
    let [smallest, largest] = ends.map_or([None, None], |ends| ends.map(Some));
    let play = effect.largest_si.is_finite().then(|| {
        [
            effect.written(output, writer),
            effect.place(record, output, PLAIN_DIGITS, writer),
            effect.proven(record, output, writer).unwrap_or_else(|| "not proven".to_owned()),
            spread_on_rims(record, output, writer),
        ]
    });
    let play = play.map_or([const { None }; 4], |cells| cells.map(Some));
    let name = named_words(&output.name, &output.words);
    [Some(name), smallest, largest].into_iter().chain(play).map(Cell::from).collect()
}
