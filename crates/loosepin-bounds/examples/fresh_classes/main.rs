//! Bounds of problems that are drawn from a seed class by class, against the exact ones: `just campaign fresh-classes N SEED [CLASS]`.
//!
//! N visible problems of each class. Misses of each end of each statistic are counted, and each end is tested against 0.5 % by a binomial test at a
//! level of 1 % for all of them together. Hidden problems that are drawn before, N/5 at most, are solved and counted apart. What is visible is said
//! in `visible.rs`.

mod classes;
#[allow(dead_code, reason = "the other campaign reads the rest of it")]
#[path = "../../tests/fresh/draw.rs"]
mod draw;
mod problem;
mod visible;

use classes::CLASSES;
use draw::Draw;
use loosepin_bounds::{BoundPair, evaluate};
use loosepin_uncertainty::{binomial_tail, hash};
use problem::Problem;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// An end may be missed so often.
const STATED_MISS: f64 = 0.005;
/// Of all tests together.
const LEVEL: f64 = 0.01;
/// More problems than so many times those asked for are not drawn to find visible ones.
const MOST_DRAWN: u64 = 20;
/// Differences of this share of the exact width, and of the size of the response, are round-off.
const ROUND_OFF: [f64; 2] = [1e-9, 2e-15];

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
                evaluate(problem.question(hash(seed, index as u64) >> 32), problem).expect("a plan").pairs
            })
            .collect();
        let mut counted: BTreeMap<String, [Counted; 2]> = BTreeMap::new();
        for (index, ((problem, is_visible), pairs)) in all.iter().zip(&solved).enumerate() {
            for (exact, pair) in problem.exact.iter().zip(pairs) {
                let word = format!("{:?}", exact.statistic).split('(').next().unwrap_or_default().to_owned();
                let own = &mut counted.entry(word).or_default()[usize::from(*is_visible)];
                let [low, high] = exact.ends;
                let width = if high > low { high - low } else { high.abs().max(f64::MIN_POSITIVE) };
                let allowed = (ROUND_OFF[0] * width).max(ROUND_OFF[1] * problem.magnitude);
                let beyond = [pair.lower.widened - low - allowed, high - pair.upper.widened - allowed];
                own.problems += 1;
                for (end, beyond) in beyond.into_iter().enumerate() {
                    if beyond > 0.0 {
                        own.missed[end] += 1;
                        println!(
                            "{name} {index}{} {:?} end {end}: exact {:?}, widened {:?}, short by {:.1e} of the width",
                            if *is_visible { "" } else { " (hidden)" },
                            exact.statistic,
                            exact.ends,
                            [pair.lower.widened, pair.upper.widened],
                            beyond / width
                        );
                    }
                }
                let is_endless = pair.lower.widened.is_infinite() || pair.upper.widened.is_infinite();
                own.endless += u64::from(is_endless);
                own.widths.push((pair.upper.widened - pair.lower.widened) / width);
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
        let is_last = |misses: &u64| binomial_tail(visible.problems, misses + 1, STATED_MISS) < LEVEL / tests;
        let allowed = (0..=visible.problems).find(is_last).unwrap_or(visible.problems);
        let fails = visible.missed.iter().filter(|missed| **missed > allowed).count();
        failed += fails;
        visible.widths.sort_by(f64::total_cmp);
        let width = visible.widths.get(visible.widths.len() / 2).copied().unwrap_or(f64::NAN);
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
