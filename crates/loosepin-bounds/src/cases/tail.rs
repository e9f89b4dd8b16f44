//! Cases in which a sample shows little or nothing: tails beyond its values, events that never happened, scatter at one u only. A bound
//! holds, or has no end.

use crate::Function;
use crate::cases::exact::{STANDARD_NORMAL, check, problem};
use crate::{Reading, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{Distribution, normal_cdf};

const PROBABILITY: f64 = 0.99;
/// Seeds of each case; bounds with 99 % confidence may miss in two of them without that being a sign of anything.
const SEEDS: u64 = 24;
const MAX_MISSED: usize = 2;

#[test]
fn analytic_bounds_of_tail_quantiles_hold_or_have_no_end() {
    let exponential = Distribution::Exponential { lower: 0.25, mean: 1.75 };
    let truth = 0.25 - 1.5 * libm::log(1.0 - PROBABILITY);
    let rough = |x: &[f64], u: &[f64]| (x[0] - 0.9).abs() + u[0];
    let smooth = |x: &[f64], u: &[f64]| x[0] + u[0];
    for (name, response, exact) in [
        ("smooth", &smooth as &(dyn Fn(&[f64], &[f64]) -> f64 + Sync), truth + 0.5),
        ("rough", &rough, truth - 0.9 + 0.5),
    ] {
        for reading in [Reading::FixedButUnknown, Reading::RandomSet] {
            for inner in [64, 256] {
                let (mut missed, mut endless) = (0, 0_u64);
                for seed in 0..SEEDS {
                    let mut problem = problem(
                        std::slice::from_ref(&exponential),
                        &[(-0.5, 0.5)],
                        &[Statistic::Quantile(PROBABILITY)],
                    );
                    problem.reading = reading;
                    problem.sampling = Sampling { outer: 6, inner, seed, ..Sampling::default() };
                    let upper = evaluate(problem, &Function(response)).unwrap().pairs[0].upper.clone();
                    endless += u64::from(upper.widened.is_infinite());
                    missed += usize::from(upper.widened < exact);
                }
                assert!(missed <= MAX_MISSED, "{name} {reading:?} {inner}: {missed} missed");
                // 0.99^n < 0.005 from n = 528 on.
                let is_counted = name == "rough" || reading == Reading::RandomSet;
                assert!(endless == SEEDS || !is_counted, "{name} {reading:?} {inner}: {endless} have no end");
            }
        }
    }
}

#[test]
fn analytic_a_centred_response_is_likeliest_beyond_a_limit_where_it_scatters_most() {
    // P(|u X| > L) = 2 Φ(-L/u): below and above where an index takes the tail instead of the count.
    const LIMIT: f64 = 3.5;
    const TOLERANCE: f64 = 2e-5; // of a probability of 1.5e-3
    let mut problem = problem(&[STANDARD_NORMAL], &[(0.5, 1.1)], &[Statistic::ProbabilityBeyond(LIMIT)]);
    problem.sampling = Sampling { inner: 128, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| u[0] * x[0])).unwrap();
    check(&bounds.pairs[0], (2.0 * normal_cdf(-LIMIT / 0.5), 2.0 * normal_cdf(-LIMIT / 1.1)), TOLERANCE);
    assert_eq!(bounds.pairs[0].upper.witness.as_ref().unwrap().epistemic, [1.1]);
}

#[test]
fn analytic_what_no_run_has_shown_is_not_taken_for_impossible() {
    // A rare step, and a part that is rarely the other one: most samples of 64 never meet them.
    const STEP: f64 = 3.2;
    let rare_part = Distribution::Discrete { values: vec![0.25, 1.75], probabilities: vec![0.9993, 0.0007] };
    let step = |x: &[f64], _: &[f64]| if x[0] > STEP { 1.75 } else { 0.25 };
    let part = |x: &[f64], u: &[f64]| x[0] * (1.0 + 0.1 * u[0]);
    for (name, random, response, exact) in [
        ("step", &STANDARD_NORMAL, &step as &(dyn Fn(&[f64], &[f64]) -> f64 + Sync), normal_cdf(-STEP)),
        ("part", &rare_part, &part, 0.0007),
    ] {
        for seed in 0..SEEDS {
            let statistics = [Statistic::ProbabilityAbove(0.9)];
            let mut problem = problem(std::slice::from_ref(random), &[(-0.5, 0.5)], &statistics);
            problem.sampling = Sampling { outer: 6, inner: 64, seed, ..Sampling::default() };
            let pair = evaluate(problem, &Function(response)).unwrap().pairs[0].clone();
            assert!(pair.upper.widened >= exact, "{name} {seed}: {pair:?}");
        }
    }
}

/// 256 runs have no such event in 41 % of the samples. From these alone 32 of 100 bounds are missed (`just campaign refereed-bounds 100`).
#[test]
fn analytic_a_rare_event_that_only_single_runs_show_is_in_the_bounds() {
    let rare = normal_cdf(-2.7);
    let response = |x: &[f64], u: &[f64]| x[0] * (1.0 + u[0]) + if x[1] > 2.7 { 4.0 } else { 0.0 };
    let spread = |u: f64| ((1.0 + u).powi(2) + 16.0 * rare * (1.0 - rare)).sqrt();
    let above = |u: f64| (1.0 - rare) * normal_cdf(-6.5 / (1.0 + u)) + rare * normal_cdf(-2.5 / (1.0 + u));
    let exact = [4.0 * rare, spread(1.0), above(1.0)];
    for seed in 0..SEEDS {
        let statistics = [Statistic::Mean, Statistic::StandardDeviation, Statistic::ProbabilityAbove(6.5)];
        let mut problem = problem(&[STANDARD_NORMAL, STANDARD_NORMAL], &[(0.0, 1.0)], &statistics);
        problem.compared_columns = vec![0];
        problem.sampling = Sampling { outer: 16, seed, ..Sampling::default() };
        let bounds = evaluate(problem, &Function(response)).unwrap();
        for (pair, exact) in bounds.pairs.iter().zip(exact) {
            assert!(pair.upper.widened >= exact, "{seed}: {pair:?}");
        }
    }
}

/// What single runs must not take for a contradiction: curved in u and in X, to corners three standard deviations out.
#[test]
fn analytic_single_runs_leave_bounds_of_analytic_responses_as_they_are() {
    let smooth = |x: &[f64], u: &[f64]| (0.3 * x[0]).exp() * (1.0 + u[0] * u[0]) + (2.0 * u[1] + 0.2 * x[1]).sin();
    let statistics = [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.975)];
    for seed in 0..6 {
        let [alone, beside] = [vec![], vec![0]].map(|compared_columns| {
            let mut problem = problem(&[STANDARD_NORMAL; 2], &[(0.0, 1.0), (-0.5, 0.5)], &statistics);
            problem.compared_columns = compared_columns;
            problem.sampling = Sampling { outer: 32, seed, ..Sampling::default() };
            evaluate(problem, &Function(smooth)).unwrap().pairs
        });
        for (alone, beside) in alone.iter().zip(&beside) {
            let [alone, beside] = [alone, beside].map(|pair| pair.upper.error.sampling + pair.lower.error.sampling);
            // Other statistics are searched beside them, so that the points differ.
            assert!(beside <= 2.0 * alone, "{seed}: {beside} {alone}");
        }
    }
}

#[test]
fn analytic_where_a_bounded_response_nearly_reaches_the_limit_is_found() {
    // Y = hill(u) + X, X uniform in (-1/2, 1/2): above the limit only where the hill exceeds 0.8, in 0.1 % of the box.
    const LIMIT: f64 = 1.3;
    const TOP: [f64; 4] = [0.31, 0.62, 0.45, 0.58];
    const WIDTH: f64 = 0.3;
    let hill = |x: &[f64], u: &[f64]| {
        let square: f64 = u.iter().zip(TOP).map(|(u, top)| (u - top) * (u - top)).sum();
        x[0] + libm::exp(-square / (WIDTH * WIDTH))
    };
    let mut missed = 0;
    for seed in 0..SEEDS {
        let uniform = Distribution::Uniform { lower: -0.5, upper: 0.5 };
        let mut problem = problem(&[uniform], &[(0.0, 1.0); 4], &[Statistic::ProbabilityAbove(LIMIT)]);
        problem.sampling = Sampling { outer: 64, inner: 128, seed, ..Sampling::default() };
        let upper = evaluate(problem, &Function(hill)).unwrap().pairs[0].upper.clone();
        missed += usize::from(upper.widened < 1.5 - LIMIT);
    }
    assert_eq!(missed, 0, "of {SEEDS}");
}

#[test]
fn analytic_scatter_where_the_estimate_is_not_the_furthest_counts() {
    // The mean is 1 + 0.02 u, exactly known at u = 0 alone: in many samples its estimate is largest there.
    let mut missed = 0;
    for seed in 0..SEEDS {
        let mut problem = problem(&[STANDARD_NORMAL], &[(0.0, 1.0)], &[Statistic::Mean]);
        problem.sampling = Sampling { outer: 8, inner: 64, seed, ..Sampling::default() };
        let response = |x: &[f64], u: &[f64]| 1.0 + u[0] * (0.02 + 0.9 * (1e3 * x[0]).sin());
        let upper = evaluate(problem, &Function(response)).unwrap().pairs[0].upper.clone();
        missed += usize::from(upper.widened < 1.02);
    }
    assert!(missed <= MAX_MISSED, "{missed} of {SEEDS} missed");
}
