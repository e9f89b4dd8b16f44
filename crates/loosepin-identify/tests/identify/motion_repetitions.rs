//! `just campaign identify-motion`: the worn pin from ten turns that cases/oracle made with other seeds: misses of the truth, and widths
//! beside those of brute force. Readings of other mechanisms are not among them: nothing is shown of how often a misfit is told.

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

/// A reading with the truth behind it.
struct Reading {
    play_m: f64,
    values_si: [f64; 2],
}

fn readings(folder: &Path) -> Vec<Reading> {
    let path = folder.join("motion_repetitions.csv");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let read = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |place: usize| cells[place].parse::<f64>().expect("a number");
        assert_eq!(cells[0], "none", "a reading of the mechanism of the study");
        Reading { play_m: 1e-3 * number(2), values_si: [number(7), number(8)] }
    };
    text.lines().skip(1).map(read).collect()
}

#[test]
#[ignore = "minutes of processor time: just campaign identify-motion"]
fn peer_worn_pin_from_ten_turns_of_the_oracle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let study = Study::from_path(&folder.join("measured.toml")).unwrap_or_else(|complaints| panic!("{complaints}"));
    let features: Vec<&MeasuredMotion> = study.motion.iter().collect();
    let asked = MotionValues { confidence: CONFIDENCE, points: POINTS, threads: 0 };
    let mut rig = MotionRig::new(&study, &features, &asked, 0).unwrap_or_else(|complaints| panic!("{complaints}"));
    let cell_m = (0.5e-3 - 0.1e-3) / BRUTE_FORCE as f64;
    let (mut count, mut missed, mut narrowed, mut widths) = (0, 0, Vec::new(), Vec::new());
    for reading in readings(&folder) {
        let found = rig.invert(None, &reading.values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
        let [low_m, high_m] = found.unknowns[0].after_si;
        let words = match &found.misfit {
            Some(misfit) => format!("misfit, distance {:.3}", misfit.least_distance),
            None => format!("{:.4} to {:.4} mm", 1e3 * low_m, 1e3 * high_m),
        };
        println!("play {:.4} mm: {words}", 1e3 * reading.play_m);
        count += 1;
        missed += usize::from(found.misfit.is_some() || reading.play_m < low_m || reading.play_m > high_m);
        let kept = rig.kept(&[BRUTE_FORCE], &reading.values_si).unwrap_or_else(|complaints| panic!("{complaints}"));
        let plays = kept.iter().map(|values| values[0]);
        let [least, most] = plays.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], play| [a.min(play), b.max(play)]);
        if found.misfit.is_none() && most >= least {
            // Each value of brute force stands for the cell around it.
            widths.push((high_m - low_m) / (most - least + cell_m));
            narrowed.push((high_m - low_m) / 0.4e-3);
        }
    }
    for list in [&mut widths, &mut narrowed] {
        list.sort_by(f64::total_cmp);
    }
    println!("{count} readings, {missed} misses");
    println!("width over brute force: median {:.3}, largest {:.3}", widths[widths.len() / 2], widths[widths.len() - 1]);
    println!("share of the interval left: median {:.3}", narrowed[narrowed.len() / 2]);
    assert!(missed as f64 <= MOST_MISSES * count as f64, "{missed} of {count}");
    assert!(widths[widths.len() - 1] <= MOST_WIDTH, "{widths:?}");
}
