//! Whether a motion in space is one turn of its input: pictures, charts and words then tell its angles from 0° to 360°.

use loosepin_result::spatial_motion::SpatialMotionRecord;
use loosepin_text::units::SiUnit;
use std::f64::consts::TAU;

/// Whether the record holds one whole turn of its input, the last position a step before its end or at it.
pub(crate) fn is_whole_turn(record: &SpatialMotionRecord) -> bool {
    const ROUND_OFF: f64 = 1e-6;
    let [first, .., before, last] = record.inputs_si[..] else { return false };
    let is_turn = |extent: f64| (extent.abs() / TAU - 1.0).abs() < ROUND_OFF;
    record.input_unit == SiUnit::ANGLE && (is_turn(last - first) || is_turn(2.0 * last - before - first))
}
