//! Whole runs against the histories of independent programs: every case folder with a `reference.csv`.

use loosepin::mechanism::Mechanism;
use loosepin::model::Model;
use loosepin::simulate::{Plan, Settings, Simulation, simulate};
use std::path::{Path, PathBuf};

/// What the issue of the first landing asks of the slider's position: 1e-8 m at every row of the recorded span. Angles are
/// held to the same number in rad. The histories agree with a second run of their own program to 1e-9 or better.
const POSITION_TOLERANCE_M: f64 = 1e-8;

/// In contact, a time shift of 1e-9 s at accelerations of 1e5 m/s² is 1e-4 m/s: ten times that is allowed.
const VELOCITY_TOLERANCE_M_S: f64 = 1e-3;

fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

struct Reference {
    time_s: Vec<f64>,
    rows: Vec<Vec<f64>>,
}

fn reference(folder: &Path) -> Reference {
    let text = std::fs::read_to_string(folder.join("reference.csv")).expect("the case has a reference");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().expect("cells are numbers")).collect())
        .collect();
    Reference {
        time_s: rows.iter().map(|row| row[0]).collect(),
        rows: rows.into_iter().map(|row| row[1..].to_vec()).collect(),
    }
}

/// Runs the case over the span of its reference, with a row at each of its times.
fn run(folder: &Path, reference: &Reference, tolerance_m: f64) -> Simulation {
    let model = Model::from_path(&folder.join("model.toml")).unwrap_or_else(|complaints| panic!("{complaints}"));
    let values = model.quantities.evaluate(&[]).expect("the values of a case are sound");
    let mechanism = Mechanism::new(&model, &values).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut cycle = model.cycle.clone();
    let turn_s = model.input(cycle.span, &values).turn_s();
    let span_s = reference.time_s[reference.time_s.len() - 1];
    cycle.transient_turns = 0.0;
    cycle.recorded_turns = span_s / turn_s;
    let rows = reference.time_s.len() - 1;
    cycle.samples_per_turn = (rows as f64 / cycle.recorded_turns).round() as usize;
    let settings = Settings { tolerance_m, ..Settings::for_simulation() };
    let plan = Plan { cycle, settings, with_states: true, lyapunov_turns: None, overrides: Vec::new() };
    simulate(&mechanism, &values, &plan).unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
}

/// Largest differences of positions (m and rad) and velocities over all rows.
fn differences(simulation: &Simulation, reference: &Reference) -> (f64, f64) {
    let states = simulation.states.as_ref().expect("states were asked for");
    assert_eq!(states.rows.len(), reference.rows.len());
    let third = reference.rows[0].len() / 3;
    let (mut position, mut velocity) = (0.0_f64, 0.0_f64);
    for (ours, theirs) in states.rows.iter().zip(&reference.rows) {
        for k in 0..third {
            position = position.max((ours[k] - theirs[k]).abs());
            velocity = velocity.max((ours[third + k] - theirs[third + k]).abs());
        }
    }
    (position, velocity)
}

#[test]
fn peer_histories_of_all_cases() {
    let mut failures = Vec::new();
    let mut compared = 0;
    let mut folders: Vec<PathBuf> =
        std::fs::read_dir(cases()).expect("the cases are there").map(|entry| entry.expect("readable").path()).collect();
    folders.sort();
    for folder in folders.iter().filter(|folder| folder.join("reference.csv").exists()) {
        let reference = reference(folder);
        let simulation = run(folder, &reference, 1e-9);
        let (position, velocity) = differences(&simulation, &reference);
        let name = folder.file_name().expect("a folder has a name").to_string_lossy().into_owned();
        let residual = simulation.record.energy.relative_residual;
        println!(
            "{name}: {position:.1e} m, {velocity:.1e} m/s, residual {residual:.1e}, {} evaluations",
            simulation.report.counters.evaluations
        );
        if !(position < POSITION_TOLERANCE_M && velocity < VELOCITY_TOLERANCE_M_S && residual < 1e-8) {
            failures.push(name);
        }
        compared += 1;
    }
    assert!(compared >= 2, "only {compared} cases have a reference");
    assert!(failures.is_empty(), "beyond the tolerances: {failures:?}");
}
