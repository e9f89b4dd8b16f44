//! Place in the cycle of a motion.

use crate::charts::chart::Chart;
use crate::numbers::number::{NumberWriter, Rounding, within_turn_rad};
use loosepin_result::motion::MotionRecord;
use loosepin_text::units::SiUnit;
use std::f64::consts::TAU;

/// An angle of the drive in words; from 0° to below 360° where the record holds a whole turn.
pub(crate) fn turn_angle(record: &MotionRecord, angle_rad: f64, digits: usize, writer: &NumberWriter) -> String {
    writer.rounded(shown_angle_rad(record, angle_rad), &SiUnit::ANGLE, digits, Rounding::Nearest)
}

/// The displayed angle of the drive: within its turn if the record holds a whole one.
pub(super) fn shown_angle_rad(record: &MotionRecord, angle_rad: f64) -> f64 {
    const ROUND_OFF: f64 = 1e-9;
    let span_rad = match record.drive_angle_rad[..] {
        [first, .., last] => last - first,
        _ => 0.0,
    };
    if (span_rad / TAU - 1.0).abs() < ROUND_OFF { within_turn_rad(angle_rad) } else { angle_rad }
}

/// Place and value of the maximum of a history over the cycle.
pub(crate) fn largest(record: &MotionRecord, values: &[f64]) -> (f64, f64) {
    record
        .drive_angle_rad
        .iter()
        .copied()
        .zip(values.iter().copied())
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or((f64::NAN, f64::NAN))
}

/// A chart over the angle of the drive.
pub(crate) fn angle_chart(record: &MotionRecord, id: String, writer: &NumberWriter) -> Chart {
    Chart::over_angle(id, &record.drive, &record.drive_angle_rad, writer)
}
