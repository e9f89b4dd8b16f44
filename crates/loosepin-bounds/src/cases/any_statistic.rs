//! Bounds of a statistic that has no estimator of its own, the mean absolute deviation about the mean: E|Y - E Y| = s √(2/π) of a normal
//! law with the standard deviation s.

use crate::cases::exact::{STANDARD_NORMAL, check, paired, problem};
use crate::{
    Bounds, Failure, Function, Problem, PromiseError, PromisePlan, PromiseRequest, PromiseSettings, Reading, Request,
    Sampling, Statistic, evaluate,
};
use loosepin_terms::Side;
use loosepin_uncertainty::{Distribution, Evidence, FocalElement, FuzzyNumber, Interval};

const DEVIATION: Statistic = Statistic::MeanAbsoluteDeviation;
const ROOT_OF_2_OVER_PI: f64 = 0.797_884_560_802_865_4;

/// Bounds of all `statistics` by `inner` runs.
fn bounds(
    random: &[Distribution],
    epistemic: &[(f64, f64)],
    (statistics, inner): (&[Statistic], usize),
    of: impl Fn(&[f64], &[f64]) -> f64 + Sync,
) -> Bounds {
    let problem = problem(random, epistemic, statistics);
    let sampling = Sampling { inner, ..problem.sampling };
    evaluate(Problem { sampling, ..problem }, &Function(of)).unwrap()
}

#[test]
fn analytic_an_interval_that_moves_a_normal_law_leaves_its_deviation() {
    let found = bounds(&[STANDARD_NORMAL], &[(-1.0, 1.0)], (&[DEVIATION], 1024), |x, u| x[0] + u[0]);
    check(&found.pairs[0], (ROOT_OF_2_OVER_PI, ROOT_OF_2_OVER_PI), 0.04);
}

#[test]
fn analytic_mean_and_deviation_of_a_normal_law_in_intervals() {
    let statistics = [DEVIATION, Statistic::StandardDeviation];
    let (least, most) = (0.5, 2.0);
    let found =
        bounds(&[STANDARD_NORMAL], &[(-3.0, 1.0), (least, most)], (&statistics, 1024), |x, u| u[0] + u[1] * x[0]);
    check(&found.pairs[0], (least * ROOT_OF_2_OVER_PI, most * ROOT_OF_2_OVER_PI), 0.1);
    check(&found.pairs[1], (least, most), 0.05);
    let scale = |bound: &crate::Bound| bound.witness.as_ref().unwrap().epistemic[1];
    assert_eq!((scale(&found.pairs[0].lower), scale(&found.pairs[0].upper)), (least, most));
}

#[test]
fn analytic_a_response_that_is_hit_or_missed() {
    // P(Y = 1) = u: 2 u (1 - u), greatest at 1/2, inside.
    let uniform = Distribution::Uniform { lower: 0.0, upper: 1.0 };
    let hit = |x: &[f64], u: &[f64]| if x[0] < u[0] { 1.0 } else { 0.0 };
    let found = bounds(&[uniform], &[(0.2, 0.9)], (&[DEVIATION], 4096), hit);
    check(&found.pairs[0], (2.0 * 0.9 * 0.1, 0.5), 0.02);
}

#[test]
fn analytic_the_least_deviation_is_none_and_bounds_do_not_go_below() {
    let found = bounds(&[STANDARD_NORMAL], &[(-1.0, 1.0)], (&[DEVIATION], 256), |x, u| u[0] * x[0]);
    check(&found.pairs[0], (0.0, ROOT_OF_2_OVER_PI), 0.2);
    assert_eq!(found.pairs[0].lower.widened, 0.0);
    // Nothing scatters.
    let found = bounds(&[], &[(0.25, 2.0)], (&[DEVIATION], 256), |_, u| u[0]);
    check(&found.pairs[0], (0.0, 0.0), 0.0);
}

#[test]
fn analytic_stated_intervals_hold_the_deviation_of_laws_of_many_shapes() {
    const SEEDS: u64 = 150;
    let normal = STANDARD_NORMAL;
    let uniform = Distribution::Uniform { lower: 0.0, upper: 1.0 };
    let exponential = Distribution::Exponential { mean: 1.0, lower: 0.0 };
    type Of = fn(f64) -> f64;
    let laws: [(&str, Distribution, Of, f64); 5] = [
        ("normal", normal.clone(), |x| x, ROOT_OF_2_OVER_PI),
        ("uniform", uniform.clone(), |x| x, 0.25),
        // E|X - 1| = 2/e.
        ("exponential", exponential, |x| x, 2.0 / core::f64::consts::E),
        ("in three steps", uniform, |x| (3.0 * x).floor().min(2.0), 2.0 / 3.0),
        ("two humps", normal, |x| x + 4.0 * x.signum(), 4.0 + ROOT_OF_2_OVER_PI),
    ];
    for (name, law, of, exact) in laws {
        let mut misses = 0;
        for seed in 0..SEEDS {
            let problem = problem(std::slice::from_ref(&law), &[], &[DEVIATION]);
            let sampling = Sampling { inner: 64, seed, ..problem.sampling };
            let response = Function(move |x: &[f64], _: &[f64]| of(x[0]));
            let found = evaluate(Problem { sampling, ..problem }, &response).unwrap();
            let [lower, upper] = [&found.pairs[0].lower, &found.pairs[0].upper].map(|bound| bound.widened);
            misses += u32::from(lower > exact || upper < exact);
        }
        // One in a hundred is due: with more than 6 of 150 it would be far more.
        assert!(misses <= 6, "{name}: {misses} of {SEEDS}");
    }
}

#[test]
fn failed_runs_leave_it_unbounded() {
    struct Fails;
    impl crate::Response for Fails {
        fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
            columns[0] = random[0] + epistemic[0];
            if random[0] > 2.0 { Err(Failure(3)) } else { Ok(()) }
        }
    }
    let problem = problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &[DEVIATION]);
    let found = evaluate(problem, &Fails).unwrap();
    let pair = &found.pairs[0];
    assert!(pair.unbounded_by_failures && pair.lower.value > 0.5);
    // What is shown has no end, and keeps what the finished runs have.
    assert_eq!(pair.guarantee(), crate::Guarantee::FinishedRuns);
    let ends = pair.ends();
    assert_eq!(ends.each_ref().map(|end| end.widened), [f64::NEG_INFINITY, f64::INFINITY]);
    let found = [&pair.lower, &pair.upper].map(|end| (end.value, end.error));
    assert_eq!(ends.map(|end| (end.value, end.error)), found);
}

/// Bounds of mixtures and of random sets are only checked to be non-negative.
fn is_open(found: &Bounds) {
    let [lower, upper] = [&found.pairs[0].lower, &found.pairs[0].upper];
    assert_eq!((lower.widened, upper.widened), (0.0, f64::INFINITY), "{:?}", found.pairs[0]);
    assert!(lower.error.total().is_infinite() && upper.error.total().is_infinite());
}

#[test]
fn what_is_not_known_of_mixtures_and_sets_is_said() {
    let response = Function(|x: &[f64], u: &[f64]| x[0] + u[0]);
    let of = || problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &[DEVIATION]);
    for reading in [Reading::UnknownDistribution, Reading::RandomSet] {
        is_open(&evaluate(Problem { reading, ..of() }, &response).unwrap());
    }
    let element = |lower, upper, mass| FocalElement { interval: Interval::try_new(lower, upper).unwrap(), mass };
    let evidence = Evidence::try_new(vec![element(-1.0, 0.25, 0.4), element(0.0, 1.0, 0.6)]).unwrap();
    is_open(&evaluate(Problem { epistemic: vec![evidence.into()], ..of() }, &response).unwrap());
}

#[test]
fn analytic_cuts_of_a_fuzzy_scale() {
    let cut = |(alpha, (lower, upper)): (f64, (f64, f64))| (alpha, Interval::try_new(lower, upper).unwrap());
    let fuzzy =
        FuzzyNumber::try_new([(0.0, (0.5, 2.0)), (0.5, (0.75, 1.5)), (1.0, (1.0, 1.0))].map(cut).to_vec()).unwrap();
    let problem = problem(&[STANDARD_NORMAL], &[], &[DEVIATION]);
    let sampling = Sampling { inner: 1024, ..problem.sampling };
    let problem = Problem { epistemic: vec![fuzzy.into()], sampling, ..problem };
    let found = evaluate(problem, &Function(|x: &[f64], u: &[f64]| u[0] * x[0])).unwrap();
    for (level, (least, most)) in paired(&found.levels, [(0.5, 2.0), (0.75, 1.5), (1.0, 1.0)]) {
        check(&level.pairs[0], (least * ROOT_OF_2_OVER_PI, most * ROOT_OF_2_OVER_PI), 0.1);
    }
}

#[test]
fn no_number_of_runs_promises_it() {
    let request = Request { column: 0, statistic: DEVIATION };
    let asked = vec![PromiseRequest { request, side: Side::Upper }];
    let problem = problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &[]);
    let refused = PromisePlan::try_new(problem, asked, Vec::new(), PromiseSettings::default()).unwrap_err();
    assert_eq!(refused, PromiseError::Unbounded { statistic: DEVIATION });
    assert!(refused.to_string().contains("nothing can be promised of a mean_absolute_deviation"), "{refused}");
}
