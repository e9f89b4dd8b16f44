//! Torque and power of a drive in a study, against the closed form of a crank that lifts a weight: T = m g r cos φ.

use crate::silent::run;
use loosepin::model::Model;
use loosepin::report::{study_page, study_text};
use loosepin::study::Study;
use loosepin::study::result::{BoundRecord, StudyResult, Verdict};

/// Of the widest bound below: what a search leaves open of a response that is linear in the mass, and Gauss's rule of a sine.
const SHARE: f64 = 1e-6;
/// g r, N m for each kg, and the speed, rad/s.
const ARM_N_M_KG: f64 = 9.81 * 0.13;
const SPEED_RAD_S: f64 = 11.0;
const MASSES_KG: [f64; 2] = [1.4, 1.9];
/// The ideal motion has unknown inputs in the middle of what is possible.
const MIDDLE_KG: f64 = 1.65;

const MODEL: &str = r#"
name = "hoist"
gravity = "9.81 m/s^2"
[body.ground]
points = { o = ["7 mm", "-3 mm"] }
[body.crank]
mass = "1.7 kg"
inertia = "3e-3 kg m^2"
centre_of_mass = ["130 mm", "0 mm"]
points = { eye = ["0 mm", "0 mm"] }
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.eye"
[drive.motor]
joint = "main"
speed = "11 rad/s"
start_angle = "0.3 rad"
[cycle]
drive = "motor"
[output]
torque = { torque_of = "drive.motor", unit = "N mm" }
power = { power_of = "drive.motor" }
"#;

/// One mass is as likely as another, so that every statistic lies between those at both ends.
const STUDY: &str = r#"
name = "motor for the hoist"
model = "model.toml"
[cycle]
transient_turns = 0
[sampling]
outer = 16
inner = 16
replicates = 4
[epistemic]
"body.crank.mass" = { interval = ["1.4 kg", "1.9 kg"] }
[[ask]]
output = "torque"
of = "value"
poses = { motor = ["60 deg"] }
statistics = ["mean"]
[[ask]]
output = "torque"
of = "value"
reduce = "maximum"
statistics = ["mean"]
[[ask]]
output = "power"
of = "value"
reduce = "rms"
statistics = ["mean"]
[[ask]]
output = "torque"
of = "total"
poses = { motor = ["60 deg"] }
statistics = ["mean"]
[[require]]
output = "torque"
of = "value"
below = "2.43 N m"
over = "cycle"
probability_at_least = 1.0
[[require]]
output = "torque"
of = "value"
below = "2.41 N m"
over = "cycle"
probability_at_least = 0.9
"#;

/// The result of a study in two texts.
pub(super) fn conducted(model: &str, study: &str) -> StudyResult {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    run(&study).result
}

fn near(bound: &BoundRecord, exact: impl Fn(f64) -> f64) {
    let found = [(bound.lower.value_si, MASSES_KG[0]), (bound.upper.value_si, MASSES_KG[1])];
    let size = MASSES_KG.map(&exact).into_iter().fold(0.0, |size: f64, exact| size.max(exact.abs()));
    for (found, mass_kg) in found {
        assert!((found - exact(mass_kg)).abs() < SHARE * size, "{found}, not {}: {bound:?}", exact(mass_kg));
    }
}

#[test]
fn analytic_torque_and_power_of_a_drive_from_file_to_page() {
    let result = conducted(MODEL, STUDY);
    near(&result.bounds[0], |mass_kg| 0.5 * mass_kg * ARM_N_M_KG);
    near(&result.bounds[1], |mass_kg| mass_kg * ARM_N_M_KG);
    near(&result.bounds[2], |mass_kg| mass_kg * ARM_N_M_KG * SPEED_RAD_S / std::f64::consts::SQRT_2);
    near(&result.bounds[3], |mass_kg| 0.5 * (mass_kg - MIDDLE_KG) * ARM_N_M_KG);
    assert_eq!((result.bounds[0].unit.symbol(), result.bounds[2].unit.symbol()), ("N m", "W"));
    // The largest torque is 2.423 N m.
    let verdicts: Vec<Verdict> = result.requirements.iter().map(|requirement| requirement.verdict).collect();
    assert_eq!(verdicts, [Verdict::Met, Verdict::NotMet]);
    // Rounded outwards to three digits: 2423 N mm, and 18.85 W of the root mean square.
    let text = study_text(&result);
    assert!(text.contains("torque") && text.contains("2430 N mm") && text.contains("18.9 W"), "{text}");
    assert!(study_page(&result).contains("torque of drive motor"));
}
