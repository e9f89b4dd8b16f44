//! Place in the cycle of a motion.

use crate::charts::chart::Chart;
use crate::numbers::largest::places_of_largest;
use crate::numbers::number::{NumberWriter, Rounding, within_turn_rad};
use crate::numbers::tag::Tag;
use loosepin_result::motion::{MotionRecord, PoseEffect};
use loosepin_text::units::SiUnit;
use std::f64::consts::TAU;

/// Angles that are nearer to each other are one place, rad: both are computed from the same input.
const SAME_ANGLE_RAD: f64 = 1e-9;

/// An angle of the drive in words; from 0° to below 360° where the record holds a whole turn. The time, where that is the input.
pub(crate) fn turn_angle(record: &MotionRecord, angle_rad: f64, digits: usize, writer: &NumberWriter) -> String {
    match record.time_at_s(angle_rad) {
        Some(time_s) => writer.rounded(time_s, &SiUnit::TIME, digits, Rounding::Nearest),
        None => writer.rounded(shown_angle_rad(record, angle_rad), &SiUnit::ANGLE, digits, Rounding::Nearest),
    }
}

/// The displayed angle of the drive: within its turn if the record holds a whole one.
pub(super) fn shown_angle_rad(record: &MotionRecord, angle_rad: f64) -> f64 {
    without_round_off_rad(if record.is_whole_turn() { within_turn_rad(angle_rad) } else { angle_rad })
}

/// An angle, or 0 where it is nothing but round-off: places are located to 1e-13 turns.
pub(super) fn without_round_off_rad(angle_rad: f64) -> f64 {
    const ROUND_OFF_RAD: f64 = 1e-12;
    if angle_rad.abs() < ROUND_OFF_RAD { 0.0 } else { angle_rad }
}

/// Place and value of the maximum of a history over the cycle; of places alike the last one.
pub(crate) fn largest(record: &MotionRecord, values: &[f64]) -> (f64, f64) {
    let values = &values[..values.len().min(record.drive_angle_rad.len())];
    let place = places_of_largest(values).map(|[_, last]| last);
    let largest = values.iter().copied().max_by(f64::total_cmp);
    place.zip(largest).map_or((f64::NAN, f64::NAN), |(place, value)| (record.drive_angle_rad[place], value))
}

/// A pose that a study asks about, in words: `at 0°, where the requirement is`.
pub(crate) fn asked_place(asked: &PoseEffect, writer: &NumberWriter) -> String {
    format!("at {}, where the {} is", asked_angle(asked, writer), asking(asked))
}

/// The angle of a pose that a study asks about.
pub(crate) fn asked_angle(asked: &PoseEffect, writer: &NumberWriter) -> String {
    writer.with_tag(&Tag::Given("pose")).value_trimmed(asked.pose_rad, &SiUnit::ANGLE)
}

/// What asks about a pose.
fn asking(asked: &PoseEffect) -> &'static str {
    if asked.is_required { "requirement" } else { "question" }
}

/// Words behind the place of the cycle where a number of an output is largest, beside the poses that a study asks about: that it is another one,
/// where it is none of them.
pub(crate) fn not_the_asked_one<'r>(asked: impl Iterator<Item = &'r PoseEffect>, angle_rad: f64) -> String {
    let asked: Vec<&PoseEffect> = asked.collect();
    let is_there = |own: &&PoseEffect| {
        let apart_rad = (own.pose_rad - angle_rad).rem_euclid(TAU);
        apart_rad.min(TAU - apart_rad) < SAME_ANGLE_RAD
    };
    match asked.first() {
        None => String::new(),
        Some(_) if asked.iter().any(is_there) => " in the cycle".to_owned(),
        Some(first) => format!(" in the cycle; the {} is at another place", asking(first)),
    }
}

/// A chart over the angle of the drive, or over the time where that is the input.
pub(crate) fn angle_chart(record: &MotionRecord, id: String, writer: &NumberWriter) -> Chart {
    match &record.time_s[..] {
        [] => Chart::over_angle(id, &record.drive, &record.drive_angle_rad, writer),
        times_s => Chart::over(id, &record.drive, times_s, &SiUnit::TIME, writer),
    }
}
