//! How often the bounds of known cases hold, and how much too large their stated errors are:
//! `just campaign bounds [SEEDS] [ANGLES] [CASE]`. Ends with status 1 where a statistic held in fewer than 98 % of the seeds, or where
//! the median of stated over actual error is above 6.

use loosepin::bounds::{BoundPair, Statistic, evaluate};
use loosepin_bench::hard_bounds;
use loosepin_bench::known_bounds::{self, slider_crank_with_play};
use loosepin_bench::known_case::KnownCase;
use loosepin_bench::{largest, median};
use std::ops::Range;
use std::time::Instant;

/// Round-off of numbers about 1.
const ROUND_OFF: f64 = 1e-12;
/// Actual errors below this share of the width are not compared with stated ones.
const MIN_SHARE: f64 = 1e-6;
/// Share of the seeds in which a statistic must hold.
const MIN_HELD: f64 = 0.98;
/// Widened bounds that exceed the true width by at most this share of it are counted.
const NEARLY_EXACT: f64 = 1e-3;
/// Greatest median of stated over actual error.
const MAX_RATIO: f64 = 6.0;

/// What all seeds said of one statistic.
struct Tally {
    statistic: Statistic,
    exact: (f64, f64),
    held: u64,
    /// The furthest that an exact value lay outside of a widened one, at the lower and at the upper end.
    missed: [f64; 2],
    /// Stated error over actual one, at either end, of those that are compared.
    ratios: Vec<f64>,
    /// Ends, compared or not.
    ends: usize,
    /// By how much the widened width exceeds the true one, as a share of it.
    excess: Vec<f64>,
}

fn main() {
    let mut words = std::env::args().skip(1);
    let seeds: u64 = words.next().map_or(100, |word| word.parse().expect("a number of seeds"));
    let angles = words.next().map_or(0..0, |word| indices(&word));
    let only = words.next().unwrap_or_default();
    println!(
        "{:32} {:24} {:>22} {:>11} {:>11} {:>13} {:>13} {:>17} {:>19}",
        "case",
        "statistic",
        "exact",
        "held",
        "stated/true",
        "ends compared",
        "within 0.1 %",
        "too wide: median",
        "largest; missed by"
    );
    let mut is_met = true;
    let cases = known_bounds::all().into_iter().chain(hard_bounds::hard());
    for case in cases.filter(|case| case.name.contains(&only)) {
        is_met &= report(&case, seeds);
    }
    let step = std::f64::consts::TAU / 72.0;
    for angle in angles {
        is_met &= report(&slider_crank_with_play(step * angle as f64), seeds.min(100));
    }
    if !is_met {
        println!("some statistic held in fewer than {MIN_HELD} of the seeds, or has a median above {MAX_RATIO}");
        std::process::exit(1);
    }
}

/// The first so many indices, or those from A up to B without B: `A..B`.
fn indices(word: &str) -> Range<u64> {
    let number = |word: &str| word.parse().expect("a number of angles, or A..B");
    word.split_once("..").map_or_else(|| 0..number(word), |(first, end)| number(first)..number(end))
}

/// Prints what all seeds say of one case, and tells whether it is good enough.
fn report(case: &KnownCase, seeds: u64) -> bool {
    let tally = |&(statistic, exact): &(Statistic, (f64, f64))| Tally {
        statistic,
        exact,
        held: 0,
        missed: [0.0; 2],
        ratios: Vec::new(),
        ends: 0,
        excess: Vec::new(),
    };
    let mut tallies: Vec<Tally> = case.statistics.iter().map(tally).collect();
    let (started, mut runs) = (Instant::now(), 0);
    for seed in 1..=seeds {
        let bounds = evaluate(case.problem(seed), case).expect("the case can be planned");
        runs = runs.max(bounds.runs);
        assert_eq!(bounds.pairs.len(), case.statistics.len(), "{}: bounds", case.name);
        assert_eq!(bounds.levels.len(), case.levels.len(), "{}: levels", case.name);
        for (place, tally) in tallies.iter_mut().enumerate() {
            // A fuzzy number has bounds at each degree: all of them must hold.
            let pairs: Vec<(&BoundPair, (f64, f64))> = if case.levels.is_empty() {
                vec![(&bounds.pairs[place], tally.exact)]
            } else {
                bounds
                    .levels
                    .iter()
                    .zip(&case.levels)
                    .map(|(level, exact)| (&level.pairs[place], exact[place]))
                    .collect()
            };
            let held = pairs.iter().all(|(pair, exact)| tally.take(pair, *exact));
            tally.held += u64::from(held);
        }
    }
    let mut is_met = true;
    for tally in &tallies {
        let (ratio, share) = (median(&tally.ratios), tally.held as f64 / seeds as f64);
        is_met &= share >= MIN_HELD && ratio <= MAX_RATIO;
        let nearly_exact = tally.excess.iter().filter(|share| **share <= NEARLY_EXACT).count();
        let (excess, compared) = (median(&tally.excess), tally.ratios.len());
        println!(
            "{:32} {:24} [{:9.5}, {:9.5}] {:>5}/{:<5} {ratio:>11.2} {:>13} {nearly_exact:>13} {excess:>17.1e} {:>8.1e} {:>8.1e} {:>8.1e}",
            case.name,
            format!("{:?}", tally.statistic),
            tally.exact.0,
            tally.exact.1,
            tally.held,
            seeds,
            format!("{compared}/{}", tally.ends),
            largest(&tally.excess),
            tally.missed[0],
            tally.missed[1],
        );
    }
    println!("{:32} {runs} runs, {:.3} s each\n", "", started.elapsed().as_secs_f64() / seeds as f64);
    is_met
}

impl Tally {
    /// Counts one pair of bounds; tells whether it holds.
    fn take(&mut self, pair: &BoundPair, (low, high): (f64, f64)) -> bool {
        let beyond = [pair.lower.widened - low, high - pair.upper.widened];
        self.missed = [0, 1].map(|end| self.missed[end].max(beyond[end]));
        let width = if high > low { high - low } else { low.abs().max(1.0) };
        for (bound, exact) in [(&pair.lower, low), (&pair.upper, high)] {
            let actual = (bound.value - exact).abs();
            self.ends += 1;
            if actual > MIN_SHARE * width {
                self.ratios.push(bound.error.total() / actual);
            }
        }
        self.excess.push((pair.upper.widened - pair.lower.widened - (high - low)) / width);
        beyond.iter().all(|beyond| *beyond <= ROUND_OFF)
    }
}
