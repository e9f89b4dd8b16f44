//! Whether more outer points give narrower bounds.

use super::fresh::Problem;
use super::{Options, bounds, quantile};
use rayon::prelude::*;

const OUTER: [usize; 4] = [32, 64, 128, 256];
/// A median that is larger by more than this share of the exact width than that with half of the points is worse.
const WORSE: f64 = 1e-3;

/// Prints medians over seeds of the widened width over the exact one, for each number of outer points.
pub fn run(options: &Options) {
    println!("median of widened over exact width over {} seeds, for outer = {OUTER:?}", options.repetitions);
    let (mut medians, mut worse) = (0, 0);
    for &index in &options.indices {
        let problem = Problem::draw(options.seed, index);
        let of_outer = OUTER.map(|outer| {
            let all: Vec<_> = (0..options.repetitions)
                .into_par_iter()
                .map(|repetition| bounds(&problem, repetition, outer))
                .collect();
            let width = |place: usize| -> Vec<f64> {
                all.iter().map(|b| b.pairs[place].upper.widened - b.pairs[place].lower.widened).collect()
            };
            (0..problem.exact.len()).map(|place| quantile(&width(place), 0.5)).collect::<Vec<f64>>()
        });
        println!("{index:5} {}-d {}", problem.dimensions(), problem.kinds().join(", "));
        for (place, exact) in problem.exact.iter().enumerate() {
            let width = exact.ends[1] - exact.ends[0];
            let scale = if width > 0.0 { width } else { exact.magnitude };
            let shares =
                OUTER.map(|outer| of_outer[OUTER.iter().position(|o| *o == outer).unwrap_or(0)][place] / scale);
            let grown = shares.windows(2).filter(|pair| pair[1] > pair[0] + WORSE).count();
            medians += shares.len() - 1;
            worse += grown;
            println!("      {:20} {shares:9.4?}{}", exact.name(), if grown > 0 { "  worse with more" } else { "" });
        }
    }
    println!(
        "\nseed {}, {} problems: {worse} of {medians} medians are worse with twice the outer points",
        options.seed,
        options.indices.len()
    );
}
