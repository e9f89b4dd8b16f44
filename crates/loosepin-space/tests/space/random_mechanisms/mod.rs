//! Exact worst cases of random mechanisms against an optimiser that shares nothing with the search of the product: its unknowns are the poses.

pub mod drawn;
mod linear;
pub mod optimiser;
pub mod poses;
mod scatter;

use crate::random::Random;
use drawn::CLASSES;
use loosepin_space::{DriveValue, PoseAccuracy, Position, SearchOptions, SpatialMechanism, SpatialOutput, assemble};
use optimiser::maximise;
use poses::PoseSet;

/// How far the optimiser may be above the worst case, relative to the larger of both worst cases.
const ABOVE: f64 = 1e-6;
/// Near a singular position play reaches a long way, and other assemblies come near.
const NEARLY_SINGULAR: f64 = 3e-3;

/// Most variables of play of a mechanism of the short test: a search takes seconds with 40.
const FEW_VARIABLES: usize = 17;

/// One comparison.
struct Compared {
    class: usize,
    conditions: usize,
    variables: usize,
    /// (optimiser - worst case)/larger worst case.
    above: f64,
    /// Share of the optimiser's starts that end within 1e-6 of its best.
    agreeing: f64,
    /// Starts that ended in another assembly, which do not count.
    other_assemblies: usize,
}

/// The position in which a mechanism is drawn.
fn at_rest(mechanism: &SpatialMechanism) -> Position {
    assemble(mechanism, &vec![DriveValue::held(0.0); mechanism.drives().len()])
        .unwrap_or_else(|error| panic!("{error}"))
}

/// A mechanism of a class with an output that its drives determine, in a position that is not nearly singular, with at most so many variables of
/// play.
fn drawn_case(class: usize, random: &mut Random, max_variables: usize) -> (SpatialMechanism, SpatialOutput) {
    loop {
        let mechanism = drawn::mechanism(class, random);
        let position = at_rest(&mechanism);
        if position.singular_ratio < NEARLY_SINGULAR {
            continue;
        }
        let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
        if accuracy.play_set().variables() > max_variables {
            continue;
        }
        let outputs: Vec<SpatialOutput> = (0..8).map(|_| drawn::output(random, &mechanism)).collect();
        let seen = outputs.into_iter().find(|output| {
            accuracy.gains(output).is_ok_and(|gains| accuracy.first_order(&gains).is_ok_and(|own| own.worst > 1e-7))
        });
        if let Some(output) = seen {
            return (mechanism, output);
        }
    }
}

fn compare(class: usize, random: &mut Random, starts: usize, max_variables: usize) -> [Compared; 2] {
    let (mechanism, output) = drawn_case(class, random, max_variables);
    let position = at_rest(&mechanism);
    let accuracy = PoseAccuracy::new(&mechanism, &position).unwrap();
    let exact = accuracy.worst_case(&output, &SearchOptions::default()).unwrap();
    let size = exact.largest.deviation.abs().max(exact.smallest.deviation.abs());
    let set = PoseSet::new(&mechanism, &output);
    let (conditions, variables) = (accuracy.conditions(), accuracy.play_set().variables());
    assert_eq!(set.dimensions(), variables - conditions, "{}", CLASSES[class].0);
    [(1.0, exact.largest.deviation), (-1.0, -exact.smallest.deviation)].map(|(sign, worst)| {
        let ends = maximise(&set, sign, starts, random);
        let own: Vec<f64> = ends.iter().filter(|end| !end.is_other_assembly).map(|end| end.value).collect();
        let best = own.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let agreeing = own.iter().filter(|end| best - **end <= 1e-6 * size).count() as f64 / starts as f64;
        let other_assemblies = ends.len() - own.len();
        Compared { class, conditions, variables, above: (best - worst) / size, agreeing, other_assemblies }
    })
}

/// Worst shortfall of the product; of the optimiser, the share of searches that come within 1e-6 of the product.
fn check(compared: &[Compared]) {
    let highest = compared.iter().max_by(|a, b| a.above.total_cmp(&b.above)).unwrap();
    assert!(
        highest.above <= ABOVE,
        "{}: the optimiser is above the worst case by {:e} ({} conditions, {} variables)",
        CLASSES[highest.class].0,
        highest.above,
        highest.conditions,
        highest.variables
    );
    let near = compared.iter().filter(|own| own.above >= -1e-6).count() as f64 / compared.len() as f64;
    assert!(near > 0.9, "the optimiser is no test: only {near} of its values come near");
}

#[test]
fn identity_no_optimiser_over_poses_finds_more_than_the_worst_case() {
    let mut random = Random(4711);
    let compared: Vec<Compared> =
        (0..CLASSES.len()).flat_map(|class| compare(class, &mut random, 2, FEW_VARIABLES)).collect();
    check(&compared);
}

/// A hundred mechanisms with many starts: `SEED=1 STARTS=8 cargo test --release -p loosepin-space --test space -- --ignored --nocapture campaign`.
#[test]
#[ignore = "minutes; prints the figures of a campaign"]
fn campaign_of_a_hundred_random_mechanisms() {
    let number =
        |name: &str, default: usize| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default);
    let (seed, starts, count) = (number("SEED", 1), number("STARTS", 8), number("COUNT", 100));
    let mut compared = Vec::new();
    let started = std::time::Instant::now();
    for case in number("FROM", 0)..count {
        // Each case has a seed of its own, so that it can be looked at alone.
        let mut random = Random(1_000_003 * seed as u64 + 7919 * case as u64);
        let class = case % CLASSES.len();
        let pair = compare(class, &mut random, starts, usize::MAX);
        for own in &pair {
            println!(
                "{case:3} {:26} variables {:2} conditions {:2} optimiser above worst case {:+.2e}, starts agreeing {:.2}, in other assemblies {}",
                CLASSES[class].0, own.variables, own.conditions, own.above, own.agreeing, own.other_assemblies
            );
        }
        compared.extend(pair);
    }
    let above = compared.iter().map(|own| own.above);
    let (lowest, highest) =
        (above.clone().fold(f64::INFINITY, f64::min), above.clone().fold(f64::NEG_INFINITY, f64::max));
    let near = above.filter(|own| own.abs() <= 1e-6).count();
    println!(
        "seed {seed}: {} comparisons, {starts} starts each, {:.0} s; product lower by at most {highest:.2e}, higher by at most {:.2e}, \
         {near} agree to 1e-6",
        compared.len(),
        started.elapsed().as_secs_f64(),
        -lowest
    );
    check(&compared);
}
