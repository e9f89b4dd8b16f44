//! Class of the loops, swings, dead centres, time ratio and transmission angles in sentences.

use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::motion::MotionRecord;
use loosepin_text::units::SiUnit;

use super::angles::{turn_angle, without_round_off_rad};

/// A sentence on each loop, each range at the ground and each transmission angle.
pub(super) fn kinematic_sentences(record: &MotionRecord, writer: &NumberWriter) -> Vec<String> {
    let found = &record.kinematics;
    let at = |angle_rad: f64| turn_angle(record, angle_rad, 4, writer);
    let mut sentences: Vec<String> = found.loops.iter().map(|each| format!("Loop {}.", each.words())).collect();
    for range in found.ranges.iter().filter(|range| range.is_at_ground) {
        let kind = if range.unit == SiUnit::ANGLE { "Swing" } else { "Stroke" };
        let extent = writer.rounded(range.extent_si, &range.unit, 4, Rounding::Nearest);
        let [low, high] = range.ends_rad.map(at);
        let ratio = range.time_ratio.map_or_else(String::new, |ratio| format!(", time ratio {ratio:.3}"));
        sentences.push(format!("{kind} of {}: {extent}, dead centres at {low} and {high}{ratio}.", range.name));
    }
    for angle in &found.transmission_angles {
        let [smallest, largest] =
            angle.extremes_rad.map(|value_rad| writer.value(without_round_off_rad(value_rad), &SiUnit::ANGLE));
        let [first, second] = angle.at_rad.map(at);
        let [coupler, output] = &angle.bodies;
        let between = if angle.is_pressure_angle {
            format!("Pressure angle between {coupler} and the guide of {output}")
        } else {
            format!("Transmission angle between {coupler} and {output}")
        };
        sentences.push(format!("{between}: {smallest} (at {first}) to {largest} (at {second})."));
    }
    sentences
}
