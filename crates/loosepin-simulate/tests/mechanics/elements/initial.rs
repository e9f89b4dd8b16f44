//! Mechanisms that no drive moves.

use super::{Built, build};
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, Plan, Settings, Simulation, Step, Window, run, simulate};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Tolerance of a simulation times a few periods, m or rad.
const MOTION: f64 = 1e-8;

/// A slider on a rail, with `elements` and an initial state.
fn slider(elements: &str, initial: &str) -> Built {
    build(&format!(
        r#"
name = "oscillator"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], anchor = ["-100 mm", "0 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["3 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
{elements}
{initial}
[cycle]
duration = "0.4 s"
samples_per_turn = 40
[output.slider]
position_of = "slider.pin"
along = "x"
"#
    ))
}

const SPRING: &str = r#"
[spring.coil]
kind = "linear"
first = "ground.anchor"
second = "slider.pin"
stiffness = "350 N/m"
free_length = "90 mm"
"#;

pub(super) fn simulated(built: &Built) -> Simulation {
    let plan = Plan {
        cycle: built.mechanism.model.cycle.clone(),
        settings: Settings::for_simulation(),
        with_states: false,
        lyapunov_turns: None,
        second_run: false,
        overrides: Vec::new(),
    };
    simulate(&built.mechanism, &built.values, &plan).unwrap_or_else(|failure| panic!("{failure}"))
}

/// x'' = -(k x + d x')/m about the rest at -10 mm, from 20 mm and 0.3 m/s.
#[test]
fn analytic_oscillators_without_and_with_damping() {
    for damping in [0.0, 4.0] {
        let damper = if damping > 0.0 { format!("damping = \"{damping} N s/m\"\n") } else { String::new() };
        let built =
            slider(&format!("{SPRING}{damper}"), "[initial.joint.rail]\nposition = \"20 mm\"\nvelocity = \"0.3 m/s\"");
        let (k, m, x0, v0) = (350.0_f64, 0.7_f64, 0.03, 0.3);
        let decay = damping / (2.0 * m);
        let w = (k / m - decay * decay).sqrt();
        let exact = |t: f64| -0.01 + (-decay * t).exp() * (x0 * (w * t).cos() + (v0 + decay * x0) / w * (w * t).sin());
        let simulation = simulated(&built);
        let record = &simulation.record;
        assert_eq!(record.time_s.len(), 41);
        for (time_s, x) in record.time_s.iter().zip(&record.outputs[0].value_si) {
            assert!((x - exact(*time_s)).abs() < MOTION, "damping {damping} at {time_s}: {x} {}", exact(*time_s));
        }
        assert!(record.outputs[0].deviation_si.iter().all(|deviation| deviation.abs() < MOTION), "it is its own ideal");
        let account = simulation.report.energy.expect("it is integrated");
        assert!(account.relative_residual() < ACCOUNT, "{account:?}");
        assert_eq!(record.energy.damping_loss_j.len(), if damping > 0.0 { 41 } else { 0 });
        assert!(record.energy.residual_j.iter().all(|residual| residual.abs() < ACCOUNT * account.largest_exchange_j));
    }
}

/// A torsional pendulum without gravity: θ'' = -(k θ + d θ')/I about its free angle, from rest.
#[test]
fn analytic_torsional_pendulum() {
    let built = build(
        r#"
name = "torsional pendulum"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["10 mm", "20 mm"] }
[body.arm]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = { eye = ["0 mm", "0 mm"], tip = ["100 mm", "0 mm"] }
[joint.pivot]
kind = "revolute"
bearing = "ground.o"
journal = "arm.eye"
[spring.wire]
kind = "torsional"
joint = "pivot"
stiffness = "0.9 N m/rad"
free_angle = "-25 deg"
damping = "0.003 N m s/rad"
[initial.body.arm]
angle = "400 deg"
[cycle]
duration = "0.5 s"
samples_per_turn = 25
[output.arm]
angle_of = "arm"
"#,
    );
    let inertia_kg_m2: f64 = 2e-4 + 0.3 * 0.04 * 0.04;
    let decay: f64 = 0.003 / (2.0 * inertia_kg_m2);
    let w = (0.9 / inertia_kg_m2 - decay * decay).sqrt();
    let (rest, start) = (-25.0_f64.to_radians(), 425.0_f64.to_radians());
    let record = simulated(&built).record;
    for (t, angle_rad) in record.time_s.iter().zip(&record.outputs[0].value_si) {
        let exact = rest + start * (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
        assert!((angle_rad - exact).abs() < MOTION * 10.0, "at {t}: {angle_rad} {exact}");
    }
}

fn bars(extra: &str) -> String {
    let mut text = String::from(
        r#"
name = "double four-bar"
gravity = "9.81 m/s^2"
[body.ground]
points = { a = ["0 m", "0 m"], b = ["1 m", "0 m"], c = ["2 m", "0 m"] }
"#,
    );
    for bar in ["left", "top_left", "middle", "top_right", "right"] {
        text.push_str(&format!(
            "[body.{bar}]\nmass = \"1 kg\"\ninertia = \"1 kg m^2 / 12\"\ncentre_of_mass = [\"0.5 m\", \"0 m\"]\npoints = {{ foot = [\"0 m\", \"0 m\"], head = [\"1 m\", \"0 m\"] }}\n"
        ));
    }
    for (joint, bearing, journal) in [
        ("a", "ground.a", "left.foot"),
        ("b", "ground.b", "middle.foot"),
        ("c", "ground.c", "right.foot"),
        ("d", "left.head", "top_left.foot"),
        ("e", "top_left.head", "middle.head"),
        ("f", "middle.head", "top_right.foot"),
        ("g", "top_right.head", "right.head"),
    ] {
        text.push_str(&format!(
            "[joint.{joint}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n"
        ));
    }
    text.push_str(extra);
    text.push_str("[assembly]\nguess = { left = \"90 deg\", middle = \"90 deg\", right = \"90 deg\" }\n");
    text.push_str("[cycle]\nduration = \"0.3 s\"\n[output.tip]\npath_of = \"left.head\"\n");
    text
}

/// Five bars of 1 m and 1 kg, upright, the head of the first at 1 m/s: the rest follows from the joints.
#[test]
fn identity_a_double_four_bar_starts_as_given_and_keeps_its_energy() {
    let initial = "[initial.body.left]\nangle = \"90 deg\"\nangular_velocity = \"-1 rad/s\"\n";
    let built = build(&bars(initial));
    assert_eq!((built.mechanism.degrees_of_freedom, built.mechanism.is_driven()), (1, false));
    struct First(Vec<[f64; 3]>);
    impl Observer for First {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            if self.0.is_empty() {
                let dynamics = step.evaluate(0.0);
                let tree = &dynamics.mechanism().real;
                self.0 = (1..=5)
                    .map(|body| {
                        let (pose, twist) = (
                            dynamics.kinematics.poses[tree.slot_of_body[body]],
                            dynamics.kinematics.twists[tree.slot_of_body[body]],
                        );
                        [pose.angle_rad(), twist.angular, twist.linear.x]
                    })
                    .collect();
            }
        }
    }
    let mut first = First(Vec::new());
    let window = Window { start_s: 0.0, end_s: 0.3 };
    let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut first)
        .unwrap_or_else(|failure| panic!("{failure}"));
    let upright = std::f64::consts::FRAC_PI_2;
    let expected = [[upright, -1.0, 0.0], [0.0, 0.0, 1.0], [upright, -1.0, 0.0], [0.0, 0.0, 1.0], [upright, -1.0, 0.0]];
    for (found, expected) in first.0.iter().zip(expected) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?} {expected:?}");
    }
    let account = report.energy.expect("it is integrated");
    // Nothing is exchanged: the residual is measured by the kinetic energy of the start, 2.5 J.
    assert!(account.largest_residual_j < 1e-9, "{account:?}");
}

/// Ten seconds of it. Twice a turn all bars lie in a line: there the loops leave more than one free motion, and inertia
/// decides which way it goes on. The tip at the end is that of the IFToMM benchmark (`cases/README.md`).
#[test]
fn published_a_double_four_bar_passes_its_change_points() {
    const TIP_M: [f64; 2] = [0.3284581115, 0.9445185382];
    /// Asked for by the benchmark, m.
    const AGREEMENT_M: f64 = 1e-7;
    /// Of the largest kinetic energy that is exchanged.
    const ENERGY: f64 = 1e-9;
    struct Last([f64; 2]);
    impl Observer for Last {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            let dynamics = step.end();
            let tree = &dynamics.mechanism().real;
            let angle_rad = dynamics.kinematics.poses[tree.slot_of_body[1]].angle_rad();
            self.0 = [angle_rad.cos(), angle_rad.sin()];
        }
    }
    let initial = "[initial.body.left]\nangle = \"90 deg\"\nangular_velocity = \"-1 rad/s\"\n";
    let built = build(&bars(initial));
    let window = Window { start_s: 0.0, end_s: 10.0 };
    for accuracy_m in [1e-7, 1e-8, 1e-9, 1e-10] {
        let settings = Settings { tolerance_m: accuracy_m, ..Settings::for_simulation() };
        let mut last = Last([f64::NAN; 2]);
        let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut last)
            .unwrap_or_else(|failure| panic!("{accuracy_m:e}: {failure}"));
        let account = report.energy.expect("it is integrated");
        let off_m = (last.0[0] - TIP_M[0]).hypot(last.0[1] - TIP_M[1]);
        assert!(off_m < AGREEMENT_M, "{off_m:e} m off for {accuracy_m:e} m");
        assert!(account.largest_residual_j < ENERGY * account.largest_exchange_j, "{account:?}");
    }
}

/// A pendulum hung with play: its ideal reference is its own run without play.
#[test]
fn identity_the_reference_of_an_undriven_mechanism_is_its_own_run_without_play() {
    let text = |clearance: &str| {
        format!(
            r#"
name = "pendulum with play"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.arm]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = {{ eye = ["0 mm", "0 mm"], tip = ["100 mm", "0 mm"] }}
[contact.steel]
restitution = 0.5
stiffness = "1e9 N/m^1.5"
exponent = 1.5
[joint.pivot]
kind = "revolute"
bearing = "ground.o"
journal = "arm.eye"
bearing_radius = "10 mm"
radial_clearance = "{clearance}"
contact = "steel"
[initial.joint.pivot]
angle = "-30 deg"
angular_velocity = "2 rad/s"
[cycle]
duration = "50 ms"
samples_per_turn = 10
[output.tip]
position_of = "arm.tip"
along = "y"
"#
        )
    };
    let (with, without) = (build(&text("0.1 mm")), build(&text("0 mm")));
    let [with, without] = [&with, &without].map(|built| simulated(built).record);
    let mut largest = 0.0_f64;
    for k in 0..=10 {
        let (ideal, exact) = (with.outputs[0].ideal_si[k], without.outputs[0].value_si[k]);
        assert!((ideal - exact).abs() < MOTION, "{ideal} {exact}");
        largest = largest.max(with.outputs[0].deviation_si[k].abs());
    }
    assert!(largest > 1e-5, "the play of 1e-4 m shows: {largest}");
    assert_eq!(with.quasi_static_check, []);
}

/// A number that is not given follows from the joints, or is refused in words.
#[test]
fn starts_that_do_not_fit_are_refused() {
    let refused = |initial: &str| {
        let model =
            Model::from_text("model.toml", &bars(initial)).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        Mechanism::new(&model, &model.quantities.nominal()).expect_err("it is refused").to_string()
    };
    assert_eq!(
        refused(""),
        "the mechanism has 1 degree of freedom and 0 drives: the motions of 'left', 'top_left', 'middle', 'top_right' and 'right' are not determined"
    );
    assert_eq!(
        refused("[initial.body.left]\nangular_velocity = \"1 rad/s\"\n"),
        "the initial state does not determine where 'left', 'top_left', 'middle', 'top_right' and 'right' are"
    );
    // Least gap² + (left - 90°)² + (middle - 60°)² over the three angles, by a search of its own: the gap there is 0.176081287 m.
    assert_eq!(
        refused("[initial.body.left]\nangle = \"90 deg\"\n[initial.body.middle]\nangle = \"60 deg\"\n"),
        "the links cannot close at the start that [initial] gives: joint 'e' stays 176.0813 mm open at best"
    );
    let doubled = slider(SPRING, "[initial.joint.rail]\nposition = \"20 mm\"").mechanism.model;
    let twice =
        doubled.source().text().replace("[cycle]", "[initial.body.slider]\nposition = [\"24 mm\", \"0 mm\"]\n[cycle]");
    let twice = Model::from_text("model.toml", &twice).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(
        Mechanism::new(&twice, &twice.quantities.nominal()).expect_err("it is refused").to_string(),
        "initial: body 'slider': position x cannot be 24 mm at the start; the nearest value that the links and the other given values permit is 22 mm"
    );
    let contradicting = bars(
        "[initial.body.left]\nangle = \"90 deg\"\nangular_velocity = \"1 rad/s\"\n[initial.body.middle]\nangular_velocity = \"2 rad/s\"\n",
    );
    let built = build(&contradicting);
    let window = Window { start_s: 0.0, end_s: 0.1 };
    struct Nobody;
    impl Observer for Nobody {
        fn step(&mut self, _step: &mut Step<'_, '_>) {}
    }
    let failure = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut Nobody);
    assert_eq!(
        failure.expect_err("it is refused").to_string(),
        "initial: body 'middle': angular velocity is 19.09859 rpm; from the links and the other given values it is 9.549297 rpm"
    );
    let driven = "[drive.left]\njoint = \"a\"\nspeed = \"1 rad/s\"\nstart_angle = \"80 deg\"\n[initial.body.left]\nangle = \"80 deg\"\n";
    assert_eq!(
        refused(driven),
        "the drives determine the motion, so there is no initial state to give under [initial]"
    );
}
