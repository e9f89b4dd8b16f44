//! Bounds of the problems that a referee found missed, against the exact ones, over many seeds: `just campaign refereed-bounds SEEDS [NAME]`.
//!
//! Each end of each statistic may be missed in 0.5 % of the samples. Of every end the number of misses is held against that by a binomial
//! test, and the level of all tests together, 1 %, is divided by their number (C. E. Bonferroni). The seeds are 1 to SEEDS.

#[allow(dead_code, reason = "the other campaign reads the rest of it")]
#[path = "../../tests/exact/mod.rs"]
mod exact;
mod problems;

use exact::{Case, LEVEL, Met, median, most_misses};
use loosepin_bounds::{Bound, BoundPair, evaluate};
use problems::cases;
use rayon::prelude::*;

/// What all seeds say of one statistic of one case.
struct Line {
    name: String,
    /// Lower, upper.
    missed: [u64; 2],
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
    let met: Vec<Vec<Met>> = all.iter().map(|pairs| case.met(pairs)).collect();
    let of_statistic = |place: usize| {
        let exact = &case.exact[place];
        let name = format!("{}, {:?}", case.name, exact.statistic);
        let own = || met.iter().map(|met| met[place]);
        for (seed, (pairs, met)) in (1..).zip(all.iter().zip(own())) {
            let ends = [&pairs[place].lower, &pairs[place].upper];
            for end in [0, 1].into_iter().filter(|&end| met.is_missed[end]) {
                let Bound { value, widened, error, .. } = ends[end];
                println!(
                    "{name} seed {seed}: exact {:.9} widened {widened:.9} value {value:.9}, sampling {:.1e}, optimisation {:.1e}",
                    exact.ends[end], error.sampling, error.optimisation
                );
            }
        }
        Line {
            name,
            missed: [0, 1].map(|end| own().filter(|met| met.is_missed[end]).count() as u64),
            furthest: own().flat_map(|met| met.short).fold(0.0, f64::max),
            unknown: own().filter(|met| met.has_no_end).count(),
            median_width: median(own().map(|met| met.width).collect()),
        }
    };
    (0..case.exact.len()).map(of_statistic).collect()
}
