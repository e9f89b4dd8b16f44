//! The CSV file of an ideal motion, SI.

use crate::recording::tables::{self, HistoryColumn, table, unit_suffix};
use loosepin_result::motion::MotionRecord;
use loosepin_text::units::SiUnit;

/// The columns of `motion.csv`: the angle of the drive, or the time where that is the input; each output with its rates, then its deviations by
/// play and its standard deviation by scatter; each path; transmission angles; mechanical advantages. What a record does not have has no column.
pub fn motion_columns<'r>(record: &'r MotionRecord) -> Vec<HistoryColumn<'r>> {
    let mut columns = Vec::new();
    let mut add = |name: &str, what: &str, unit: &'static str, values_si: &'r [f64]| {
        if values_si.len() == record.drive_angle_rad.len() {
            tables::add(
                &mut columns,
                format!("{}{what}{}", name.replace(' ', "_"), unit_suffix(unit)),
                unit,
                values_si,
            );
        }
    };
    match &record.time_s[..] {
        [] => add(&record.drive, "", "rad", &record.drive_angle_rad),
        times_s => add(&record.drive, "", "s", times_s),
    }
    for output in &record.outputs {
        let units = if output.unit == SiUnit::ANGLE { ["rad", "rad/s", "rad/s^2"] } else { ["m", "m/s", "m/s^2"] };
        add(&output.name, "", units[0], &output.value_si);
        add(&output.name, "_velocity", units[1], &output.velocity_si);
        add(&output.name, "_acceleration", units[2], &output.acceleration_si);
        if !output.clearance.searched.is_empty() {
            add(&output.name, "_first_order_worst_case", units[0], &output.clearance.first_order_si);
            add(&output.name, "_first_order_worst_case_without_lean", units[0], &output.clearance.held_first_order_si);
            add(&output.name, "_standard_deviation", units[0], &output.clearance.disc_standard_deviation_si);
        }
        add(&output.name, "_play_lowest", units[0], &output.clearance.lowest_si);
        add(&output.name, "_play_highest", units[0], &output.clearance.highest_si);
        add(&output.name, "_scatter_standard_deviation", units[0], &output.dimensional_standard_deviation_si);
    }
    for path in &record.paths {
        // In the plane the coordinates of an output that is a path are outputs too.
        if path.output.is_none() || path.is_in_space() {
            for (axis, position, velocity, acceleration) in [
                ("x", &path.x_m, &path.velocity_x_m_s, &path.acceleration_x_m_s2),
                ("y", &path.y_m, &path.velocity_y_m_s, &path.acceleration_y_m_s2),
                ("z", &path.z_m, &path.velocity_z_m_s, &path.acceleration_z_m_s2),
            ] {
                add(&path.name, &format!("_{axis}"), "m", position);
                add(&path.name, &format!("_{axis}_velocity"), "m/s", velocity);
                add(&path.name, &format!("_{axis}_acceleration"), "m/s^2", acceleration);
            }
        }
        add(&path.name, "_play_along", "m", &path.play_along_m);
        add(&path.name, "_play_across", "m", &path.play_across_m);
        add(&path.name, "_play_longest", "m", &path.play_longest_m);
        add(&path.name, "_scatter_major", "m", &path.scatter_major_m);
        add(&path.name, "_scatter_minor", "m", &path.scatter_minor_m);
        add(&path.name, "_scatter_angle", "rad", &path.scatter_angle_rad);
    }
    for angle in &record.kinematics.transmission_angles {
        let what = if angle.is_pressure_angle { "_pressure_angle" } else { "_transmission_angle" };
        add(&angle.bodies.join(" "), what, "rad", &angle.value_rad);
    }
    for each in &record.kinematics.mechanical_advantages {
        let unit = if each.unit == SiUnit::NONE { "1" } else { "1/m" };
        add(&each.name, "_mechanical_advantage", unit, &each.value_si);
    }
    columns
}

/// `motion.csv`: the [`motion_columns`], one row for each angle.
pub fn motion_csv(record: &MotionRecord) -> String {
    table(&motion_columns(record), record.drive_angle_rad.len())
}
