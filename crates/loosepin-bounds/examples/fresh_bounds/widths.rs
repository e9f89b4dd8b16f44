//! How much too large stated errors are.

use super::fresh::Problem;
use super::{OUTER, Options, bounds, quantile};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Errors below this share of the exact width count as this share.
const MIN_SHARE: f64 = 1e-6;
/// Of the actual errors over seeds; with fewer than 100 seeds it is the largest.
const ACTUAL: f64 = 0.99;

/// Of each end: the median stated error over the quantile of actual ones, and the same without the search.
fn ratios(problem: &Problem, repetitions: u64) -> Vec<(String, f64)> {
    let all: Vec<_> = (0..repetitions).map(|repetition| bounds(problem, repetition, OUTER)).collect();
    let mut ratios = Vec::new();
    for (place, exact) in problem.exact.iter().enumerate() {
        let width = exact.ends[1] - exact.ends[0];
        let least = MIN_SHARE * if width > 0.0 { width } else { exact.magnitude };
        for end in 0..2 {
            let ends = all.iter().map(|bounds| [&bounds.pairs[place].lower, &bounds.pairs[place].upper][end]);
            let stated: Vec<f64> = ends.clone().map(|bound| bound.error.total().max(least)).collect();
            let actual: Vec<f64> = ends.map(|bound| (bound.value - exact.ends[end]).abs().max(least)).collect();
            ratios.push((exact.name(), quantile(&stated, 0.5) / quantile(&actual, ACTUAL)));
        }
    }
    ratios
}

/// The ratios of a problem, by statistic.
struct Outcome {
    line: String,
    class: &'static str,
    ratios: Vec<(String, f64)>,
}

/// Prints the ratios by class and statistic.
pub fn run(options: &Options) {
    let solve = |&index: &u64| {
        let problem = Problem::draw(options.seed, index);
        let class = if problem.is_rough() { "rough" } else { "smooth" };
        let ratios = ratios(&problem, options.repetitions);
        let own: Vec<f64> = ratios.iter().map(|(_, ratio)| *ratio).collect();
        let line = format!(
            "{index:5} {class:6} {:9.2}  {}-d {}",
            quantile(&own, 0.5),
            problem.dimensions(),
            problem.kinds().join(", ")
        );
        Outcome { line, class, ratios }
    };
    let all: Vec<Outcome> = options.indices.par_iter().map(solve).collect();
    println!("each problem: median over its ends");
    all.iter().for_each(|outcome| println!("{}", outcome.line));
    let mut groups: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for Outcome { class, ratios, .. } in &all {
        for (statistic, ratio) in ratios {
            for name in [format!("{class} {statistic}"), format!("{class} all"), "all".to_owned()] {
                groups.entry(name).or_default().push(*ratio);
            }
        }
    }
    println!("stated error over the 99 % quantile of the actual one over {} seeds", options.repetitions);
    for (name, ratios) in &groups {
        let (median, most) = (quantile(ratios, 0.5), quantile(ratios, 0.9));
        println!("  {name:28} median {median:9.2}, 90 % quantile {most:11.2}, ends {}", ratios.len());
    }
    let median = |name: &str| groups.get(name).map_or(f64::NAN, |ratios| quantile(ratios, 0.5));
    println!(
        "\nseed {}, {} problems: stated over actual error: median {:.2} (rough), {:.2} (all)",
        options.seed,
        options.indices.len(),
        median("rough all"),
        median("all"),
    );
}
