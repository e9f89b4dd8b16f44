//! Torque, force and power of drives and controls: against closed forms, and against the power balance.

use super::initial::simulated;
use super::{Built, build, file};
use loosepin_math::{Dual, Quintic};
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::Sample;
use loosepin_simulate::record::{Extreme, OutputHistory, SimulationRecord};
use loosepin_simulate::{Arms, GAUSS, Observer, Reading, Settings, Step, Window, columns, run};
use std::path::Path;

/// Round-off of a closed form and of a few dozen operations, relative.
const ROUND_OFF: f64 = 1e-12;
/// Share of the peak power by which the balance of powers may fail.
const BALANCE: f64 = 1e-9;
/// Share of the largest energy exchanged by which work that is integrated by looks inside of steps may fail: positions there are
/// known to the tolerance of the run, and contacts are stiff.
const WORK: f64 = 1e-7;
/// Tolerance of the runs, m: a hundredth of that of a simulation.
const TOLERANCE_M: f64 = 1e-11;
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

/// An actuator that pushes evenly: F is as stated, and its power F v = F² t / m.
#[test]
fn analytic_a_control_that_pushes_evenly() {
    let built = build(
        r#"
name = "sled"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["7 mm", "-3 mm"] }
[body.sled]
mass = "0.8 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["11 mm", "8 mm"]
points = { shoe = ["0 mm", "5 mm"] }
[joint.rail]
kind = "prismatic"
guide = { point = "ground.o", angle = "25 deg" }
slider = "sled.shoe"
[control.push]
joint = "rail"
proportional = "0 N/m"
feed_forward = "6 N"
motion = { kind = "polynomial", coefficients = ["0 m"] }
[cycle]
duration = "0.3 s"
samples_per_turn = 20
[output]
push = { force_of = "control.push" }
power = { power_of = "control.push" }
"#,
    );
    let record = simulated(&built).record;
    assert_eq!(output(&record, "power").words, "power of control push");
    assert_follows(&record, "push", |_| 6.0);
    assert_follows(&record, "power", |time_s| 6.0 * 6.0 * time_s / 0.8);
}

fn case(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name).join("model.toml");
    std::fs::read_to_string(path).expect("the case is there")
}

fn replaced(text: &str, own: &str, by: &str) -> String {
    assert!(text.contains(own), "{own}");
    text.replace(own, by)
}

/// Mechanisms with two clearances each, whose power outputs are the last ones: rigid cranks and rods with friction; springs, dampers
/// and loads; a rotary and a linear drive; two controls.
fn with_two_clearances() -> [(Built, f64); 4] {
    let power_of = |text: &str, actuators: &[&str]| {
        let outputs = actuators.iter().enumerate().map(|(k, of)| format!("[output.power{k}]\npower_of = \"{of}\"\n"));
        build(&format!("{text}\n{}", outputs.collect::<String>()))
    };
    let rubbing = replaced(
        &case("slider_crank_two_clearances"),
        "restitution = 0.65\n",
        "restitution = 0.65\nfriction = { law = \"ambrosio\", coefficient = 0.07 }\n",
    );
    let with_elements = replaced(
        &file("slider_crank_elements.toml"),
        "journal = \"rod.big_end\"\n",
        "journal = \"rod.big_end\"\nbearing_radius = \"13 mm\"\nradial_clearance = \"0.3 mm\"\ncontact = \"steel_pin\"\n",
    );
    let five_bar = replaced(
        &case("five_bar_driven_slider"),
        "journal = \"left_link.low\"\n",
        "journal = \"left_link.low\"\nbearing_radius = \"6 mm\"\nradial_clearance = \"0.1 mm\"\ncontact = \"steel\"\n",
    );
    [
        (power_of(&rubbing, &["drive.crank"]), 0.03),
        (power_of(&with_elements, &["drive.crank"]), 0.012),
        (power_of(&five_bar, &["drive.left", "drive.slide"]), 0.06),
        (power_of(TWO_LINK_ARM, &["control.shoulder", "control.elbow"]), 0.2),
    ]
}

const TWO_LINK_ARM: &str = r#"
name = "two-link arm with play"
gravity = "9.81 m/s^2"
[body.ground]
points = { o = ["10 mm", "20 mm"] }
[body.upper]
mass = "1.3 kg"
inertia = "4e-3 kg m^2"
centre_of_mass = ["110 mm", "7 mm"]
points = { eye = ["0 mm", "0 mm"], elbow = ["240 mm", "0 mm"] }
[body.lower]
mass = "0.7 kg"
inertia = "2e-3 kg m^2"
centre_of_mass = ["80 mm", "-4 mm"]
points = { elbow = ["0 mm", "0 mm"] }
[contact.bush]
restitution = 0.6
stiffness = "3e8 N/m^1.5"
exponent = 1.5
friction = { coefficient = 0.13 }
[joint.shoulder]
kind = "revolute"
bearing = "ground.o"
journal = "upper.eye"
bearing_radius = "11 mm"
radial_clearance = "0.15 mm"
contact = "bush"
[joint.elbow]
kind = "revolute"
bearing = "lower.elbow"
journal = "upper.elbow"
bearing_radius = "8 mm"
radial_clearance = "0.2 mm"
contact = "bush"
[control.shoulder]
joint = "shoulder"
proportional = "60 N m/rad"
derivative = "2 N m s/rad"
motion = { kind = "harmonic", mean = "40 deg", amplitude = "25 deg", frequency = "3 Hz" }
[control.elbow]
joint = "elbow"
proportional = "20 N m/rad"
integral = "30 N m/(rad s)"
derivative = "0.4 N m s/rad"
limit = "5 N m"
motion = { kind = "harmonic", mean = "-20 deg", amplitude = "30 deg", frequency = "5 Hz" }
[cycle]
duration = "0.2 s"
"#;

/// The power outputs of a mechanism, which have names of their own.
fn powers(built: &Built) -> Vec<Reading> {
    let all = columns(&built.mechanism).into_iter();
    all.filter(|column| column.name.starts_with("power")).map(|column| column.reading).collect()
}

/// What a run looks at: what its power outputs and loads supply, integrated over time, and the balance of powers on the way.
struct Balance<'l> {
    arms: Arms,
    powers: Vec<Reading>,
    /// The equations of motion at a state of the run.
    own: Dynamics<'l, f64>,
    /// The same on numbers that move along with the motion.
    moving: Dynamics<'l, Dual<f64>>,
    supplied_j: f64,
    peak_w: f64,
    defect_w: f64,
    in_contact: [usize; 3],
}

impl Balance<'_> {
    /// P - dE/dt - losses at a state of the run. Derivatives of the energies come from the motion alone, q̇ and q̈, by dual numbers;
    /// the roots of penetrations, which a run carries as unknowns, are read off the positions.
    fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64) {
        let contacts = step.set_state(time_s).mechanism().contacts.len();
        let closed: Vec<f64> = (0..contacts).map(|contact| f64::from(u8::from(step.is_in_contact(contact)))).collect();
        let seen = step.set_state(time_s);
        let (coordinates, rates) = seen.free_state();
        // Any speed of impact does: its energy loss is another one, and belongs to the balance.
        let touch = |&contact: &f64| PlayState { contact, inverse_impact_speed_s_m: 3.0, effective_mass_kg: 0.2 };
        let states: Vec<PlayState<f64>> = closed.iter().map(touch).collect();
        self.own.error_integrals_mut().copy_from_slice(seen.error_integrals());
        self.own.evaluate(time_s, coordinates, rates, &states);
        let supplied_w: f64 = self.powers.iter().map(|power| power.value(&self.arms, &self.own)).sum();
        let along = |values: &[f64], derivatives: &[f64]| -> Vec<Dual<f64>> {
            values.iter().zip(derivatives).map(|(&value, &derivative)| Dual { value, derivative }).collect()
        };
        let moving_rates = along(rates, self.own.accelerations());
        self.moving.set_state(Dual::variable(time_s), &along(coordinates, rates), &moving_rates);
        let energy = self.moving.energy_in(|contact| Dual::constant(closed[contact]));
        let of = self.own.powers();
        let lost_w = of.contact_loss_w + of.friction_loss_w + of.damping_loss_w;
        let defect_w = supplied_w + of.loads_w - energy.total_j().derivative - lost_w;
        self.peak_w = self.peak_w.max(supplied_w.abs());
        self.defect_w = self.defect_w.max(defect_w.abs());
        self.in_contact[closed.iter().filter(|closed| **closed > 0.0).count()] += 1;
        assert!(defect_w.is_finite());
    }
}

impl Observer for Balance<'_> {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        /// Parts of a step, each with Gauss's points.
        const PARTS: usize = 4;
        let [start, end] = [0, 1].map(|side| step.time(side));
        let time = Quintic::new(start, end, step.length);
        for part in 0..PARTS {
            for (place, weight) in GAUSS {
                let share = (part as f64 + place) / PARTS as f64;
                let dynamics = step.evaluate(time.value(share));
                let powers = self.powers.iter().map(|power| power.value(&self.arms, dynamics));
                let supplied_w = powers.sum::<f64>() + dynamics.powers().loads_w;
                self.supplied_j += weight / PARTS as f64 * time.slope(share) * supplied_w;
            }
        }
        let span_s = step.end_s - step.start_s;
        for place in [0.0, 0.3, 0.7, 1.0] {
            self.look(step, step.start_s + place * span_s);
        }
    }
}

/// What drives, controls and loads supply is what kinetic, potential and stored energy gain and what contact, friction and dampers
/// lose: at any instant, and from one event to the next over the whole run.
#[test]
fn identity_power_is_what_energies_gain_and_losses_take() {
    for (built, end_s) in with_two_clearances() {
        let name = &built.mechanism.model.name;
        let moving = Sample::<Dual<f64>>::new(&built.mechanism, &built.values).expect("the values fit");
        let mut balance = Balance {
            arms: Arms::new(&built.mechanism, &built.values),
            powers: powers(&built),
            own: Dynamics::new(&built.mechanism, &built.sample()),
            moving: Dynamics::new(&built.mechanism, &moving),
            supplied_j: 0.0,
            peak_w: 0.0,
            defect_w: 0.0,
            in_contact: [0; 3],
        };
        let settings = Settings { tolerance_m: TOLERANCE_M, ..Settings::for_simulation() };
        let window = Window { start_s: 0.0, end_s };
        let report = run(&built.mechanism, &built.sample(), &window, &settings, &mut balance)
            .unwrap_or_else(|failure| panic!("{name}: {failure}"));
        assert!(balance.in_contact.iter().all(|states| *states > 20), "{name}: {:?}", balance.in_contact);
        let share = balance.defect_w / balance.peak_w;
        let account = report.energy.expect("it is integrated");
        let lost_j = account.contact_loss_j + account.friction_loss_j + account.damping_loss_j;
        let gained_j = account.at_end_j - account.at_start_j + lost_j;
        let open_j = (balance.supplied_j - gained_j).abs() / account.largest_exchange_j;
        assert!(share < BALANCE, "{name}: {} W of {} W are missing", balance.defect_w, balance.peak_w);
        assert!(open_j < WORK, "{name}: {} J supplied, {gained_j} J gained and lost", balance.supplied_j);
    }
}
