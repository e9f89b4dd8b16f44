//! Springs with their dampers.

use super::{build, crank, file, report};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_simulate::{Settings, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Relative round-off of a few dozen operations.
const ROUND_OFF: f64 = 1e-13;

#[test]
fn identity_the_energy_account_closes_with_springs_dampers_and_loads() {
    let text = file("slider_crank_elements.toml");
    let all = build(&text);
    // A third of a turn: some ten impacts beside the elements.
    let account = report(&all, 4e-3).energy.expect("a run with play is integrated");
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
    assert!(account.damping_loss_j > 0.1 && account.contact_loss_j > 0.01, "the elements act: {account:?}");
    // Each alone, so that none hides behind another.
    for name in ["spring.return", "spring.coil", "spring.wire", "load.weight", "load.jet", "load.cutting", "load.motor"]
    {
        let alone: Vec<&str> = text
            .split("\n\n")
            .filter(|table| {
                !table.starts_with("[spring.") && !table.starts_with("[load.")
                    || table.starts_with(&format!("[{name}]"))
            })
            .collect();
        let account = report(&build(&alone.join("\n\n")), 2e-3).energy.expect("a run with play is integrated");
        assert!(account.relative_residual() < ACCOUNT, "{name}: {account:?}");
    }
}

/// Linear spring between ground and a crank pin: length from the law of cosines, torque from its derivative.
#[test]
fn analytic_torque_of_a_drive_against_a_spring_with_damper() {
    let built = crank(
        "300 rpm",
        r#"
[spring.return]
kind = "linear"
first = "ground.anchor"
second = "crank.pin"
stiffness = "2.3 N/mm"
free_length = "45 mm"
damping = "17 N s/m"
preload = "-4 N"
[spring.coil]
kind = "torsional"
joint = "main"
stiffness = "0.7 N m/rad"
free_angle = "-30 deg"
damping = "0.02 N m s/rad"
preload = "0.3 N m"
"#,
    );
    let sample = built.sample();
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    let speed_rad_s = 10.0 * std::f64::consts::PI;
    for time_s in [0.0, 0.013, 0.171, 0.333] {
        dynamics.evaluate(time_s, &[], &[], &[]);
        let angle_rad = 20.0_f64.to_radians() + speed_rad_s * time_s;
        let (x, y) = (0.05 * angle_rad.cos() - 0.07, 0.05 * angle_rad.sin() + 0.02);
        let length_m = x.hypot(y);
        // dL/dθ = (r_pin - r_anchor)·(dr_pin/dθ)/L.
        let lever_m = (-x * 0.05 * angle_rad.sin() + y * 0.05 * angle_rad.cos()) / length_m;
        let pull_n = -4.0 + 2300.0 * (length_m - 0.045) + 17.0 * lever_m * speed_rad_s;
        let coil_n_m = 0.3 + 0.7 * (angle_rad + 30.0_f64.to_radians()) + 0.02 * speed_rad_s;
        let expected_n_m = pull_n * lever_m + coil_n_m;
        let found_n_m = dynamics.drive_force(0);
        assert!((found_n_m - expected_n_m).abs() < ROUND_OFF * 10.0, "{found_n_m} {expected_n_m}");
        let powers = dynamics.powers();
        let loss_w = 17.0 * (lever_m * speed_rad_s).powi(2) + 0.02 * speed_rad_s * speed_rad_s;
        assert!((powers.damping_loss_w - loss_w).abs() < ROUND_OFF * loss_w);
        let stored_j = 1150.0 * (length_m - 0.045).powi(2) - 4.0 * (length_m - 0.045)
            + 0.35 * (angle_rad + 30.0_f64.to_radians()).powi(2)
            + 0.3 * (angle_rad + 30.0_f64.to_radians());
        let energy = dynamics.energy(|_| false);
        assert!((energy.stored_j - stored_j).abs() < ROUND_OFF * stored_j.abs().max(1.0));
    }
    // The same as an account over one turn, which the coil winds up by 2π.
    let account = report(&built, 0.2).energy.expect("springs have an account");
    let wound_rad = 50.0_f64.to_radians();
    let (from, to) = (wound_rad, wound_rad + std::f64::consts::TAU);
    let stored_j = 0.35 * (to * to - from * from) + 0.3 * (to - from);
    assert!((account.at_end_j - account.at_start_j - stored_j).abs() < 1e-12);
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
    assert!(account.damping_loss_j > 0.02 * speed_rad_s * std::f64::consts::TAU, "{account:?}");
}

/// Two bodies on one line, held apart by a spring: the drive of the first carries what the spring pulls, and so does its joint.
#[test]
fn analytic_reaction_of_a_joint_to_a_spring() {
    let built = crank(
        "0 rpm",
        r#"
[spring.return]
kind = "linear"
first = "ground.anchor"
second = "crank.pin"
stiffness = "2.3 N/mm"
free_length = "45 mm"
[load.push]
kind = "force"
point = "crank.pin"
force = "7 N"
direction = "33 deg"
"#,
    );
    let sample = built.sample();
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    dynamics.evaluate(0.0, &[], &[], &[]);
    let (x, y) = (0.05 * 20.0_f64.to_radians().cos() - 0.07, 0.05 * 20.0_f64.to_radians().sin() + 0.02);
    let pull_n = 2300.0 * (x.hypot(y) - 0.045);
    let main = loosepin_mechanics::model::JointId(0);
    let force_n = dynamics.joint_force_n(main);
    let push_rad = 33.0_f64.to_radians();
    let expected = [pull_n * x / x.hypot(y) - 7.0 * push_rad.cos(), pull_n * y / x.hypot(y) - 7.0 * push_rad.sin()];
    assert!((force_n.x - expected[0]).abs() < ROUND_OFF * 100.0 && (force_n.y - expected[1]).abs() < ROUND_OFF * 100.0);
}

/// A slider on a spring, with an arm that hangs on it by another.
fn slider_on(springs: &str) -> super::Built {
    build(&format!(
        r#"
name = "slider on a table"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], anchor = ["-100 mm", "0 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["3 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[body.arm]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = {{ eye = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
[joint.pivot]
kind = "revolute"
bearing = "slider.pin"
journal = "arm.eye"
{springs}
[initial.joint.rail]
position = "20 mm"
velocity = "0.3 m/s"
[initial.joint.pivot]
angle = "-25 deg"
angular_velocity = "4 rad/s"
[cycle]
duration = "0.4 s"
samples_per_turn = 40
[output.slider]
position_of = "slider.pin"
along = "x"
[output.arm]
angle_of = "arm"
"#
    ))
}

/// A linear spring on the slider and a torsional one on the arm.
fn springs(linear: &str, torsional: &str) -> String {
    format!(
        "[spring.coil]\nkind = \"linear\"\nfirst = \"ground.anchor\"\nsecond = \"slider.pin\"\n{linear}\n[spring.wire]\nkind = \"torsional\"\njoint = \"pivot\"\n{torsional}"
    )
}

/// Points on a line are a spring with a constant stiffness, by either curve, beyond their ends as well (at 110 mm and 20 deg); points
/// that bend keep the account.
#[test]
fn identity_springs_by_tables() {
    let line = slider_on(&springs(
        "stiffness = \"350 N/m\"\nfree_length = \"90 mm\"",
        "stiffness = \"0.9 N m/rad\"\nfree_angle = \"10 deg\"\npreload = \"0.2 N m\"",
    ));
    let expected = super::initial::simulated(&line).record;
    for curve in ["monotone", "spline"] {
        let with = |points: &str| format!("curve = \"{curve}\"\npoints = [{points}]");
        let built = slider_on(&springs(
            &with("[\"70 mm\", \"-7 N\"], [\"90 mm\", \"0 N\"], [\"101 mm\", \"3.85 N\"], [\"110 mm\", \"7 N\"]"),
            &with(
                "[\"-0.5 rad + 10 deg\", \"-0.25 N m\"], [\"10 deg\", \"0.2 N m\"], [\"0.2 rad + 10 deg\", \"0.38 N m\"]",
            ),
        ));
        let record = super::initial::simulated(&built).record;
        for (found, expected) in record.outputs.iter().zip(&expected.outputs) {
            for (a, b) in found.value_si.iter().zip(&expected.value_si) {
                assert!((a - b).abs() < 1e-8, "{curve}: {a} {b}");
            }
        }
        let bent = slider_on(&springs(
            &with("[\"70 mm\", \"-30 N\"], [\"90 mm\", \"0 N\"], [\"101 mm\", \"1 N\"], [\"120 mm\", \"25 N\"]"),
            &with(
                "[\"-40 deg\", \"-2 N m\"], [\"10 deg\", \"0.2 N m\"], [\"30 deg\", \"0.2 N m\"], [\"60 deg\", \"0.9 N m\"]",
            ),
        ));
        let account = super::initial::simulated(&bent).report.energy.expect("it is integrated");
        assert!(account.relative_residual() < ACCOUNT && account.supplied_j == 0.0, "{curve}: {account:?}");
    }
}

/// A slider that runs against a compression spring which its own anchor lies behind: pressed to length zero it would push nowhere, and
/// turn over beyond. A run ends there in words; a spring without a force at length zero goes through.
#[test]
fn a_spring_that_is_pressed_to_length_zero_ends_the_run_in_words() {
    let sliding = |spring: &str| {
        build(&format!(
            r#"
name = "slider against a spring"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], anchor = ["-30 mm", "0 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
[spring.coil]
kind = "linear"
first = "ground.anchor"
second = "slider.pin"
{spring}
[initial.joint.rail]
position = "0 mm"
velocity = "-2 m/s"
[cycle]
duration = "40 ms"
samples_per_turn = 40
[output.slider]
position_of = "slider.pin"
along = "x"
"#
        ))
    };
    let outcome = |spring: &str| {
        let built = sliding(spring);
        let window = Window { start_s: 0.0, end_s: 0.04 };
        run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut super::Nobody)
    };
    // ½ k L0² = 0.12 J of the 1.4 J that the slider has.
    let failure = outcome("stiffness = \"150 N/m\"\nfree_length = \"40 mm\"").expect_err("it has no direction");
    let text = failure.to_string();
    assert!(text.ends_with("spring 'coil' is compressed to length zero: its force has no direction there"), "{text}");
    assert_eq!(failure.code(), "spring_without_direction");
    outcome("stiffness = \"150 N/m\"\nfree_length = \"0 mm\"").unwrap_or_else(|failure| panic!("{failure}"));
}
