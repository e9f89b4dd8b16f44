//! Bounds of the slider-crank with play, seed after seed, as rows for `tools/compare/bounds.py`: this library's part in that
//! comparison.
//!
//! `slider_crank_bounds SEEDS [smooth | rough]` prints `seed,statistic,lower,upper,lower_widened,upper_widened,evaluations,seconds`; the mean, the
//! deviation and the quantiles are in mm. The rough problem adds a normal number to each of 60 x 60 cells of the box, and another one to
//! each evaluation, as `tools/compare/bounds/problem.py` does.

use loosepin::bounds::{Statistic, evaluate};
use loosepin::uncertainty::{hash, normal};
use loosepin_bench::known_bounds::slider_crank_with_play;
use loosepin_bench::known_case::KnownCase;
use std::f64::consts::FRAC_PI_3;
use std::sync::Arc;
use std::time::Instant;

/// Cells along each side of the box, and the standard deviations of what they and single evaluations add.
const CELLS: f64 = 60.0;
const ROUGHNESS_MM: f64 = 0.07;
const NOISE_MM: f64 = 0.03;

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

/// `case` with what its cell and the evaluation itself add.
fn roughened(case: KnownCase) -> KnownCase {
    let smooth = case.function.clone();
    let ends: Vec<[f64; 2]> = case.epistemic.iter().map(|input| input.ends()).collect();
    let function = move |x: &[f64], u: &[f64]| {
        let cell = |axis: usize| {
            let [low, high] = ends[axis];
            ((CELLS * ((u[axis] - low) / (high - low))).floor() as u64).min(CELLS as u64 - 1)
        };
        let own = hash(hash(x[0].to_bits(), x[1].to_bits()), u[0].to_bits());
        let rough = ROUGHNESS_MM * normal(0, cell(0) * CELLS as u64 + cell(1));
        smooth(x, u) + rough + NOISE_MM * normal(own, u[1].to_bits())
    };
    KnownCase { function: Arc::new(function), ..case }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (seeds, is_rough) = match words[..] {
        [] => ("12", false),
        [seeds] | [seeds, "smooth"] => (seeds, false),
        [seeds, "rough"] => (seeds, true),
        _ => panic!("slider_crank_bounds SEEDS [smooth | rough], not {words:?}"),
    };
    let seeds: u64 = seeds.parse().expect("a number of seeds");
    // As the other programs are asked.
    let smooth = slider_crank_with_play(FRAC_PI_3).without_periodic_inputs();
    let case = if is_rough { roughened(smooth) } else { smooth };
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
