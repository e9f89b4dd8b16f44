//! Wear of joints: against histories of another program, closed forms, and its own sums.

use crate::elements::{Built, build, file};
use loosepin_mechanics::model::{Model, Values};
use loosepin_simulate::record::{JointWearRecord, WornSurface};
use loosepin_simulate::{Plan, Settings, Simulation, simulate};

const MODEL: &str = include_str!("../../../../cases/slider_crank_5000/model.toml");
/// A turn at 5000 rpm, s.
const TURN_S: f64 = 0.012;

/// The slider-crank whose gudgeon wears; its table of wear has further lines.
fn slider_crank(clearance: &str, wear: &str) -> String {
    let joint = format!("radial_clearance = \"{clearance}\"\nbearing_length = \"20 mm\"\n{wear}\n");
    let text = MODEL.replace("radial_clearance = \"0.5 mm\"\n", &joint);
    assert_ne!(text, MODEL);
    text
}

const BOTH_WEAR: &str =
    "wear.bearing.coefficient = \"1e-15 m^2/N\"\nwear.journal.coefficient = \"1e-6 mm^3/(N m)\"\nwear.sectors = 72";

fn run_with(built: &Built, values: &Values, turns: f64, tolerance_m: f64) -> Simulation {
    let mut plan = Plan::of_model(&built.mechanism.model);
    plan.cycle.recorded_turns = turns;
    plan.settings = Settings { tolerance_m, ..plan.settings };
    simulate(&built.mechanism, values, &plan).unwrap_or_else(|failure| panic!("{failure}"))
}

fn wear_of(text: &str, turns: f64) -> JointWearRecord {
    let built = build(text);
    let mut simulation = run_with(&built, &built.values, turns, 1e-9);
    assert_eq!(simulation.record.wear.len(), 1);
    simulation.record.wear.remove(0)
}

#[test]
fn peer_friction_path_of_the_first_turn() {
    // friction_path_j of wear_one_turn.csv, made by a program of its own: quadrature as a state, with reversals of v_T as events. Its
    // accuracy is 1e-7 J up to 6 ms and 1e-4 J at the end of the turn, where contacts have amplified differences.
    const PATHS_J: [(f64, f64, f64); 4] = [
        (0.002_01, 14.406_653_407_4, 1e-7),
        (0.003, 17.065_756_05, 1e-7),
        (0.006, 26.862_911_247_3, 1e-7),
        (0.012, 57.164_450_250_7, 1e-4),
    ];
    let built = build(&slider_crank("0.5 mm", BOTH_WEAR));
    for (time_s, path_j, tolerance_j) in PATHS_J {
        let simulation = run_with(&built, &built.values, time_s / TURN_S, 1e-10);
        let wear = &simulation.record.wear[0];
        assert!((wear.friction_path_j - path_j).abs() < tolerance_j, "{time_s} s: {} {path_j}", wear.friction_path_j);
        // Two quadratures of one path: the weights of the integrator, and Gauss's rule on its dense output.
        let error = wear.checks.path_error.unwrap_or(f64::NAN);
        assert!(error.abs() < 1e-6, "{time_s} s: {error}");
    }
}

#[test]
fn peer_profile_of_the_first_turn() {
    // Work by sector of the other program; two of its tolerances differ by 9e-4 J.
    const TOLERANCE_J: f64 = 9e-4;
    let built = build(&slider_crank("0.5 mm", BOTH_WEAR));
    // Contacts amplify errors: sectors are 9e-4 J off at 1e-9 m, 4.9e-4 J at 1e-10 m and 3.9e-4 J at 1e-12 m.
    let mut simulation = run_with(&built, &built.values, 1.0, 1e-10);
    let wear = simulation.record.wear.remove(0);
    let text = file("wear_one_turn_profile.csv");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!([rows.len(), wear.surfaces[0].depth_m.len(), wear.surfaces[1].depth_m.len()], [72; 3]);
    for (side, (surface, radius_m)) in wear.surfaces.iter().zip([0.01, 0.0095]).enumerate() {
        assert_eq!(surface.surface, [WornSurface::Bearing, WornSurface::Journal][side]);
        let depth_per_j_m = 1e-15 / (radius_m * std::f64::consts::TAU / 72.0 * 0.02);
        for (sector, row) in rows.iter().enumerate() {
            let difference_j = surface.depth_m[sector] / depth_per_j_m - row[1 + side];
            assert!(difference_j.abs() < TOLERANCE_J, "{side} {sector}: {difference_j} of {} J", row[1 + side]);
            assert!((surface.depth_m[sector] - row[3 + side]).abs() < TOLERANCE_J * depth_per_j_m, "{side} {sector}");
        }
        assert!((surface.volume_m3 - 5.716_44e-14).abs() < 2e-19, "{}", surface.volume_m3);
    }
    assert_eq!(wear.surfaces[0].deepest_sector, 71);
}

#[test]
fn peer_friction_path_without_play() {
    // ∮|F| R |φ̇| dt of the gudgeon by converged quadrature of another program, to the digits given.
    for (speed, path_j, tolerance_j) in [("5000 rpm", 28.203_994_85, 1e-8), ("300 rpm", 0.102_977_96, 5e-9)] {
        let wear = wear_of(&slider_crank("0 mm", BOTH_WEAR).replace("5000 rpm", speed), 1.0);
        assert!((wear.friction_path_j - path_j).abs() < tolerance_j, "{speed}: {}", wear.friction_path_j);
        assert_eq!(wear.checks.path_error, None);
    }
}

#[test]
fn identity_friction_loses_its_coefficient_times_the_friction_path() {
    // From the energy account: Ambrósio's friction is full from 1 mm/s on, and less below.
    const COEFFICIENT: f64 = 0.05;
    let text = include_str!("../../../../cases/four_bar_friction/model.toml");
    let wear = "bearing_length = \"20 mm\"\nwear.journal.coefficient = \"1e-15 m^2/N\"\nradial_clearance";
    let built = build(&text.replacen("radial_clearance", wear, 1));
    let record = run_with(&built, &built.values, 1.0, 1e-9).record;
    let full_j = COEFFICIENT * record.wear[0].friction_path_j;
    let lost_j = record.energy.friction_loss_j.last().copied().unwrap_or(f64::NAN) - record.energy.friction_loss_j[0];
    assert!(full_j > 0.01, "{full_j}");
    // Sliding below 1 mm/s passes 2.3e-5 of the path.
    assert!((0.0..1e-4).contains(&(1.0 - lost_j / full_j)), "{lost_j} {full_j}");
}

/// A wheel that hangs on a pin of the ground, driven at constant speed.
fn wheel(bearing_and_journal: [&str; 2], wear: &str) -> String {
    let [bearing, journal] = bearing_and_journal;
    format!(
        "name = \"wheel\"\ngravity = \"9.81 m/s^2\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.wheel]\nmass = \"3 kg\"\ninertia = \"2e-2 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
         points = {{ axis = [\"0 mm\", \"0 mm\"] }}\n\
         [contact.steel]\nrestitution = 0.7\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\n\
         [joint.axle]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\nbearing_radius = \"8 mm\"\n\
         radial_clearance = \"0 mm\"\nbearing_length = \"15 mm\"\ncontact = \"steel\"\n{wear}\n\
         [drive.motor]\njoint = \"axle\"\nspeed = \"120 rpm\"\nstart_angle = \"0 deg\"\n[cycle]\ndrive = \"motor\"\nrecorded_turns = 3\n[wear]\ncycles = 500\n"
    )
}

#[test]
fn analytic_a_wheel_on_a_pin_wears_evenly_and_its_pin_on_top() {
    let wear = "wear = { bearing = { coefficient = \"2e-15 m^2/N\" }, journal = { archard = 6e-6, hardness = \"2 GPa\" }, \
                sectors = 10, pressure = \"concentrated\" }";
    let wear = wear_of(&wheel(["wheel.axis", "ground.o"], wear), 3.0);
    // W = m g · 2πR · 3 turns, and k_j = K/H = 3e-15 m²/N.
    let path_j = 3.0 * 9.81 * std::f64::consts::TAU * 0.008 * 3.0;
    assert!((wear.friction_path_j / path_j - 1.0).abs() < 1e-12, "{}", wear.friction_path_j);
    let area_m2 = std::f64::consts::TAU / 10.0 * 0.008 * 0.015;
    let [bearing, journal] = &wear.surfaces[..] else { panic!("two surfaces wear") };
    assert!((bearing.volume_m3 / (500.0 * 2e-15 * path_j) - 1.0).abs() < 1e-12);
    assert!((journal.volume_m3 / (500.0 * 3e-15 * path_j) - 1.0).abs() < 1e-12);
    for depth_m in &bearing.depth_m {
        // The contact passes a sector in 9.6 steps of a 96th of a turn with five points each.
        assert!((depth_m / (500.0 * 2e-15 * path_j / 10.0 / area_m2) - 1.0).abs() < 0.02, "{depth_m}");
    }
    // The wheel hangs on the top of the pin, at 90° of the ground: sector 2 reaches from 72° to 108°.
    assert_eq!(journal.deepest_sector, 2);
    assert!((journal.greatest_depth_m / (500.0 * 3e-15 * path_j / area_m2) - 1.0).abs() < 1e-12);
    assert!(journal.depth_m.iter().enumerate().all(|(sector, depth_m)| sector == 2 || *depth_m == 0.0));
}

#[test]
fn analytic_a_shaft_in_a_bearing_of_the_ground_wears_the_bearing_at_the_bottom() {
    let wear = "wear = { bearing = { coefficient = \"2e-15 m^2/N\" }, sectors = 10, pressure = \"concentrated\" }";
    let wear = wear_of(&wheel(["ground.o", "wheel.axis"], wear), 3.0);
    // At 270° of the ground: sector 7 reaches from 252° to 288°. The journal has no coefficient.
    assert_eq!(wear.surfaces.len(), 1);
    assert_eq!(wear.surfaces[0].deepest_sector, 7);
}

#[test]
fn identity_sums_of_sectors_are_the_volume_whatever_their_number() {
    let of = |sectors: &str| wear_of(&slider_crank("0.5 mm", &BOTH_WEAR.replace("72", sectors)), 0.7);
    let (coarse, fine) = (of("72"), of("360"));
    assert_eq!(coarse.friction_path_j.to_bits(), fine.friction_path_j.to_bits());
    for (coarse, fine) in coarse.surfaces.iter().zip(&fine.surfaces) {
        assert_eq!(coarse.volume_m3.to_bits(), fine.volume_m3.to_bits());
        assert_eq!(fine.volume_m3, fine.coefficient_m2_n * of("4").friction_path_j);
        // Each coarse sector is the mean of five fine ones.
        for (own, five) in coarse.depth_m.iter().zip(fine.depth_m.chunks(5)) {
            let mean_m = five.iter().sum::<f64>() / 5.0;
            assert!((own - mean_m).abs() < 1e-13 * coarse.greatest_depth_m, "{own} {mean_m}");
        }
        assert!((coarse.sum_of_sectors_error - fine.sum_of_sectors_error).abs() < 1e-12);
        assert!(coarse.sum_of_sectors_error.abs() < 1e-6, "{}", coarse.sum_of_sectors_error);
        assert!(fine.depth_m.iter().all(|depth_m| *depth_m >= 0.0));
    }
    // Sectors converge: the greatest depth by 72, 144 and 360.
    let middle = of("144");
    let [first, second] = [0, 1].map(|side| {
        let depth = |wear: &JointWearRecord| wear.surfaces[side].greatest_depth_m;
        [depth(&middle) / depth(&coarse) - 1.0, depth(&fine) / depth(&middle) - 1.0]
    });
    for [to_middle, to_fine] in [first, second] {
        assert!(to_fine.abs() < 0.5 * to_middle.abs().max(0.02), "{to_middle} {to_fine}");
    }
}

#[test]
fn identity_wear_leaves_the_motion_as_it_is_within_the_tolerance() {
    let with = build(&slider_crank("0.5 mm", BOTH_WEAR));
    let without = build(MODEL);
    // Half a turn: from there on contacts amplify the difference of steps.
    let [with, without] = [&with, &without].map(|built| run_with(built, &built.values, 0.5, 1e-10).record);
    assert!(without.wear.is_empty());
    let slider = |record: &loosepin_simulate::record::SimulationRecord| record.outputs[0].value_si.clone();
    let difference = slider(&with).iter().zip(slider(&without)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // The tolerance is that of half a turn; its amplification is part of it.
    assert!(difference < 1e-9, "{difference}");
    assert_eq!(with.joints[0].contacts, without.joints[0].contacts);
}

#[test]
fn identity_coefficients_and_cycles_can_be_set() {
    let text = slider_crank("0.5 mm", "wear.journal = { archard = 1e-6, hardness = \"2 GPa\" }");
    let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let built = build(&text);
    let wear = |settings: &[&str]| {
        let settings: Vec<String> = settings.iter().map(|text| (*text).to_owned()).collect();
        let set = model.set_values(&settings).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        run_with(&built, &set.values, 0.2, 1e-9).record.wear.remove(0)
    };
    let nominal = wear(&[]);
    assert_eq!([nominal.cycles, nominal.surfaces[0].coefficient_m2_n], [1.0, 1e-6 / 2e9]);
    let path = "joint.gudgeon.wear.journal";
    let harder = wear(&[&format!("{path}.hardness=4 GPa"), "wear.cycles=3000"]);
    assert_eq!(harder.friction_path_j.to_bits(), nominal.friction_path_j.to_bits());
    assert!((harder.surfaces[0].volume_m3 / nominal.surfaces[0].volume_m3 - 1500.0).abs() < 1e-9);
}
