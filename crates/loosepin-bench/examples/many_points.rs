//! Bounds of a response with ninety hills in the unit square, by more points than one model of the search sees:
//! `just campaign many-points [SEEDS]`. Ends with status 1 where a bound does not hold, or where 1,200 points are not enough for bounds
//! within 0.1 % of their true width.

use loosepin::bounds::{BoundPair, Function, Problem, Request, Sampling, Statistic, evaluate};
use loosepin::uncertainty::{Interval, uniform};
use std::time::Instant;

/// Heights of the hills above and below 0.
const HEIGHT: f64 = 1.7;
/// Round-off of numbers about 1.
const ROUND_OFF: f64 = 1e-12;
/// Points, and by which share of their true width bounds may be too wide with them.
const PLANS: [(usize, f64); 3] = [(512, f64::INFINITY), (900, f64::INFINITY), (1200, 1e-3)];

fn main() {
    let seeds = std::env::args().nth(1).map_or(3, |word| word.parse::<u64>().expect("a number of seeds"));
    println!("{:>6} {:>5} {:>6} {:>9} {:>9} {:>8}", "points", "seed", "used", "lower", "upper", "seconds");
    let mut is_met = true;
    for (outer, max_excess) in PLANS {
        for seed in 0..seeds {
            let started = Instant::now();
            let (used, BoundPair { lower, upper, .. }) = bounds(seed, outer);
            let holds = lower.widened <= ROUND_OFF - HEIGHT && upper.widened >= HEIGHT - ROUND_OFF;
            let excess = (upper.widened - lower.widened) / (2.0 * HEIGHT) - 1.0;
            is_met &= holds && excess <= max_excess;
            let (lower, upper, seconds) = (lower.widened, upper.widened, started.elapsed().as_secs_f64());
            println!("{outer:>6} {seed:>5} {used:>6} {lower:>9.4} {upper:>9.4} {seconds:>8.1}");
        }
    }
    std::process::exit(i32::from(!is_met));
}

/// Points that were used, and the bounds of u ↦ sin(61 u₁ + a) + 0.7 sin(53 u₂ + 8 u₁ + b), whose hills are moved otherwise by each seed.
fn bounds(seed: u64, outer: usize) -> (usize, BoundPair) {
    let (a, b) = (uniform(seed, 0), uniform(seed, 1));
    let unit = Interval::try_new(0.0, 1.0).expect("the ends are in order");
    let request = Request { column: 0, statistic: Statistic::Mean };
    let mut problem = Problem::new(Vec::new(), vec![unit.into(), unit.into()], vec![request]);
    problem.sampling = Sampling { outer, seed, ..Sampling::default() };
    let response = move |_: &[f64], u: &[f64]| {
        let (long, short) = (61.0 * u[0] + a, 53.0 * u[1] + 8.0 * u[0] + b);
        libm::sin(long) + 0.7 * libm::sin(short)
    };
    let bounds = evaluate(problem, &Function(response)).expect("a problem that can be planned");
    (bounds.outer_points.len(), bounds.pairs.into_iter().next().expect("one statistic"))
}
