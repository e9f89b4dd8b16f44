//! Journals that do not start in the middle of their bearings.

use super::{Built, build};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, PlayId};
use loosepin_simulate::{Observer, Onset, Plan, Settings, Step, Window, run, simulate};

/// Crank and rod turn, m and m/s: round-off of a start.
const ROUND_OFF: f64 = 1e-12;

/// A slider-crank with play in the crank pin and in the gudgeon, at 40° of its crank, with `initial` behind it.
fn slider_crank(initial: &str) -> String {
    format!(
        r#"
name = "slider-crank with two clearances"
gravity = "9.81 m/s^2"
[body.ground]
points = {{ o = ["0 mm", "0 mm"] }}
[body.crank]
mass = "0.30 kg"
inertia = "1.1e-4 kg m^2"
centre_of_mass = ["25 mm", "0 mm"]
points = {{ main = ["0 mm", "0 mm"], pin = ["52 mm", "0 mm"] }}
[body.rod]
mass = "0.21 kg"
inertia = "2.5e-4 kg m^2"
centre_of_mass = ["61 mm", "0 mm"]
points = {{ big_end = ["0 mm", "0 mm"], small_end = ["123 mm", "0 mm"] }}
[body.slider]
mass = "0.14 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = {{ pin = ["0 mm", "0 mm"] }}
[contact.steel]
law = "flores"
restitution = 0.6
youngs_modulus = "207 GPa"
poisson_ratio = 0.3
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"
[joint.crank_pin]
kind = "revolute"
bearing = "crank.pin"
journal = "rod.big_end"
bearing_radius = "11 mm"
radial_clearance = "0.2 mm"
contact = "steel"
[joint.gudgeon]
kind = "revolute"
bearing = "rod.small_end"
journal = "slider.pin"
bearing_radius = "10 mm"
radial_clearance = "0.5 mm"
contact = "steel"
[joint.guide]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slider.pin"
[drive.crank]
joint = "main"
speed = "300 rpm"
start_angle = "40 deg"
[assembly]
guess = {{ rod = "-10 deg" }}
{initial}
[cycle]
drive = "crank"
recorded_turns = 0.05
samples_per_turn = 200
[output.slider]
position_of = "slider.pin"
along = "x"
"#
    )
}

/// Places and velocities of the journals in their bearings at time zero, and the speed of the first contact of each.
struct Start {
    places: Vec<[Vec2<f64>; 2]>,
    first_contacts_m_s: Vec<Option<f64>>,
}

impl Observer for Start {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        if !self.places.is_empty() {
            return;
        }
        let dynamics = step.evaluate(step.start_s);
        let (mechanism, sample) = (dynamics.mechanism(), dynamics.sample());
        for (id, play) in mechanism.plays.iter().zip(&sample.plays) {
            let PlayId::Joint(joint) = *id else { continue };
            let slots = mechanism.model.joints[joint.0].kind.bodies().map(|body| mechanism.real.slot_of_body[body.0]);
            let [bearing, journal] = [0, 1].map(|side| {
                let arm = [play.bearing_arm_m, play.journal_arm_m][side];
                let (pose, twist) = (dynamics.kinematics.poses[slots[side]], dynamics.kinematics.twists[slots[side]]);
                [pose.point_m(arm), twist.at(pose.turn(arm))]
            });
            self.places.push([journal[0] - bearing[0], journal[1] - bearing[1]]);
        }
    }

    fn contact_begins(&mut self, onset: &Onset) {
        self.first_contacts_m_s[onset.contact].get_or_insert(onset.speed_m_s);
    }
}

fn start_of(built: &Built, end_s: f64) -> Start {
    let mut start = Start { places: Vec::new(), first_contacts_m_s: vec![None; 2] };
    let window = Window { start_s: 0.0, end_s };
    run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut start)
        .unwrap_or_else(|failure| panic!("{failure}"));
    start
}

fn assert_near(found: Vec2<f64>, expected: [f64; 2], tolerance: f64) {
    let off = (found - Vec2::new(expected[0], expected[1])).length();
    assert!(off < tolerance, "{found:?} is {off:e} from {expected:?}");
}

#[test]
fn identity_a_loop_starts_with_its_journals_where_they_are_placed() {
    let given = "[initial.joint.crank_pin]\noffset = [\"0.05 mm\", \"-0.13 mm\"]\n\
                 [initial.joint.gudgeon]\noffset = [\"-0.21 mm\", \"0.34 mm\"]\noffset_velocity = [\"31 mm/s\", \"-7 mm/s\"]\n";
    let start = start_of(&build(&slider_crank(given)), 1e-5);
    let [crank_pin, gudgeon] = [start.places[0], start.places[1]];
    assert_near(crank_pin[0], [5e-5, -1.3e-4], ROUND_OFF);
    assert_near(crank_pin[1], [0.0, 0.0], ROUND_OFF);
    assert_near(gudgeon[0], [-2.1e-4, 3.4e-4], ROUND_OFF);
    assert_near(gudgeon[1], [0.031, -0.007], ROUND_OFF);
    // Elsewhere nothing is opened: the slider stays on its line, the crank at its angle (drives hold both by construction).
    let centred = start_of(&build(&slider_crank("")), 1e-5);
    for place in centred.places {
        assert_near(place[0], [0.0, 0.0], ROUND_OFF);
        assert_near(place[1], [0.0, 0.0], ROUND_OFF);
    }
}

/// The usual start of the literature, for example [SC16]: the centres of pin and hole coincide, with the velocities of the ideal mechanism.
#[test]
fn published_centres_that_coincide_are_what_is_started_from_without_a_word() {
    let given = "[initial.joint.gudgeon]\noffset = [\"0 mm\", \"0 mm\"]\noffset_velocity = [\"0 m/s\", \"0 m/s\"]\n";
    let values = [given, ""].map(|initial| {
        let built = build(&slider_crank(initial));
        let record = simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model));
        record.unwrap_or_else(|failure| panic!("{failure}")).record.outputs[0].value_si.clone()
    });
    assert_eq!(values[0], values[1]);
}

/// What lies still under its weight alone rests at the lower side of its bearing: the journal of the crank pin under rod and slider at a
/// crank that hardly turns, that of the gudgeon where the guide takes a part of it.
#[test]
fn analytic_a_resting_journal_begins_without_a_fall() {
    /// A fall through the clearance of 0.5 mm ends at √(2 g 2c), m/s.
    const FALL_M_S: f64 = 0.14;
    /// Speed of the first touch, a millionth of the clearance away, m/s: √(2 · 1e-6 c · a) with a of 1 m/s² is 3e-5.
    const TOUCH_M_S: f64 = 2e-4;
    let slow = |initial: &str| build(&slider_crank(initial).replace("300 rpm", "0.01 rpm"));
    let both = "[initial.joint.crank_pin]\nstart = \"resting\"\n[initial.joint.gudgeon]\nstart = \"resting\"\n";
    let rested = start_of(&slow(both), 0.02);
    for (place, clearance_m) in rested.places.iter().zip([2e-4, 5e-4]) {
        assert!((place[0].length() / clearance_m - 1.0).abs() < 2e-6, "{place:?}");
    }
    // The crank pin bears most of the rod: its journal, the rod's eye, lies below the centre of the hole.
    assert!(rested.places[0][0].y < -0.9 * 2e-4, "{:?}", rested.places[0]);
    for speed_m_s in &rested.first_contacts_m_s {
        assert!(speed_m_s.is_some_and(|speed_m_s| speed_m_s < TOUCH_M_S), "{:?}", rested.first_contacts_m_s);
    }
    let fallen = start_of(&slow(""), 0.05);
    let fastest = fallen.first_contacts_m_s.iter().flatten().fold(0.0_f64, |fastest, speed| fastest.max(*speed));
    assert!(fastest > 0.1 * FALL_M_S, "{fastest}");
}

#[test]
fn offsets_that_do_not_fit_are_refused() {
    let long = build(&slider_crank("[initial.joint.gudgeon]\noffset = [\"0.3 mm\", \"-0.41 mm\"]\n"));
    assert_eq!(
        Sample::<f64>::new(&long.mechanism, &long.values).expect_err("it is refused").to_string(),
        "initial: joint 'gudgeon': offset is 0.5080354 mm long; must be at most the radial clearance of 0.5 mm"
    );
    let complaints = |text: &str| Model::from_text("model.toml", text).expect_err("it is refused").to_string();
    let beside = complaints(&slider_crank("[initial.joint.main]\noffset = [\"0 mm\", \"0.1 mm\"]\n"));
    assert!(
        beside
            .contains("'offset' needs a journal in its bearing; joint 'main' is not a revolute joint with a clearance"),
        "{beside}"
    );
    let twice =
        complaints(&slider_crank("[initial.joint.gudgeon]\nstart = \"resting\"\noffset = [\"0 mm\", \"0.1 mm\"]\n"));
    assert!(twice.contains("'offset' cannot be used with 'start'"), "{twice}");
    // A rod that just reaches: with both journals pulled together it does not.
    let text = slider_crank(
        "[initial.joint.crank_pin]\noffset = [\"0 mm\", \"0.2 mm\"]\n[initial.joint.gudgeon]\noffset = [\"0 mm\", \"0.5 mm\"]\n",
    );
    let text = text.replace("start_angle = \"40 deg\"", "start_angle = \"90 deg\"").replace("123 mm", "52.1 mm");
    let built = build(&text.replace("rod = \"-10 deg\"", "rod = \"-80 deg\""));
    let failure = built.mechanism.start(&built.sample()).expect_err("it cannot close").to_string();
    assert!(failure.starts_with("the links cannot close at 0 ms, drive 'crank' at 90 deg: "), "{failure}");
}

/// Where forces move the mechanism an offset is possible, a velocity in the bearing is not.
#[test]
fn a_velocity_in_the_bearing_needs_drives() {
    let free = |initial: &str| {
        let text = slider_crank(initial);
        let (before, rest) = text.split_once("[drive.crank]").expect("it has a drive");
        let (_, after) = rest.split_once("[assembly]").expect("it has guesses");
        let initial = "[initial.joint.main]\nangle = \"40 deg\"\nangular_velocity = \"3 rad/s\"\n";
        let text = format!("{before}{initial}[assembly]{after}");
        text.replace("drive = \"crank\"\nrecorded_turns = 0.05", "duration = \"5 ms\"")
    };
    let model = |text: &str| Model::from_text("model.toml", text).unwrap_or_else(|complaints| panic!("{complaints}"));
    let moving = model(&free("[initial.joint.gudgeon]\noffset_velocity = [\"1 mm/s\", \"0 m/s\"]\n"));
    assert_eq!(
        Mechanism::new(&moving, &moving.quantities.nominal()).expect_err("it is refused").to_string(),
        "initial: joint 'gudgeon': offset velocity can be given only if the drives determine the motion"
    );
    let placed = start_of(&build(&free("[initial.joint.gudgeon]\noffset = [\"0.1 mm\", \"-0.2 mm\"]\n")), 1e-5);
    assert_near(placed.places[1][0], [1e-4, -2e-4], 1e-11);
}
