//! How often each end of each statistic is missed.

use super::fresh::{Exact, Problem};
use super::{OUTER, Options, bounds};
use loosepin_bounds::BoundPair;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// What one seed of one problem says.
struct Outcome {
    is_visible: bool,
    classes: Vec<String>,
    /// Names of the statistics, and whether the lower and the upper end were missed.
    statistics: Vec<(String, [bool; 2])>,
    /// One for each miss.
    lines: Vec<String>,
    runs: usize,
}

/// Solves every problem and prints what was missed.
pub fn run(options: &Options) {
    let solve = |&(index, repetition): &(u64, u64)| outcome(&Problem::draw(options.seed, index), index, repetition);
    let outcomes: Vec<Outcome> = options.tasks().par_iter().map(solve).collect();
    outcomes.iter().flat_map(|outcome| &outcome.lines).for_each(|line| println!("{line}"));
    let summaries: Vec<String> = [true, false].map(|is_visible| summary(&outcomes, is_visible)).to_vec();
    let runs: usize = outcomes.iter().map(|outcome| outcome.runs).sum();
    println!("\nseed {}: {}; {} runs each", options.seed, summaries.join("; "), runs / outcomes.len().max(1));
}

fn outcome(problem: &Problem, index: u64, repetition: u64) -> Outcome {
    let bounds = bounds(problem, repetition, OUTER);
    let (mut statistics, mut lines) = (Vec::new(), Vec::new());
    for (pair, exact) in bounds.pairs.iter().zip(&problem.exact) {
        let missed = exact.missed_by([pair.lower.widened, pair.upper.widened]);
        statistics.push((exact.name(), missed.map(|inside| inside.is_some())));
        for (end, _) in missed.iter().enumerate().filter(|(_, inside)| inside.is_some()) {
            lines.push(format!("{index:5} {repetition:3} {} | {}", of_end(pair, exact, end), told(problem)));
        }
    }
    Outcome { is_visible: problem.is_visible(), classes: classes(problem), statistics, lines, runs: bounds.runs }
}

fn of_end(pair: &BoundPair, exact: &Exact, end: usize) -> String {
    let bound = [&pair.lower, &pair.upper][end];
    format!(
        "{} {}: exact {:.6} widened {:.6} value {:.6} sampling {:.1e} optimisation {:.1e} of width {:.1e}",
        ["lower", "upper"][end],
        exact.name(),
        exact.ends[end],
        bound.widened,
        bound.value,
        bound.error.sampling,
        bound.error.optimisation,
        exact.ends[1] - exact.ends[0],
    )
}

/// A problem in words: dimension, kinds, features with their volume and their height in scatters of one run.
fn told(problem: &Problem) -> String {
    let features: Vec<String> = problem
        .features
        .iter()
        .map(|(feature, height)| format!("{} {:.4} x {height:.2}", feature.name, feature.volume))
        .collect();
    let visible = if problem.is_visible() { "visible" } else { "hidden" };
    let together = problem.volume_together();
    format!(
        "{visible} {}-d {} | {}; together {together:.1e}",
        problem.dimensions(),
        problem.kinds().join(", "),
        features.join(", ")
    )
}

fn classes(problem: &Problem) -> Vec<String> {
    let mut classes = problem.kinds();
    classes.push(format!("{} dimensions", problem.dimensions()));
    classes.push(
        if problem.is_seen_together() { "all with extremes in a run" } else { "all with extremes where no run is" }
            .to_owned(),
    );
    classes.push(if problem.is_rough() { "all rough" } else { "all smooth" }.to_owned());
    classes
}

/// Prints the misses of the problems with visible, or hidden, features; returns them in a few words.
fn summary(outcomes: &[Outcome], is_visible: bool) -> String {
    let word = if is_visible { "visible" } else { "hidden" };
    let group: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.is_visible == is_visible).collect();
    // Lower and upper ends missed, asked.
    let mut statistics: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    // Solutions with a miss, all.
    let mut classes: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for outcome in &group {
        for (name, [lower, upper]) in &outcome.statistics {
            let counts = statistics.entry(name).or_default();
            for (count, more) in counts.iter_mut().zip([*lower, *upper, true]) {
                *count += usize::from(more);
            }
        }
        for class in &outcome.classes {
            let counts = classes.entry(class).or_default();
            counts[0] += usize::from(!outcome.lines.is_empty());
            counts[1] += 1;
        }
    }
    println!("\n{} solved with {word} features", group.len());
    for (name, [lower, upper, asked]) in &statistics {
        println!("  {name:20} missed: lower {lower:4}, upper {upper:4} of {asked}");
    }
    for (name, [missed, all]) in &classes {
        println!("  {name:32} with a miss: {missed:4} of {all}");
    }
    let missed = group.iter().filter(|outcome| !outcome.lines.is_empty()).count();
    let worst = statistics.iter().map(|(name, [lower, upper, asked])| (lower.max(upper), asked, name)).max();
    let worst = worst
        .map_or_else(String::new, |(most, asked, name)| format!(", at most {most} of {asked} at one end ({name})"));
    format!("{word}: a miss in {missed} of {}{worst}", group.len())
}

/// What is drawn, one line each, and the share of problems with visible features.
pub fn tell_drawn(options: &Options) {
    let problems: Vec<Problem> = options.indices.par_iter().map(|&index| Problem::draw(options.seed, index)).collect();
    for (index, problem) in options.indices.iter().zip(&problems) {
        println!("{index:5} {}", told(problem));
    }
    let share = |has: fn(&Problem) -> bool| {
        problems.iter().filter(|problem| has(problem)).count() as f64 / problems.len().max(1) as f64
    };
    println!("visible: {:.3}, rough: {:.3}", share(Problem::is_visible), share(Problem::is_rough));
}
