//! The short version of `just campaign bounds`: every case with known bounds, with one seed; but of weighted runs only boxes alone,
//! the campaign has more.

#[path = "../../../loosepin-bench/src/known_bounds.rs"]
mod known_bounds;
#[path = "../../../loosepin-bench/src/known_pairings.rs"]
mod known_pairings;
#[path = "../../../loosepin-bench/src/known_weights.rs"]
mod known_weights;

use known_bounds::KnownCase;
use loosepin::bounds::{BoundPair, evaluate};

/// Of numbers about 1.
const ROUND_OFF: f64 = 1e-12;
/// By this share of the true width a bound may be too wide.
const MOST_EXCESS: f64 = 0.03;
/// Where the response jumps a model of smooth functions concedes more than the jump.
const MOST_EXCESS_AT_A_JUMP: f64 = 2.0;

/// Fails where bounds are narrower than the truth, or much wider.
#[track_caller]
fn check(case: &KnownCase) {
    const SEED: u64 = 1;
    let bounds = evaluate(case.problem(SEED), case).expect("the case can be planned");
    let is_rough = case.name == "a jump" || case.name.contains("rough");
    let most = if is_rough { MOST_EXCESS_AT_A_JUMP } else { MOST_EXCESS };
    let hold = |pair: &BoundPair, (low, high): (f64, f64)| {
        let width = if high > low { high - low } else { low.abs().max(1.0) };
        let excess = (pair.upper.widened - pair.lower.widened - (high - low)) / width;
        let is_held = pair.lower.widened <= low + ROUND_OFF && pair.upper.widened >= high - ROUND_OFF;
        assert!(is_held && excess <= most, "{}: [{low}, {high}], too wide by {excess}: {pair:#?}", case.name);
    };
    for (pair, (_, exact)) in bounds.pairs.iter().zip(&case.statistics) {
        hold(pair, *exact);
    }
    for (level, exact) in bounds.levels.iter().zip(&case.levels) {
        for (pair, exact) in level.pairs.iter().zip(exact) {
            hold(pair, *exact);
        }
    }
}

#[test]
fn analytic_closed_forms_lie_within_their_bounds() {
    let elsewhere =
        known_pairings::pairings().into_iter().chain(known_pairings::box_weighted()).chain(known_weights::weighted());
    let elsewhere: Vec<String> = elsewhere.map(|case| case.name).collect();
    KnownCase::all().iter().filter(|case| !elsewhere.contains(&case.name)).for_each(check);
}

#[test]
fn analytic_every_pairing_with_something_random_lies_within_its_bounds() {
    known_pairings::pairings().iter().filter(|case| !case.random.is_empty()).for_each(check);
}

#[test]
fn analytic_boxes_by_weighted_runs_lie_within_their_bounds() {
    known_pairings::box_weighted().iter().for_each(check);
}

#[test]
fn analytic_every_pairing_without_anything_random_lies_within_its_bounds() {
    known_pairings::pairings().iter().filter(|case| case.random.is_empty()).for_each(check);
}

/// Where the crank and the rod stretch, the deviation changes by 0.2 nm over all clearances and directions.
#[test]
fn analytic_at_a_dead_centre_bounds_are_within_a_thousandth_of_the_width() {
    const OF_WIDTH: f64 = 1e-3;
    const SEED: u64 = 1;
    let case = known_bounds::slider_crank_with_play(0.0);
    let bounds = evaluate(case.problem(SEED), &case).expect("the case can be planned");
    for (pair, &(statistic, (low, high))) in bounds.pairs.iter().zip(&case.statistics) {
        let beyond = [low - pair.lower.widened, pair.upper.widened - high].map(|beyond| beyond + ROUND_OFF);
        let most = OF_WIDTH * (high - low) + 2.0 * ROUND_OFF;
        assert!(beyond.iter().all(|beyond| *beyond >= 0.0) && beyond[0] + beyond[1] <= most, "{statistic:?}: {pair:?}");
    }
}

/// Along the ridge the greatest of all values changes by a millionth of the width over an eighth of its length. Each of these seeds of
/// the campaign ended further from it without a climb of its own.
#[test]
fn analytic_the_summit_of_a_curved_ridge_is_attained() {
    const SEEDS: [u64; 3] = [235, 308, 409];
    const OF_WIDTH: f64 = 1e-6;
    let cases = KnownCase::all();
    let ridge = cases.iter().find(|case| case.name == "a curved ridge").expect("a case with a ridge");
    let (low, high) = ridge.statistics[0].1;
    for seed in SEEDS {
        let bounds = evaluate(ridge.problem(seed), ridge).expect("the case can be planned");
        let upper = &bounds.pairs[0].upper;
        let missing = (high - upper.value) / (high - low);
        assert!((-ROUND_OFF..OF_WIDTH).contains(&missing), "seed {seed}: {missing} of the width is missing: {upper:?}");
    }
}
