//! Requirements of drawn mechanisms: four-bars in space with play in both balls, and four-bars in the plane with a link of unknown length,
//! each with a limit that has room and one that has none. What is true comes from closed forms alone: many mechanisms are drawn with the unknown
//! values at their worst, which for one loop with two balls is the largest play with the coupler stretched or shortened by all of it.

use super::ball_four_bar::{FourBar, MM, Vector, dot, minus, quantile, unit};
use crate::silent::run;
use loosepin::result::study::Verdict;
use loosepin::space::SpatialModel;
use loosepin::study::{Study, StudyModel};
use loosepin::uncertainty::{hash, uniform};
use std::fmt::Write;

/// Positions of the cycle.
const POSITIONS: usize = 12;
/// Mechanisms that say what is true of one: the share outside is known to 0.1 % where it is 1 %.
const MECHANISMS: u64 = 20_000;
/// Limits in terms of the true quantile at the required share.
const WITH_ROOM: f64 = 1.2;
const WITHOUT: f64 = 0.8;

fn angles(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |position| std::f64::consts::TAU * position as f64 / count as f64)
}

/// Draws one that turns all the way, stays away from its dead centres and swings by less than half a turn.
fn draw(number: impl Fn(u64) -> f64 + Copy, is_in_space: bool) -> FourBar {
    for trial in 0.. {
        let within = |place: u64, low: f64, high: f64| low + (high - low) * number(100 * trial + place);
        let about = |place: u64| within(place, -1.0, 1.0);
        let (crank_m, rocker_m) = (within(0, 30.0, 70.0) * MM, within(1, 90.0, 160.0) * MM);
        let axis = if is_in_space { unit([about(2), about(3), about(4)]) } else { [0.0, 0.0, 1.0] };
        let free = [about(5), about(6), if is_in_space { about(7) } else { 0.0 }];
        let arm = unit(minus(free, axis.map(|x| x * dot(free, axis))));
        let height_m = if is_in_space { 80.0 * about(10) * MM } else { 0.0 };
        let pivot_m = [within(8, 150.0, 260.0) * MM, 80.0 * about(9) * MM, height_m];
        let ball_m = [0, 1, 2].map(|k| pivot_m[k] + rocker_m * arm[k]);
        let reach = minus(ball_m, [crank_m, 0.0, 0.0]);
        let lengths_m = [crank_m, rocker_m, dot(reach, reach).sqrt()];
        let deviations_m = [11, 12, 13].map(|place| within(place, 0.01, 0.05) * MM);
        let angles_rad = angles(POSITIONS).collect();
        let mut own = FourBar { lengths_m, deviations_m, pivot_m, axis, arm, side: 1.0, angles_rad };
        if own.rocker(lengths_m, 0.0).0.abs() > 1e-6 {
            own.side = -1.0;
        }
        let at: Vec<(f64, f64)> = own.angles_rad.iter().map(|&angle| own.rocker(lengths_m, angle)).collect();
        let is_regular = angles(360).all(|angle| own.rocker(lengths_m, angle).1.abs() < 0.85);
        if is_regular && at[0].0.abs() < 1e-6 && at.iter().all(|(angle, _)| angle.abs() < 1.5) {
            return own;
        }
    }
    unreachable!("some of all mechanisms turn")
}

fn random(own: &FourBar) -> String {
    let names = ["crank", "rocker", "coupler"].iter().zip(own.deviations_m);
    let line = |(name, deviation_m): (&&str, f64)| {
        format!("\"parameter.{name}\" = {{ normal = {{ standard_deviation = \"{} mm\" }} }}\n", deviation_m / MM)
    };
    names.map(line).collect()
}

/// Numbers as text with enough digits to be the same again.
fn vector(v: Vector, unit: &str, size: f64) -> String {
    format!("[{}]", v.map(|x| format!("\"{:.17e}{unit}\"", x / size)).join(", "))
}

fn in_space(own: &FourBar) -> StudyModel {
    let FourBar { lengths_m, pivot_m, axis, arm, .. } = own;
    let [crank_mm, rocker_mm, coupler_mm] = lengths_m.map(|length| length / MM);
    let ball_m = [0, 1, 2].map(|k| pivot_m[k] + lengths_m[1] * arm[k]);
    let along = unit(minus(ball_m, [lengths_m[0], 0.0, 0.0]));
    let scaled = |name: &str, v: Vector| format!("[{}]", v.map(|x| format!("\"{name} * ({x:.17e})\"")).join(", "));
    let text = format!(
        "name = \"four-bar\"\ngeometry = \"space\"\n\
         [parameter]\ncrank = \"{crank_mm:.17e} mm\"\nrocker = \"{rocker_mm:.17e} mm\"\ncoupler = \"{coupler_mm:.17e} mm\"\n\
         first = \"0.01 mm\"\nsecond = \"0.01 mm\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], p = {} }}\naxes = {{ skew = {} }}\n\
         [body.crank]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], pin = [\"crank\", \"0 mm\", \"0 mm\"] }}\n\
         [body.coupler]\npoints = {{ a = [\"0 mm\", \"0 mm\", \"0 mm\"], b = {} }}\n\
         [body.rocker]\npoints = {{ o = [\"0 mm\", \"0 mm\", \"0 mm\"], ball = {} }}\naxes = {{ skew = {} }}\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"crank.o\"\naxis = \"z\"\n\
         [joint.pivot]\nkind = \"revolute\"\nbearing = \"ground.p\"\njournal = \"rocker.o\"\naxis = \"skew\"\n\
         [joint.a]\nkind = \"spherical\"\nbearing = \"crank.pin\"\njournal = \"coupler.a\"\nradial_clearance = \"first\"\n\
         [joint.b]\nkind = \"spherical\"\nbearing = \"rocker.ball\"\njournal = \"coupler.b\"\nradial_clearance = \"second\"\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"0 deg\"\n\
         [cycle]\ndrive = \"crank\"\nsamples_per_turn = {POSITIONS}\n\
         [output.rocker]\nturn_of = \"rocker\"\nabout = \"skew\"\n",
        vector(*pivot_m, " mm", MM),
        vector(*axis, "", 1.0).replace('"', ""),
        scaled("coupler", along),
        scaled("rocker", *arm),
        vector(*axis, "", 1.0).replace('"', ""),
    );
    SpatialModel::from_text("model.toml", &text).unwrap_or_else(|found| panic!("{found}\n{text}")).into()
}

fn in_the_plane(own: &FourBar) -> StudyModel {
    let FourBar { lengths_m, pivot_m, arm, .. } = own;
    let [crank_mm, rocker_mm, coupler_mm] = lengths_m.map(|length| length / MM);
    let start_deg = arm[1].atan2(arm[0]).to_degrees();
    let mut text = format!(
        "name = \"four-bar\"\ngravity = \"0 m/s^2\"\n\
         [parameter]\ncrank = \"{crank_mm:.17e} mm\"\nrocker = \"{rocker_mm:.17e} mm\"\ncoupler = \"{coupler_mm:.17e} mm\"\nlonger = \"0 mm\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"], p = [\"{:.17e} mm\", \"{:.17e} mm\"] }}\n\
         [body.crank]\nmass = \"0.2 kg\"\ninertia = \"1e-4 kg m^2\"\ncentre_of_mass = [\"10 mm\", \"0 mm\"]\n\
         points = {{ o = [\"0 mm\", \"0 mm\"], pin = [\"crank\", \"0 mm\"] }}\n\
         [body.coupler]\nmass = \"0.5 kg\"\ninertia = \"3e-3 kg m^2\"\ncentre_of_mass = [\"70 mm\", \"0 mm\"]\n\
         points = {{ a = [\"0 mm\", \"0 mm\"], b = [\"coupler + longer\", \"0 mm\"] }}\n\
         [body.rocker]\nmass = \"0.4 kg\"\ninertia = \"1e-3 kg m^2\"\ncentre_of_mass = [\"50 mm\", \"0 mm\"]\n\
         points = {{ o = [\"0 mm\", \"0 mm\"], pin = [\"rocker\", \"0 mm\"] }}\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"0 deg\"\n\
         [assembly]\nguess = {{ rocker = \"{start_deg} deg\" }}\n\
         [cycle]\ndrive = \"crank\"\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = {POSITIONS}\n\
         [output.rocker]\nangle_of = \"rocker\"\n",
        pivot_m[0] / MM,
        pivot_m[1] / MM
    );
    for (name, bearing, journal) in [
        ("main", "ground.o", "crank.o"),
        ("pivot", "ground.p", "rocker.o"),
        ("a", "crank.pin", "coupler.a"),
        ("b", "rocker.pin", "coupler.b"),
    ] {
        let _ = write!(text, "[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n");
    }
    let source = loosepin::diagnostics::Source::new("model.toml", &text);
    StudyModel::from_source(source).unwrap_or_else(|found| panic!("{found}\n{text}"))
}

/// A question about a drawn mechanism, and the two limits.
struct Case {
    model: StudyModel,
    inputs: String,
    deviation: &'static str,
    share: f64,
    quantile_rad: f64,
}

impl Case {
    /// Play in both balls, of one size or of two.
    fn in_space(seed: u64, index: u64) -> Self {
        let key = hash(seed, 2 * index);
        let own = draw(|k| uniform(key, k), true);
        let extra = hash(key, 1);
        let within = |place: u64, low: f64, high: f64| low + (high - low) * uniform(extra, place);
        let share = [0.95, 0.99][(index % 2) as usize];
        let plays = [0, 1].map(|place| (within(2 * place, 0.02, 0.1), within(2 * place + 1, 0.1, 0.9)));
        let mut inputs = format!("[random]\n{}[epistemic]\n", random(&own));
        for ((most_mm, least), name) in plays.into_iter().zip(["first", "second"]) {
            let _ = writeln!(
                inputs,
                "\"parameter.{name}\" = {{ interval = [\"{:.17e} mm\", \"{most_mm:.17e} mm\"] }}",
                least * most_mm
            );
        }
        let longer_m = (plays[0].0 + plays[1].0) * MM;
        let all = own.drawn(MECHANISMS, hash(key, 2), &[longer_m, -longer_m]);
        Self { model: in_space(&own), inputs, deviation: "total", share, quantile_rad: quantile(&all, share) }
    }

    /// A coupler that is longer or shorter by what is unknown.
    fn in_the_plane(seed: u64, index: u64) -> Self {
        let key = hash(seed, 2 * index + 1);
        let own = draw(|k| uniform(key, k), false);
        let most_mm = 0.05 + 0.15 * uniform(hash(key, 1), 0);
        let inputs = format!(
            "[random]\n{}[epistemic]\n\"parameter.longer\" = {{ interval = [\"{:.17e} mm\", \"{most_mm:.17e} mm\"] }}\n",
            random(&own),
            -most_mm
        );
        let share = [0.95, 0.99][(index % 2) as usize];
        let of = |longer_m: f64| quantile(&own.drawn(MECHANISMS, hash(key, 2), &[longer_m]), share);
        let quantile_rad = of(most_mm * MM).max(of(-most_mm * MM));
        Self { model: in_the_plane(&own), inputs, deviation: "dimensional", share, quantile_rad }
    }

    /// The verdicts with room and without, and the shares that are shown.
    fn verdicts(&self) -> [(Verdict, f64); 2] {
        let mut text = format!("name = \"drawn\"\nmodel = \"model.toml\"\n{}", self.inputs);
        for of_quantile in [WITH_ROOM, WITHOUT] {
            let _ = write!(
                text,
                "[[require]]\noutput = \"rocker\"\nof = \"{}\"\nwithin = \"{:.17e} rad\"\nover = \"cycle\"\nprobability_at_least = {}\n",
                self.deviation,
                of_quantile * self.quantile_rad,
                self.share
            );
        }
        let study = Study::from_text("study.toml", &text, self.model.clone());
        let study = study.unwrap_or_else(|found| panic!("{found}\n{text}"));
        let found = run(&study).result.requirements;
        [0, 1].map(|k| (found[k].verdict, found[k].probability[0]))
    }
}

/// How often a limit was met, not met and undecided.
#[derive(Debug, Default, PartialEq)]
struct Counts {
    met: usize,
    not_met: usize,
    undecided: usize,
}

impl Counts {
    fn count(&mut self, verdict: Verdict) {
        match verdict {
            Verdict::Met => self.met += 1,
            Verdict::NotMet => self.not_met += 1,
            Verdict::Undecided | Verdict::Promised => self.undecided += 1,
        }
    }
}

/// Verdicts with room and without over `count` mechanisms, printed one by one.
fn campaign(name: &str, draw: impl Fn(u64, u64) -> Case, seed: u64, count: u64) -> [Counts; 2] {
    let mut counts = [Counts::default(), Counts::default()];
    for index in 0..count {
        let case = draw(seed, index);
        let found = case.verdicts();
        println!("{name} {index}: {} % required: with room {:?}, without {:?}", 100.0 * case.share, found[0], found[1]);
        for (counts, (verdict, _)) in counts.iter_mut().zip(found) {
            counts.count(verdict);
        }
    }
    println!("{name}, seed {seed}: with room {:?}, without {:?}", counts[0], counts[1]);
    counts
}

/// Short versions of `just campaign drawn-requirements`, of which these are other mechanisms.
const SEED: u64 = 75;

#[test]
fn analytic_requirements_of_drawn_mechanisms_in_space_are_met_with_room_and_not_without() {
    let [with_room, without] = campaign("space", Case::in_space, SEED, 2);
    assert_eq!(with_room, Counts { met: 2, ..Counts::default() });
    assert_eq!(without, Counts { not_met: 2, ..Counts::default() });
}

/// Of this mechanism, whose lengths scatter more than the unknown one is unknown, 256 are too few to show 95 % (94.6 %).
#[test]
fn analytic_requirements_of_a_drawn_mechanism_in_the_plane_are_never_judged_wrongly() {
    let [with_room, without] = campaign("plane", Case::in_the_plane, SEED, 1);
    assert_eq!(with_room.not_met, 0, "{with_room:?}");
    assert_eq!(without, Counts { not_met: 1, ..Counts::default() });
}

/// Seed and number of mechanisms: `LOOSEPIN_SEED=7 LOOSEPIN_MECHANISMS=100`.
#[test]
#[ignore = "minutes: just campaign drawn-requirements"]
fn analytic_campaign_of_requirements_of_drawn_mechanisms() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let (seed, count) = (number("LOOSEPIN_SEED", 1), number("LOOSEPIN_MECHANISMS", 100));
    for (name, draw) in [("space", Case::in_space as fn(u64, u64) -> Case), ("plane", Case::in_the_plane)] {
        let [with_room, without] = campaign(name, draw, seed, count);
        assert_eq!((with_room.not_met, without.met), (0, 0), "{name}: wrong verdicts");
        assert!(20 * with_room.undecided <= count as usize, "{name}: {with_room:?}");
    }
}
