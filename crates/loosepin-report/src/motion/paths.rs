//! Paths of points: how far play and scatter take them along and across their motion, and on a page their pictures.

use maud::{Markup, html};

use crate::charts::path_figure::{along_and_across_m, extent_words, largest_reach_m, path_figure, without_round_off};
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::head;
use loosepin_result::motion::MotionRecord;
use loosepin_result::point_path::PointPath;
use loosepin_text::article::{Cell, Column, Content, Medium, Section, Table};
use loosepin_text::units::SiUnit;

use super::angles::{largest, turn_angle};
use super::charts::path_words;

/// The figure of the first path; empty if there is none.
pub(super) fn first_path_figure(record: &MotionRecord, writer: &NumberWriter) -> Markup {
    let figure = |path| path_figure(path, &record.drive, &record.drive_angle_rad, writer);
    record.paths.first().map(figure).unwrap_or_default()
}

/// `None` if there are no paths. The page shows the figures of the first `shown` ones elsewhere.
pub(super) fn paths_section(record: &MotionRecord, shown: usize, writer: &NumberWriter) -> Option<Section> {
    if record.paths.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("paths", "Paths of points");
    let numbers = ["most along", "at", "most across", "at"].map(|words| Column::numbers(head(words)));
    let columns = std::iter::once(Column::words(head("path"))).chain(numbers).collect();
    section.push(Content::Table(Table::new(columns, record.paths.iter().map(|path| row(record, path, writer)))));
    let has_rest = |path: &&PointPath| path.has_zone() && (0..path.positions()).any(|k| path.stands_still(k));
    for path in record.paths.iter().filter(has_rest) {
        // The figure on the page says the same.
        section
            .push_on(Medium::Terminal, Content::Note(format!("{}: {}", path.point, extent_words(path, writer)).into()));
    }
    let figures = record.paths.get(shown..).unwrap_or_default();
    if !figures.is_empty() {
        push_figure(&mut section, writer, || {
            html! {
                div.charts {
                    @for path in figures { (path_figure(path, &record.drive, &record.drive_angle_rad, writer)) }
                }
            }
        });
    }
    Some(section)
}

/// The largest reach of the zone along and across the motion, with the angles of the drive.
fn row(record: &MotionRecord, path: &PointPath, writer: &NumberWriter) -> Vec<Cell> {
    let ends = ["along", "across"].into_iter().zip(along_and_across_m(path)).flat_map(|(word, values)| {
        let (angle_rad, most_m) = largest(record, &values);
        let most_m = without_round_off(most_m, largest_reach_m(path));
        let [most, at] = [Tag::joint(&path.name, "path", word), Tag::joint(&path.name, "path", word).part("at")];
        // What stands still is as far off at each angle.
        let has_place = most_m > 0.0 && !path.always_stands_still();
        let place = has_place.then(|| turn_angle(record, angle_rad, PLAIN_DIGITS, &writer.with_tag(&at)));
        [Some(writer.with_tag(&most).rounded(most_m, &SiUnit::LENGTH, 2, Rounding::Up)), place]
    });
    std::iter::once(Some(path_words(path))).chain(ends).map(Cell::from).collect()
}
