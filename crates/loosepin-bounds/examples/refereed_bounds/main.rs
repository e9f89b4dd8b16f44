//! Bounds of the problems that a referee found missed, against the exact ones, over many seeds: `just campaign refereed-bounds SEEDS [NAME]`.
//!
//! Each end of each statistic may be missed in 0.5 % of the samples. Of every end the number of misses is held against that by a binomial
//! test, and the level of all tests together, 1 %, is divided by their number (C. E. Bonferroni). The seeds are 1 to SEEDS.

mod problems;

use loosepin_bounds::{Bound, BoundPair, evaluate};
use loosepin_uncertainty::binomial_tail;
use problems::{Case, cases};
use rayon::prelude::*;

/// Probability of a miss that is stated for an end.
const STATED_MISS: f64 = 0.005;
/// Probability with which any test fails where all ends miss as often as stated.
const LEVEL: f64 = 0.01;
/// Round-off, of the exact width and of the response.
const ROUND_OFF: [f64; 2] = [1e-9, 1e-12];

/// What all seeds say of one statistic of one case.
struct Line {
    name: String,
    /// Lower, upper.
    missed: [usize; 2],
    /// By how much at most, in exact widths.
    furthest: f64,
    /// Seeds with an end that is not known.
    unknown: usize,
    /// Of widened over exact width; infinite ones count.
    median_width: f64,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = words.first().and_then(|word| word.parse::<u64>().ok());
    let Some(seeds) = number.filter(|&seeds| seeds > 0) else {
        eprintln!("usage: refereed-bounds SEEDS [NAME]\n  NAME: only cases whose names contain it");
        std::process::exit(2)
    };
    let meant = |case: &Case| words.get(1).is_none_or(|part| case.name.contains(part.as_str()));
    let cases: Vec<Case> = cases().into_iter().filter(meant).collect();
    let lines: Vec<Line> = cases.iter().flat_map(|case| lines(case, seeds)).collect();
    let tests = 2 * lines.len();
    let allowed = most_misses(seeds, LEVEL / tests.max(1) as f64);
    println!("{:58} {:>6} {:>6} {:>9} {:>8} {:>9}", "", "lower", "upper", "furthest", "unknown", "width");
    for line in &lines {
        let fails = line.missed.iter().any(|&missed| missed > allowed);
        println!(
            "{:58} {:6} {:6} {:9.1e} {:8} {:9.3} {}",
            line.name,
            line.missed[0],
            line.missed[1],
            line.furthest,
            line.unknown,
            line.median_width,
            if fails { "fails" } else { "" }
        );
    }
    let failed = lines.iter().flat_map(|line| line.missed).filter(|&missed| missed > allowed).count();
    println!("\n{seeds} seeds: {failed} of {tests} ends are missed more than {allowed} times, too often for 0.5 %");
}

/// Each statistic of `case`, over all seeds.
fn lines(case: &Case, seeds: u64) -> Vec<Line> {
    let of_seed = |seed: u64| evaluate(case.question(seed), case).expect("the case can be planned").pairs;
    let all: Vec<Vec<BoundPair>> = (1..=seeds).into_par_iter().map(of_seed).collect();
    case.exact
        .iter()
        .enumerate()
        .map(|(place, exact)| {
            let [low, high] = exact.ends;
            let width = if high > low { high - low } else { low.abs().max(f64::MIN_POSITIVE) };
            let allowed = (ROUND_OFF[0] * width).max(ROUND_OFF[1] * case.magnitude);
            let mut line = Line {
                name: format!("{}, {:?}", case.name, exact.statistic),
                missed: [0; 2],
                furthest: 0.0,
                unknown: 0,
                median_width: 0.0,
            };
            let mut widths = Vec::new();
            for (seed, pairs) in (1..).zip(&all) {
                let ends = [&pairs[place].lower, &pairs[place].upper];
                let inside = [ends[0].widened - low, high - ends[1].widened];
                for (end, missed) in line.missed.iter_mut().enumerate() {
                    line.furthest = line.furthest.max(inside[end] / width);
                    if !(inside[end] <= allowed) {
                        *missed += 1;
                        let Bound { value, widened, error, .. } = ends[end];
                        println!(
                            "{} seed {seed}: exact {:.9} widened {widened:.9} value {value:.9}, sampling {:.1e}, optimisation {:.1e}",
                            line.name, exact.ends[end], error.sampling, error.optimisation
                        );
                    }
                }
                line.unknown += usize::from(ends.iter().any(|end| end.widened.is_infinite()));
                widths.push((ends[1].widened - ends[0].widened) / width);
            }
            widths.sort_by(f64::total_cmp);
            line.median_width = widths[widths.len() / 2];
            line
        })
        .collect()
}

/// The largest number of misses of `seeds` that is not less probable than `level` where an end is missed with [`STATED_MISS`].
fn most_misses(seeds: u64, level: f64) -> usize {
    let is_last = |misses: &u64| binomial_tail(seeds, misses + 1, STATED_MISS) < level;
    (0..=seeds).find(is_last).unwrap_or(seeds) as usize
}
