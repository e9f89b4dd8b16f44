//! Gears and racks with backlash.

use super::{Built, build, file};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_simulate::{Observer, Onset, RunReport, Separation, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-8;
/// Error of speeds within the tolerance of a simulation, relative.
const SPEED: f64 = 1e-8;
/// Backlash, m.
const BACKLASH_M: f64 = 0.3e-3;
/// Torque on the first wheel, N m.
const TORQUE_N_M: f64 = 0.03;
/// Moments of inertia of both wheels, kg m², and mass of the rack, kg.
const INERTIAS_KG_M2: [f64; 2] = [2e-4, 9e-4];
const RACK_KG: f64 = 0.4;

/// A wheel under a torque, and what it drives by `coupling`.
fn driven_by_a_torque(coupling: &str, law: &str) -> Built {
    build(&format!(
        r#"
name = "wheels"
gravity = "0 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"], p = ["84 mm", "0 mm"], q = ["0 mm", "-20 mm"] }}
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
[body.rack]
mass = "0.4 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["3 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[contact.teeth]
{law}
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
slider = "rack.pin"
[coupling.mesh]
first = "first"
backlash = "0.3 mm"
contact = "teeth"
{coupling}
[coupling.other]
kind = "ratio"
first = "first"
ratio = {}
[load.pull]
kind = "torque"
body = "first"
torque = "0.03 N m"
[initial.joint.first]
angle = "0 deg"
angular_velocity = "0 rad/s"
[cycle]
duration = "0.1 s"
"#,
        if coupling.contains("rail") { "0\nsecond = \"second\"" } else { "\"0 mm/rad\"\nsecond = \"rail\"" }
    ))
}

/// Couplings with the slope f' and the inertia of what they drive, along its coordinate, and r.
const COUPLINGS: [(&str, f64, f64, f64); 3] = [
    (
        "kind = \"gears\"\nmesh = \"external\"\nsecond = \"second\"\nradii = [\"23 mm\", \"61 mm\"]\noffset = \"12 deg\"",
        -23.0 / 61.0,
        INERTIAS_KG_M2[1],
        0.061,
    ),
    (
        "kind = \"gears\"\nmesh = \"internal\"\nsecond = \"second\"\nradii = [\"23 mm\", \"61 mm\"]",
        23.0 / 61.0,
        INERTIAS_KG_M2[1],
        0.061,
    ),
    (
        "kind = \"rack\"\nsecond = \"rail\"\nradius = \"23 mm\"\ndirection = \"backward\"\noffset = \"7 mm\"",
        -0.023,
        RACK_KG,
        1.0,
    ),
];

/// Speeds of the first wheel and of the second joint at the ends of all steps, and the contacts.
#[derive(Default)]
struct Seen {
    speeds: Vec<(f64, [f64; 2])>,
    onsets: Vec<(f64, f64, usize)>,
    separations: Vec<(f64, f64)>,
}

impl Observer for Seen {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let time_s = step.end_s;
        let dynamics = step.evaluate(time_s);
        let slots = &dynamics.mechanism().real.slot_of_body;
        let twists = &dynamics.kinematics.twists;
        let is_rack = twists[slots[2]].angular == 0.0;
        let second = if is_rack { twists[slots[3]].linear.x } else { twists[slots[2]].angular };
        self.speeds.push((time_s, [twists[slots[1]].angular, second]));
    }
    fn contact_begins(&mut self, onset: &Onset) {
        self.onsets.push((onset.time_s, onset.speed_m_s, onset.contact));
    }
    fn contact_ends(&mut self, separation: &Separation) {
        self.separations.push((separation.time_s, separation.speed_m_s));
    }
}

fn followed(built: &Built, end_s: f64) -> (Seen, RunReport) {
    let mut seen = Seen::default();
    let window = Window { start_s: 0.0, end_s };
    let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut seen)
        .unwrap_or_else(|failure| panic!("{failure}"));
    (seen, report)
}

/// The first wheel crosses half of its backlash under the torque alone: c = r |f'| M t²/(2 J1). From then on J1 ω1 + f' I2 ω2 = M t,
/// whatever the law of contact; the wheels never leave their flanks by more than the law allows, and energy is accounted for.
#[test]
fn analytic_a_wheel_goes_through_its_backlash_and_shares_its_momentum() {
    const LAWS: [&str; 2] = [
        "law = \"flores\"\nrestitution = 0.5\nstiffness = \"4e9 N/m^1.5\"\nexponent = 1.5",
        "law = \"anagnostopoulos\"\nrestitution = 0.5\nstiffness = \"3e7 N/m\"",
    ];
    for (coupling, slope, inertia, lever) in COUPLINGS {
        for law in LAWS {
            let built = driven_by_a_torque(coupling, law);
            let (seen, report) = followed(&built, 0.1);
            let arm = lever * slope.abs();
            let first_s = (BACKLASH_M * INERTIAS_KG_M2[0] / (arm * TORQUE_N_M)).sqrt();
            let (time_s, speed_m_s, contact) = seen.onsets[0];
            assert!((time_s - first_s).abs() < 1e-10, "{coupling}: {time_s} {first_s}");
            let due_m_s = arm * TORQUE_N_M / INERTIAS_KG_M2[0] * first_s;
            assert!((speed_m_s - due_m_s).abs() < SPEED * due_m_s, "{coupling}: {speed_m_s} {due_m_s}");
            // The first wheel goes forwards: the second is behind where its coordinate should grow.
            let name = built.mechanism.contact_name(contact);
            assert_eq!(name, if slope > 0.0 { "mesh (behind)" } else { "mesh (ahead)" });
            for (time_s, [first, second]) in &seen.speeds {
                let momentum = INERTIAS_KG_M2[0] * first + slope * inertia * second;
                assert!(
                    (momentum - TORQUE_N_M * time_s).abs() < SPEED * TORQUE_N_M * 0.1,
                    "{coupling} at {time_s}: {momentum}"
                );
            }
            let account = report.energy.expect("it is integrated");
            assert!(account.relative_residual() < ACCOUNT && account.contact_loss_j > 1e-6, "{account:?}");
            assert!(report.plays[0].contacts > 3, "{coupling}: {:?}", report.plays);
        }
    }
}

/// A planetary gear and a rack on a moving frame.
#[test]
fn identity_angular_momentum_and_energy_of_gears_on_a_moving_carrier() {
    let text = file("planetary_backlash.toml");
    let built = build(&text);
    let (_, report) = followed(&built, 0.3);
    let account = report.energy.expect("it is integrated");
    assert!(account.relative_residual() < ACCOUNT && account.contact_loss_j > 1e-6, "{account:?}");
    assert!(report.plays.iter().all(|play| play.contacts > 3), "{:?}", report.plays);

    struct Momentum(Vec<f64>);
    impl Observer for Momentum {
        fn step(&mut self, step: &mut Step<'_, '_>) {
            let dynamics = step.end();
            let mechanism = dynamics.mechanism();
            let (kinematics, numbers) = (&dynamics.kinematics, &dynamics.sample().real.links);
            let of = |slot: usize| {
                let (pose, twist, link) = (&kinematics.poses[slot], &kinematics.twists[slot], &numbers[slot - 1]);
                let arm = pose.turn(link.centre_of_mass_m);
                let velocity = twist.at(arm);
                link.mass_kg * (pose.position_m + arm).cross(velocity) + link.inertia_kg_m2 * twist.angular
            };
            self.0.push((1..=mechanism.real.links.len()).map(of).sum());
        }
    }
    let mut momentum = Momentum(Vec::new());
    let window = Window { start_s: 0.0, end_s: 0.3 };
    run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut momentum)
        .unwrap_or_else(|failure| panic!("{failure}"));
    let start = momentum.0[0];
    assert!(start.abs() > 1e-3, "it turns");
    for found in &momentum.0 {
        assert!((found - start).abs() < SPEED * start.abs(), "{found} {start}");
    }
}

/// A backlash of zero is the ideal coupling; one that becomes zero is another mechanism.
#[test]
fn identity_without_backlash_a_coupling_is_ideal() {
    let law = "restitution = 0.5\nstiffness = \"4e9 N/m^1.5\"\nexponent = 1.5";
    let built = driven_by_a_torque(COUPLINGS[0].0, law);
    let model = &built.mechanism.model;
    let backlash = model.find("coupling.mesh.backlash").expect("it can be set");
    let values = model.quantities.evaluate(&[(backlash, 0.0)]).expect("zero is possible");
    let ideal = Mechanism::new(model, &values).expect("it is a mechanism");
    assert!(ideal.plays.is_empty() && ideal.real.couplings.len() == 2);
    assert_eq!((built.mechanism.plays.len(), built.mechanism.real.couplings.len()), (1, 1));
    let error = Sample::<f64>::new(&built.mechanism, &values).expect_err("another mechanism");
    assert_eq!(
        error.to_string(),
        "coupling 'mesh' has a backlash of 0 mm; the compiled mechanism treats it as a coupling with play"
    );
}
