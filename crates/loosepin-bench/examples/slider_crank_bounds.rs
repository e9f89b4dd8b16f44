//! Bounds of the slider-crank with play, seed after seed, as rows for `tools/compare/bounds.py`: this library's part in that
//! comparison.
//!
//! `slider_crank_bounds SEEDS` prints `seed,statistic,lower,upper,lower_widened,upper_widened,evaluations,seconds`; the mean, the
//! deviation and the quantiles are in mm.

use loosepin::bounds::{Statistic, evaluate};
use loosepin_bench::known_bounds::slider_crank_with_play;
use std::f64::consts::FRAC_PI_3;
use std::time::Instant;

/// What `tools/compare/bounds/problem.py` calls a statistic of this case.
fn name(statistic: Statistic) -> String {
    match statistic {
        Statistic::Mean => "mean".into(),
        Statistic::StandardDeviation => "deviation".into(),
        Statistic::Quantile(probability) => format!("quantile {probability}"),
        Statistic::ProbabilityBeyond(limit) => format!("beyond {limit:.2}"),
        other => unreachable!("the case does not ask for {other:?}"),
    }
}

fn main() {
    let seeds = std::env::args().nth(1).map_or(12, |word| word.parse::<u64>().expect("a number of seeds"));
    // As the other programs are asked.
    let case = slider_crank_with_play(FRAC_PI_3).cut_open();
    println!("seed,statistic,lower,upper,lower_widened,upper_widened,evaluations,seconds");
    for seed in 1..=seeds {
        let started = Instant::now();
        let bounds = evaluate(case.problem(seed), &case).expect("the case can be planned");
        let seconds = started.elapsed().as_secs_f64();
        assert_eq!(bounds.pairs.len(), case.statistics.len());
        for (pair, &(statistic, _)) in bounds.pairs.iter().zip(&case.statistics) {
            println!(
                "{seed},{},{:e},{:e},{:e},{:e},{},{seconds:.4}",
                name(statistic),
                pair.lower.value,
                pair.upper.value,
                pair.lower.widened,
                pair.upper.widened,
                bounds.runs,
            );
        }
    }
}
