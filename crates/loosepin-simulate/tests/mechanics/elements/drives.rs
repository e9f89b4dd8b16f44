//! Motions that drives prescribe.

use super::{build, crank_with_drive, report};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::IdealMotion;
use loosepin_mechanics::model::DriveId;
use loosepin_simulate::{Observer, Plan, Settings, Step, Window, run, simulate};

/// Relative round-off of a few dozen operations.
const ROUND_OFF: f64 = 1e-13;
/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;

type Closed = fn(f64) -> [f64; 3];

fn harmonic(t: f64) -> [f64; 3] {
    let (w, phase) = (2.0 * std::f64::consts::PI * 3.0, 20.0_f64.to_radians());
    let (s, c) = (w * t + phase).sin_cos();
    [1.3 + 0.7 * s, 0.7 * w * c, -0.7 * w * w * s]
}

fn cycloidal(t: f64) -> [f64; 3] {
    let tau = std::f64::consts::TAU;
    let share = ((t - 0.05) / 0.2).clamp(0.0, 1.0);
    let (s, c) = (tau * share).sin_cos();
    [0.4 + 1.2 * (share - s / tau), 6.0 * (1.0 - c), 6.0 * tau * s / 0.2]
}

fn polynomial(t: f64) -> [f64; 3] {
    [0.1 + 2.0 * t - 3.0 * t * t + 40.0 * t * t * t, 2.0 - 6.0 * t + 120.0 * t * t, -6.0 + 240.0 * t]
}

fn expression(t: f64) -> [f64; 3] {
    // 0.2 e with e = sqrt(1 + (4 t)²).
    let e = (1.0 + 16.0 * t * t).sqrt();
    [0.2 * e, 3.2 * t / e, 3.2 / (e * e * e)]
}

const MOTIONS: [(&str, Closed); 4] = [
    (
        "{ kind = \"harmonic\", mean = \"1.3 rad\", amplitude = \"0.7 rad\", frequency = \"3 Hz\", phase = \"20 deg\" }",
        harmonic,
    ),
    (
        "{ kind = \"cycloidal\", from = \"0.4 rad\", to = \"1.6 rad\", duration = \"0.2 s\", dwell = \"0.05 s\" }",
        cycloidal,
    ),
    (
        "{ kind = \"polynomial\", coefficients = [\"0.1 rad\", \"2 rad/s\", \"-3 rad/s^2\", \"40 rad/s^3\"] }",
        polynomial,
    ),
    ("{ kind = \"expression\", position = \"0.2 rad * sqrt(1 + (4 * time / 1 s)^2)\" }", expression),
];

/// A driven crank without play: position, velocity, acceleration and torque of the drive from the closed form of its angle.
#[test]
fn analytic_motions_of_a_crank_at_all_three_levels() {
    for (motion, closed) in MOTIONS {
        let built = crank_with_drive(&format!("motion = {motion}"), "duration = \"0.4 s\"", "");
        let sample = built.sample();
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
        let inertia_kg_m2 = 1e-4 + 0.3 * 0.025 * 0.025;
        for time_s in [0.0, 0.03, 0.05, 0.127, 0.25, 0.33] {
            let [angle_rad, rate, acceleration] = closed(time_s);
            dynamics.evaluate(time_s, &[], &[], &[]);
            let found = [
                dynamics.kinematics.poses[1].angle_rad(),
                dynamics.kinematics.twists[1].angular,
                dynamics.acceleration(1).angular,
                dynamics.drive_force(0) / inertia_kg_m2,
            ];
            ideal.move_to(time_s).expect("it moves");
            let solved = [
                ideal.kinematics().poses[1].angle_rad(),
                ideal.kinematics().twists[1].angular,
                ideal.acceleration(1).angular,
                ideal.acceleration(1).angular,
            ];
            let expected = [angle_rad, rate, acceleration, acceleration];
            for (k, scale) in [1.0, 20.0, 400.0, 400.0].into_iter().enumerate() {
                for found in [found[k], solved[k]] {
                    assert!(
                        (found - expected[k]).abs() < ROUND_OFF * scale,
                        "{motion} at {time_s}: {found} {}",
                        expected[k]
                    );
                }
            }
        }
    }
}

const SLIDER_CRANK: &str = include_str!("../../files/slider_crank_elements.toml");

/// The slider-crank with play, springs and loads, its crank moved otherwise.
fn slider_crank(motion: &str, cycle: &str) -> super::Built {
    let text = SLIDER_CRANK
        .replace(
            "speed = \"5000 rpm\"\nstart_angle = \"0 deg\"                                # top dead centre",
            motion,
        )
        .replace("drive = \"crank\"\n", &format!("{cycle}\n"));
    assert!(!text.contains("5000 rpm\"\n"), "the drive is replaced");
    build(&text)
}

/// Accelerations of the drive enter masses, couplings and powers: the account closes only if all of them are right.
#[test]
fn identity_the_energy_account_closes_for_every_motion() {
    let motions = [
        "motion = { kind = \"harmonic\", mean = \"40 deg\", amplitude = \"50 deg\", frequency = \"60 Hz\" }",
        "motion = { kind = \"cycloidal\", from = \"20 deg\", to = \"200 deg\", duration = \"5 ms\", dwell = \"1 ms\" }",
        "motion = { kind = \"polynomial\", coefficients = [\"20 deg\", \"100 rad/s\", \"5e4 rad/s^2\"] }",
        "motion = { kind = \"expression\", position = \"300 rad/s * time + 0.3 rad * cos(800 rad/s * time)\" }",
        "motion = { kind = \"table\", ends = \"clamped\", points = [[\"1 ms\", \"20 deg\"], [\"3 ms\", \"90 deg\"], [\"5 ms\", \"70 deg\"]] }",
        "motion = { kind = \"table\", ends = \"periodic\", points = [[\"0 s\", \"0 deg\"], [\"1 ms\", \"150 deg\"], [\"4 ms\", \"360 deg\"]] }",
    ];
    for motion in motions {
        let built = slider_crank(motion, "duration = \"7 ms\"");
        let account = report(&built, 7e-3).energy.expect("a run with play is integrated");
        assert!(account.relative_residual() < ACCOUNT, "{motion}: {account:?}");
        assert!(account.supplied_j.abs() > 0.1, "{motion}: the drive works: {account:?}");
        // Without play, by the ideal motion.
        let text = SLIDER_CRANK.replace("radial_clearance = \"0.5 mm\"", "radial_clearance = \"0 mm\"");
        let text = text
            .replace(
                "speed = \"5000 rpm\"\nstart_angle = \"0 deg\"                                # top dead centre",
                motion,
            )
            .replace("drive = \"crank\"\n", "duration = \"7 ms\"\n");
        let account = report(&build(&text), 7e-3).energy.expect("springs have an account");
        assert!(account.relative_residual() < ACCOUNT, "{motion}: {account:?}");
    }
}

/// Ends of all steps.
struct Ends(Vec<f64>);

impl Observer for Ends {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        self.0.push(step.end_s);
    }
}

#[test]
fn identity_steps_end_where_pieces_meet() {
    let cases = [
        (
            "motion = { kind = \"cycloidal\", from = \"20 deg\", to = \"200 deg\", duration = \"4 ms\", dwell = \"1 ms\" }",
            vec![0.001, 0.005],
        ),
        (
            "motion = { kind = \"table\", ends = \"clamped\", points = [[\"1 ms\", \"20 deg\"], [\"3 ms\", \"90 deg\"], [\"5 ms\", \"70 deg\"]] }",
            vec![0.001, 0.003, 0.005],
        ),
        (
            "motion = { kind = \"table\", ends = \"periodic\", points = [[\"0 s\", \"0 deg\"], [\"1 ms\", \"150 deg\"], [\"3 ms\", \"360 deg\"]] }",
            vec![0.001, 0.003, 0.004, 0.006],
        ),
    ];
    for (motion, breaks_s) in cases {
        for built in [slider_crank(motion, "duration = \"7 ms\""), crank_with_drive(motion, "duration = \"7 ms\"", "")]
        {
            let mut ends = Ends(Vec::new());
            let window = Window { start_s: 0.0, end_s: 7e-3 };
            run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends).expect("it runs");
            for at_s in &breaks_s {
                assert!(ends.0.iter().any(|end_s| (end_s - at_s).abs() < 1e-16), "{motion}: no step ends at {at_s}");
            }
            assert_eq!(ends.0.last(), Some(&7e-3));
        }
    }
}

/// A table goes through its points and turns a periodic course by one turn each time.
#[test]
fn identity_a_table_goes_through_its_points() {
    let motion = "motion = { kind = \"table\", ends = \"periodic\", points = [[\"0 s\", \"0.2 rad\"], [\"0.1 s\", \"1.4 rad\"], [\"0.3 s\", \"2 rad\"], [\"0.4 s\", \"0.7 rad\"]] }";
    let built = crank_with_drive(motion, "drive = \"crank\"", "");
    let sample = built.sample();
    let mut drives = sample.drives.clone();
    for (time_s, angle_rad) in [(0.0, 0.2), (0.1, 1.4), (0.3, 2.0), (0.4, 0.7), (0.5, 1.9), (0.7, 2.5), (1.1, 3.0)] {
        drives.take_pieces_at(time_s);
        let found = drives.at(&built.mechanism.model, DriveId(0), time_s)[0];
        assert!((found - angle_rad).abs() < ROUND_OFF, "at {time_s}: {found} {angle_rad}");
    }
    let input = built.mechanism.model.cycle_input(&built.values);
    assert!((input.turn_s() - 0.4).abs() < 1e-15 && !input.is_drive && input.name == "cycle");
}

/// `simulate` over periods of a motion: the history has the phase of the cycle beside the time, and no deviation without play.
#[test]
fn identity_a_simulation_counts_periods() {
    let motion = "motion = { kind = \"harmonic\", mean = \"1.3 rad\", amplitude = \"0.7 rad\", frequency = \"3 Hz\", phase = \"20 deg\" }";
    let output = "[output.pin]\nposition_of = \"crank.pin\"\nalong = \"x\"\n";
    let built = crank_with_drive(motion, "drive = \"crank\"\ntransient_turns = 1\nsamples_per_turn = 12", output);
    let plan = Plan {
        cycle: built.mechanism.model.cycle.clone(),
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    let record = simulate(&built.mechanism, &built.values, &plan).expect("it runs").record;
    assert_eq!((record.settings.drive.as_str(), record.settings.drive_speed_rad_s), ("cycle", None));
    assert_eq!(record.time_s.len(), 13);
    for k in 0..13 {
        assert!((record.drive_angle_rad[k] - std::f64::consts::TAU * 3.0 * record.time_s[k]).abs() < 1e-12);
        assert!((record.outputs[0].value_si[k] - 0.05 * harmonic(record.time_s[k])[0].cos()).abs() < 1e-14);
        assert!(record.outputs[0].deviation_si[k].abs() < 1e-14);
    }
}

/// A drive that turns back at once: its rate jumps, and expressions have no pieces. The loops must close the same way round as before.
#[test]
fn identity_a_drive_that_turns_back_at_once_goes_back_the_way_it_came() {
    const STEPS: u32 = 96;
    let text = include_str!("../../../../../cases/four_bar_600/model.toml");
    let turns = (1..STEPS).flat_map(|steps| [0.0, 0.25, 0.5, 0.75].map(|beyond| (steps, beyond)));
    for ((steps, beyond), sign) in turns.flat_map(|turn| [(turn, ""), (turn, "-")]) {
        let turn_ms = 100.0;
        let back_ms = turn_ms * (f64::from(steps) + beyond) / f64::from(STEPS);
        let motion = format!(
            "motion = {{ kind = \"expression\", position = \"0.6 rad + {sign}600 rpm * ({back_ms} ms - abs(time - {back_ms} ms))\" }}"
        );
        let driven = text.replace("speed = \"600 rpm\"\nstart_angle = \"0.6 rad\"", &motion);
        let built = build(&driven.replace("drive = \"crank\"", "duration = \"0.2 s\""));
        let sample = built.sample();
        let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
        let start: Vec<f64> = ideal.kinematics().poses.iter().map(|pose| pose.angle_rad()).collect();
        // One step, then two at once, and so on: a guess from the last step reaches furthest over one that is twice as long.
        for step in (1..=2 * steps + 4).filter(|step| step % 3 != 2) {
            let time_ms = (turn_ms * f64::from(step) / f64::from(STEPS)).min(2.0 * back_ms);
            ideal.move_to(1e-3 * time_ms).expect("it moves");
        }
        for (body, (pose, start)) in ideal.kinematics().poses.iter().zip(&start).enumerate() {
            let angle_rad = pose.angle_rad();
            assert!(
                (angle_rad - start).abs() < 1e-9,
                "{sign} back after {steps} steps and {beyond}, body {body}: {angle_rad} {start}"
            );
        }
    }
}
