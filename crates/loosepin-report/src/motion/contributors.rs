//! Contributions of the joints to the effect of play.

use maud::html;

use crate::charts::still_figures::percent_of;
use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{head, named_words};
use loosepin_result::motion::{MotionRecord, OutputMotion};
use loosepin_text::article::{Cell, Column, Content, Group, Medium, Section, Table, Text};
use loosepin_text::units::SiUnit;

use super::angles::{largest, turn_angle};
use super::answer::has_clearance;

/// `None` if play moves nothing.
pub(super) fn contributors_section(record: &MotionRecord, writer: &NumberWriter) -> Option<Section> {
    let groups: Vec<Group> = record
        .outputs
        .iter()
        .filter(|output| has_clearance(output))
        .map(|output| group(record, output, writer))
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
    let caption = "Shares of the sum of the first-order effects, at the angle where it is largest.".into();
    let mut section = Section::headed_on_page("contributors", "Contribution of each joint");
    section.push(Content::Table(Table { columns, groups, caption, ..Table::default() }));
    Some(section)
}

/// The joints of an output where the sum of their effects is largest, the largest first.
fn group(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Group {
    let answer = &output.clearance;
    let (angle_rad, sum_si) = largest(record, &answer.first_order_si);
    let pose = record.drive_angle_rad.iter().position(|angle| *angle == angle_rad).unwrap_or(0);
    let part = |effect_si: &[f64]| effect_si.get(pose).copied().unwrap_or(f64::NAN);
    let mut joints: Vec<_> = answer.contributors.iter().map(|joint| (part(&joint.first_order_si), joint)).collect();
    joints.sort_by(|a, b| b.0.total_cmp(&a.0));
    let rows = joints.into_iter().map(|(part_si, joint)| -> Vec<Cell> {
        let tag = |part: &str| Tag::joint(&output.name, "first order", part).at(&joint.joint);
        let of_clearance = Tag::joint(&joint.joint, "clearance", "radial");
        vec![
            output.name.as_str().into(),
            joint.joint.as_str().into(),
            writer.with_tag(&of_clearance).value_trimmed(joint.radial_clearance_m, &SiUnit::LENGTH).into(),
            writer.with_tag(&tag("effect")).value(part_si, &output.unit).into(),
            share_bar(part_si / sum_si, &writer.with_tag(&tag("share"))),
        ]
    });
    let at = turn_angle(record, angle_rad, 3, &writer.with_tag(&Tag::joint(&output.name, "first order", "at")));
    let heading = format!("{}, at {at}", named_words(&output.name, &output.words));
    Group { heading: Text::by_medium(heading, ""), rows: rows.collect() }
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
