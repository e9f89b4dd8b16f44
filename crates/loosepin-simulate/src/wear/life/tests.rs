//! Coupled cycles against those of another program, which has the same foundation, splines and jumps (RK4 in absolute coordinates).

use super::{LifePlan, run_cycle, wear};
use crate::engine::run_from;
use crate::motion::Layout;
use crate::observer::{Observer, Step};
use crate::reference::IdealReference;
use crate::resume::MotionState;
use crate::settings::{Settings, Window};
use crate::wear::jumps::{Depths, JumpLength, Life, life};
use crate::wear::{WearRecorder, WearingJoint};
use loosepin_mechanics::contact::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, Values};
use std::sync::atomic::AtomicBool;

const MODEL: &str = include_str!("../../../../../cases/slider_crank_5000/model.toml");
/// Time, angle of the rod, abscissa of the slider and their rates, friction path, force and deepest penetration of a settled turn on the
/// unworn shape.
const FIRST_TURN: &str = include_str!("../../../tests/files/wear_cycles_first_turn.csv");
/// Depths of the 360 sectors of bearing and journal after 4000 cycles, by 32 jumps.
const PROFILE: &str = include_str!("../../../tests/files/wear_cycles_profile.csv");

fn rows(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    text.lines().skip(1).map(row).collect()
}

/// The slider-crank at 300 rpm under -500 N along x on its slider, whose gudgeon has 0.1 mm of play and wears.
struct Pressed {
    mechanism: Mechanism,
    values: Values,
    sample: Sample<f64>,
}

impl Pressed {
    fn new(sectors: usize) -> Self {
        let joint = format!(
            "radial_clearance = \"0.1 mm\"\nbearing_length = \"20 mm\"\nwear.sectors = {sectors}\n\
             wear.bearing.coefficient = \"2e-14 m^2/N\"\nwear.journal.coefficient = \"1e-14 m^2/N\"\n"
        );
        let text = MODEL.replace("radial_clearance = \"0.5 mm\"\n", &joint).replace("5000 rpm", "300 rpm")
            + "\n[load.press]\nkind = \"force\"\npoint = \"slider.pin\"\ndirection = \"180 deg\"\nforce = \"500 N\"\n\
               [wear]\ncycles = 4000\ngeometry = \"worn\"\n";
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|complaints| panic!("{complaints}"));
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
        let sample = Sample::new(&mechanism, &values).unwrap_or_else(|error| panic!("{error}"));
        Self { mechanism, values, sample }
    }

    /// The start of the other program: in contact, v0 held at 1 mm/s.
    fn settled(&self) -> MotionState {
        let row = &rows(FIRST_TURN)[0];
        let layout = Layout::new(&self.mechanism, &self.sample);
        let mut state = vec![0.0; layout.length()];
        // Free coordinates: the slider along its guide, and the angle of the rod.
        let (start, _) = self.mechanism.start(&self.sample).expect("it starts");
        assert!(start.len() == 3 && (start[0] - 0.17).abs() < 1e-12, "{start:?}");
        (state[0], state[1], state[2], state[3]) = (row[2], row[1], row[4], row[3]);
        let contact = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1e3, effective_mass_kg: 0.0 };
        MotionState::new(&layout, &state, 0.0, vec![contact])
    }

    fn life(&self, length: JumpLength, tolerance_m: f64) -> Life {
        let settings = Settings { tolerance_m, ..Settings::for_simulation() };
        let window = Window { start_s: 0.0, end_s: 0.2 };
        let plan = LifePlan { values: &self.values, window, turns: 1.0, settings: &settings };
        let joints = WearingJoint::all(&self.mechanism, &self.values);
        let start: Depths = joints.iter().map(|joint| [0, 1].map(|_| vec![0.0; joint.sectors])).collect();
        let (ideal, ideal_sample) = (self.mechanism.without_play(), self.sample.clone().without_play());
        let mut sample = self.sample.clone();
        let stop = AtomicBool::new(false);
        life(4000.0, length, start, &mut |depths_m| {
            wear(&mut sample, &joints, depths_m);
            let reference = IdealReference::new(&ideal, &ideal_sample, window.end_s, &settings)?;
            let cycle = run_cycle(&self.mechanism, &sample, reference, &plan, &stop, Some(self.settled()))?;
            println!("W {:?} N_s {:.1}", cycle.paths_j, cycle.stable_cycles);
            Ok(cycle)
        })
        .unwrap_or_else(|failure| panic!("{failure}"))
    }
}

/// Sees positions at the times of the other program, and the wear.
struct Beside {
    rows: Vec<Vec<f64>>,
    next: usize,
    largest: [f64; 4],
    wear: WearRecorder,
}

impl Observer for Beside {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        while let Some(row) = self.rows.get(self.next).filter(|row| row[0] <= step.end_s) {
            self.next += 1;
            if row[0] < step.start_s {
                continue;
            }
            let dynamics = step.evaluate(row[0]);
            let (coordinates, rates) = dynamics.free_state();
            let force_n = dynamics.contacts()[0].normal_n;
            let contact = dynamics.contacts()[0];
            let at = step.foundation(0, 0, row[0]).expect("a foundation");
            let mut sums = [0.0; 6];
            let all = at.foundation.load(&at.motion, at.inverse_impact_speed_s_m, &mut |own| {
                let arm = 0.5 * (at.motion.eccentricity_m.length() - 1e-4);
                sums[0] += own.force_n * own.sliding_m_s.abs();
                sums[1] += own.force_n * (own.sliding_m_s + 0.0 * arm).abs();
                sums[2] += own.force_n;
            });
            let elastic = at.foundation.load(&at.motion, 0.0, &mut |_| {});
            println!("{} force {} theirs {} W' {} all {:?} el {:?} sum {:?} v0 {}", row[0], contact.normal_n, row[6], contact.spread_path_w.unwrap(), all, elastic, sums, at.inverse_impact_speed_s_m);
            println!("motion {:?}", at.motion);
            let dynamics = step.evaluate(row[0]);
            let (coordinates, rates) = dynamics.free_state();
            let found = [coordinates[1], coordinates[0], rates[1], force_n];
            for (largest, (found, expected)) in
                self.largest.iter_mut().zip(found.iter().zip([row[1], row[2], row[3], row[6]]))
            {
                *largest = largest.max((found - expected).abs());
            }
        }
        self.wear.step(step);
    }
}

#[test]
fn peer_the_unworn_foundation_over_a_part_of_a_turn() {
    let pressed = Pressed::new(360);
    let tolerance_m = std::env::var("TOL").map_or(1e-7, |text| text.parse().unwrap());
    let settings = Settings { tolerance_m, ..Settings::for_simulation() };
    let (window, rows) = (Window { start_s: 0.0, end_s: 0.01 }, rows(FIRST_TURN));
    let wear = WearRecorder::new(&pressed.mechanism, &pressed.values);
    let mut beside = Beside { rows: rows[..21].to_vec(), next: 0, largest: [0.0; 4], wear };
    let (mechanism, resume) = (&pressed.mechanism, Some(pressed.settled()));
    let started = std::time::Instant::now();
    let report = run_from(mechanism, &pressed.sample, &window, &settings, resume, &mut beside)
        .unwrap_or_else(|failure| panic!("{failure}"));
    let path_j = report.friction_paths[0].path_j;
    println!("{:?} {:?} {path_j} {:?} {:?}", started.elapsed(), report.counters, beside.largest, beside.wear.profiles[0].total_j/path_j-1.0);
    assert!((path_j - rows[20][5]).abs() < 1e-8, "{path_j} {}", rows[20][5]);
}

#[test]
#[ignore = "a campaign: minutes"]
fn peer_four_thousand_cycles() {
    let tolerance_m = std::env::var("TOL").map_or(1e-7, |text| text.parse().unwrap());
    let jumps = std::env::var("JUMPS").map_or(64, |text| text.parse().unwrap());
    let sectors = std::env::var("SECTORS").map_or(360, |text| text.parse().unwrap());
    let length = if jumps == 0 { JumpLength::Controlled { tolerance_m: std::env::var("JTOL").unwrap().parse().unwrap() } } else { JumpLength::Equal(jumps) };
    let life = Pressed::new(sectors).life(length, tolerance_m);
    let greatest_m = |side: usize| life.last().depths_m[0][side].iter().copied().fold(0.0, f64::max);
    println!("V_i {:e} V_j {:e} depths {:e} {:e} runs {} error {:e} over stable {}", 2e-14 * life.paths_j[0], 1e-14 * life.paths_j[0], greatest_m(0), greatest_m(1), life.runs, life.largest_error_m, life.longest_over_stable);
    let profile = rows(PROFILE);
    for side in [0, 1] {
        let own = &life.last().depths_m[0][side];
        if own.len() == profile.len() {
            let off = profile.iter().zip(own).map(|(row, own)| (row[1 + side] - own).abs()).fold(0.0, f64::max);
            println!("side {side} off {off:e}");
        }
    }
}
