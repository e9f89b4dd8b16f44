//! The largest Lyapunov exponent against systems whose exponent is known.

use super::{Built, build, file};
use loosepin_simulate::record::{LyapunovRecord, NeighbourKind};
use loosepin_simulate::{ExponentPlan, Settings, largest_exponent};
use std::sync::atomic::AtomicBool;

fn exponent(built: &Built, transient_turns: f64, turns: u32) -> LyapunovRecord {
    let turn_s = built.mechanism.model.cycle_input(&built.values).turn_s();
    let plan = ExponentPlan { transient_turns, turns, turn_s, settings: Settings::for_simulation() };
    let never = AtomicBool::new(false);
    largest_exponent(&built.mechanism, &built.sample(), &plan, None, &never)
        .unwrap_or_else(|failure| panic!("{failure}"))
}

/// A slider between spring, damper and a swinging force: neighbours differ by a free oscillation, which decays as
/// exp(-d t/(2 m)).
#[test]
fn analytic_exponent_of_a_linear_oscillator() {
    let built = build(&file("oscillator.toml"));
    let record = exponent(&built, 0.0, 40);
    let expected_1_s = -4.0 / (2.0 * 0.7);
    assert!(record.lower_1_s < expected_1_s && expected_1_s < record.upper_1_s, "{record:?}");
    assert!((record.exponent_1_s - expected_1_s).abs() < 5e-3 * expected_1_s.abs(), "{record:?}");
    assert_eq!(record.kind, NeighbourKind::Meet);
}

/// θ'' + θ'/2 + sin θ = 1.5 cos(2τ/3), a chaotic pendulum (Baker and Gollub 1990), in units of 1/ω0.
/// `cases/oracle/exponent.py` integrates the equation of small differences: 0.11290 with a standard error of 0.00028.
#[test]
fn peer_exponent_of_the_driven_pendulum() {
    let built = build(
        r#"
name = "driven pendulum"
gravity = "9.81 m/s^2"
[parameter]
arm = "210 mm"
mass = "0.8 kg"
own = "3.1e-3 kg m^2"
inertia = "own + mass * arm^2"
pace = "sqrt(mass * 9.81 m/s^2 * arm / inertia)"
[body.ground]
points = { o = ["0 mm", "0 mm"] }
[body.bob]
mass = "mass"
inertia = "own"
centre_of_mass = ["0 mm", "-arm"]
points = { hook = ["0 mm", "0 mm"] }
[joint.hinge]
kind = "revolute"
bearing = "ground.o"
journal = "bob.hook"
[spring.brake]
kind = "torsional"
joint = "hinge"
stiffness = "0 N m/rad"
free_angle = "0 deg"
damping = "inertia * pace / 2 / 1 rad"
[load.motor]
kind = "torque"
body = "bob"
torque = { mean = "0 N m", amplitude = "1.5 * inertia * pace^2", frequency = "2/3 * pace / (2 * pi)", phase = "90 deg" }
[initial.joint.hinge]
angle = "30 deg"
angular_velocity = "0.4 rad/s"
[cycle]
duration = "2 * pi / (2/3 * pace)"
[output.angle]
angle_of = "bob"
"#,
    );
    let record = exponent(&built, 20.0, 400);
    let pace_1_s = (0.8_f64 * 9.81 * 0.21 / (3.1e-3 + 0.8 * 0.21 * 0.21)).sqrt();
    let [lower, upper] = [record.lower_1_s, record.upper_1_s].map(|bound_1_s| bound_1_s / pace_1_s);
    assert!(lower < 0.1129 && 0.1129 < upper, "{lower} to {upper}");
    // Narrow enough to tell something.
    assert!(upper - lower < 0.05, "{lower} to {upper}");
    assert_eq!(record.kind, NeighbourKind::Part);
}

/// The slider-crank of Flores at 5000 rpm: differences grow about tenfold per half turn with a play of 0.5 mm; with 0.05 mm the
/// motion repeats itself every second turn.
#[test]
fn identity_neighbours_part_in_a_chaotic_slider_crank_and_meet_in_a_periodic_one() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
    let text = std::fs::read_to_string(path).expect("the case is there");
    let of = |clearance: &str, turns: u32| exponent(&build(&text.replace("0.5 mm", clearance)), 6.0, turns);
    let chaotic = of("0.5 mm", 20);
    assert_eq!(chaotic.kind, NeighbourKind::Part, "{chaotic:?}");
    // Half a turn, in powers of ten.
    let tenfold = 0.5 * chaotic.growth_per_turn() / std::f64::consts::LN_10;
    assert!((0.7..1.8).contains(&tenfold), "{chaotic:?}");
    let periodic = of("0.05 mm", 40);
    assert_eq!(periodic.kind, NeighbourKind::Meet, "{periodic:?}");
    // Every second turn has the same growth, and a batch is two turns: the mean is sharp.
    assert!(periodic.standard_error_1_s < 1e-2 * periodic.exponent_1_s.abs(), "{periodic:?}");
}
