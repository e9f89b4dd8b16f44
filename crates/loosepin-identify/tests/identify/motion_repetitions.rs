//! `just campaign identify-motion`: the worn pin from ten turns that cases/oracle made with other seeds: misses of the truth, widths
//! beside those of brute force, and how often a mechanism that the study does not allow is told to be a misfit.

use loosepin_identify::motion_record::MotionPosterior;
use loosepin_identify::{CONFIDENCE, MotionRig, MotionValues, RunsOfValue};
use loosepin_mechanics::model::Model;
use loosepin_study::{MeasuredMotion, Study};
use std::path::Path;

/// Values of the play that brute force tests: so many, evenly over the box.
const BRUTE_FORCE: usize = 128;
/// Values that an inversion tests, at most.
const POINTS: usize = 100;
/// Misses of the truth in 100 readings, at most: more have a probability of 0.3 % for a confidence of 99 %.
const MAX_MISSES: f64 = 0.04;
/// Width of the interval over that of brute force, at most.
const MAX_WIDTH: f64 = 1.2;
/// Share of the readings outside all predictions that must be told.
const MIN_TOLD: f64 = 0.95;
/// Common error of both features: the gain of the sensor.
const ERROR: f64 = 0.05;
/// Play in the file, and that of a study which knows it better, mm.
const FILE_PLAY_MM: [f64; 2] = [0.1, 0.5];
const KNOWN_PLAY_MM: [f64; 2] = [0.3, 0.5];
/// Mechanisms that the study does not allow, by their name in the readings, and the play of the study that they are held against, mm.
const ALTERNATIVES: [(&str, [f64; 2]); 4] = [
    ("joint", FILE_PLAY_MM),
    ("worn_joint", FILE_PLAY_MM),
    ("friction", FILE_PLAY_MM),
    ("friction_known_play", KNOWN_PLAY_MM),
];

/// Readings of a forgotten play of 1 mm that the distance of the test was chosen by: seeds below this. They are told, and not counted.
const CHOSEN_BY: (&str, usize) = ("worn_joint", 31);

/// A reading with the truth behind it.
struct Reading {
    alternative: String,
    seed: usize,
    play_m: f64,
    /// What the sensor would have said without its error, and what it said.
    true_si: [f64; 2],
    values_si: [f64; 2],
}

fn readings(folder: &Path) -> Vec<Reading> {
    let path = folder.join("motion_repetitions.csv");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let read = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |place: usize| cells[place].parse::<f64>().expect("a number");
        let values_si = [number(7), number(8)];
        let true_si = values_si.map(|value| value / number(6));
        let seed = cells[1].parse().expect("a whole number");
        Reading { alternative: cells[0].to_owned(), seed, play_m: 1e-3 * number(2), true_si, values_si }
    };
    text.lines().skip(1).map(read).collect()
}

/// The least and the largest of what `of` gives.
fn range(runs: &[[f64; 2]], of: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
    let fold = |[low, high]: [f64; 2], run: &[f64; 2]| [low.min(of(*run)), high.max(of(*run))];
    runs.iter().fold([f64::INFINITY, f64::NEG_INFINITY], fold)
}

/// Whether a measurement lies outside runs at all values by more than its error: by a feature, or by their ratio, from which the gain
/// drops out.
fn is_outside(runs: &[[f64; 2]], [peak, rms]: [f64; 2]) -> bool {
    let beyond =
        |value: f64, [low, high]: [f64; 2], error: f64| value / (1.0 - error) < low || value / (1.0 + error) > high;
    beyond(peak, range(runs, |run| run[0]), ERROR)
        || beyond(rms, range(runs, |run| run[1]), ERROR)
        || beyond(peak / rms, range(runs, |run| run[0] / run[1]), 0.0)
}

/// Peak and rms of all runs with a play within an interval, mm.
fn within(all: &[RunsOfValue], [low_mm, high_mm]: [f64; 2]) -> Vec<[f64; 2]> {
    let is_within = |(values, _): &&RunsOfValue| (low_mm..=high_mm).contains(&(1e3 * values[0]));
    all.iter().filter(is_within).flat_map(|(_, runs)| runs.iter().map(|run| [run[0], run[1]])).collect()
}

/// The study of the case with this interval of the play, mm.
fn study(folder: &Path, [low_mm, high_mm]: [f64; 2]) -> Study {
    let read =
        |name: &str| std::fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let written = "interval = [\"0.1 mm\", \"0.5 mm\"]";
    let text = read("measured.toml");
    assert_eq!(text.matches(written).count(), 1, "the play of measured.toml is {FILE_PLAY_MM:?} mm");
    let text = text.replace(written, &format!("interval = [\"{low_mm} mm\", \"{high_mm} mm\"]"));
    let model =
        Model::from_text("model.toml", &read("model.toml")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("measured.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

#[test]
#[ignore = "minutes of processor time: just campaign identify-motion"]
fn peer_worn_pin_from_ten_turns_of_the_oracle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let of_file = study(&folder, FILE_PLAY_MM);
    let of_alternatives = ALTERNATIVES.map(|(_, play_mm)| study(&folder, play_mm));
    let features: Vec<&MeasuredMotion> = of_file.motion.iter().collect();
    let asked =
        MotionValues { confidence: CONFIDENCE, points: POINTS, threads: 0, with_posterior: false, with_lengths: false };
    let mut rig = MotionRig::new(&of_file, &features, &asked, 0).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let runs = rig.predicted(&[BRUTE_FORCE]).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let cell_m = (0.5e-3 - 0.1e-3) / BRUTE_FORCE as f64;
    let readings = readings(&folder);
    let (mut count, mut missed, mut narrowed, mut widths) = (0, 0, Vec::new(), Vec::new());
    // Credible intervals: given, missed, and their widths over that of the set.
    let (mut given, mut not_held, mut credible) = (0, 0, Vec::new());
    for reading in readings.iter().filter(|reading| reading.alternative == "none") {
        let found = rig.invert(None, &reading.values_si, false).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let [low_m, high_m] = found.unknowns[0].after_si;
        let words = match &found.misfit {
            Some(misfit) => format!("misfit, distance {:.3}", misfit.least_distance),
            None => format!("{:.4} to {:.4} mm", 1e3 * low_m, 1e3 * high_m),
        };
        count += 1;
        missed += usize::from(found.misfit.is_some() || reading.play_m < low_m || reading.play_m > high_m);
        let kept = rig.kept(&[BRUTE_FORCE], &reading.values_si).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
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
        let weighed = rig.invert(None, &reading.values_si, true).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        if let Some(MotionPosterior::Given(posterior)) = &weighed.posterior {
            let [least, most] = posterior.marginals[0].summary.expect("the play is no list").credible_si;
            given += 1;
            not_held += usize::from(reading.play_m < least || reading.play_m > most);
            credible.push((most - least) / (high_m - low_m));
        }
    }
    let mut told_all = Vec::new();
    for ((alternative, play_mm), own) in ALTERNATIVES.into_iter().zip(&of_alternatives) {
        let features: Vec<&MeasuredMotion> = own.motion.iter().collect();
        // Runs of the study as it is written are made already.
        let mut narrower = if play_mm == FILE_PLAY_MM {
            None
        } else {
            Some(MotionRig::new(own, &features, &asked, 0).unwrap_or_else(|diagnostics| panic!("{diagnostics}")))
        };
        let ours = within(&runs, play_mm);
        // The independent program's own runs of mechanisms that the study allows.
        let is_allowed = |reading: &&Reading| {
            reading.alternative == "none" && (play_mm[0]..=play_mm[1]).contains(&(1e3 * reading.play_m))
        };
        let theirs: Vec<[f64; 2]> = readings.iter().filter(is_allowed).map(|reading| reading.true_si).collect();
        // By outside: readings, those that are told, and those that brute force keeps nowhere. Of the last ones only where runs are made.
        let mut counts = [[0; 3]; 2];
        let mut chosen_by = [0; 3];
        for reading in readings.iter().filter(|reading| reading.alternative == alternative) {
            let asked_rig = narrower.as_mut().unwrap_or(&mut rig);
            let found =
                asked_rig.invert(None, &reading.values_si, false).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
            let outside = is_outside(&ours, reading.values_si) && is_outside(&theirs, reading.values_si);
            let mut one = [1, usize::from(found.misfit.is_some()), 0];
            if play_mm == FILE_PLAY_MM {
                let kept = asked_rig
                    .kept(&[BRUTE_FORCE], &reading.values_si)
                    .unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
                one[2] = usize::from(kept.is_empty());
            }
            let is_counted = (alternative, true) != (CHOSEN_BY.0, reading.seed < CHOSEN_BY.1);
            let list = if is_counted { &mut counts[usize::from(outside)] } else { &mut chosen_by };
            list.iter_mut().zip(one).for_each(|(sum, one)| *sum += one);
        }
        let [[within, told_within, nowhere_within], [outside, told, nowhere]] = counts;
        println!(
            "{alternative}: {outside} outside all predictions, {told} of them told; {within} within, {told_within} told"
        );
        if alternative == CHOSEN_BY.0 {
            println!("not counted, since the distance was chosen by them: {}, {} told", chosen_by[0], chosen_by[1]);
        }
        if play_mm == FILE_PLAY_MM {
            println!(
                "kept at none of {BRUTE_FORCE} plays: {nowhere} outside, {nowhere_within} within, {} not counted",
                chosen_by[2]
            );
        }
        told_all.push((alternative, outside, told));
    }
    for list in [&mut widths, &mut narrowed, &mut credible] {
        list.sort_by(f64::total_cmp);
    }
    println!("{count} readings, {missed} misses");
    println!("width over brute force: median {:.3}, largest {:.3}", widths[widths.len() / 2], widths[widths.len() - 1]);
    println!("share of the interval left: median {:.3}", narrowed[narrowed.len() / 2]);
    println!(
        "credible intervals: {given} given, {not_held} misses; median width over the set {:.3}",
        credible[credible.len() / 2]
    );
    assert!(missed as f64 <= MAX_MISSES * count as f64, "{missed} of {count}");
    assert!(widths[widths.len() - 1] <= MAX_WIDTH, "{widths:?}");
    for (alternative, outside, told) in told_all {
        assert!(told as f64 >= MIN_TOLD * outside as f64, "{alternative}: {told} of {outside}");
    }
}
