//! Torque, force and power of drives and controls: against closed forms.

use super::build;
use super::initial::simulated;
use loosepin_simulate::record::{Extreme, OutputHistory, SimulationRecord};

/// Round-off of a closed form and of a few dozen operations, relative.
const ROUND_OFF: f64 = 1e-12;
const GRAVITY_M_S2: f64 = 9.81;

fn output<'r>(record: &'r SimulationRecord, name: &str) -> &'r OutputHistory {
    record.outputs.iter().find(|output| output.name == name).unwrap_or_else(|| panic!("there is no output {name}"))
}

fn extreme<'r>(record: &'r SimulationRecord, name: &str) -> &'r Extreme {
    record.extremes.iter().find(|extreme| extreme.name == name).unwrap_or_else(|| panic!("there is no output {name}"))
}

fn assert_follows(record: &SimulationRecord, name: &str, exact: impl Fn(f64) -> f64) {
    let size = record.time_s.iter().fold(0.0, |size: f64, &time_s| size.max(exact(time_s).abs()));
    for (&time_s, &value) in record.time_s.iter().zip(&output(record, name).value_si) {
        let exact = exact(time_s);
        assert!((value - exact).abs() < ROUND_OFF * size, "{name} at {time_s} s: {value}, not {exact}");
    }
}

/// A weight on a crank at constant speed: T = m g r cos φ, largest where the crank is level, which no row of the history is. The
/// other way round, with the pin on the ground, torque and angle have the other sign, and the power is the same.
#[test]
fn analytic_a_crank_lifts_a_weight() {
    let model = |bearing: &str, journal: &str, speed: &str, start: &str| {
        build(&format!(
            r#"
name = "hoist"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["7 mm", "-3 mm"] }}
[body.crank]
mass = "1.7 kg"
inertia = "3e-3 kg m^2"
centre_of_mass = ["130 mm", "0 mm"]
points = {{ eye = ["0 mm", "0 mm"] }}
[joint.main]
kind = "revolute"
bearing = "{bearing}"
journal = "{journal}"
[drive.motor]
joint = "main"
speed = "{speed}"
start_angle = "{start}"
[cycle]
drive = "motor"
transient_turns = 0
samples_per_turn = 37
[output]
torque = {{ torque_of = "drive.motor", unit = "N mm" }}
power = {{ power_of = "drive.motor" }}
"#
        ))
    };
    let (speed, start) = (11.0, 0.3);
    let torque = |time_s: f64| 1.7 * GRAVITY_M_S2 * 0.13 * (start + speed * time_s).cos();
    let largest = 1.7 * GRAVITY_M_S2 * 0.13;
    for (built, sign) in [
        (model("ground.o", "crank.eye", "11 rad/s", "0.3 rad"), 1.0),
        (model("crank.eye", "ground.o", "-11 rad/s", "-0.3 rad"), -1.0),
    ] {
        let record = simulated(&built).record;
        assert_eq!(record.outputs[0].words, "torque of drive motor");
        assert_eq!((record.outputs[0].unit.symbol(), record.outputs[1].unit.symbol()), ("N m", "W"));
        assert_follows(&record, "torque", |time_s| sign * torque(time_s));
        assert_follows(&record, "power", |time_s| speed * torque(time_s));
        let sampled = output(&record, "torque").value_si.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        assert!(sampled < largest * (1.0 - 1e-4), "a row lies at the extreme: {sampled}");
        let found = extreme(&record, "torque");
        for (value, exact) in [(found.maximum.value_si, largest), (found.minimum.value_si, -largest)] {
            assert!((value - exact).abs() < 1e-9 * largest, "{value}, not {exact}");
        }
    }
}

/// Three drives, named in another order than their joints: a weight that is pushed up a slope by F = m (a + g sin α), and two cranks
/// of other weights. Each output has the effort of its own drive.
#[test]
fn analytic_each_of_three_drives_has_its_own_effort() {
    let built = build(
        r#"
name = "three drives"
gravity = "9.81 m/s^2"
[body.ground]
points = { a = ["7 mm", "-3 mm"], b = ["400 mm", "20 mm"], c = ["-300 mm", "50 mm"] }
[body.long]
mass = "1.7 kg"
inertia = "3e-3 kg m^2"
centre_of_mass = ["130 mm", "0 mm"]
points = { eye = ["0 mm", "0 mm"] }
[body.carriage]
mass = "2.3 kg"
inertia = "4e-3 kg m^2"
centre_of_mass = ["11 mm", "8 mm"]
points = { shoe = ["0 mm", "5 mm"] }
[body.short]
mass = "0.9 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["70 mm", "0 mm"]
points = { eye = ["0 mm", "0 mm"] }
[joint.long]
kind = "revolute"
bearing = "ground.a"
journal = "long.eye"
[joint.slope]
kind = "prismatic"
guide = { point = "ground.b", angle = "25 deg" }
slider = "carriage.shoe"
[joint.short]
kind = "revolute"
bearing = "ground.c"
journal = "short.eye"
[drive.push]
joint = "slope"
motion = { kind = "polynomial", coefficients = ["3 mm", "0.2 m/s", "1.5 m/s^2", "-4 m/s^3"] }
[drive.short]
joint = "short"
speed = "-5 rad/s"
start_angle = "0.7 rad"
[drive.long]
joint = "long"
speed = "11 rad/s"
start_angle = "0.3 rad"
[cycle]
duration = "0.6 s"
samples_per_turn = 41
[output]
long = { torque_of = "drive.long" }
push = { force_of = "drive.push" }
short = { torque_of = "drive.short" }
pushing = { power_of = "drive.push" }
"#,
    );
    let record = simulated(&built).record;
    let force = |t: f64| 2.3 * (3.0 - 24.0 * t + GRAVITY_M_S2 * 25.0_f64.to_radians().sin());
    assert_eq!(
        (output(&record, "push").words.as_str(), output(&record, "push").unit.symbol()),
        ("force of drive push", "N")
    );
    assert_follows(&record, "long", |t| 1.7 * GRAVITY_M_S2 * 0.13 * (0.3 + 11.0 * t).cos());
    assert_follows(&record, "short", |t| 0.9 * GRAVITY_M_S2 * 0.07 * (0.7 - 5.0 * t).cos());
    assert_follows(&record, "push", force);
    assert_follows(&record, "pushing", |t| force(t) * (0.2 + 3.0 * t - 12.0 * t * t));
}

/// An actuator that pushes evenly, along a guide or a slot: F is as stated, and its power F v = F² t / m.
#[test]
fn analytic_a_control_that_pushes_evenly() {
    let guide = "kind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"25 deg\" }\nslider = \"sled.shoe\"";
    let slot = "kind = \"slot\"\nslot = { point = \"ground.o\", angle = \"25 deg\" }\npin = \"sled.shoe\"";
    let start = "[initial.joint.rail]\nposition = \"4 mm\"\n[initial.body.sled]\nangle = \"10 deg\"";
    for (joint, start) in [(guide, ""), (slot, start)] {
        let built = build(&format!(
            r#"
name = "sled"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["7 mm", "-3 mm"] }}
[body.sled]
mass = "0.8 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["11 mm", "8 mm"]
points = {{ shoe = ["11 mm", "8 mm"] }}
[joint.rail]
{joint}
[control.push]
joint = "rail"
proportional = "0 N/m"
feed_forward = "6 N"
motion = {{ kind = "polynomial", coefficients = ["0 m"] }}
{start}
[cycle]
duration = "0.3 s"
samples_per_turn = 20
[output]
push = {{ force_of = "control.push" }}
power = {{ power_of = "control.push" }}
"#
        ));
        let record = simulated(&built).record;
        assert_eq!(output(&record, "power").words, "power of control push");
        assert_follows(&record, "push", |_| 6.0);
        assert_follows(&record, "power", |time_s| 6.0 * 6.0 * time_s / 0.8);
    }
}
