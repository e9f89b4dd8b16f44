//! Bounds of problems that are drawn afresh from a seed, against the exact ones: `just campaign fresh-bounds N SEED [OPTIONS]`.
//!
//! Without options every problem is solved once, and misses of each end of each statistic are counted. `--only INDEX --seeds K` solves one
//! of them with K sampling seeds. `--widths` compares stated with actual errors over K seeds of each, `--growth` widths with 32 to 256 outer
//! points; `--intervals` asks for the treatment that takes every input for an interval; `--draw` only tells what is drawn.

#[allow(dead_code, unused_imports, reason = "tests read the rest of it")]
#[path = "../../tests/fresh/mod.rs"]
mod fresh;
mod growth;
mod intervals;
mod misses;
mod widths;

use fresh::Problem;
use loosepin_bounds::{Bounds, Sampling, evaluate};
use std::fmt::Display;
use std::str::FromStr;

/// Points u of a problem where the number is not the question.
const OUTER: usize = 64;

/// What is asked on the command line.
struct Options {
    /// Indices of problems.
    indices: Vec<u64>,
    seed: u64,
    /// Sampling seeds of each.
    repetitions: u64,
}

impl Options {
    /// Every problem with every sampling seed.
    fn tasks(&self) -> Vec<(u64, u64)> {
        self.indices
            .iter()
            .flat_map(|&index| (0..self.repetitions).map(move |repetition| (index, repetition)))
            .collect()
    }
}

/// The number after `name`; nothing where the option is not there.
fn option<T: FromStr<Err: Display>>(words: &[String], name: &str) -> Option<T> {
    let at = words.iter().position(|word| word == name)?;
    let word = words.get(at + 1).unwrap_or_else(|| stop(&format!("{name} needs a number")));
    Some(word.parse().unwrap_or_else(|error| stop(&format!("{name} {word}: {error}"))))
}

fn stop(diagnostic: &str) -> ! {
    eprintln!("error: {diagnostic}");
    eprintln!(
        "usage: fresh-bounds N SEED [--threads T] [--only INDEX] [--seeds K] [--widths | --growth | --intervals | --draw]"
    );
    std::process::exit(2)
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize, what: &str| -> u64 {
        let word = words.get(at).unwrap_or_else(|| stop(&format!("{what} is missing")));
        word.parse().unwrap_or_else(|error| stop(&format!("{what} {word}: {error}")))
    };
    let (problems, seed) = (number(0, "the number of problems"), number(1, "the seed"));
    let is_asked = |name: &str| words.iter().any(|word| word == name);
    let indices = option(&words, "--only").map_or_else(|| (0..problems).collect(), |only: u64| vec![only]);
    let repetitions: Option<u64> = option(&words, "--seeds");
    let threads = option(&words, "--threads").unwrap_or(1);
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().expect("threads are there once");
    let options = |usual: u64| Options { indices: indices.clone(), seed, repetitions: repetitions.unwrap_or(usual) };
    if is_asked("--draw") {
        misses::tell_drawn(&options(1));
    } else if is_asked("--widths") {
        widths::run(&options(20));
    } else if is_asked("--intervals") {
        intervals::run(&options(1));
    } else if is_asked("--growth") {
        growth::run(&options(30));
    } else {
        misses::run(&options(1));
    }
}

/// Bounds of a problem, one for each of its statistics.
fn bounds(problem: &Problem, repetition: u64, outer: usize) -> Bounds {
    let sampling = Sampling { outer, ..Sampling::default() };
    let bounds = evaluate(problem.question(repetition, sampling), problem).expect("the problem can be planned");
    assert_eq!(bounds.pairs.len(), problem.exact.len(), "a pair of bounds for each statistic");
    bounds
}

/// `share` of the numbers are at most this one; infinite ones count.
fn quantile(values: &[f64], share: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(place.max(1) - 1).copied().unwrap_or(f64::NAN)
}
