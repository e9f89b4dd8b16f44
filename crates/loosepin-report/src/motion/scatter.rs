//! The effect of part scatter on the outputs.

use maud::html;

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};

use super::angles::{angle_chart, largest, turn_angle};
use super::answer::{has_scatter, scatter_words};

/// A chart of each output but that which is `shown` already, and what each dimension adds; `None` if no part scatters.
pub(super) fn scatter_section(
    record: &MotionRecord,
    shown: Option<&OutputMotion>,
    writer: &NumberWriter,
) -> Option<Section> {
    let scattering = || record.outputs.iter().filter(|output| has_scatter(output));
    scattering().next()?;
    let mut section = Section::headed_on_page("scatter", "Effect of part scatter");
    let what =
        "Root sum of squares of the effects of all dimensions, correlations included. First order, without play.";
    section.push_on(Medium::Page, Content::sentences([what]));
    push_figure(&mut section, writer, || {
        let others = scattering().filter(|output| shown.is_none_or(|shown| shown.name != output.name));
        html! { @for output in others { (scatter_chart(record, output, writer).figure()) } }
    });
    let columns = vec![
        Column { only: Some(Medium::Terminal), ..Column::words("output") },
        Column::words(head("input")),
        Column::numbers(head("standard deviation")),
        Column { only: Some(Medium::Terminal), ..Column::numbers("at") },
        Column::numbers(head("share of variance")),
        Column { only: Some(Medium::Page), ..Column::numbers("Largest over the cycle") },
    ];
    let groups = scattering().map(|output| group(record, output, writer)).collect();
    section.push(Content::Table(Table { columns, groups, ..Table::default() }));
    Some(section)
}

/// The standard deviation of an output where it is largest, and what each dimension adds to it there, the largest first.
fn group(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Group {
    let (angle_rad, total_si) = largest(record, &output.dimensional_standard_deviation_si);
    let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
    let tag = |part: &str| Tag::joint(&output.name, "scatter", part);
    let at = |digits: usize| turn_angle(record, angle_rad, digits, &writer.with_tag(&tag("at")));
    let row = |name: Text, part_si: f64, path: &str, over_cycle_si: f64| -> Vec<Cell> {
        let number = |part: &str, value_si: f64| {
            writer.with_tag(&tag(part).at(path)).rounded(value_si, &output.unit, PLAIN_DIGITS, Rounding::Up)
        };
        vec![
            output.name.as_str().into(),
            name.into(),
            number("largest", part_si).into(),
            at(PLAIN_DIGITS).into(),
            writer.with_tag(&tag("share").at(path)).percent((part_si / total_si).powi(2), Rounding::Nearest).into(),
            number("over the cycle", over_cycle_si).into(),
        ]
    };
    let mut dimensions: Vec<_> = output
        .dimensional_contributors
        .iter()
        .map(|one| (one.standard_deviation_si.get(pose).copied().unwrap_or(f64::NAN), one))
        .collect();
    dimensions.sort_by(|a, b| b.0.total_cmp(&a.0));
    let all = row(head("all (root sum of squares)"), total_si, "", total_si);
    let parts = dimensions.into_iter().map(|(part_si, one)| {
        let (_, over_cycle_si) = largest(record, &one.standard_deviation_si);
        row(Text::default().code(&one.path), part_si, &one.path, over_cycle_si)
    });
    let heading = format!("{}, at {}, where it is largest", named_words(&output.name, &output.words), at(3));
    Group { heading: Text::by_medium(heading, ""), rows: std::iter::once(all).chain(parts).collect() }
}

/// The standard deviation of an output over the cycle.
pub(super) fn scatter_chart(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Chart {
    let mut chart = angle_chart(record, name_of("scatter", &output.name), writer);
    chart.set_vertical_axis(format!("deviation of {}", output.name), &output.unit, writer);
    let upper = scaled(&output.dimensional_standard_deviation_si, &output.unit, writer);
    let lower: Vec<f64> = upper.iter().map(|value| -value).collect();
    let values = EntryValues::band(&lower, &upper);
    chart.entries.push(Entry::new("± standard deviation of the dimensions", Role::Random, false, values));
    let [most, place] = scatter_words(record, output, writer);
    let words = format!("at most {most}, at {place}");
    chart.caption = html! {
        strong { "Scatter of " (named_words(&output.name, &output.words)) " due to part scatter." } " Standard deviation: " (words) "."
    };
    chart.alternative = format!(
        "Chart of the standard deviation of {} over one cycle: {words}.",
        named_words(&output.name, &output.words)
    );
    chart
}
