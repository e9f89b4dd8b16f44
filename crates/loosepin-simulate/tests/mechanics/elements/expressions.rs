//! Exponentials, logarithms and powers in expressions, and expressions that have no value.

use super::{build, crank, crank_with_drive, report};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::SampleError;
use loosepin_simulate::{Plan, RunFailure, simulate};

/// Relative round-off of a few dozen operations.
const ROUND_OFF: f64 = 1e-13;

#[test]
fn analytic_torque_of_a_drive_against_exponentials_logarithms_and_powers() {
    type Torque = fn(f64, f64, f64) -> f64;
    let cases: [(&str, Torque); 4] = [
        ("0.7 N m * exp(-time / 20 ms)", |time, _, _| 0.7 * (-time / 0.02).exp()),
        ("0.2 N m * log(1 + angle / 1 rad)", |_, angle, _| 0.2 * (1.0 + angle).ln()),
        ("3e-3 N m * (speed / 1 rad/s)^1.37", |_, _, speed| 3e-3 * speed.powf(1.37)),
        ("0.1 N m * 2^(angle / 90 deg) * (1 + time / 1 s)^-0.3", |time, angle, _| {
            0.1 * (angle / std::f64::consts::FRAC_PI_2).exp2() * (1.0 + time).powf(-0.3)
        }),
    ];
    for (text, torque_n_m) in cases {
        let load =
            format!("[load.twist]\nkind = \"torque\"\nbody = \"crank\"\ntorque = \"{text}\"\njoint = \"main\"\n");
        let built = crank("210 rpm", &load);
        let sample = built.sample();
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        for time_s in [0.0, 0.021, 0.14] {
            dynamics.evaluate(time_s, &[], &[], &[]);
            let speed_rad_s = 7.0 * std::f64::consts::PI;
            let expected_n_m = torque_n_m(time_s, 20.0_f64.to_radians() + speed_rad_s * time_s, speed_rad_s);
            let found_n_m = -dynamics.drive_force(0);
            assert!((found_n_m - expected_n_m).abs() < ROUND_OFF, "{text}: {found_n_m} {expected_n_m}");
        }
    }
}

/// The angle θ = a exp(-t/τ) has the acceleration θ/τ².
#[test]
fn analytic_motion_of_a_drive_by_an_exponential() {
    let motion = "motion = { kind = \"expression\", position = \"0.5 rad * exp(-time / 50 ms)\" }";
    let built = crank_with_drive(motion, "duration = \"0.1 s\"", "");
    let sample = built.sample();
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    // About the pivot: its own moment of inertia and m (25 mm)².
    let inertia_kg_m2 = 1e-4 + 0.3 * 0.025 * 0.025;
    for time_s in [0.0_f64, 0.013, 0.09] {
        dynamics.evaluate(time_s, &[], &[], &[]);
        let due_n_m = inertia_kg_m2 * 0.5 * (-time_s / 0.05).exp() / (0.05 * 0.05);
        assert!((dynamics.drive_force(0) - due_n_m).abs() < ROUND_OFF * due_n_m.max(1.0));
    }
    let account = report(&built, 0.1).energy;
    assert!(account.is_none_or(|account| account.largest_residual_j < 1e-12));
}

/// A slider that a force moves.
fn slider(force: &str) -> String {
    format!(
        r#"
name = "slider"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
[initial.joint.rail]
position = "5 mm"
velocity = "1 m/s"
[load.push]
kind = "force"
point = "slider.pin"
direction = "0 deg"
joint = "rail"
force = "{force}"
[cycle]
duration = "0.2 s"
"#
    )
}

#[test]
fn an_expression_without_a_value_ends_the_run_and_is_named() {
    let failure = |text: &str| {
        let built = build(text);
        simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model)).expect_err("it has no value")
    };
    // At once, on the way in time, on the way by the position; hidden behind a minimum.
    for (force, from_s, to_s) in [
        ("2 N * log(-position / 1 m)", 0.0, 0.0),
        ("2 N * sqrt((50 ms - time) / 1 s) + 0 N/m * position", 0.049, 0.05),
        ("2 N * log((5 mm - position) / 1 mm + 60)", 0.01, 0.07),
        ("2 N * min((0.02 - position / 1 m)^0.7, 3)", 0.001, 0.03),
        ("2 N * max(0, (0.02 - position / 1 m)^0.7)", 0.001, 0.03),
    ] {
        let failure = failure(&slider(force));
        let RunFailure::NotFinite { time_s, element } = &failure else { panic!("{force}: {failure}") };
        assert_eq!(element.as_deref(), Some("load.push"), "{force}");
        assert!((from_s..=to_s).contains(time_s), "{force}: {failure}");
        assert_eq!(failure.code(), "not_finite");
        let said = failure.complaint(&build(&slider(force)).mechanism.model).to_string();
        assert!(said.starts_with("model.toml:18:7: error[E0803]: at "), "{said}");
        assert!(
            said.contains("load 'push' is not a finite number\nhint: its expression leaves the domain of log"),
            "{said}"
        );
    }
    // Where the drives alone move the mechanism.
    let load = "[load.twist]\nkind = \"torque\"\nbody = \"crank\"\ntorque = \"1 N m * log(1 - time / 50 ms)\"\n";
    let cycle = "duration = \"0.1 s\"";
    let driven = crank_with_drive("speed = \"210 rpm\"\nstart_angle = \"20 deg\"", cycle, load);
    let found = simulate(&driven.mechanism, &driven.values, &Plan::of_model(&driven.mechanism.model));
    let Err(RunFailure::NotFinite { time_s, element }) = found else { panic!("it has no value") };
    assert!(element.as_deref() == Some("load.twist") && (0.05..0.07).contains(&time_s), "{element:?} {time_s}");
    let motion = "motion = { kind = \"expression\", position = \"1 rad * sqrt(1 - time / 50 ms)\" }";
    let driven = crank_with_drive(motion, cycle, "");
    let found = simulate(&driven.mechanism, &driven.values, &Plan::of_model(&driven.mechanism.model));
    let failure = found.expect_err("it has no value");
    let RunFailure::Sample(SampleError::DriveWithoutValue { drive, time_s }) = &failure else { panic!("{failure}") };
    assert!(drive == "crank" && *time_s >= 0.05, "{time_s}");
}
