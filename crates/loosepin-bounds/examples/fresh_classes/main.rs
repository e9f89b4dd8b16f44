//! Bounds of problems that are drawn from a seed class by class, against the exact ones: `just campaign fresh-classes N SEED [CLASS]`.
//!
//! N visible problems of each class. Misses of each end of each statistic are counted, and each end is tested against 0.5 % by a binomial test at a
//! level of 1 % for all of them together. Hidden problems that are drawn before, N/5 at most, are solved and counted apart. What is visible is said
//! in `visible.rs`.

mod classes;
#[allow(dead_code, reason = "the other campaigns read the rest of it")]
#[path = "../../tests/fresh/draw.rs"]
mod draw;
#[allow(dead_code, reason = "the other campaign reads the rest of it")]
#[path = "../../tests/exact/mod.rs"]
mod exact;
mod problem;
mod visible;

use classes::CLASSES;
use draw::Draw;
use exact::{LEVEL, median, most_misses};
use loosepin_bounds::{BoundPair, evaluate};
use loosepin_uncertainty::hash;
use problem::Problem;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// More problems than so many times those asked for are not drawn to find visible ones.
const MOST_DRAWN: u64 = 20;
/// What was counted of one statistic of a class.
#[derive(Debug, Clone, Default)]
struct Counted {
    problems: u64,
    missed: [u64; 2],
    endless: u64,
    widths: Vec<f64>,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize| words.get(at).and_then(|word| word.parse::<u64>().ok());
    let (Some(problems), Some(seed)) = (number(0).filter(|problems| *problems > 0), number(1)) else {
        eprintln!("usage: fresh-classes N SEED [CLASS]");
        std::process::exit(2)
    };
    let is_meant = |name: &str| words.get(2).is_none_or(|part| name.contains(part.as_str()));
    let mut lines: Vec<(String, [Counted; 2])> = Vec::new();
    for (place, (name, draw)) in CLASSES.iter().enumerate().filter(|(_, (name, _))| is_meant(name)) {
        let drawn = |index: u64| draw(&mut Draw::new(hash(seed, place as u64), index));
        // Hidden ones, and visible ones.
        let most = [problems / 5, problems];
        let (mut all, mut made): (Vec<(Problem, bool)>, [u64; 2]) = (Vec::new(), [0; 2]);
        for problem in (0..MOST_DRAWN * problems).map(drawn) {
            if made[1] == most[1] {
                break;
            }
            let is_visible = visible::is_visible(&problem);
            let own = usize::from(is_visible);
            if made[own] < most[own] {
                made[own] += 1;
                all.push((problem, is_visible));
            }
        }
        let solved: Vec<Vec<BoundPair>> = all
            .par_iter()
            .enumerate()
            .map(|(index, (problem, _))| {
                let question = problem.case.question(hash(seed, index as u64) >> 32);
                evaluate(question, &problem.case).expect("a plan").pairs
            })
            .collect();
        let mut counted: BTreeMap<&str, [Counted; 2]> = BTreeMap::new();
        for (index, ((problem, is_visible), pairs)) in all.iter().zip(&solved).enumerate() {
            for ((exact, pair), met) in problem.case.exact.iter().zip(pairs).zip(problem.case.met(pairs)) {
                let own = &mut counted.entry(exact.statistic.word()).or_default()[usize::from(*is_visible)];
                own.problems += 1;
                for end in [0, 1].into_iter().filter(|&end| met.is_missed[end]) {
                    own.missed[end] += 1;
                    println!(
                        "{name} {index}{} {:?} end {end}: exact {:?}, widened {:?}, short by {:.1e} of the width",
                        if *is_visible { "" } else { " (hidden)" },
                        exact.statistic,
                        exact.ends,
                        [pair.lower.widened, pair.upper.widened],
                        met.short[end]
                    );
                }
                own.endless += u64::from(met.has_no_end);
                own.widths.push(met.width);
            }
        }
        lines.extend(counted.into_iter().map(|(word, counted)| (format!("{name}, {word}"), counted)));
    }
    let tests = (2 * lines.len()) as f64;
    println!(
        "{:46} {:>8} {:>6} {:>6} {:>8} {:>7} | {:>6} {:>6} {:>6}",
        "", "visible", "lower", "upper", "no end", "width", "hidden", "lower", "upper"
    );
    let mut failed = 0;
    for (name, [hidden, visible]) in &mut lines {
        let allowed = most_misses(visible.problems, LEVEL / tests);
        let fails = visible.missed.iter().filter(|missed| **missed > allowed).count();
        failed += fails;
        let width = median(std::mem::take(&mut visible.widths));
        println!(
            "{name:46} {:8} {:6} {:6} {:8} {width:7.3} | {:6} {:6} {:6} {}",
            visible.problems,
            visible.missed[0],
            visible.missed[1],
            visible.endless,
            hidden.problems,
            hidden.missed[0],
            hidden.missed[1],
            if fails > 0 { "fails" } else { "" }
        );
    }
    println!("\nseed {seed}: {failed} of {tests} ends of visible problems are missed too often for 0.5 %");
}
