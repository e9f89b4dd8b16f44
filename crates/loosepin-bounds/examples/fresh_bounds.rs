//! Bounds of problems that the program has never seen: `just campaign fresh-bounds N SEED [OPTIONS]`.

#[path = "../../loosepin-bench/src/fresh/mod.rs"]
mod fresh;

use fresh::Problem;
use loosepin_bounds::{Sampling, evaluate};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// An end of a statistic that was found too narrow.
struct Miss {
    statistic: String,
    end: usize,
    line: String,
}

struct Outcome {
    is_visible: bool,
    classes: Vec<String>,
    misses: Vec<Miss>,
    asked: Vec<String>,
}

struct Options {
    problems: u64,
    seed: u64,
    threads: usize,
    only: Option<u64>,
    seeds: u64,
}

fn options() -> Options {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |word: Option<&String>| word.and_then(|word| word.parse().ok());
    let option = |name: &str| words.iter().position(|word| word == name).and_then(|at| number(words.get(at + 1)));
    Options {
        problems: number(words.first()).expect("usage: fresh_bounds N SEED [--threads T] [--only INDEX] [--seeds K]"),
        seed: number(words.get(1)).expect("a seed"),
        threads: option("--threads").unwrap_or(1) as usize,
        only: option("--only"),
        seeds: option("--seeds").unwrap_or(1),
    }
}

fn main() {
    let options = options();
    rayon::ThreadPoolBuilder::new().num_threads(options.threads).build_global().expect("threads");
    let indices: Vec<u64> = options.only.map_or_else(|| (0..options.problems).collect(), |only| vec![only]);
    let tasks: Vec<(u64, u64)> = indices.iter().flat_map(|&i| (0..options.seeds).map(move |k| (i, k))).collect();
    let outcomes: Vec<Outcome> =
        tasks.par_iter().map(|&(index, repetition)| outcome(options.seed, index, repetition)).collect();
    for is_visible in [true, false] {
        let group: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.is_visible == is_visible).collect();
        println!("\n{} problems with {} features", group.len(), if is_visible { "visible" } else { "hidden" });
        let mut asked: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
        let mut classes: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
        for outcome in &group {
            for statistic in &outcome.asked {
                asked.entry(statistic).or_default()[2] += 1;
            }
            for miss in &outcome.misses {
                asked.entry(&miss.statistic).or_default()[miss.end] += 1;
            }
            for class in &outcome.classes {
                let counts = classes.entry(class).or_default();
                counts[0] += usize::from(!outcome.misses.is_empty());
                counts[1] += 1;
            }
        }
        for (statistic, [lower, upper, count]) in asked {
            println!("  {statistic:20} missed: lower {lower:4}, upper {upper:4} of {count}");
        }
        for (class, [missed, count]) in classes {
            println!("  {class:24} problems with a miss: {missed:4} of {count}");
        }
    }
    for miss in outcomes.iter().flat_map(|outcome| &outcome.misses) {
        println!("{}", miss.line);
    }
}

fn outcome(seed: u64, index: u64, repetition: u64) -> Outcome {
    let problem = Problem::draw(seed, index);
    let bounds = evaluate(problem.question(repetition, Sampling::default()), &problem).expect("a plan");
    assert_eq!(bounds.pairs.len(), problem.exact.len());
    let features: Vec<String> = problem
        .features()
        .iter()
        .map(|(feature, height)| format!("{}(volume {:.4}, height {height:.2} scatters)", feature.name, feature.volume))
        .collect();
    let mut misses = Vec::new();
    for (pair, exact) in bounds.pairs.iter().zip(&problem.exact) {
        let allowed = (1e-9 * (exact.ends[1] - exact.ends[0])).max(1e-12 * exact.magnitude);
        for (end, bound, inside) in
            [(0, &pair.lower, pair.lower.widened - exact.ends[0]), (1, &pair.upper, exact.ends[1] - pair.upper.widened)]
        {
            if inside > allowed {
                let line = format!(
                    "miss: --only {index} repetition {repetition}: {}-d {} {} {:?} exact {:.6} widened {:.6} value {:.6} \
                     sampling {:.2e} optimisation {:.2e} exact width {:.2e} | {} | {}",
                    problem.ends.len(),
                    if problem.is_visible() { "visible" } else { "hidden" },
                    ["lower", "upper"][end],
                    exact.statistic,
                    exact.ends[end],
                    bound.widened,
                    bound.value,
                    bound.error.sampling,
                    bound.error.optimisation,
                    exact.ends[1] - exact.ends[0],
                    problem.kinds().join(" "),
                    features.join(" "),
                );
                misses.push(Miss { statistic: name(exact.statistic), end, line });
            }
        }
    }
    let mut classes = problem.kinds();
    classes.push(format!("{}-d", problem.ends.len()));
    classes.push(if problem.is_rough() { "rough".into() } else { "smooth".into() });
    let asked = problem.exact.iter().map(|exact| name(exact.statistic)).collect();
    Outcome { is_visible: problem.is_visible(), classes, misses, asked }
}

fn name(statistic: loosepin_bounds::Statistic) -> String {
    use loosepin_bounds::Statistic;
    match statistic {
        Statistic::ProbabilityAbove(_) => "P(Y > L)".into(),
        Statistic::ProbabilityBeyond(_) => "P(|Y| > L)".into(),
        other => format!("{other:?}"),
    }
}
