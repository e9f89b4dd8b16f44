//! Contributions of the joints to the effect of play.

use maud::html;

use crate::charts::still_figures::percent_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

use super::angles::{asked_place, largest, not_the_asked_one, turn_angle};
use super::answer::has_clearance;

/// `None` if play moves nothing.
pub(super) fn contributors_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    let groups: Vec<Group> = record
        .outputs
        .iter()
        .filter(|output| has_clearance(output))
        .flat_map(|output| groups_of(record, output, writer))
        .collect();
    if groups.is_empty() {
        return None;
    }
    let columns = vec![
        Column { only: Some(Medium::Terminal), ..Column::words("output") },
        Column::words(head("joint")),
        Column::numbers(Text::by_medium("Radial clearance", "clearance")),
        Column::numbers(head("effect, first order")),
        Column::numbers_on_terminal(head("share")),
    ];
    let caption = match record.asked.is_empty() {
        true => "Shares of the sum of the first-order effects, at the angle where it is largest.",
        false => "Shares of the sum of the first-order effects, at the angle above them.",
    };
    let caption = caption.into();
    let mut section = Section::headed_on_page("contributors", "Contribution of each joint");
    section.push(Content::Table(Table { columns, groups, caption, ..Table::default() }));
    Some(section)
}

/// The joints of an output at the poses that a study asks about, then where the sum of their effects is largest.
fn groups_of(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Vec<Group> {
    let answer = &output.clearance;
    let name = named_words(&output.name, &output.words);
    let radial_m = |joint: &str| {
        let own = answer.contributors.iter().find(|own| own.joint == joint);
        own.map_or(f64::NAN, |own| own.radial_clearance_m)
    };
    let asked = record.asked_of(&output.name).map(|asked| {
        let parts = asked.joints.iter().map(|own| (own.value_si, own.name.as_str(), radial_m(&own.name))).collect();
        let statistic = format!("first order at {}", asked.pose_rad);
        let heading = format!("{name}, {}", asked_place(asked, writer));
        Group { heading: heading.into(), rows: rows(output, &statistic, (asked.first_order_si, parts), writer) }
    });
    let (angle_rad, sum_si) = largest(record, &answer.first_order_si);
    let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
    let part = |effect_si: &[f64]| effect_si.get(pose).copied().unwrap_or(f64::NAN);
    let joints = answer.contributors.iter();
    let parts = joints.map(|own| (part(&own.first_order_si), own.joint.as_str(), own.radial_clearance_m)).collect();
    let at = turn_angle(record, angle_rad, 3, &writer.with_tag(&Tag::joint(&output.name, "first order", "at")));
    let (heading, on_terminal) = match record.asked.is_empty() {
        true => (format!("{name}, at {at}"), String::new()),
        false => {
            let others = not_the_asked_one(record.asked_of(&output.name), angle_rad);
            let heading = format!("{name}, at {at}, where it is largest{others}");
            (heading.clone(), heading)
        }
    };
    let rows = rows(output, "first order", (sum_si, parts), writer);
    asked.chain([Group { heading: Text::by_medium(heading, on_terminal), rows }]).collect()
}

/// Effect, name and radial clearance of each joint with their share of the sum, the largest first.
fn rows(
    output: &OutputMotion,
    statistic: &str,
    (sum_si, mut joints): (f64, Vec<(f64, &str, f64)>),
    writer: &NumberWriter,
) -> Vec<Vec<Cell>> {
    joints.sort_by(|a, b| b.0.total_cmp(&a.0));
    let row = |(part_si, joint, radial_m): (f64, &str, f64)| -> Vec<Cell> {
        let tag = |part: &str| Tag::joint(&output.name, statistic, part).at(joint);
        let of_clearance = Tag::joint(joint, "clearance", "radial");
        let share = if sum_si > 0.0 { part_si / sum_si } else { 0.0 };
        vec![
            output.name.as_str().into(),
            joint.into(),
            writer.with_tag(&of_clearance).value_trimmed(radial_m, &SiUnit::LENGTH).into(),
            writer.with_tag(&tag("effect")).value(part_si, &output.unit).into(),
            share_bar(share, &writer.with_tag(&tag("share"))),
        ]
    };
    joints.into_iter().map(row).collect()
}

/// A share, on a page with a bar.
pub(super) fn share_bar(share: f64, writer: &NumberWriter) -> Cell {
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
