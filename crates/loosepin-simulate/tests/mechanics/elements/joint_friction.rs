//! Friction in ideal joints against closed forms, the constraint forces and the energy account.

use super::{Built, build, report};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, RunFailure, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Relative round-off of a few dozen operations, and what is left of Newton's method.
const ROUND_OFF: f64 = 1e-12;
const GRAVITY_M_S2: f64 = 9.81;

/// The last state that a run shows: free coordinates and rates.
#[derive(Default)]
struct Last(Vec<f64>, Vec<f64>);

impl Observer for Last {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let (coordinates, rates) = step.end().free_state();
        *self = Last(coordinates.to_vec(), rates.to_vec());
    }
}

fn last(built: &Built, end_s: f64) -> Result<Last, RunFailure> {
    let mut last = Last::default();
    let window = Window { start_s: 0.0, end_s };
    run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut last)?;
    Ok(last)
}

// Pendulum: mass, arm, inertia about the centre of mass, pin radius.
const MASS_KG: f64 = 0.8;
const ARM_M: f64 = 0.21;
const INERTIA_KG_M2: f64 = 3.1e-3;
const PIN_M: f64 = 0.013;

/// A pendulum on a pin, `angle_rad` from hanging.
fn pendulum(angle_rad: f64, rate_rad_s: f64, friction: &str) -> Built {
    build(&format!(
        r#"
name = "pendulum"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["11 mm", "-7 mm"] }}
[body.bob]
mass = "0.8 kg"
inertia = "3.1e-3 kg m^2"
centre_of_mass = ["0 mm", "-210 mm"]
points = {{ hook = ["0 mm", "0 mm"] }}
[joint.hinge]
kind = "revolute"
bearing = "ground.o"
journal = "bob.hook"
pin_radius = "13 mm"
friction = {friction}
[initial.joint.hinge]
angle = "{angle_rad} rad"
angular_velocity = "{rate_rad_s} rad/s"
[cycle]
duration = "0.5 s"
"#
    ))
}

const DRY: &str = r#"{ coefficient = 0.31, lower_speed = "0.0001 mm/s", upper_speed = "0.001 mm/s" }"#;

/// I α = -m g l sin θ + μ r |R| against the turning, R = m (a - g).
#[test]
fn analytic_acceleration_of_a_pendulum_on_a_pin() {
    let built = pendulum(0.7, 2.9, DRY);
    let sample = built.sample();
    let mut dynamics = Dynamics::new(&built.mechanism, &sample);
    for (angle_rad, rate_rad_s) in [(0.7_f64, 2.9_f64), (-1.9, 3.3), (0.4, -5.1), (2.8, -0.4)] {
        dynamics.evaluate(0.0, &[angle_rad], &[rate_rad_s], &[]);
        let inertia = INERTIA_KG_M2 + MASS_KG * ARM_M * ARM_M;
        let (sine, cosine) = angle_rad.sin_cos();
        let (mut alpha, mut carried_n) = (0.0, 0.0);
        for _ in 0..200 {
            // Along the arm and across it.
            let along_n = MASS_KG * (ARM_M * rate_rad_s * rate_rad_s + GRAVITY_M_S2 * cosine);
            let across_n = MASS_KG * (ARM_M * alpha + GRAVITY_M_S2 * sine);
            carried_n = f64::hypot(along_n, across_n);
            let friction_n_m = -0.31 * carried_n * PIN_M * rate_rad_s.signum();
            alpha = (friction_n_m - MASS_KG * GRAVITY_M_S2 * ARM_M * sine) / inertia;
        }
        let found = dynamics.accelerations()[0];
        assert!((found - alpha).abs() < ROUND_OFF * alpha.abs(), "{angle_rad}: {found} against {alpha}");
        let frictions: Vec<_> = dynamics.joint_frictions().collect();
        assert!((frictions[0].1 - carried_n).abs() < ROUND_OFF * carried_n, "{frictions:?}");
    }
}

/// At rest a pin carries m g, and its friction reaches up to μ r m g: sin θ = μ r/l.
#[test]
fn analytic_break_away_of_a_pendulum_on_a_pin() {
    let steepest = 0.31 * PIN_M / ARM_M;
    // Just below: it creeps at the surface speed at which friction is large enough, between 0.1 and 1 µm/s.
    let share = 0.97;
    let last_below = last(&pendulum(f64::asin(share * steepest), 0.0, DRY), 0.2).expect("it runs");
    let surface_m_s = PIN_M * last_below.1[0].abs();
    let expected_m_s = 1e-7 + share * 9e-7;
    // Meanwhile it turns by a thousandth of its angle.
    assert!((surface_m_s - expected_m_s).abs() < 3e-3 * expected_m_s, "{surface_m_s} against {expected_m_s}");
    // Just above it swings about the break-away angle, for half a period, and stays as far below as it was above.
    let share = 0.06;
    let above = pendulum(f64::asin((1.0 + share) * steepest), 0.0, DRY);
    let pace_rad_s = (MASS_KG * GRAVITY_M_S2 * ARM_M / (INERTIA_KG_M2 + MASS_KG * ARM_M * ARM_M)).sqrt();
    let quarter_s = 0.5 * std::f64::consts::PI / pace_rad_s;
    let fastest_rad_s = last(&above, quarter_s).expect("it runs").1[0].abs();
    // Of these parts in a thousand: sine against angle, and what the pin carries in motion.
    assert!((fastest_rad_s - share * steepest * pace_rad_s).abs() < 5e-3 * fastest_rad_s, "{fastest_rad_s}");
    let end_rad = last(&above, 2.2 * quarter_s).expect("it runs").0[0];
    assert!((end_rad.sin() - (1.0 - share) * steepest).abs() < 5e-3 * share * steepest, "{end_rad}");
}

/// Bristles hold: below the break-away angle the pendulum comes to rest, above it slides.
#[test]
fn analytic_bristles_stick_and_slip_in_a_pin() {
    let lugre = r#"{ law = "lugre", coefficient = 0.25, static_coefficient = 0.31, stribeck_speed = "2 mm/s",
        bristle_stiffness = "2e4 m^-1", bristle_damping = "2000 s/m" }"#
        .replace('\n', " ");
    let steepest = 0.31 * PIN_M / ARM_M;
    let start_rad = f64::asin(0.5 * steepest);
    let stuck = last(&pendulum(start_rad, 0.0, &lugre), 1.0).expect("it runs");
    assert!(PIN_M * stuck.1[0].abs() < 1e-7, "it creeps at {} m/s", PIN_M * stuck.1[0]);
    // Bristles bend by z until they carry m g l sin θ: dz/dx = 1 - z/z_max with z_max = μ_s/σ0, x = -z_max ln(1 - z/z_max).
    let expected_m = -0.31 / 2e4 * (1.0 - stuck.0[0].sin() / steepest).ln();
    let moved_m = PIN_M * (start_rad - stuck.0[0]).abs();
    assert!((moved_m - expected_m).abs() < 0.02 * expected_m, "{moved_m} against {expected_m}");
    // Beyond the static coefficient it slides.
    let free = last(&pendulum(f64::asin(1.3 * steepest), 0.0, &lugre), 0.2).expect("it runs");
    assert!(PIN_M * free.1[0].abs() > 1e-4, "{:?}", free.1);
}

/// A slider on a level rail, its centre of mass at (`b_mm`, `h_mm`) from the slider point.
fn slider(b_mm: f64, h_mm: f64, guide_mm: f64, speed: &str) -> Built {
    build(&format!(
        r#"
name = "slider"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["3 mm", "5 mm"] }}
[body.slider]
mass = "0.7 kg"
inertia = "1.9e-4 kg m^2"
centre_of_mass = ["{b_mm} mm", "{h_mm} mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
guide_length = "{guide_mm} mm"
friction = {{ coefficient = 0.23 }}
[initial.joint.rail]
position = "20 mm"
velocity = "{speed}"
[cycle]
duration = "0.2 s"
"#
    ))
}

#[test]
fn analytic_a_slider_slows_down_at_mu_g() {
    // Both ends of the guide press downwards: |N1| + |N2| = m g.
    let built = slider(4.0, 0.0, 80.0, "1.7 m/s");
    let end_s = 0.3;
    let last = last(&built, end_s).expect("it runs");
    let expected_m_s = 1.7 - 0.23 * GRAVITY_M_S2 * end_s;
    assert!((last.1[0] - expected_m_s).abs() < 1e-9, "{} against {expected_m_s}", last.1[0]);
    let account = report(&built, end_s).energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT, "{account:?}");
    let lost_j = 0.35 * (1.7 * 1.7 - expected_m_s * expected_m_s);
    assert!((account.friction_loss_j - lost_j).abs() < ACCOUNT * lost_j);
}

#[test]
fn analytic_a_slider_that_tilts_in_its_guide() {
    // |M|/ℓ > N/2: the ends press in opposite directions, 2 |M|/ℓ together, M = m (g b + a h).
    for (b_mm, h_mm, guide_mm) in [(30.0, 0.0, 40.0), (30.0, 17.0, 40.0), (-26.0, 21.0, 35.0)] {
        let built = slider(b_mm, h_mm, guide_mm, "2.6 m/s");
        let sample = built.sample();
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        dynamics.evaluate(0.0, &[0.02], &[2.6], &[]);
        let sign = f64::signum(b_mm);
        let expected_m_s2 = 2.0 * 0.23 * GRAVITY_M_S2 * b_mm.abs() / (guide_mm - sign * 2.0 * 0.23 * h_mm);
        let found_m_s2 = -dynamics.accelerations()[0];
        assert!((found_m_s2 - expected_m_s2).abs() < ROUND_OFF * expected_m_s2, "{found_m_s2} {expected_m_s2}");
    }
}

#[test]
fn a_slider_jams_where_friction_outgrows_its_cause() {
    // ℓ < 2 μ h: a = 2 μ g b/(ℓ - 2 μ h) has no meaning any longer.
    let failure = last(&slider(30.0, 95.0, 40.0, "2.6 m/s"), 0.1).err().expect("it jams");
    assert!(matches!(&failure, RunFailure::Jams { joint, .. } if joint == "rail"), "{failure}");
    assert_eq!(failure.code(), "joint_jams");
    // Just long enough.
    assert!(last(&slider(30.0, 85.0, 40.0, "0.1 m/s"), 0.01).is_ok());
}

#[test]
fn friction_of_a_joint_that_carries_what_nobody_knows_is_refused() {
    let text = r#"
name = "two rails"
gravity = "9.81 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"], above = ["0 mm", "30 mm"] }
[body.slider]
mass = "0.7 kg"
inertia = "1.9e-4 kg m^2"
centre_of_mass = ["4 mm", "3 mm"]
points = { pin = ["0 mm", "0 mm"], ear = ["10 mm", "30 mm"] }
[joint.lower]
kind = "prismatic"
guide = { point = "ground.o", angle = "0 deg" }
slider = "slider.pin"
guide_length = "60 mm"
friction = { coefficient = 0.2 }
[joint.upper]
kind = "prismatic"
guide = { point = "ground.above", angle = "0 deg" }
slider = "slider.ear"
[initial.joint.lower]
position = "20 mm"
velocity = "0.3 m/s"
[cycle]
duration = "0.2 s"
"#;
    let model = Model::from_text("model.toml", text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let error = Mechanism::new(&model, &model.quantities.nominal()).expect_err("nobody knows which rail carries");
    assert_eq!(
        error.complaint(&model).to_string(),
        "model.toml:11:8: error[E0708]: joint 'lower' has friction, but its force is not determined: constraints of ideal joints are redundant\nhint: remove the redundant constraint, or the friction"
    );
}

/// The slider-crank of a case with friction in all its ideal joints.
fn slider_crank(law: &str) -> Built {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
    let mut text = std::fs::read_to_string(path).expect("the case is there");
    let lines = text.lines().filter(|line| line.starts_with("[joint."));
    let tables: Vec<String> = lines.map(|line| format!("{line}\n")).collect();
    assert!(tables.len() == 4, "{tables:?}");
    for table in tables {
        let start = text.find(&table).expect("it is there") + table.len();
        let rest = &text[start..];
        let own = &rest[..rest.find("\n[").unwrap_or(rest.len())];
        if own.contains("radial_clearance") {
            continue;
        }
        let size = if own.contains("prismatic") { "guide_length = \"70 mm\"" } else { "pin_radius = \"12 mm\"" };
        text.insert_str(start, &format!("{size}\nfriction = {law}\n"));
    }
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
    Built { values, mechanism }
}

const LUGRE: &str = "{ law = \"lugre\", coefficient = 0.06, static_coefficient = 0.09, stribeck_speed = \"20 mm/s\", \
                     bristle_stiffness = \"2e3 m^-1\", bristle_damping = \"0.004 s/m\" }";

/// A pin carries the force of its joint, found from the balance of all bodies beyond it.
struct Forces {
    looks: usize,
}

impl Observer for Forces {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let dynamics = step.end();
        for (joint, carried_n, friction_n) in dynamics.joint_frictions() {
            let force_n = dynamics.joint_force_n(joint);
            let total_n = force_n.length();
            // A guide's force holds its friction, and what its ends carry against each other is no part of it.
            let is_pin = dynamics.mechanism().model.joints[joint.0].name != "guide";
            if is_pin {
                assert!((carried_n - total_n).abs() < 1e-9 * (1.0 + total_n), "{carried_n} against {total_n}");
            } else {
                assert!(f64::hypot(carried_n, friction_n) > total_n * (1.0 - 1e-9));
            }
            self.looks += 1;
        }
    }
}

#[test]
fn identity_carried_forces_and_energy_of_a_slider_crank_with_friction_everywhere() {
    for law in ["{ coefficient = 0.08 }", LUGRE] {
        let with_play = slider_crank(law);
        let without = with_play.mechanism.without_play();
        let sample = with_play.sample();
        for (mechanism, sample) in [(&with_play.mechanism, sample.clone()), (&without, sample.without_play())] {
            let mut forces = Forces { looks: 0 };
            let window = Window { start_s: 0.0, end_s: 2e-3 };
            let report = run(mechanism, &sample, &window, &Settings::for_simulation(), &mut forces)
                .unwrap_or_else(|failure| panic!("{failure}"));
            assert!(forces.looks > 40);
            let account = report.energy.expect("there is friction");
            assert!(account.relative_residual() < ACCOUNT, "{law}: {account:?}");
            assert!(account.friction_loss_j > 1e-3, "{law}: {account:?}");
        }
    }
}
