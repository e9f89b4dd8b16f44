//! What random dimensions do to the outputs of a motion in space.

use super::numbers::{shown, shown_input};
use crate::motion::angles::{asked_angle, asked_place, not_the_asked_one};
use crate::numbers::largest::places_of_largest;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{head, named_words};
use loosepin_result::motion::DimensionContributor;
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};
use loosepin_text::units::DisplayUnits;

/// The standard deviation of each output where it is largest, and what each dimension adds to it there; `None` where nothing scatters.
pub(super) fn scatter_section(record: &SpatialMotionRecord, medium: Medium) -> Option<Section> {
    let groups: Vec<Group> = record.outputs.iter().flat_map(|output| groups_of(record, output, medium)).collect();
    if groups.is_empty() {
        return None;
    }
    let mut section = Section::headed_on_page("scatter", "Effect of part scatter");
    section.push(Content::sentences([
        "Standard deviations by the random inputs of the study, correlations included, to first order. They are without play, and come on top of its \
         worst case. `loosepin study` joins both, and judges the requirements.",
    ]));
    let columns = vec![
        Column { only: Some(Medium::Terminal), ..Column::words("output") },
        Column::words(head("input")),
        Column::numbers(head("standard deviation")),
        Column { only: Some(Medium::Terminal), ..Column::numbers("at") },
        Column::numbers(head("share of variance")),
    ];
    section.push(Content::Table(Table { columns, groups, ..Table::default() }));
    Some(section)
}

/// The position in which the scatter of an output is largest, the first of several alike, with its standard deviation there.
pub(super) fn largest_scatter(output: &SpatialOutputRecord) -> Option<(usize, f64)> {
    let all = &output.scatter.standard_deviation_si;
    let [first, _] = places_of_largest(all)?;
    Some((first, all[first])).filter(|(_, value_si)| *value_si > 0.0)
}

/// What each dimension adds to the standard deviation of an output: at the poses that a study asks about, then where it is largest.
fn groups_of(record: &SpatialMotionRecord, output: &SpatialOutputRecord, medium: Medium) -> Vec<Group> {
    let Some((position, total_si)) = largest_scatter(output) else { return Vec::new() };
    let units = DisplayUnits::default();
    let writer = match medium {
        Medium::Page => NumberWriter::for_page(&units),
        Medium::Terminal => NumberWriter::for_terminal(&units),
    };
    let name = named_words(&output.name, &output.words);
    let of_asked = record.asked_of(&output.name).map(|asked| {
        let parts = asked.dimensions.iter().map(|own| (own.value_si, own.name.as_str())).collect();
        let all = (asked.standard_deviation_si, parts);
        let heading = format!("{name}, {}", asked_place(asked, &writer));
        Group { heading: heading.into(), rows: rows(output, &asked_angle(asked, &writer), total_si, all, medium) }
    });
    let at_position = |own: &DimensionContributor| own.standard_deviation_si.get(position).copied().unwrap_or_default();
    let parts = output.scatter.contributors.iter().map(|own| (at_position(own), own.path.as_str())).collect();
    let at = shown_input(record, position, medium);
    let others = not_the_asked_one(record.asked_of(&output.name), record.phase_rad(position));
    let heading = format!("{name}, at {at}, where it is largest{others}");
    // One table on a terminal, unless there are places to tell apart.
    let on_terminal = if record.asked.is_empty() { "" } else { &heading };
    let heading = Text::by_medium(heading.as_str(), on_terminal);
    let largest = Group { heading, rows: rows(output, &at, total_si, (total_si, parts), medium) };
    of_asked.chain([largest]).collect()
}

/// All together, then the dimensions, the largest first; in the unit of numbers of the size of `scale_si`.
fn rows(
    output: &SpatialOutputRecord,
    at: &str,
    scale_si: f64,
    (total_si, mut parts): (f64, Vec<(f64, &str)>),
    medium: Medium,
) -> Vec<Vec<Cell>> {
    let units = DisplayUnits::default();
    let writer = NumberWriter::for_page(&units);
    let row = |name: Text, part_si: f64| -> Vec<Cell> {
        let share = if total_si > 0.0 { (part_si / total_si).powi(2) } else { 0.0 };
        vec![
            output.name.as_str().into(),
            name.into(),
            shown(part_si, &output.unit, scale_si, medium).into(),
            at.into(),
            writer.percent(share, Rounding::Nearest).into(),
        ]
    };
    parts.sort_by(|a, b| b.0.total_cmp(&a.0));
    let all = row(head("all (root sum of squares)"), total_si);
    let rows = parts.into_iter().map(|(part_si, path)| row(Text::default().code(path), part_si));
    std::iter::once(all).chain(rows).collect()
}
