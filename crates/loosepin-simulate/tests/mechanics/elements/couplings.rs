//! Gears, belts, racks and other ratios.

use super::{Built, build, file, report};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, RowOwner};
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Round-off of angles of a few turns, rad, and of their rates over those.
const ROUND_OFF: f64 = 1e-12;
/// Error of the motion over half a second within the tolerance of a simulation, relative.
const MOTION: f64 = 1e-8;

/// Two wheels and a carriage on the ground, with `elements`.
fn wheels(elements: &str) -> String {
    format!(
        r#"
name = "wheels"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], p = ["65 mm", "0 mm"], q = ["0 mm", "-20 mm"] }}
[body.first]
mass = "0.3 kg"
inertia = "2e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ shaft = ["0 mm", "0 mm"] }}
[body.second]
mass = "0.7 kg"
inertia = "9e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ shaft = ["0 mm", "0 mm"] }}
[body.carriage]
mass = "0.4 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["3 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.first]
kind = "revolute"
bearing = "ground.o"
journal = "first.shaft"
[joint.second]
kind = "revolute"
bearing = "ground.p"
journal = "second.shaft"
[joint.rail]
kind = "prismatic"
guide = {{ point = "ground.q", angle = "0 deg" }}
slider = "carriage.pin"
[coupling.rack]
kind = "rack"
first = "second"
second = "rail"
radius = "24 mm"
direction = "backward"
offset = "7 mm"
{elements}
"#
    )
}

/// Couplings between the two wheels, with the ratio of their speeds.
const BETWEEN: [(&str, f64); 5] = [
    ("kind = \"gears\"\nmesh = \"external\"\nteeth = [20, 45]", -20.0 / 45.0),
    ("kind = \"gears\"\nmesh = \"internal\"\nradii = [\"23 mm\", \"61 mm\"]", 23.0 / 61.0),
    ("kind = \"belt\"\nradii = [\"23 mm\", \"31 mm\"]", 23.0 / 31.0),
    ("kind = \"belt\"\nrun = \"crossed\"\nteeth = [17, 29]", -17.0 / 29.0),
    ("kind = \"ratio\"\nratio = 1.7", 1.7),
];

fn between(coupling: &str) -> String {
    format!("[coupling.between]\n{coupling}\nfirst = \"first\"\nsecond = \"second\"\noffset = \"25 deg\"\n")
}

#[test]
fn analytic_driven_wheels_keep_their_ratio_in_position_velocity_and_acceleration() {
    for (coupling, ratio) in BETWEEN {
        let drive = "[drive.first]\njoint = \"first\"\nmotion = { kind = \"polynomial\", coefficients = [\"100 deg\", \"30 rad/s\", \"40 rad/s^2\"] }\n[cycle]\nduration = \"0.5 s\"";
        let built = build(&wheels(&format!("{}{drive}", between(coupling))));
        assert_eq!((built.mechanism.degrees_of_freedom, built.mechanism.is_ideal()), (1, true));
        assert_eq!(built.mechanism.other_assemblies_rad, Vec::<Vec<f64>>::new(), "{coupling}");
        let sample = built.sample();
        let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        let slot = |body: usize| built.mechanism.ideal.slot_of_body[body];
        for time_s in [0.0, 0.07, 0.31, 0.5] {
            ideal.move_to(time_s).expect("it moves");
            let first = [100_f64.to_radians() + 30.0 * time_s + 40.0 * time_s * time_s, 30.0 + 80.0 * time_s, 80.0];
            let second = [ratio * first[0] + 25_f64.to_radians(), ratio * first[1], ratio * first[2]];
            let (pose, twist) = (&ideal.kinematics().poses[slot(2)], &ideal.kinematics().twists[slot(2)]);
            let found = [pose.angle_rad(), twist.angular, ideal.acceleration(slot(2)).angular];
            let (pose, twist) = (&ideal.kinematics().poses[slot(3)], &ideal.kinematics().twists[slot(3)]);
            let slid = [pose.position_m.x, twist.linear.x, ideal.acceleration(slot(3)).linear.x];
            for k in 0..3 {
                let scale = second[k].abs().max(1.0);
                assert!((found[k] - second[k]).abs() < ROUND_OFF * scale, "{coupling}: {found:?} {second:?}");
                let due = -0.024 * second[k] + if k == 0 { 0.007 } else { 0.0 };
                assert!((slid[k] - due).abs() < ROUND_OFF * scale, "{coupling}: {slid:?} {due}");
            }
            // What the drive needs: the inertia of everything that hangs on it.
            let (coordinates, rates) = ideal.real_state();
            let n = built.mechanism.real.free;
            dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], &[]);
            let inertia = 2e-4 + ratio * ratio * (9e-4 + 0.4 * 0.024 * 0.024);
            assert!((dynamics.drive_force(0) - inertia * 80.0).abs() < 1e-12, "{coupling}");
        }
    }
}

/// Angles of the first two bodies at the ends of all steps.
struct Ends(Vec<(f64, [f64; 2])>);

impl Observer for Ends {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let time_s = step.end_s;
        let dynamics = step.evaluate(time_s);
        let slots = &dynamics.mechanism().real.slot_of_body;
        let angles = [1, 2].map(|body| dynamics.kinematics.poses[slots[body]].angle_rad());
        self.0.push((time_s, angles));
    }
}

/// A torque on the first wheel accelerates all: J = J1 + k² (J2 + m r²).
#[test]
fn analytic_a_torque_moves_all_that_is_coupled() {
    for (coupling, ratio) in BETWEEN {
        let torque = "[load.pull]\nkind = \"torque\"\nbody = \"first\"\ntorque = \"0.03 N m\"\n[initial.joint.second]\nangle = \"40 deg\"\nangular_velocity = \"3 rad/s\"\n[cycle]\nduration = \"0.5 s\"";
        let built = build(&wheels(&format!("{}{torque}", between(coupling))));
        let inertia = 2e-4 + ratio * ratio * (9e-4 + 0.4 * 0.024 * 0.024);
        let exact = |t: f64| {
            let start = 15_f64.to_radians() / ratio;
            start + 3.0 / ratio * t + 0.5 * 0.03 / inertia * t * t
        };
        let mut ends = Ends(Vec::new());
        let window = Window { start_s: 0.0, end_s: 0.5 };
        let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends)
            .unwrap_or_else(|failure| panic!("{failure}"));
        for (time_s, angles) in &ends.0 {
            assert!((angles[0] - exact(*time_s)).abs() < MOTION * exact(0.5), "{coupling} at {time_s}: {angles:?}");
            let due = ratio * angles[0] + 25_f64.to_radians();
            assert!((angles[1] - due).abs() < ROUND_OFF * due.abs().max(1.0), "{coupling}: {angles:?} {due}");
        }
        let account = report.energy.expect("it is integrated");
        assert!(account.relative_residual() < ACCOUNT && account.supplied_j.abs() > 1e-3, "{coupling}: {account:?}");
    }
}

/// Sun, planet and ring on a carrier; (ω_sun - ω_carrier)/(ω_ring - ω_carrier) = -z_ring/z_sun.
#[test]
fn published_willis_equation_of_a_planetary_gear() {
    let wheel = |name: &str| {
        format!(
            "[body.{name}]\nmass = \"0.3 kg\"\ninertia = \"2e-4 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\npoints = {{ o = [\"0 mm\", \"0 mm\"], pin = [\"36 mm\", \"0 mm\"] }}\n"
        )
    };
    let joint = |name: &str, bearing: &str, journal: &str| {
        format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n")
    };
    let drive = |name: &str, speed: f64| {
        format!("[drive.{name}]\njoint = \"{name}\"\nspeed = \"{speed} rad/s\"\nstart_angle = \"10 deg\"\n")
    };
    let mesh = |first: &str, second: &str, mesh: &str, teeth: &str| {
        format!(
            "[coupling.{first}]\nkind = \"gears\"\nfirst = \"{first}\"\nsecond = \"{second}\"\nmesh = \"{mesh}\"\nteeth = {teeth}\n"
        )
    };
    let head = "name = \"planetary gear\"\ngravity = \"0 m/s^2\"\n[body.ground]\npoints = { o = [\"0 mm\", \"0 mm\"] }\n[cycle]\nduration = \"0.1 s\"\n";
    let bodies = ["carrier", "sun", "planet"].map(wheel).concat();
    let joints = [
        joint("carrier", "ground.o", "carrier.o"),
        joint("sun", "carrier.o", "sun.o"),
        // Turned round: the carrier's side is the journal.
        joint("planet", "planet.o", "carrier.pin"),
    ]
    .concat();
    let sun = mesh("sun", "planet", "external", "[20, 16]");
    // The ring is the ground, or turns on the carrier.
    let fixed = [mesh("carrier", "planet", "internal", "[52, 16]"), drive("carrier", 30.0)].concat();
    let turning = [
        wheel("ring"),
        joint("ring", "carrier.o", "ring.o"),
        mesh("ring", "planet", "internal", "[52, 16]"),
        drive("carrier", 30.0),
        drive("sun", 47.0),
    ]
    .concat();
    for (text, has_ring) in [(fixed, false), (turning, true)] {
        let built = build(&[head, &bodies, &joints, &sun, &text].concat());
        assert_eq!(built.mechanism.degrees_of_freedom, if has_ring { 2 } else { 1 });
        let sample = built.sample();
        let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
        for time_s in [0.0, 0.04] {
            ideal.move_to(time_s).expect("it moves");
            let speed = |body: usize| ideal.kinematics().twists[built.mechanism.ideal.slot_of_body[body]].angular;
            let (carrier, sun, planet) = (speed(1), speed(2), speed(3));
            let ring = if has_ring { speed(4) } else { 0.0 };
            assert!((carrier - 30.0).abs() < ROUND_OFF * 30.0);
            assert!(((sun - carrier) / (ring - carrier) + 52.0 / 20.0).abs() < ROUND_OFF, "{sun} {ring}");
            assert!(((planet - carrier) / (sun - carrier) + 20.0 / 16.0).abs() < ROUND_OFF, "{planet} {sun}");
        }
    }
}

/// Gears in a mechanism with play, friction and a moving drive: the account closes, and the gears stay in mesh.
#[test]
fn identity_a_coupling_does_no_net_work_beside_play() {
    let built = build(&file("geared_pendulum.toml"));
    assert_eq!((built.mechanism.degrees_of_freedom, built.mechanism.model.drives.len()), (2, 1));
    let mut ends = Ends(Vec::new());
    let window = Window { start_s: 0.0, end_s: 0.4 };
    let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends)
        .unwrap_or_else(|failure| panic!("{failure}"));
    for (time_s, [pinion, arm]) in &ends.0 {
        // External gears turn against each other; the joint of the arm counts backwards, from the arm, and so does its offset.
        let due = -(18.0 / 41.0) * pinion - 70_f64.to_radians();
        assert!((arm - due).abs() < ROUND_OFF, "at {time_s}: {arm} {due}");
    }
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT && account.contact_loss_j > 1e-6, "{account:?}");
    assert!(report.plays[0].contacts > 3);
}

#[test]
fn what_couplings_repeat_or_contradict_is_told() {
    let model = |elements: &str| {
        let text = wheels(elements);
        Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
    };
    let coupling = between(BETWEEN[0].0);
    let cycle = "[cycle]\nduration = \"0.5 s\"\n";
    let drive = |name: &str, angle: &str| {
        format!("[drive.{name}]\njoint = \"{name}\"\nspeed = \"1 rad/s\"\nstart_angle = \"{angle}\"\n")
    };
    let both = model(&[&coupling, &drive("first", "0 deg"), &drive("second", "0 deg"), cycle].concat());
    assert_eq!(
        Mechanism::new(&both, &both.quantities.nominal()).expect_err("it is refused").to_string(),
        "the links cannot close at the start, drive 'first' at 0 deg: coupling 'between' stays 25 deg open at best, from 48 positions tried"
    );
    let twice = coupling.replace("between", "again");
    let repeated = model(&[&coupling, &twice, &drive("first", "0 deg"), cycle].concat());
    let mechanism = Mechanism::new(&repeated, &repeated.quantities.nominal()).expect("it moves");
    assert_eq!(mechanism.redundant.len(), 1);
    let (owner, count) = mechanism.redundant[0];
    assert!(matches!(owner, RowOwner::Coupling(_)) && count == 1, "{owner:?}");
    let driven = Built { values: repeated.quantities.nominal(), mechanism };
    assert_eq!(report(&driven, 0.1).energy, None, "it follows its drive");
}
