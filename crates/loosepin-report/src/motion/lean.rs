//! How much of what play does is lean out of the plane, in words.

use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use loosepin_result::motion::{MotionRecord, OutputMotion};

use super::play_effect::{largest_first_order, to_both_sides};

/// Whether journals lean in their bearings: in space, and in a planar mechanism whose pins do.
pub(super) fn journals_lean(record: &MotionRecord) -> bool {
    let has_held = |output: &OutputMotion| !output.clearance.held_first_order_si.is_empty();
    !record.picture.is_empty() || record.outputs.iter().any(has_held)
}

/// `75 % of it is lean: with pins that do not lean it is ±0.05000 mm.`, where play moves an output most; `None` where pins do not lean.
pub(super) fn lean_words(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Option<String> {
    let answer = &output.clearance;
    let (angle_rad, all_si) = largest_first_order(record, output);
    let position = record.drive_angle_rad.iter().position(|own_rad| *own_rad == angle_rad)?;
    let held_si = *answer.held_first_order_si.get(position)?;
    let tag = |part: &str| Tag::joint(&output.name, "lean", part);
    // Held pins can go nowhere that leaning ones cannot; what is left of the difference is round-off.
    let share = (1.0 - held_si / all_si).max(0.0);
    let share = writer.with_tag(&tag("share")).percent(share, Rounding::Nearest);
    let held = writer.with_tag(&tag("held")).rounded(held_si, &output.unit, PLAIN_DIGITS, Rounding::Up);
    Some(format!("{share} of it is lean: with pins that do not lean it is {}.", to_both_sides(output, held)))
}
