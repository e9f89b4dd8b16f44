//! Whether more outer points give narrower bounds.

use super::fresh::Problem;
use super::{Options, bounds, quantile};
use rayon::prelude::*;

const OUTER: [usize; 4] = [32, 64, 128, 256];
/// A median that is larger by more than this share of the exact width than that with half of the points is worse, unless that one is
/// narrower than the exact width, so too narrow.
const WORSE: f64 = 1e-3;

/// Prints medians over seeds of the widened width over the exact one, for each number of outer points.
pub fn run(options: &Options) {
    println!("median of widened over exact width over {} seeds, for outer = {OUTER:?}", options.repetitions);
    let (mut medians, mut worse) = (0, 0);
    for &index in &options.indices {
        let problem = Problem::draw(options.seed, index);
        let widths = OUTER.map(|outer| median_widths(&problem, outer, options.repetitions));
        println!("{index:5} {}-d {}", problem.dimensions(), problem.kinds().join(", "));
        for (place, exact) in problem.exact.iter().enumerate() {
            let width = exact.ends[1] - exact.ends[0];
            let scale = if width > 0.0 { width } else { exact.magnitude };
            let shares = widths.each_ref().map(|widths| widths[place] / scale);
            let is_worse = |pair: &&[f64]| pair[0] >= width / scale && pair[1] > pair[0] + WORSE;
            let grown = shares.windows(2).filter(is_worse).count();
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

/// The median of the widened width over seeds, for each statistic.
fn median_widths(problem: &Problem, outer: usize, repetitions: u64) -> Vec<f64> {
    let all: Vec<_> = (0..repetitions).into_par_iter().map(|repetition| bounds(problem, repetition, outer)).collect();
    let widths = |place: usize| -> Vec<f64> {
        all.iter().map(|bounds| bounds.pairs[place].upper.widened - bounds.pairs[place].lower.widened).collect()
    };
    (0..problem.exact.len()).map(|place| quantile(&widths(place), 0.5)).collect()
}
