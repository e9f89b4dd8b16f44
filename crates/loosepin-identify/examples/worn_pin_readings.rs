//! The worn pin identified from all readings of `cases/slider_crank_worn_pin/motion_repetitions.csv`, or of another such table: `cargo run
//! --release --package loosepin-identify --example worn_pin_readings RUNS.csv [READINGS.csv]`. Writes play, peak and rms of every run at evenly spread plays to RUNS.csv, for
//! other programs, and prints a line for each reading. `tools/compare/identify.py` calls it.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use loosepin_identify::motion_record::MotionPosterior;
use loosepin_identify::{CONFIDENCE, MotionRig, MotionValues};
use loosepin_study::{MeasuredMotion, Study};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Plays whose runs are made once, evenly over the box: as many as brute force tests.
const PLAYS: usize = 128;
/// Values that an inversion tests, at most.
const POINTS: usize = 100;

/// Processor time of this process so far, s: user and system, in hundredths; 0 where the system has no such file.
fn processor_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after = text.rsplit(')').next().unwrap_or_default();
    let ticks = |place: usize| after.split_whitespace().nth(place).and_then(|t| t.parse::<f64>().ok()).unwrap_or(0.0);
    // Fields 14 and 15 of the line, of which two stand before the bracket.
    (ticks(11) + ticks(12)) / 100.0
}

fn main() {
    let Some(path) = std::env::args().nth(1) else { panic!("name the table of runs that is to be written") };
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let study = Study::from_path(&folder.join("measured.toml")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let features: Vec<&MeasuredMotion> = study.motion.iter().collect();
    let asked =
        MotionValues { confidence: CONFIDENCE, points: POINTS, threads: 0, with_posterior: true, with_lengths: false };
    let mut bank = MotionRig::new(&study, &features, &asked, 0).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let start_s = processor_s();
    let all = bank.predicted(&[PLAYS]).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let seconds = processor_s() - start_s;
    let mut table = "play_mm,peak_m_s2,rms_m_s2\n".to_owned();
    for (play_m, run) in all.iter().flat_map(|(values, runs)| runs.iter().map(|run| (values[0], run))) {
        writeln!(table, "{:.6},{:.8e},{:.8e}", 1e3 * play_m, run[0], run[1]).unwrap_or_else(|error| panic!("{error}"));
    }
    std::fs::write(&path, table).unwrap_or_else(|error| panic!("{path}: {error}"));
    println!("runs of {PLAYS} plays: {seconds:.1} s");
    println!(
        "alternative,seed,play_mm,set_low_mm,set_high_mm,is_misfit,values,mean_mm,credible_low_mm,credible_high_mm,effective_values,seconds,refused"
    );
    let table = std::env::args().nth(2).map_or_else(|| folder.join("motion_repetitions.csv"), PathBuf::from);
    let readings = std::fs::read_to_string(&table).unwrap_or_else(|error| panic!("{}: {error}", table.display()));
    for line in readings.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |place: usize| cells[place].parse::<f64>().unwrap_or_else(|error| panic!("{line}: {error}"));
        let values_si = [number(7), number(8)];
        let mut ask = || bank.invert(None, &values_si, true).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        // Its runs are kept: the second time the seconds are those of the test and of the distribution alone.
        let found = ask();
        let start_s = processor_s();
        ask();
        let seconds = processor_s() - start_s;
        let [low_m, high_m] = found.unknowns[0].after_si;
        let (mut posterior, mut effective) = ([f64::NAN; 3], f64::NAN);
        if let Some(MotionPosterior::Given(given)) = &found.posterior {
            if let Some(summary) = given.marginals[0].summary {
                posterior = [summary.mean_si, summary.credible_si[0], summary.credible_si[1]];
            }
            effective = given.effective_values;
        }
        let refused = match &found.posterior {
            Some(MotionPosterior::Refused(refusal)) => format!("{refusal:?}").replace(',', ";"),
            _ => String::new(),
        };
        println!(
            "{},{},{},{:.6},{:.6},{},{},{:.6},{:.6},{:.6},{effective:.3},{seconds:.3},{refused}",
            cells[0],
            cells[1],
            cells[2],
            1e3 * low_m,
            1e3 * high_m,
            found.misfit.is_some(),
            found.points.len(),
            1e3 * posterior[0],
            1e3 * posterior[1],
            1e3 * posterior[2],
        );
    }
}
