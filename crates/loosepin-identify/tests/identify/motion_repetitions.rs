//! `just campaign identify-motion`: the worn pin from ten turns that cases/oracle made with other seeds: misses of the truth, widths
//! beside those of brute force, and how often a mechanism that the study does not allow is told to be a misfit.

use loosepin_identify::{CONFIDENCE, MotionRig, MotionValues};
use loosepin_study::{MeasuredMotion, Study};
use std::path::Path;

/// Values of the play that brute force tests: so many, evenly over the box.
const BRUTE_FORCE: usize = 128;
/// Values that an inversion tests, at most.
const POINTS: usize = 100;
/// Misses of the truth in 100 readings, at most: more have a probability of 0.3 % for a confidence of 99 %.
const MOST_MISSES: f64 = 0.04;
/// Width of the interval over that of brute force, at most.
const MOST_WIDTH: f64 = 1.2;
/// Share of the readings outside all predictions that must be told.
const LEAST_TOLD: f64 = 0.95;
/// Common error of both features: the gain of the sensor.
const ERROR: f64 = 0.05;

/// A reading with the truth behind it.
struct Reading {
    alternative: String,
    play_m: f64,
    values_si: [f64; 2],
}

fn readings(folder: &Path) -> Vec<Reading> {
    let path = folder.join("motion_repetitions.csv");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let read = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |place: usize| cells[place].parse::<f64>().expect("a number");
        Reading { alternative: cells[0].to_owned(), play_m: 1e-3 * number(2), values_si: [number(7), number(8)] }
    };
    text.lines().skip(1).map(read).collect()
}

/// The least and the largest of what `of` gives.
fn range(runs: &[Vec<f64>], of: impl Fn(&[f64]) -> f64) -> [f64; 2] {
    let fold = |[low, high]: [f64; 2], run: &Vec<f64>| [low.min(of(run)), high.max(of(run))];
    runs.iter().fold([f64::INFINITY, f64::NEG_INFINITY], fold)
}

/// Whether a measurement lies outside the runs of all values by more than its error: by a feature, or by their ratio, from which the gain
/// drops out.
fn is_outside(runs: &[Vec<f64>], [peak, rms]: [f64; 2]) -> bool {
    let beyond =
        |value: f64, [low, high]: [f64; 2], error: f64| value / (1.0 - error) < low || value / (1.0 + error) > high;
    beyond(peak, range(runs, |run| run[0]), ERROR)
        || beyond(rms, range(runs, |run| run[1]), ERROR)
        || beyond(peak / rms, range(runs, |run| run[0] / run[1]), 0.0)
}

#[test]
#[ignore = "minutes of processor time: just campaign identify-motion"]
fn peer_worn_pin_from_ten_turns_of_the_oracle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let study = Study::from_path(&folder.join("measured.toml")).unwrap_or_else(|complaints| panic!("{complaints}"));
    let features: Vec<&MeasuredMotion> = study.motion.iter().collect();
    let asked = MotionValues { confidence: CONFIDENCE, points: POINTS, threads: 0 };
    let mut rig = MotionRig::new(&study, &features, &asked, 0).unwrap_or_else(|complaints| panic!("{complaints}"));
    let runs = rig.predicted(&[BRUTE_FORCE]).unwrap_or_else(|complaints| panic!("{complaints}"));
    let cell_m = (0.5e-3 - 0.1e-3) / BRUTE_FORCE as f64;
    let readings = readings(&folder);
    let (mut count, mut missed, mut narrowed, mut widths) = (0, 0, Vec::new(), Vec::new());
    for reading in readings.iter().filter(|reading| reading.alternative == "none") {
        let found = rig.invert(None, &reading.values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
        let [low_m, high_m] = found.unknowns[0].after_si;
        let words = match &found.misfit {
            Some(misfit) => format!("misfit, distance {:.3}", misfit.least_distance),
            None => format!("{:.4} to {:.4} mm", 1e3 * low_m, 1e3 * high_m),
        };
        count += 1;
        missed += usize::from(found.misfit.is_some() || reading.play_m < low_m || reading.play_m > high_m);
        let kept = rig.kept(&[BRUTE_FORCE], &reading.values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
        let plays = kept.iter().map(|values| values[0]);
        let [least, most] = plays.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], play| [a.min(play), b.max(play)]);
        let mut ratio = f64::NAN;
        if found.misfit.is_none() && most >= least {
            // Each value of brute force stands for the cell around it.
            ratio = (high_m - low_m) / (most - least + cell_m);
            widths.push(ratio);
            narrowed.push((high_m - low_m) / 0.4e-3);
        }
        println!("play {:.4} mm: {words}; width over brute force {ratio:.3}", 1e3 * reading.play_m);
    }
    let mut told_all = Vec::new();
    for alternative in ["joint", "friction"] {
        let of = readings.iter().filter(|reading| reading.alternative == alternative);
        // By outside: readings, and those that are told.
        let mut counts = [[0; 2]; 2];
        for reading in of {
            let found = rig.invert(None, &reading.values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
            let outside = usize::from(is_outside(&runs, reading.values_si));
            counts[outside][0] += 1;
            counts[outside][1] += usize::from(found.misfit.is_some());
        }
        let [[within, told_within], [outside, told]] = counts;
        println!(
            "{alternative}: {outside} outside all predictions, {told} of them told; {within} within, {told_within} told"
        );
        told_all.push((alternative, outside, told));
    }
    for list in [&mut widths, &mut narrowed] {
        list.sort_by(f64::total_cmp);
    }
    println!("{count} readings, {missed} misses");
    println!("width over brute force: median {:.3}, largest {:.3}", widths[widths.len() / 2], widths[widths.len() - 1]);
    println!("share of the interval left: median {:.3}", narrowed[narrowed.len() / 2]);
    assert!(missed as f64 <= MOST_MISSES * count as f64, "{missed} of {count}");
    assert!(widths[widths.len() - 1] <= MOST_WIDTH, "{widths:?}");
    for (alternative, outside, told) in told_all {
        assert!(told as f64 >= LEAST_TOLD * outside as f64, "{alternative}: {told} of {outside}");
    }
}
