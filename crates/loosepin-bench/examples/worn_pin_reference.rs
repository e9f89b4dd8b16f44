//! A reference for the bounds of `cases/slider_crank_worn_pin` from about a million runs, and its study held against it seed by seed.
//!
//! `worn_pin_reference make FILE SEED [NOTE ...]`: three stages, each with mechanisms of its own.
//! 1. *Find*: 3,000 values of u (Sobol' points inside the box, even points on its edges, its corners), the same 192 mechanisms at each.
//! 2. *Choose*: the 16 best values of each end of each statistic, 2,048 other mechanisms at each. The best of all of them is the witness:
//!    a value that was best by the luck of its first mechanisms is not.
//! 3. *Measure*: 8,192 mechanisms more at each witness. Its statistic there is the end of the reference. Nothing was chosen by these
//!    runs, so luck does not move it outwards.
//!
//! How far the reference itself can be relied on: made once more with seed 2000001, the ends of means moved by 0.01 % of the
//! width, those of quantiles by 0.4 %, those of the standard deviation of the largest by 6 %, of the rms by 15 %. Standard deviations
//! have extremes narrower than the distance of 3,000 values of u: the reference of these falls short of the true ones.
//!
//! `worn_pin_reference hold SEEDS`: the study with seeds 1 to SEEDS. A bound misses where it does not reach the end of the reference less
//! 2.6 of its standard errors.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use loosepin::bounds::Statistic;
use loosepin::math::dense::Cholesky;
use loosepin::study::result::{BoundRecord, Treatment};
use loosepin::study::{Study, StudyRun};
use loosepin_bench::fresh_runs::{FreshRuns, Mechanisms, Sample};
use loosepin_bench::worn_pin::{double_loop, low_discrepancy_fractions, run_at, values_at};
use loosepin_bench::worn_pin_reference::{
    ASKED, Asked, ENDS, REDUCTIONS, ReferenceEnd, estimate, file, read, standard_error, study, written,
};
use loosepin_bench::{largest, median, run};
use std::time::Instant;

const VALUES_INSIDE: u32 = 2600;
/// Between two corners.
const VALUES_ON_AN_EDGE: u32 = 99;
const MECHANISMS_TO_FIND: u32 = 192;
/// Values of u that the second stage looks at again, for each end of each statistic.
const BEST: usize = 16;
/// Independent scramblings, for standard errors.
const REPLICATES: u32 = 16;
const TO_CHOOSE_IN_EACH: u32 = 128;
const TO_MEASURE_IN_EACH: u32 = 512;
/// Two-sided 99 % of a normal error.
const STANDARD_ERRORS: f64 = 2.6;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        // The seed is that of the values of u; those of the mechanisms of each stage count up from it. No study that is held has one of them.
        ["make", file, seed, ref notes @ ..] => make(file, seed.parse().expect("a seed"), notes),
        ["hold", seeds] => hold(seeds.parse().expect("a number of seeds")),
        _ => panic!("expected make FILE SEED [NOTE ...], or hold SEEDS; found {arguments:?}"),
    }
}

/// Makes the reference.
fn make(file: &str, seed: u64, notes: &[&str]) {
    let started = Instant::now();
    let study = study();
    assert_eq!(study.epistemic.len(), 2, "the clearance and the restitution");
    let mut runs = FreshRuns::new(&study);
    check(&study, &mut runs, seed);
    let done = |made: usize| eprintln!("{made} runs, {:.0} s", started.elapsed().as_secs_f64());

    let fractions = values_to_try(&study, seed);
    let values: Vec<Vec<f64>> = fractions.iter().map(|fractions| values_at(&study, fractions)).collect();
    let found = runs.at(&values, &Mechanisms::new(&study, seed + 1, 1, MECHANISMS_TO_FIND), done);
    let surfaces: Vec<Vec<f64>> = ASKED.iter().map(|asked| surface(asked, &found)).collect();

    let mut again: Vec<usize> = surfaces.iter().flat_map(|surface| ends(surface).concat()).collect();
    again.sort_unstable();
    again.dedup();
    let again: Vec<Vec<f64>> = again.into_iter().map(|place| values[place].clone()).collect();
    let chosen = runs.at(&again, &Mechanisms::new(&study, seed + 2, REPLICATES, TO_CHOOSE_IN_EACH), done);

    // Chosen among all that were run again, not among its own 16 alone.
    let witnesses: Vec<Vec<f64>> =
        ASKED.iter().flat_map(|asked| ends(&surface(asked, &chosen)).map(|best| chosen[best[0]].at.clone())).collect();
    let measured = runs.at(&witnesses, &Mechanisms::new(&study, seed + 3, REPLICATES, TO_MEASURE_IN_EACH), done);
    let reference: Vec<ReferenceEnd> =
        measured.iter().enumerate().map(|(place, at)| reference_end(place, at)).collect();

    let seconds = started.elapsed().as_secs_f64();
    let mut head = vec![
        "Bounds of cases/slider_crank_worn_pin: the least and the largest statistic over the box of what is unknown, SI.".to_owned(),
        "Written by `just campaign worn-pin-reference make`; do not edit.".to_owned(),
    ];
    head.extend(notes.iter().map(|&note| note.to_owned()));
    head.push(format!(
        "{} runs in {seconds:.0} s, {} without a result; seeds {seed} to {}.",
        runs.made(),
        runs.failed(),
        seed + 3
    ));
    head.push(format!(
        "{} values of u with {MECHANISMS_TO_FIND} mechanisms, the {} best again with {}, each witness with {}.",
        values.len(),
        again.len(),
        REPLICATES * TO_CHOOSE_IN_EACH,
        REPLICATES * TO_MEASURE_IN_EACH
    ));
    head.push(
        "How rough: the statistic over the first values of u, and the standard deviation that a cubic in u leaves, SI:"
            .to_owned(),
    );
    for (asked, surface) in ASKED.iter().zip(&surfaces) {
        let [least, most] = [surface.iter().copied().fold(f64::INFINITY, f64::min), largest(surface)];
        head.push(format!("  {}: {least:.3e} to {most:.3e}, {:.1e}", asked.name, left_by_a_cubic(&fractions, surface)));
    }
    let text = written(&head, &reference);
    std::fs::write(file, &text).unwrap_or_else(|error| panic!("{file}: {error}"));
    println!("{text}");
}

/// The numbers are those of the study, bit by bit: its own mechanisms in the middle of the box, run both ways.
fn check(study: &Study, runs: &mut FreshRuns<'_>, seed: u64) {
    let middle = values_at(study, &[0.5, 0.5]);
    let conducted = run_at(study, MECHANISMS_TO_FIND as usize, &middle, seed).runs;
    let inputs: Vec<Vec<f64>> = study.random.iter().map(|input| double_loop(&conducted, &input.path)).collect();
    let mechanisms = (0..inputs[0].len()).map(|row| inputs.iter().map(|values| values[row]).collect()).collect();
    let sample = &runs.at(&[middle], &Mechanisms::given(mechanisms), |_| {})[0];
    for (ask, (reduction, values)) in study.asks.iter().zip(REDUCTIONS.iter().zip(&sample.columns)) {
        let output = &study.outputs[ask.output].name;
        let expected = double_loop(&conducted, &format!("{output} total {}", reduction.word()));
        assert_eq!(*values, expected, "{}: the numbers of the study", reduction.word());
    }
}

/// Points of the box, as shares of it.
fn values_to_try(study: &Study, seed: u64) -> Vec<Vec<f64>> {
    let mut points = low_discrepancy_fractions(study, seed, VALUES_INSIDE);
    let steps = VALUES_ON_AN_EDGE + 1;
    for step in 0..steps {
        let along = f64::from(step) / f64::from(steps);
        // Round the box, each edge from its first corner on.
        points.extend([vec![along, 0.0], vec![1.0, along], vec![1.0 - along, 1.0], vec![0.0, 1.0 - along]]);
    }
    points
}

/// S at each value of u.
fn surface(asked: &Asked, samples: &[Sample]) -> Vec<f64> {
    samples.iter().map(|sample| estimate(asked.statistic, values_of(asked, sample))).collect()
}

fn values_of<'s>(asked: &Asked, sample: &'s Sample) -> &'s [f64] {
    let place = REDUCTIONS.iter().position(|&reduction| reduction == asked.reduction).expect("one of the two");
    &sample.columns[place]
}

/// Places of the least values and of the largest, the outermost first; among equals the first.
fn ends(surface: &[f64]) -> [Vec<usize>; 2] {
    [1.0, -1.0].map(|sign| {
        let mut places: Vec<usize> = (0..surface.len()).collect();
        places.sort_by(|&a, &b| (sign * surface[a]).total_cmp(&(sign * surface[b])));
        places.truncate(BEST);
        places
    })
}

fn reference_end(place: usize, sample: &Sample) -> ReferenceEnd {
    let asked = &ASKED[place / ENDS.len()];
    let values = values_of(asked, sample);
    ReferenceEnd {
        asked: place / ENDS.len(),
        end: place % ENDS.len(),
        value_si: estimate(asked.statistic, values),
        standard_error_si: standard_error(asked.statistic, values, REPLICATES as usize),
        witness: [sample.at[0], sample.at[1]],
        mechanisms: values.len(),
    }
}

/// The standard deviation of what the cubic of least squares in two variables leaves.
fn left_by_a_cubic(fractions: &[Vec<f64>], surface: &[f64]) -> f64 {
    let terms = |at: &[f64]| -> Vec<f64> {
        let [x, y] = [0, 1].map(|place| 2.0 * at[place] - 1.0);
        (0..=3).flat_map(|degree| (0..=degree).map(move |k| x.powi(degree - k) * y.powi(k))).collect()
    };
    let rows: Vec<Vec<f64>> = fractions.iter().map(|at| terms(at)).collect();
    let count = rows[0].len();
    let sum = |of: &dyn Fn(usize) -> f64| (0..rows.len()).map(of).sum::<f64>();
    let normal = (0..count * count).map(|at| sum(&|row| rows[row][at / count] * rows[row][at % count])).collect();
    let mut coefficients: Vec<f64> = (0..count).map(|at| sum(&|row| rows[row][at] * surface[row])).collect();
    Cholesky::new(normal, count).expect("more values of u than terms").solve(&mut coefficients);
    let left = |row: usize| {
        surface[row] - rows[row].iter().zip(&coefficients).map(|(term, coefficient)| term * coefficient).sum::<f64>()
    };
    (sum(&|row| left(row) * left(row)) / (rows.len() - count) as f64).sqrt()
}

/// What all seeds said of one statistic.
struct Tally {
    asked: usize,
    /// Lower and upper end of the reference.
    ends: [ReferenceEnd; 2],
    /// Seeds whose bound does not reach it.
    missed: [usize; 2],
    /// Widened width over that of the reference.
    widths: Vec<f64>,
}

/// Holds the study against the reference.
fn hold(seeds: u64) {
    assert!(seeds > 0, "at least one seed");
    let started = Instant::now();
    let path = file();
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let ends = read(&text);
    let mut study = study();
    let is_asked = |asked: &Asked| {
        study.asks.iter().zip(REDUCTIONS).any(|(ask, reduction)| {
            reduction == asked.reduction && ask.statistics().any(|statistic| is_same(statistic, asked.statistic))
        })
    };
    let tally = |asked: usize| {
        let end =
            |end| ends.iter().find(|one: &&ReferenceEnd| one.asked == asked && one.end == end).expect("an end").clone();
        Tally { asked, ends: [end(0), end(1)], missed: [0; 2], widths: Vec::new() }
    };
    let mut tallies: Vec<Tally> = (0..ASKED.len()).filter(|&place| is_asked(&ASKED[place])).map(tally).collect();
    let mut runs = 0;
    for seed in 1..=seeds {
        study.seed = seed;
        let StudyRun { result, .. } = run(&study);
        runs = result.counts.runs;
        for tally in &mut tallies {
            tally.take(seed, &result.bounds);
        }
        eprintln!("seed {seed}, {:.0} s", started.elapsed().as_secs_f64());
    }
    println!("{seeds} seeds, {runs} runs each; lengths in mm, probabilities as they are.");
    println!("Missed: short of the reference by more than {STANDARD_ERRORS} of its standard errors.");
    println!("Width: that of the widened bounds over that of the reference.\n");
    println!("| statistic | reference | standard errors | missed below | above | width, median | largest |");
    println!("|---|--:|--:|--:|--:|--:|--:|");
    for tally in &tallies {
        tally.print();
    }
}

fn is_same(a: Statistic, b: Statistic) -> bool {
    let is_near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    a.word() == b.word() && a.parameter().zip(b.parameter()).is_none_or(|(a, b)| is_near(a, b))
}

impl Tally {
    fn take(&mut self, seed: u64, bounds: &[BoundRecord]) {
        let asked = &ASKED[self.asked];
        let is_its = |bound: &&BoundRecord| {
            bound.treatment == Treatment::Mixed
                && bound.at.reduction() == Some(asked.reduction)
                && is_same(bound.statistic, asked.statistic)
        };
        let found: Vec<&BoundRecord> = bounds.iter().filter(is_its).collect();
        let [bound] = found[..] else { panic!("{}: {} bounds", asked.name, found.len()) };
        let widened = [bound.lower.widened_si, bound.upper.widened_si];
        for (end, sign) in [1.0, -1.0].into_iter().enumerate() {
            let reference = &self.ends[end];
            let short_si = sign * (widened[end] - reference.value_si);
            if short_si > STANDARD_ERRORS * reference.standard_error_si {
                self.missed[end] += 1;
                eprintln!(
                    "seed {seed}, {}, {}: {:.6e}, reference {:.6e} ± {:.1e}",
                    asked.name, ENDS[end], widened[end], reference.value_si, reference.standard_error_si
                );
            }
        }
        self.widths.push((widened[1] - widened[0]) / (self.ends[1].value_si - self.ends[0].value_si));
    }

    fn print(&self) {
        let asked = &ASKED[self.asked];
        let scale = if asked.statistic.is_probability() { 1.0 } else { 1e3 };
        let [lower, upper] = &self.ends;
        // A statistic that is the same everywhere has no width.
        let width =
            |ratio: f64| if upper.value_si > lower.value_si { format!("{ratio:.3}") } else { "none".to_owned() };
        println!(
            "| {} | {:.4} to {:.4} | {:.5}, {:.5} | {} | {} | {} | {} |",
            asked.name,
            scale * lower.value_si,
            scale * upper.value_si,
            scale * lower.standard_error_si,
            scale * upper.standard_error_si,
            self.missed[0],
            self.missed[1],
            width(median(&self.widths)),
            width(largest(&self.widths)),
        );
    }
}
