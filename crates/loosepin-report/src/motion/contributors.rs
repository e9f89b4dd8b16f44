//! Contributions of the joints to the effect of play.

use maud::html;

use crate::charts::still_figures::percent_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{JointContributor, MotionRecord, OutputMotion};
use loosepin_result::study::OutputDescription;
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

use super::angles::{asked_place, not_the_asked_one, turn_angle};
use super::moved::has_clearance;
use super::play_effect::largest_first_order;

/// `None` if play moves nothing.
pub(super) fn contributors_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    contributors_of(record, record.outputs.iter(), writer)
}

/// The same of some of the outputs.
fn contributors_of<'r>(
    record: &MotionRecord,
    outputs: impl Iterator<Item = &'r OutputMotion>,
    writer: &NumberWriter,
) -> Option<Section> {
    let outputs: Vec<&OutputMotion> = outputs.filter(|output| has_clearance(output)).collect();
    if outputs.is_empty() {
        return None;
    }
    let all = || outputs.iter().flat_map(|output| &output.clearance.contributors);
    let alone: Vec<Alone> = ALONE.into_iter().filter(|(_, effect)| all().any(|own| !effect(own).is_empty())).collect();
    let groups = outputs.iter().flat_map(|output| groups_of(record, output, &alone, writer)).collect();
    let mut columns = vec![
        Column { only: Some(Medium::Terminal), ..Column::words("output") },
        Column::words(head("joint")),
        Column::numbers(Text::by_medium("Radial clearance", "clearance")),
        Column::numbers(head("effect, first order")),
        Column::numbers_on_terminal(head("share")),
    ];
    columns.extend(alone.iter().map(|(words, _)| Column::numbers(head(words))));
    let caption = match record.asked.is_empty() {
        true => "Shares of the sum of the first-order effects, at the angle where it is largest.",
        false => "Shares of the sum of the first-order effects, at the angle above them.",
    };
    let share_clearance = match alone.is_empty() {
        true => "",
        false => {
            " An offset and a lean of a journal share its clearance, so that the effects of each alone add up to more than that of both."
        }
    };
    let caption = format!("{caption}{share_clearance}").into();
    let mut section = Section::headed_on_page("contributors", "Contribution of each joint");
    section.push(Content::Table(Table { columns, groups, caption, ..Table::default() }));
    Some(section)
}

/// The same on the page of a study: play alone, unknown clearances where there is most of it.
pub(crate) fn joints_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    let section = contributors_section(record, writer)?;
    Some(Section { id: "joints", ..section })
}

/// The same of one output, on a terminal: the first of those that are `asked` about, or the first with play where these are parts of paths.
pub(crate) fn joints_text(
    record: &MotionRecord,
    asked: &[OutputDescription],
    writer: &NumberWriter,
) -> Option<Section> {
    let known = asked.iter().find_map(|asked| record.outputs.iter().find(|output| output.name == asked.name));
    let shown = known.or_else(|| record.outputs.iter().find(|output| has_clearance(output)));
    let section = contributors_of(record, shown.into_iter(), writer)?;
    Some(Section { heading: "What each joint contributes".into(), ..section })
}

/// What a way in which a journal moves does alone, with its words.
type Alone = (&'static str, fn(&JointContributor) -> &[f64]);

const ALONE: [Alone; 3] =
    [("offset alone", |own| &own.offset_si), ("lean alone", |own| &own.lean_si), ("axial", |own| &own.axial_si)];

/// The joints of an output at the poses that a study asks about, then where the sum of their effects is largest.
fn groups_of(record: &MotionRecord, output: &OutputMotion, alone: &[Alone], writer: &NumberWriter) -> Vec<Group> {
    let answer = &output.clearance;
    let name = named_words(&output.name, &output.words);
    let radial_m = |joint: &str| {
        let own = answer.contributors.iter().find(|own| own.joint == joint);
        own.map_or(f64::NAN, |own| own.radial_clearance_m)
    };
    let asked = record.asked_of(&output.name).map(|asked| {
        let parts = asked.joints.iter().map(|own| Part {
            effect_si: own.value_si,
            joint: &own.name,
            radial_clearance_m: radial_m(&own.name),
            alone_si: alone.iter().map(|(words, _)| (*words, None)).collect(),
        });
        let statistic = format!("first order at {}", asked.pose_rad);
        let heading = format!("{name}, {}", asked_place(asked, writer));
        let parts = parts.collect();
        Group { heading: heading.into(), rows: rows(output, &statistic, (asked.first_order_si, parts), writer) }
    });
    let (angle_rad, sum_si) = largest_first_order(record, output);
    let pose = record.position_at(angle_rad).unwrap_or(0);
    let parts = answer.contributors.iter().map(|own| Part {
        effect_si: own.first_order_si.get(pose).copied().unwrap_or(f64::NAN),
        joint: &own.joint,
        radial_clearance_m: own.radial_clearance_m,
        alone_si: alone.iter().map(|(words, effect)| (*words, effect(own).get(pose).copied())).collect(),
    });
    let at = turn_angle(record, angle_rad, 3, &writer.with_tag(&Tag::joint(&output.name, "first order", "at")));
    let (heading, on_terminal) = match record.asked.is_empty() {
        true => (format!("{name}, at {at}"), String::new()),
        false => {
            let others = not_the_asked_one(record.asked_of(&output.name), angle_rad);
            let heading = format!("{name}, at {at}, where it is largest{others}");
            (heading.clone(), heading)
        }
    };
    let rows = rows(output, "first order", (sum_si, parts.collect()), writer);
    asked.chain([Group { heading: Text::by_medium(heading, on_terminal), rows }]).collect()
}

/// What one joint does at one position.
struct Part<'r> {
    effect_si: f64,
    joint: &'r str,
    radial_clearance_m: f64,
    /// Words and effect of each way in which its journal moves.
    alone_si: Vec<(&'static str, Option<f64>)>,
}

/// The joints with their shares of the sum, the largest first.
fn rows(
    output: &OutputMotion,
    statistic: &str,
    (sum_si, mut joints): (f64, Vec<Part>),
    writer: &NumberWriter,
) -> Vec<Vec<Cell>> {
    joints.sort_by(|a, b| b.effect_si.total_cmp(&a.effect_si));
    let row = |Part { effect_si, joint, radial_clearance_m, alone_si }: Part| -> Vec<Cell> {
        let tag = |part: &str| Tag::joint(&output.name, statistic, part).at(joint);
        let of_clearance = Tag::joint(joint, "clearance", "radial");
        let share = if sum_si > 0.0 { effect_si / sum_si } else { 0.0 };
        let alone = alone_si.into_iter().map(|(words, value_si)| {
            Cell::from(value_si.map(|value_si| writer.with_tag(&tag(words)).value(value_si, &output.unit)))
        });
        let cells = [
            output.name.as_str().into(),
            joint.into(),
            writer.with_tag(&of_clearance).value_trimmed(radial_clearance_m, &SiUnit::LENGTH).into(),
            writer.with_tag(&tag("effect")).value(effect_si, &output.unit).into(),
            share_bar(share, &writer.with_tag(&tag("share"))),
        ];
        cells.into_iter().chain(alone).collect()
    };
    joints.into_iter().map(row).collect()
}

/// A share, on a page with a bar.
fn share_bar(share: f64, writer: &NumberWriter) -> Cell {
    let text = writer.percent(share, Rounding::Nearest);
    let html = html! {
        svg.bar width="100%" height="20" role="img" aria-label=(text) {
            line.axis x1="0%" x2="100%" y1="10" y2="10" {}
            rect.mixed x="0" y="4" width=(percent_of(share, 0.0, 1.0)) height="12" rx="2" {}
        }
        span.range { (text) }
    };
    Cell::Drawn { html: html.into_string(), text }
}
