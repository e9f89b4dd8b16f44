//! Coupled cycles against those of two other programs, which have the same foundation, splines and jumps: the given one, whose surfaces slide
//! with R_i and R_j, and `cases/oracle/worn_cycles`, which repeats its numbers and also has the radii of (14).

use super::{LifePlan, run_cycle, wear};
use crate::engine::run_from;
use crate::ideal::reference::IdealReference;
use crate::lanes::batch::CompiledCodeCache;
use crate::observer::{Observer, Step};
use crate::resume::MotionState;
use crate::settings::{Settings, Window};
use crate::stepping::motion::Layout;
use crate::wear::jumps::{Depths, JumpLength, Life, life};
use crate::wear::{WearRecorder, WearingJoint};
use loosepin_math::Vec2;
use loosepin_mechanics::contact::{FoundationMotion, PlayState};
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Model, Values};
use std::f64::consts::PI;
use std::sync::atomic::AtomicBool;

const MODEL: &str = include_str!("../../../../../cases/slider_crank_5000/model.toml");
/// Time, angle of the rod, abscissa of the slider and their rates, friction path, force and deepest penetration of a settled turn on the
/// unworn shape.
const FIRST_TURN: &str = include_str!("../../../tests/files/wear_cycles_first_turn.csv");
/// Depths of the 360 sectors of bearing and journal after 4000 cycles, by 32 jumps.
const PROFILE: &str = include_str!("../../../tests/files/wear_cycles_profile.csv");
/// The same columns on the unworn shape and on that one, by `cases/oracle/worn_cycles` with the sliding radii of (14) and steps of 1 µs.
const OWN_UNWORN_TURN: &str = include_str!("../../../tests/files/wear_cycles_unworn_turn.csv");
const OWN_WORN_TURN: &str = include_str!("../../../tests/files/wear_cycles_worn_turn.csv");
/// Radial clearance, length of the rod, m, speed of the crank pin, m/s, and load, N.
const CLEARANCE_M: f64 = 1e-4;
const ROD_LENGTH_M: f64 = 0.12;
const PIN_SPEED_M_S: f64 = 0.05 * 10.0 * PI;
const LOAD_N: f64 = 500.0;

fn rows(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    text.lines().skip(1).map(row).collect()
}

/// The slider-crank at 300 rpm under -500 N along x on its slider, whose gudgeon has 0.1 mm of play and wears.
struct ContactSample {
    mechanism: Mechanism,
    values: Values,
    sample: Sample<f64>,
}

impl ContactSample {
    fn new(sectors: usize) -> Self {
        let joint = format!(
            "radial_clearance = \"0.1 mm\"\nbearing_length = \"20 mm\"\nwear.sectors = {sectors}\n\
             wear.bearing.coefficient = \"2e-14 m^2/N\"\nwear.journal.coefficient = \"1e-14 m^2/N\"\n"
        );
        let text = MODEL.replace("radial_clearance = \"0.5 mm\"\n", &joint).replace("5000 rpm", "300 rpm")
            + "\n[load.press]\nkind = \"force\"\npoint = \"slider.pin\"\ndirection = \"180 deg\"\nforce = \"500 N\"\n\
               [wear]\ncycles = 4000\ngeometry = \"worn\"\n";
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{error}"));
        let sample = Sample::new(&mechanism, &values).unwrap_or_else(|error| panic!("{error}"));
        Self { mechanism, values, sample }
    }

    /// With the shape that the given program has after 4000 cycles.
    fn worn() -> Self {
        let mut pressed = Self::new(360);
        let depths_m = [1, 2].map(|side| rows(PROFILE).iter().map(|row| row[side]).collect());
        let joints = WearingJoint::all(&pressed.mechanism, &pressed.values);
        wear(&mut pressed.sample, &joints, &vec![depths_m]);
        pressed
    }

    /// In contact at the outer dead centre, v0 held at 1 mm/s; abscissa of the slider and angle of the rod, and their rates.
    fn in_contact(&self, [slider_m, rod_rad, slider_m_s, rod_rad_s]: [f64; 4]) -> MotionState {
        let layout = Layout::new(&self.mechanism, &self.sample);
        let mut state = vec![0.0; layout.length()];
        // Free coordinates: the slider along its guide, and the angle of the rod.
        let (start, _) = self.mechanism.start(&self.sample).expect("it starts");
        assert!(start.len() == 3 && (start[0] - 0.17).abs() < 1e-12, "{start:?}");
        (state[0], state[1], state[2], state[3]) = (slider_m, rod_rad, slider_m_s, rod_rad_s);
        let contact = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1e3, effective_mass_kg: 0.0 };
        MotionState::new(&layout, &state, 0.0, vec![contact])
    }

    /// Pressed as deep into the shape of `sample` as the load at rest presses the journal, nothing swinging: a turn from here is settled
    /// after some milliseconds, without ever leaving contact.
    fn at_rest(&self, sample: &Sample<f64>) -> MotionState {
        let foundation = sample.plays[0].foundation.as_deref().expect("a foundation");
        let bears = |distance_m: f64| {
            let motion = FoundationMotion {
                eccentricity_m: Vec2::new(-distance_m, 0.0),
                rate_m_s: Vec2::zero(),
                turn_rad: 0.0,
                spins_rad_s: [0.0; 2],
            };
            foundation.load(&motion, 0.0, &mut |_| {}).on_journal_n.x > LOAD_N
        };
        let [mut low_m, mut high_m] = [CLEARANCE_M, 2.0 * CLEARANCE_M];
        for _ in 0..50 {
            let middle_m = 0.5 * (low_m + high_m);
            if bears(middle_m) { high_m = middle_m } else { low_m = middle_m }
        }
        let rod_rad_s = -PIN_SPEED_M_S / (ROD_LENGTH_M - high_m);
        self.in_contact([0.17 - high_m, 0.0, 0.0, rod_rad_s])
    }

    /// Jumps over 4000 cycles; each cycle is the second turn from rest.
    fn life(&self, length: JumpLength, tolerance_m: f64) -> Life {
        let settings = Settings { tolerance_m, ..Settings::for_simulation() };
        let window = Window { start_s: 0.2, end_s: 0.4 };
        let plan = LifePlan { values: &self.values, window, turns: 1.0, settings: &settings };
        let joints = WearingJoint::all(&self.mechanism, &self.values);
        let start: Depths = joints.iter().map(|joint| [0, 1].map(|_| vec![0.0; joint.sectors])).collect();
        let (ideal, ideal_sample) = (self.mechanism.without_play(), self.sample.clone().without_play());
        let mut sample = self.sample.clone();
        let stop = AtomicBool::new(false);
        life(4000.0, length, start, &mut |depths_m| {
            wear(&mut sample, &joints, depths_m);
            let reference = IdealReference::new(&ideal, &ideal_sample, window.end_s, &settings)?;
            let cycle = run_cycle(&self.mechanism, &sample, reference, &plan, &stop, Some(self.at_rest(&sample)))?;
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
    largest: [f64; 3],
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
            let found = [coordinates[1], coordinates[0], rates[1]];
            for (largest, (found, expected)) in self.largest.iter_mut().zip(found.iter().zip([row[1], row[2], row[3]]))
            {
                *largest = largest.max((found - expected).abs());
            }
        }
        self.wear.step(step);
    }
}

/// The first 10 ms of a turn beside `rows` of another program; friction paths at two tolerances, J.
fn part_of_a_turn(pressed: &ContactSample, rows: &[Vec<f64>]) -> [f64; 2] {
    let window = Window { start_s: 0.0, end_s: 0.01 };
    [1e-7, 1e-8].map(|tolerance_m| {
        let settings = Settings { tolerance_m, ..Settings::for_simulation() };
        let wear = WearRecorder::new(&pressed.mechanism, &pressed.values);
        let mut beside = Beside { rows: rows[..21].to_vec(), next: 0, largest: [0.0; 3], wear };
        let resume = pressed.in_contact([rows[0][2], rows[0][1], rows[0][4], rows[0][3]]);
        let report = run_from(
            &pressed.mechanism,
            &pressed.sample,
            (&window, &settings),
            Some(resume),
            &mut CompiledCodeCache::default(),
            &mut beside,
        )
        .unwrap_or_else(|failure| panic!("{failure}"));
        assert_eq!(beside.next, 21);
        let [rod_rad, slider_m, rod_rad_s] = beside.largest;
        assert!(rod_rad < 1e-12 && slider_m < 1e-11 && rod_rad_s < 1e-7, "{:?}", beside.largest);
        let path_j = report.friction_paths[0].path_j;
        // Two quadratures of one path, and the sectors that add up to it.
        let profile = &beside.wear.profiles[0];
        assert!((profile.total_j / path_j - 1.0).abs() < 1e-8, "{} {path_j}", profile.total_j);
        for side in [0, 1] {
            let sum_j: f64 = profile.path_j[side].iter().sum();
            assert!((sum_j / profile.total_j - 1.0).abs() < 1e-12, "{sum_j}");
        }
        path_j
    })
}

/// Of friction paths beside the second program, relative: its table has twelve digits.
const PATH_TOLERANCE: f64 = 1e-10;

#[test]
fn peer_the_unworn_foundation_over_a_part_of_a_turn() {
    // Its step halved changes positions by 3e-11 m over the turn, its table has twelve digits. Its path has other radii.
    part_of_a_turn(&ContactSample::new(360), &rows(FIRST_TURN));
}

#[test]
fn peer_friction_path_of_the_unworn_foundation() {
    let rows = rows(OWN_UNWORN_TURN);
    let paths_j = part_of_a_turn(&ContactSample::new(360), &rows);
    assert!(paths_j.iter().all(|path_j| (path_j / rows[20][5] - 1.0).abs() < PATH_TOLERANCE), "{paths_j:?}");
}

#[test]
fn peer_a_worn_foundation_over_a_part_of_a_turn() {
    let rows = rows(OWN_WORN_TURN);
    let paths_j = part_of_a_turn(&ContactSample::worn(), &rows);
    assert!(paths_j.iter().all(|path_j| (path_j / rows[20][5] - 1.0).abs() < PATH_TOLERANCE), "{paths_j:?}");
}

/// `LIFE_JUMPS`, or 0 with `LIFE_TOLERANCE_M`; `LIFE_SECTORS`; `LIFE_PEER`, a folder with life.csv and depths.csv of
/// `cases/oracle/worn_cycles` for as many jumps, or for 256 beside controlled ones: for `just campaign worn-cycles`.
#[test]
#[ignore = "a campaign: minutes to an hour"]
fn peer_four_thousand_cycles() {
    let number = |name: &str, default: f64| {
        std::env::var(name).map_or(default, |text| text.parse().unwrap_or_else(|_| panic!("{name} is a number")))
    };
    let folder = std::env::var("LIFE_PEER").expect("LIFE_PEER is a folder");
    let table = |name: &str| {
        let text =
            std::fs::read_to_string(format!("{folder}/{name}")).unwrap_or_else(|error| panic!("{name}: {error}"));
        rows(&text)
    };
    let (peer, peer_depths) = (table("life.csv"), table("depths.csv"));
    let (jumps, sectors) = (number("LIFE_JUMPS", 64.0) as usize, number("LIFE_SECTORS", 360.0) as usize);
    let tolerance_m = number("LIFE_TOLERANCE_M", 2e-8);
    let length = match jumps {
        0 => JumpLength::Controlled { tolerance_m },
        jumps => JumpLength::Equal(jumps),
    };
    assert_eq!(peer_depths.len(), sectors);
    assert!(peer.len() == if jumps == 0 { 257 } else { jumps + 1 }, "{} rows", peer.len());
    let life = ContactSample::new(sectors).life(length, 1e-6);
    let last = life.last();
    let volumes_m3 = [2e-14, 1e-14].map(|coefficient_m2_n| coefficient_m2_n * life.paths_j[0]);
    let peer_end = &peer[peer.len() - 1];
    println!("{} jumps, {} cycles run, {sectors} sectors", life.points.len() - 1, life.runs);
    println!("error of a jump {:e} m, longest over N_s {:.2}", life.largest_error_m, life.longest_over_stable);
    let off_volumes = [0, 1].map(|side| volumes_m3[side] / peer_end[2 + side] - 1.0);
    println!("volumes {volumes_m3:?} m³, off by {off_volumes:?} of them");
    let paths_j = [life.points[0].cycle.paths_j[0], last.cycle.paths_j[0]];
    let off_paths = [paths_j[0] / peer[0][1] - 1.0, paths_j[1] / peer_end[1] - 1.0];
    println!("friction path of the first and the last cycle {paths_j:?} J, off by {off_paths:?} of them");
    let off_depths_m = [0, 1].map(|side| {
        let pairs = peer_depths.iter().zip(&last.depths_m[0][side]);
        pairs.map(|(row, own_m)| (row[1 + side] - own_m).abs()).fold(0.0, f64::max)
    });
    let greatest_m = [0, 1].map(|side| last.depths_m[0][side].iter().copied().fold(0.0, f64::max));
    println!("greatest depths {greatest_m:?} m; depths off by {off_depths_m:?} m");
    // The longest sliding paths of a sector in the given program's first turn, by its table with the load along the rod: a sector of
    // the bearing below it slides all the way, R_i ∫|ω| dt = 17.2 mm; the journal's while the patch passes, 7.19 mm. Inertia, 9.9 N of
    // 500 N, turns the load by about a degree from the rod.
    let stable_cycles = 1.0 / (6.699618949e12 * (2e-14 * 17.2e-3 + 1e-14 * 7.19e-3));
    let found = life.points[0].cycle.stable_cycles;
    println!("N_s {found:.1} ({stable_cycles:.1})");
    assert!(sectors != 360 || (found / stable_cycles - 1.0).abs() < 0.01, "{found} {stable_cycles}");
    // The error of a jump grows as the square of its length, and so does that of all of them.
    let tolerance = if jumps == 0 { 1e-5 * (tolerance_m / 2e-8).max(1.0) } else { 1e-6 };
    assert!(off_volumes.iter().all(|off| off.abs() < tolerance), "{off_volumes:?}");
    assert!(off_paths[0].abs() < 1e-7, "{off_paths:?}");
    // With equal jumps both programs have the same error. (18) is that of Euler's jump; what Heun's jumps add up to is smaller.
    let of_depths_m = if jumps == 0 { life.largest_error_m } else { 1e-6 * greatest_m[0] };
    assert!(off_depths_m.iter().all(|off_m| *off_m < of_depths_m), "{off_depths_m:?}");
}
