//! Loads.

use super::{crank, report};
use loosepin_mechanics::dynamics::Dynamics;

/// Relative round-off of a few dozen operations.
const ROUND_OFF: f64 = 1e-13;

/// Every kind of load on a driven crank: the drive holds against their torque about the pivot.
#[test]
fn analytic_torque_of_a_drive_against_loads() {
    let speed_rad_s = 7.0 * std::f64::consts::PI;
    let at_pin = |key: &str, direction: &str, frame: &str| {
        format!(
            "[load.push]\nkind = \"force\"\npoint = \"crank.pin\"\nforce = {key}\ndirection = \"{direction}\"\nframe = \"{frame}\"\njoint = \"main\"\n"
        )
    };
    let torque =
        |key: &str| format!("[load.twist]\nkind = \"torque\"\nbody = \"crank\"\ntorque = {key}\njoint = \"main\"\n");
    let without_joint = |text: String| text.replace("joint = \"main\"\n", "");
    type Torque = fn(f64, f64, f64) -> f64;
    let cases: [(String, Torque); 6] = [
        // A force of the ground's frame: r F sin(direction - θ).
        (without_joint(at_pin("\"9 N\"", "-70 deg", "ground")), |_, angle, _| {
            0.05 * 9.0 * (-70.0_f64.to_radians() - angle).sin()
        }),
        // One that turns with the body has a constant arm.
        (without_joint(at_pin("\"9 N\"", "60 deg", "body")), |_, _, _| 0.05 * 9.0 * 60.0_f64.to_radians().sin()),
        (at_pin("\"3 N * (angle / 1 rad)^1.5\"", "90 deg", "body"), |_, angle, _| 0.05 * 3.0 * angle.powf(1.5)),
        (without_joint(torque("\"0.8 N m\"")), |_, _, _| 0.8),
        (
            without_joint(torque(
                "{ mean = \"0.2 N m\", amplitude = \"0.5 N m\", frequency = \"4 Hz\", phase = \"40 deg\" }",
            )),
            |time, _, _| 0.2 + 0.5 * (8.0 * std::f64::consts::PI * time + 40.0_f64.to_radians()).sin(),
        ),
        (torque("\"0.1 N m * tan(0.3 * angle) - 0.01 N m s/rad * speed + 2 N m/s * time\""), |time, angle, speed| {
            0.1 * (0.3 * angle).tan() - 0.01 * speed + 2.0 * time
        }),
    ];
    for (text, torque_n_m) in cases {
        let built = crank("210 rpm", &text);
        let sample = built.sample();
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        for time_s in [0.0, 0.021, 0.14] {
            dynamics.evaluate(time_s, &[], &[], &[]);
            let angle_rad = 20.0_f64.to_radians() + speed_rad_s * time_s;
            let expected_n_m = torque_n_m(time_s, angle_rad, speed_rad_s);
            let found_n_m = -dynamics.drive_force(0);
            assert!((found_n_m - expected_n_m).abs() < ROUND_OFF, "{text}\n{found_n_m} {expected_n_m}");
            assert!((dynamics.powers().loads_w - expected_n_m * speed_rad_s).abs() < 100.0 * ROUND_OFF);
        }
        let account = report(&built, 0.1).energy.expect("loads have an account");
        // The drive takes out what the load brings in: nothing is exchanged but round-off.
        assert!(account.supplied_j.abs() < 1e-12 && account.largest_residual_j < 1e-12, "{text}\n{account:?}");
    }
}
