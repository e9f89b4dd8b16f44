//! The effect of part scatter on the outputs.

use maud::html;

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::medium::article_page::push_figure;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{DimensionContributor, MotionRecord, OutputMotion};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};

use super::angles::{angle_chart, asked_angle, asked_place, largest, not_the_asked_one, turn_angle};
use super::answer::scatter_words;
use super::moved::has_scatter;

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
    let groups = scattering().flat_map(|output| groups(record, output, writer)).collect();
    section.push(Content::Table(Table { columns, groups, ..Table::default() }));
    Some(section)
}

/// What each dimension adds to the standard deviation of an output: at the poses that a study asks about, then where it is largest.
fn groups(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Vec<Group> {
    let name = named_words(&output.name, &output.words);
    let asked = record.asked_of(&output.name).map(|asked| {
        let parts = asked.dimensions.iter().map(|own| (own.value_si, own.name.as_str())).collect();
        let place = Place {
            statistic: format!("scatter at {}", asked.pose_rad),
            at: asked_angle(asked, writer),
            total_si: asked.standard_deviation_si,
            parts,
        };
        let heading = format!("{name}, {}", asked_place(asked, writer));
        Group { heading: heading.into(), rows: place.rows(record, output, writer) }
    });
    let (angle_rad, total_si) = largest(record, &output.dimensional_standard_deviation_si);
    let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
    let at_pose = |one: &DimensionContributor| one.standard_deviation_si.get(pose).copied().unwrap_or(f64::NAN);
    let at = |digits: usize| {
        let tag = Tag::joint(&output.name, "scatter", "at");
        turn_angle(record, angle_rad, digits, &writer.with_tag(&tag))
    };
    let place = Place {
        statistic: "scatter".to_owned(),
        at: at(PLAIN_DIGITS),
        total_si,
        parts: output.dimensional_contributors.iter().map(|one| (at_pose(one), one.path.as_str())).collect(),
    };
    let others = not_the_asked_one(record.asked_of(&output.name), angle_rad);
    let heading = format!("{name}, at {}, where it is largest{others}", at(3));
    // One table on a terminal, unless there are places to tell apart.
    let on_terminal = if record.asked.is_empty() { "" } else { &heading };
    let heading = Text::by_medium(heading.as_str(), on_terminal);
    let largest = Group { heading, rows: place.rows(record, output, writer) };
    asked.chain([largest]).collect()
}

/// The standard deviation of an output at a place, and those of the dimensions alone.
struct Place<'r> {
    /// What the numbers are of.
    statistic: String,
    at: String,
    total_si: f64,
    parts: Vec<(f64, &'r str)>,
}

impl Place<'_> {
    /// All together, then the dimensions, the largest first.
    fn rows(mut self, record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Vec<Vec<Cell>> {
        self.parts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let tag = |part: &str| Tag::joint(&output.name, &self.statistic, part);
        let over_cycle = Tag::joint(&output.name, "scatter", "over the cycle");
        let row = |name: Text, part_si: f64, path: &str, over_cycle_si: f64| -> Vec<Cell> {
            let number = |tag: Tag, value_si: f64| {
                writer.with_tag(&tag.at(path)).rounded(value_si, &output.unit, PLAIN_DIGITS, Rounding::Up)
            };
            let share = if self.total_si > 0.0 { (part_si / self.total_si).powi(2) } else { 0.0 };
            vec![
                output.name.as_str().into(),
                name.into(),
                number(tag("largest"), part_si).into(),
                self.at.as_str().into(),
                writer.with_tag(&tag("share").at(path)).percent(share, Rounding::Nearest).into(),
                number(over_cycle.clone(), over_cycle_si).into(),
            ]
        };
        let (_, all_si) = largest(record, &output.dimensional_standard_deviation_si);
        let all = row(head("all (root sum of squares)"), self.total_si, "", all_si);
        let parts = self.parts.iter().map(|(part_si, path)| {
            let own = output.dimensional_contributors.iter().find(|own| own.path == *path);
            let (_, own_si) = largest(record, own.map_or(&[], |own| &own.standard_deviation_si));
            row(Text::default().code(*path), *part_si, path, own_si)
        });
        std::iter::once(all).chain(parts).collect()
    }
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
