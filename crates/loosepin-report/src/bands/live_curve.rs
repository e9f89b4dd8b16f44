//! Curves of the ideal motion as numbers, for a page that draws them itself while a mechanism is edited.
//!
//! All of them are in the record already: a look at a mechanism computes nothing for them.

use serde::Serialize;

use crate::charts::chart::scaled;
use crate::mechanism::figure::pose_step;
use crate::medium::script_data::rounded;
use crate::numbers::number::NumberWriter;
use loosepin_result::motion::MotionRecord;
use loosepin_text::units::SiUnit;

/// Kind of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveKind {
    /// Ideal position or angle.
    Position,
    /// Its first time derivative at the speed of the drive.
    Velocity,
    /// Its second time derivative.
    Acceleration,
    /// Torque, force or power of a drive.
    Effort,
}

/// A quantity over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveCurve {
    /// Name of the output.
    pub name: String,
    /// The quantity in words.
    pub words: String,
    /// The unit of the values.
    pub unit: String,
    /// Its kind.
    pub kind: CurveKind,
    /// A value for each pose of the drawing; null where there is none.
    pub values: Vec<Option<f64>>,
}

/// Position, velocity and acceleration of each output of `record`, then the efforts of the drives.
pub fn live_curves(record: &MotionRecord) -> Vec<LiveCurve> {
    let step = pose_step(record.drive_angle_rad.len());
    let writer = NumberWriter::for_page(&record.display_units);
    let curve = |name: &str, words: String, kind: CurveKind, values_si: &[f64], unit: &SiUnit| LiveCurve {
        name: name.to_owned(),
        words,
        unit: writer.symbol(unit),
        kind,
        values: rounded(&scaled(values_si, unit, &writer)).into_iter().step_by(step).collect(),
    };
    let mut curves = Vec::new();
    // An error of a path belongs to its output, and has no ideal value.
    for output in record.outputs.iter().filter(|output| !output.value_si.is_empty()) {
        let name = &output.name;
        curves.push(curve(name, output.words.clone(), CurveKind::Position, &output.value_si, &output.unit));
        let Some(rate) = output.unit.per_second() else { continue };
        let words = format!("velocity: {}", output.words);
        curves.push(curve(name, words, CurveKind::Velocity, &output.velocity_si, &rate));
        let Some(second) = rate.per_second() else { continue };
        let words = format!("acceleration: {}", output.words);
        curves.push(curve(name, words, CurveKind::Acceleration, &output.acceleration_si, &second));
    }
    for effort in record.efforts.iter().filter(|effort| !effort.value_si.is_empty()) {
        curves.push(curve(&effort.name, effort.words.clone(), CurveKind::Effort, &effort.value_si, &effort.unit));
    }
    curves
}
