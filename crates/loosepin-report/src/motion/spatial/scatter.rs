//! What random dimensions do to the outputs of a motion in space.

use super::numbers::{shown, shown_input};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::{head, named_words};
use loosepin_result::spatial_motion::{SpatialMotionRecord, SpatialOutputRecord};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};
use loosepin_text::units::DisplayUnits;

/// The standard deviation of each output where it is largest, and what each dimension adds to it there; `None` where nothing scatters.
pub(super) fn scatter_section(record: &SpatialMotionRecord, medium: Medium) -> Option<Section> {
    let groups: Vec<Group> = record.outputs.iter().filter_map(|output| group(record, output, medium)).collect();
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

/// The position in which the scatter of an output is largest, with its standard deviation there.
pub(super) fn largest_scatter(output: &SpatialOutputRecord) -> Option<(usize, f64)> {
    let all = output.scatter.standard_deviation_si.iter().copied().enumerate();
    all.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, value_si)| *value_si > 0.0)
}

fn group(record: &SpatialMotionRecord, output: &SpatialOutputRecord, medium: Medium) -> Option<Group> {
    let units = DisplayUnits::default();
    let writer = NumberWriter::for_page(&units);
    let (position, total_si) = largest_scatter(output)?;
    let at = shown_input(record, position, medium);
    let row = |name: Text, part_si: f64| -> Vec<Cell> {
        let share = (part_si / total_si).powi(2);
        vec![
            output.name.as_str().into(),
            name.into(),
            shown(part_si, &output.unit, total_si, medium).into(),
            at.clone().into(),
            writer.percent(share, Rounding::Nearest).into(),
        ]
    };
    let contributors = output.scatter.contributors.iter();
    let mut parts: Vec<(f64, &str)> = contributors
        .map(|own| (own.standard_deviation_si.get(position).copied().unwrap_or_default(), own.path.as_str()))
        .collect();
    parts.sort_by(|a, b| b.0.total_cmp(&a.0));
    let all = row(head("all (root sum of squares)"), total_si);
    let rows = parts.into_iter().map(|(part_si, path)| row(Text::default().code(path), part_si));
    let heading = format!("{}, at {at}, where it is largest", named_words(&output.name, &output.words));
    Some(Group { heading: Text::by_medium(heading, ""), rows: std::iter::once(all).chain(rows).collect() })
}
