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
/// Radius of the bearing and radial clearance, m.
const BEARING_RADIUS_M: f64 = 0.01;
const CLEARANCE_M: f64 = 1e-4;

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

#[test]
fn peer_the_unworn_foundation_over_a_part_of_a_turn() {
    // Of 10 ms; the other program's step halved changes positions by 3e-11 m over the turn, its table has twelve digits.
    let (rows, window) = (rows(FIRST_TURN), Window { start_s: 0.0, end_s: 0.01 });
    let pressed = Pressed::new(360);
    let paths_j = [1e-7, 1e-8].map(|tolerance_m| {
        let settings = Settings { tolerance_m, ..Settings::for_simulation() };
        let wear = WearRecorder::new(&pressed.mechanism, &pressed.values);
        let mut beside = Beside { rows: rows[..21].to_vec(), next: 0, largest: [0.0; 3], wear };
        let (mechanism, resume) = (&pressed.mechanism, Some(pressed.settled()));
        let report = run_from(mechanism, &pressed.sample, &window, &settings, resume, &mut beside)
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
    });
    assert!((paths_j[0] / paths_j[1] - 1.0).abs() < 1e-9, "{paths_j:?}");
    // The other program slides with R_j and R_i where the specification (3.3, and (14) here) has R_j - a and R_i + a, a = δ_s/2. The
    // bearing turns and the slider does not, so that its path lacks a/R_i: over a patch where δ_s falls as a parabola from δ at its
    // middle, Σ F_s a/Σ F_s = (4/5) δ/2. What the parabola leaves out is 2δ/c of that, the square of half the patch's angle.
    let (mut lacks_j, mut tolerance_j) = (0.0, 0.0);
    for pair in rows[..21].windows(2) {
        let own_j = pair[1][5] - pair[0][5];
        let deepest_m = 0.5 * (pair[0][7] + pair[1][7]);
        let share = 0.8 * deepest_m / (2.0 * BEARING_RADIUS_M);
        lacks_j += own_j * share;
        tolerance_j += own_j * share * 2.0 * deepest_m / CLEARANCE_M;
    }
    let expected_j = rows[20][5] + lacks_j;
    assert!(tolerance_j < 2.1e-6 * expected_j);
    assert!((paths_j[1] - expected_j).abs() < tolerance_j, "{paths_j:?} {expected_j} {tolerance_j:e}");
}

/// `LIFE_JUMPS`, or 0 with `LIFE_TOLERANCE_M`; `LIFE_SECTORS`: for `just campaign worn-cycles`.
#[test]
#[ignore = "a campaign: minutes to an hour"]
fn peer_four_thousand_cycles() {
    let number = |name: &str, default: f64| {
        std::env::var(name).map_or(default, |text| text.parse().unwrap_or_else(|_| panic!("{name} is a number")))
    };
    let (jumps, sectors) = (number("LIFE_JUMPS", 8.0) as usize, number("LIFE_SECTORS", 360.0) as usize);
    let length = match jumps {
        0 => JumpLength::Controlled { tolerance_m: number("LIFE_TOLERANCE_M", 5e-8) },
        jumps => JumpLength::Equal(jumps),
    };
    let life = Pressed::new(sectors).life(length, 1e-6);
    let last = life.last();
    let greatest_m = [0, 1].map(|side| last.depths_m[0][side].iter().copied().fold(0.0, f64::max));
    let volumes_m3 = [2e-14, 1e-14].map(|coefficient_m2_n| coefficient_m2_n * life.paths_j[0]);
    println!("{} jumps, {} cycles run, {sectors} sectors", life.points.len() - 1, life.runs);
    println!("volumes {volumes_m3:?} m³ (7.119146e-10, 3.559573e-10)");
    println!("greatest depths {greatest_m:?} m (7.0821e-6, 2.0773e-6)");
    println!(
        "friction path of the first and the last cycle {:?} {:?} J (8.80006664, 8.98343)",
        life.points[0].cycle.paths_j, last.cycle.paths_j
    );
    println!("error of a jump {:e} m, longest over N_s {:.2}", life.largest_error_m, life.longest_over_stable);
    let mut off_m = [0.0_f64; 2];
    let profile = rows(PROFILE);
    if sectors == profile.len() {
        for side in [0, 1] {
            for (row, own) in profile.iter().zip(&last.depths_m[0][side]) {
                off_m[side] = off_m[side].max((row[1 + side] - own).abs());
            }
        }
        println!("profiles off by {off_m:?} m");
    }
    // The longest sliding paths of a sector in that first turn, by the other program's table with the load along the rod: a sector of
    // the bearing below it slides all the way, R_i ∫|ω| dt = 17.2 mm; the journal's while the patch passes, 7.19 mm. Inertia, 9.9 N of
    // 500 N, turns the load by about a degree from the rod.
    let stable_cycles = 1.0 / (6.699618949e12 * (2e-14 * 17.2e-3 + 1e-14 * 7.19e-3));
    let found = life.points[0].cycle.stable_cycles;
    println!("N_s {found:.1} ({stable_cycles:.1})");
    assert!(sectors != 360 || (found / stable_cycles - 1.0).abs() < 0.01, "{found} {stable_cycles}");
    // The other program's path lacks a/R_i as in the test above; on worn shapes a = (δ_s + H_i + H_j)/2, so that its volumes lack
    // between the share of the first cycle and the most that the deepest sectors of its end have. Jumps: its own table, 8 jumps
    // 8.2e-8 m and 1.4e-4, 16 jumps 1.5e-8 m and 2e-5.
    let of_jumps = 1.4e-4 * (8.0 / jumps.clamp(8, 64) as f64).powi(2);
    let lacks = [0.8 * 1.563e-6, 0.8 * 1.563e-6 + 7.0821e-6 + 2.0773e-6].map(|own_m| own_m / (2.0 * BEARING_RADIUS_M));
    let more = volumes_m3[0] / 7.119146e-10 - 1.0;
    assert!(lacks[0] - of_jumps < more && more < lacks[1] + of_jumps, "{more:e} {lacks:?}");
    // Its profile is that of 32 jumps; more of the path deepens all sectors alike.
    let of_profile_m = 8.2e-8 * (8.0 / jumps.clamp(8, 64) as f64).powi(2) + lacks[1] * 7.0821e-6;
    assert!(sectors != 360 || off_m.iter().all(|own_m| *own_m < of_profile_m), "{off_m:?}");
}
