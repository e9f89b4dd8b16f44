//! What searches found at single positions, and what numbers of such records are, in words.

use crate::medium::short_answer::{Said, Weight};
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::capitalised;
use loosepin_result::motion::{MotionRecord, OutputMotion, SearchedPosition};
use loosepin_text::units::{SiUnit, counted};

use super::angles::turn_angle;
use super::moved::{has_clearance, moved_words};
use super::play_effect::{is_spread_anywhere, to_both_sides};

/// Digits of proven ends, which lie a little beyond what was found.
const END_DIGITS: usize = 5;

/// `-1.000 mm to 1.005 mm`.
pub(super) fn found_words(output: &OutputMotion, searched: &SearchedPosition, writer: &NumberWriter) -> String {
    let [low, high] = searched.found_si;
    let number = |part: &str, value_si: f64| {
        let tag = tag(output, searched, part);
        writer.with_tag(&tag).rounded(value_si, &output.unit, PLAIN_DIGITS, Rounding::Nearest)
    };
    format!("{} to {}", number("lowest", low), number("highest", high))
}

/// `-1.0001 mm to 1.0055 mm`, or that nothing is proven; `None` where no proof was sought.
pub(super) fn proven_words(
    output: &OutputMotion,
    searched: &SearchedPosition,
    writer: &NumberWriter,
) -> Option<String> {
    let [low, high] = searched.proven_si?;
    if !(low.is_finite() && high.is_finite()) {
        return Some("not proven".to_owned());
    }
    let number = |part: &str, value_si: f64, rounding: Rounding| {
        let tag = tag(output, searched, part);
        writer.with_tag(&tag).rounded(value_si, &output.unit, END_DIGITS, rounding)
    };
    let ends = [number("lowest proven", low, Rounding::Down), number("highest proven", high, Rounding::Up)];
    Some(ends.join(" to "))
}

fn tag(output: &OutputMotion, searched: &SearchedPosition, part: &str) -> Tag {
    Tag::joint(&output.name, &format!("searched at {}", searched.position), part)
}

/// What was found of an output, a paragraph for each position.
pub(super) fn searched_said(
    record: &MotionRecord,
    output: &OutputMotion,
    weight: Weight,
    writer: &NumberWriter,
) -> Vec<Said> {
    let along = match (output.is_size(), output.unit == SiUnit::ANGLE) {
        (false, _) => "",
        (true, false) => " along the longest displacement",
        (true, true) => " about the axis of the largest rotation",
    };
    let said = |(place, searched): (usize, &SearchedPosition)| {
        let found = found_words(output, searched, writer);
        let proven = match proven_words(output, searched, writer) {
            Some(ends) if searched.proven_si.is_some_and(|ends| ends.iter().all(|end| end.is_finite())) => {
                format!("; proven: never beyond {ends}")
            }
            Some(_) => "; nothing is proven".to_owned(),
            None => String::new(),
        };
        let found = format!("a search with the loops closed exactly found {found}{along} there{proven}.");
        let words = match place {
            0 if output.is_size() => capitalised(&found),
            0 => format!("To first order this is alike to both sides; {found}"),
            _ => {
                let at = |digits: usize| {
                    let angle_rad = record.drive_angle_rad.get(searched.position).copied().unwrap_or(f64::NAN);
                    turn_angle(record, angle_rad, digits, &writer.with_tag(&tag(output, searched, "at")))
                };
                let effect_si = output.clearance.first_order_si.get(searched.position).copied().unwrap_or(f64::NAN);
                let effect_tag = tag(output, searched, "first order");
                let effect = writer.with_tag(&effect_tag).rounded(effect_si, &output.unit, PLAIN_DIGITS, Rounding::Up);
                format!(
                    "Where play comes near no dead centre, it moves the {} by up to {} (first order, at {}); {found}",
                    moved_words(output),
                    to_both_sides(output, effect),
                    at(3)
                )
            }
        };
        Said { weight, words }
    };
    output.clearance.searched.iter().enumerate().map(said).collect()
}

/// Whether the worst cases of first order are those of all journals together, and are searched in single positions: in space, and in a plane where
/// the plays must meet conditions together.
pub(super) fn is_together(record: &MotionRecord) -> bool {
    // What each play does by itself has a standard deviation on the rims.
    let is_own = |output: &OutputMotion| {
        !output.clearance.searched.is_empty() || output.clearance.rim_standard_deviation_si.is_empty()
    };
    record.outputs.iter().filter(|output| has_clearance(output)).any(is_own)
}

/// What the numbers of the table of outputs are, where they are others than those of journals in circles.
pub(super) fn notes(record: &MotionRecord) -> Vec<String> {
    let playing = || record.outputs.iter().filter(|output| has_clearance(output));
    let mut notes = Vec::new();
    if playing().any(is_spread_anywhere) {
        notes.push("The standard deviation is for journals anywhere in their play, all places alike.".to_owned());
    }
    let conditions = conditions(record);
    if conditions > 0 {
        notes.push(format!(
            "The plays must meet {} together so that the loops close; the worst cases are with them, and the standard deviation has no closed \
             form. What a joint contributes is then its share of the worst case, not what it does alone.",
            counted(conditions, "condition")
        ));
    }
    let has_size = |is_angle: bool| playing().any(|own| own.is_size() && (own.unit == SiUnit::ANGLE) == is_angle);
    if has_size(false) {
        notes.push(
            "Of a displacement, the worst case is the longest one that a search over directions found; what was found with the loops closed exactly \
             is along that direction, and the standard deviation is the root of the sum of the variances along x, y and z."
                .to_owned(),
        );
    }
    if has_size(true) {
        notes.push(
            "Of a rotation, the worst case is the largest angle that a search over axes found; what was found with the loops closed exactly is about \
             that axis, and the standard deviation is the root of the sum of the variances about x, y and z of the body."
                .to_owned(),
        );
    }
    notes
}

/// Conditions that the plays must meet together, the most of all positions that were searched.
fn conditions(record: &MotionRecord) -> usize {
    let searched = record.outputs.iter().flat_map(|output| &output.clearance.searched);
    searched.map(|searched| searched.conditions).max().unwrap_or(0)
}
