//! Smallest and largest values of the outputs of a run, and where they are.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS};
use crate::numbers::tag::Tag;
use crate::words::wording::{deviation_words, head, without_round_off};
use loosepin_result::simulation::{Extreme, ExtremePoint, SimulationRecord};
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

/// `None` if nothing has an extreme.
pub(super) fn extremes_section(record: &SimulationRecord, writer: &NumberWriter) -> Option<Section> {
    if record.extremes.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("extremes", "Smallest and largest values");
    let mut what = "Extremes of the continuous motion, also between the samples.".to_owned();
    if record.joints.iter().any(|joint| joint.impacts + joint.contacts > 0) {
        what.push_str(
            " A force in a joint is the whole force, with friction and damping; the contact forces of the joints are normal to the \
             surfaces.",
        );
    }
    section.push_on(Medium::Page, Content::sentences([what]));
    let at = || Column { only: Some(Medium::Terminal), ..Column::words("at") };
    let [smallest, largest] = ["smallest", "largest"].map(|words| Column::numbers(head(words)));
    let columns = vec![Column::words(head("quantity")), smallest, at(), largest, at()];
    let row = |extreme: &Extreme| {
        let end = |part: &str, point: &ExtremePoint| {
            end_cells(record, &Tag::extreme(extreme, part), point, &extreme.unit, writer)
        };
        let ends = [end("minimum", &extreme.minimum), end("maximum", &extreme.maximum)];
        std::iter::once(extreme_words(extreme).into()).chain(ends.into_iter().flatten()).collect()
    };
    section.push(Content::Table(Table::new::<Cell>(columns, record.extremes.iter().map(row))));
    Some(section)
}

/// The value, on a page with its place below it; and its place.
fn end_cells(
    record: &SimulationRecord,
    tag: &Tag,
    point: &ExtremePoint,
    unit: &SiUnit,
    writer: &NumberWriter,
) -> [Cell; 2] {
    let value = writer.with_tag(tag).value(without_round_off(record, point.value_si, unit), unit);
    let time = writer.with_tag(&tag.part("time")).value(point.time_s, &SiUnit::TIME);
    // The phase of a cycle in which no drive turns tells nothing that the time does not.
    let place = match record.settings.drive_speed_rad_s {
        None => Text::from(time),
        Some(_) => {
            let angle = writer.with_tag(&tag.part("angle")).angle_in_turn(point.drive_angle_rad, PLAIN_DIGITS);
            let of_drive = format!("{} at ", record.settings.drive);
            Text::from(time).plain(", ").on(Medium::Page, of_drive).plain(angle)
        }
    };
    let below = Text::from(" ").quiet(place.words_on(Medium::Page));
    [Text::default().strong(value).on(Medium::Page, below).into(), place.into()]
}

/// What an extreme is of: `slider`, or `slider, deviation`.
fn extreme_words(extreme: &Extreme) -> String {
    if extreme.of.is_value() {
        extreme.name.clone()
    } else {
        format!("{}, {}", extreme.name, deviation_words(extreme.of))
    }
}
