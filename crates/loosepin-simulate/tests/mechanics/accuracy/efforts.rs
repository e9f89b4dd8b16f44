//! What drives must do to make the ideal motion.

use super::motion::motion_of;
use super::{build_text, cases};
use loosepin_simulate::accuracy::record::{EffortMotion, MotionRecord};

/// Round-off of a few hundred operations, relative to the peak.
const ROUND_OFF: f64 = 1e-12;

/// A case with further outputs.
fn case_with(name: &str, outputs: &str) -> MotionRecord {
    let text = std::fs::read_to_string(cases().join(name).join("model.toml")).expect("the case is there");
    motion_of(&build_text(&format!("{text}\n{outputs}")), 360)
}

fn effort<'r>(record: &'r MotionRecord, name: &str) -> &'r EffortMotion {
    record.efforts.iter().find(|effort| effort.name == name).unwrap_or_else(|| panic!("no effort {name}"))
}

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |peak: f64, value| peak.max(value.abs()))
}

/// Weight and inertia give back over a turn what they took: the work of the drive over a turn of a mechanism without losses is zero.
/// The sum over equal steps of a periodic function is exact to round-off. The power is the torque times the speed of the drive.
#[test]
fn identity_a_drive_without_losses_does_no_work_over_a_turn() {
    let outputs = "[output.torque]\ntorque_of = \"drive.crank\"\n[output.power]\npower_of = \"drive.crank\"\n";
    let record = case_with("slider_crank_two_clearances", outputs);
    let (torque, power) = (effort(&record, "torque"), effort(&record, "power"));
    assert_eq!((torque.words.as_str(), torque.unit.symbol()), ("torque of drive crank", "N m"));
    assert_eq!(record.efforts.len(), 2, "the force in a joint is no effort");
    let largest = peak(&torque.value_si);
    assert!(largest > 1.0, "{largest} N m");
    let turn = &torque.value_si[..360];
    assert!(turn.iter().sum::<f64>().abs() < 360.0 * ROUND_OFF * largest, "{}", turn.iter().sum::<f64>());
    let speed = record.drive_speed_rad_s.expect("the drive has a constant speed");
    for (torque, power) in torque.value_si.iter().zip(&power.value_si) {
        assert!((torque * speed - power).abs() < ROUND_OFF * largest * speed, "{torque} {power}");
    }
}
