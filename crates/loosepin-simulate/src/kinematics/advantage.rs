//! Mechanical advantage by virtual power.

use loosepin_result::kinematics::MechanicalAdvantage;
use loosepin_result::motion::{OutputMotion, outputs_beside_paths};
use loosepin_result::point_path::PointPath;
use loosepin_text::units::SiUnit;

/// Speeds below this share of the largest one are round-off of a stand-still.
const STILL: f64 = 1e-9;

/// Mechanical advantages ω/|v| of outputs and paths that move with a drive of this speed. Coordinates of a path have none of their own.
pub fn mechanical_advantages(
    outputs: &[OutputMotion],
    paths: &[PointPath],
    drive_speed_rad_s: f64,
) -> Vec<MechanicalAdvantage> {
    let of_outputs = outputs_beside_paths(outputs, paths);
    let of_outputs = of_outputs.map(|output| (&output.name, &output.unit, output.velocity_si.clone()));
    let of_paths = paths.iter().map(|path| (&path.name, &SiUnit::LENGTH, path.speeds_m_s()));
    let of = |(name, unit, speeds_si): (&String, &SiUnit, Vec<f64>)| {
        let largest_si = speeds_si.iter().fold(0.0_f64, |largest, speed| largest.max(speed.abs()));
        let least_si = STILL * largest_si;
        let advantage = |speed: &f64| {
            if speed.abs() > least_si { drive_speed_rad_s.abs() / speed.abs() } else { f64::INFINITY }
        };
        (largest_si > 0.0).then(|| MechanicalAdvantage {
            name: name.clone(),
            unit: if *unit == SiUnit::ANGLE { SiUnit::NONE } else { SiUnit::from_symbol("1/m") },
            value_si: speeds_si.iter().map(advantage).collect(),
        })
    };
    of_outputs.chain(of_paths).filter_map(of).collect()
}
