//! How often the bounds of known cases hold, and how much too large their stated errors are:
//! `just campaign bounds [SEEDS] [ANGLES]`.

use loosepin::bounds::{Statistic, evaluate};
use loosepin_bench::known_bounds::{KnownCase, slider_crank_with_play};
use std::time::Instant;

/// Round-off of numbers about 1.
const ROUND_OFF: f64 = 1e-12;
/// Actual errors below this share of the width are not compared with stated ones.
const LEAST_SHARE: f64 = 1e-6;

/// What all seeds said of one statistic.
struct Tally {
    statistic: Statistic,
    exact: (f64, f64),
    held: u64,
    /// The furthest that an exact value lay outside of a widened one, at the lower and at the upper end.
    missed: [f64; 2],
    /// Stated error over actual one, at either end.
    ratios: Vec<f64>,
    /// Widened width over the true one.
    widths: Vec<f64>,
}

fn main() {
    let mut arguments = std::env::args().skip(1).map(|word| word.parse::<u64>().expect("a number"));
    let (seeds, angles) = (arguments.next().unwrap_or(100), arguments.next().unwrap_or(0));
    let only = std::env::var("LOOSEPIN_CASE").unwrap_or_default();
    println!(
        "{:32} {:24} {:>22} {:>11} {:>12} {:>9} {:>19}",
        "case", "statistic", "exact", "held", "stated/true", "width", "missed by at most"
    );
    for case in KnownCase::all().into_iter().filter(|case| case.name.contains(&only)) {
        report(&case, seeds);
    }
    let step = std::f64::consts::TAU / 72.0;
    for angle in 0..angles {
        report(&slider_crank_with_play(step * angle as f64), seeds.min(100));
    }
}

fn report(case: &KnownCase, seeds: u64) {
    let mut tallies: Vec<Tally> = case
        .statistics
        .iter()
        .map(|&(statistic, exact)| Tally {
            statistic,
            exact,
            held: 0,
            missed: [0.0; 2],
            ratios: Vec::new(),
            widths: Vec::new(),
        })
        .collect();
    let (started, mut runs) = (Instant::now(), 0);
    for seed in 1..=seeds {
        let bounds = evaluate(case.problem(seed), case).expect("the case can be planned");
        runs = runs.max(bounds.runs);
        for (pair, tally) in bounds.pairs.iter().zip(&mut tallies) {
            let (low, high) = tally.exact;
            tally.held += u64::from(pair.lower.widened <= low + ROUND_OFF && pair.upper.widened >= high - ROUND_OFF);
            let beyond = [pair.lower.widened - low, high - pair.upper.widened];
            tally.missed = [0, 1].map(|end| tally.missed[end].max(beyond[end]));
            let width = if high > low { high - low } else { low.abs().max(1.0) };
            for (bound, exact) in [(&pair.lower, low), (&pair.upper, high)] {
                let actual = (bound.value - exact).abs();
                if actual > LEAST_SHARE * width {
                    tally.ratios.push(bound.error.total() / actual);
                }
            }
            tally.widths.push((pair.upper.widened - pair.lower.widened) / width);
        }
    }
    for tally in &mut tallies {
        println!(
            "{:32} {:24} [{:9.5}, {:9.5}] {:>5}/{:<5} {:>11.2} {:>9.5} {:>9.1e} {:>9.1e}",
            case.name,
            format!("{:?}", tally.statistic),
            tally.exact.0,
            tally.exact.1,
            tally.held,
            seeds,
            median(&mut tally.ratios),
            median(&mut tally.widths),
            tally.missed[0],
            tally.missed[1],
        );
    }
    println!("{:32} {runs} runs, {:.3} s each\n", "", started.elapsed().as_secs_f64() / seeds as f64);
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
