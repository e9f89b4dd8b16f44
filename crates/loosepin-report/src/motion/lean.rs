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

/// Whether pins of a planar mechanism lean out of its plane, which its runs do not know.
pub(super) fn pins_lean_in_the_plane(record: &MotionRecord) -> bool {
    record.picture.is_empty() && journals_lean(record)
}

/// `75 % of the ±0.2000 mm is lean: with pins that do not lean it is ±0.05000 mm there.`, where play moves an output most; `None` where pins do not
/// lean.
pub(super) fn lean_words(record: &MotionRecord, output: &OutputMotion, writer: &NumberWriter) -> Option<String> {
    /// Share of an effect that is round-off.
    const NOTHING: f64 = 1e-9;
    let answer = &output.clearance;
    let (angle_rad, all_si) = largest_first_order(record, output);
    let position = record.drive_angle_rad.iter().position(|own_rad| *own_rad == angle_rad)?;
    let held_si = *answer.held_first_order_si.get(position)?;
    let number = |part: &str, value_si: f64| {
        let tag = Tag::joint(&output.name, "lean", part);
        to_both_sides(output, writer.with_tag(&tag).rounded(value_si, &output.unit, PLAIN_DIGITS, Rounding::Up))
    };
    let (all, share) = (number("all", all_si), 1.0 - held_si / all_si);
    let leans = share > NOTHING;
    if !leans {
        return Some(format!("None of the {all} is lean."));
    }
    let share = writer.with_tag(&Tag::joint(&output.name, "lean", "share")).percent(share, Rounding::Nearest);
    Some(format!("{share} of the {all} is lean: with pins that do not lean it is {} there.", number("held", held_si)))
}
