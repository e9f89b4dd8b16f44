//! The CSV files of a run, SI.

use super::history::Simulation;
use loosepin_result::simulation::SimulationRecord;
use std::fmt::Write;

/// Names of the columns of `history.csv`, units in the names: `time_s`, the angle of the drive, the outputs in file order, then
/// the states of all bodies where they were recorded.
pub fn history_names(simulation: &Simulation) -> Vec<String> {
    let record = &simulation.record;
    let drive = format!("{}_rad", record.settings.drive);
    let mut names = vec!["time_s".to_owned(), drive.clone()];
    for output in &record.outputs {
        let name = format!("{}{}", output.name.replace(' ', "_"), unit_suffix(output.unit.symbol()));
        // An angle output may bear the name of the drive, whose column comes first.
        let is_taken = name == drive;
        names.push(format!("{name}{}", if is_taken { "_output" } else { "" }));
    }
    if let Some(states) = &simulation.states {
        for quantities in
            [["x_m", "y_m", "angle_rad"], ["vx_m_s", "vy_m_s", "omega_rad_s"], ["ax_m_s2", "ay_m_s2", "alpha_rad_s2"]]
        {
            for body in &states.bodies {
                names.extend(quantities.iter().map(|quantity| format!("{body}.{quantity}")));
            }
        }
    }
    names
}

/// `history.csv`: the columns of [`history_names`], one row a sample.
pub fn history_csv(simulation: &Simulation) -> String {
    let record = &simulation.record;
    let mut text = history_names(simulation).join(",");
    text.push('\n');
    for row in 0..record.time_s.len() {
        let _ = write!(text, "{:?},{:?}", record.time_s[row], record.drive_angle_rad[row]);
        for output in &record.outputs {
            let _ = write!(text, ",{:?}", output.value_si[row]);
        }
        for value in simulation.states.iter().flat_map(|states| &states.rows[row]) {
            let _ = write!(text, ",{value:?}");
        }
        text.push('\n');
    }
    text
}

/// `impacts.csv`: one impact a row, in the order of time. An empty separation speed: the run ended in contact.
pub fn impacts_csv(record: &SimulationRecord) -> String {
    let mut text = String::from("time_s,joint,speed_m_s,duration_s,peak_force_n,separation_speed_m_s\n");
    for impact in &record.impacts {
        let _ = write!(text, "{:?},{},{:?},", impact.time_s, impact.joint, impact.speed_m_s);
        let _ = write!(text, "{:?},{:?},", impact.duration_s, impact.peak_force_n);
        if let Some(speed_m_s) = impact.separation_speed_m_s {
            let _ = write!(text, "{speed_m_s:?}");
        }
        text.push('\n');
    }
    text
}

/// The unit as a suffix of a column name: `m/s^2` becomes `_m_s2`.
fn unit_suffix(symbol: &str) -> String {
    let plain: String = symbol
        .chars()
        .filter(|c| *c != '^')
        .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' })
        .collect();
    if symbol == "1" { String::new() } else { format!("_{plain}") }
}
