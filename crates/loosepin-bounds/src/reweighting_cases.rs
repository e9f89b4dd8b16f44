//! Runs weighted for distributions that they were not drawn from, against closed forms.

use super::exact_cases::{Function, check, problem};
use super::{Bounds, NotReweighted, PlanError, Problem, ProblemError, Sampling, Statistic, evaluate};
use crate::DoubleLoop;
use loosepin_uncertainty::{
    Distribution, EpistemicParameter, Interval, Parameter, RandomVariable, normal_cdf, normal_quantile,
};

const MEANS: (f64, f64) = (-0.5, 0.75);
const DEVIATIONS: (f64, f64) = (0.4, 1.2);
const LIMIT: f64 = 1.5;
const STATISTICS: [Statistic; 4] =
    [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.975), Statistic::ProbabilityAbove(LIMIT)];

/// X ~ N(m, s) with m and s in intervals, beside another normal variable.
fn normal_box(statistics: &[Statistic], reweighting: bool, seed: u64) -> Problem {
    let central = Distribution::Normal { mean: 0.125, standard_deviation: 0.8 };
    let beside = Distribution::Normal { mean: 0.25, standard_deviation: 0.3 };
    Problem {
        parameters: vec![
            EpistemicParameter { random: 0, parameter: Parameter::Mean, epistemic: 0 },
            EpistemicParameter { random: 0, parameter: Parameter::StandardDeviation, epistemic: 1 },
        ],
        sampling: Sampling { inner: 512, reweighting, seed, ..Sampling::default() },
        ..problem(&[central, beside], &[MEANS, DEVIATIONS], statistics)
    }
}

fn bounds(statistics: &[Statistic], reweighting: bool, seed: u64, of: impl Fn(f64, f64) -> f64 + Sync) -> Bounds {
    evaluate(normal_box(statistics, reweighting, seed), &Function(|x: &[f64], _: &[f64]| of(x[0], x[1]))).unwrap()
}

#[test]
fn analytic_a_smooth_response_needs_the_runs_of_corners_and_centre_alone() {
    // X + Z ~ N(m + 0.25, s² + 0.3²).
    let spread = |s: f64| s.hypot(0.3);
    let (low, high) = (MEANS.0 + 0.25, MEANS.1 + 0.25);
    let z = normal_quantile(0.975);
    let above = |m: f64, s: f64| normal_cdf((m - LIMIT) / spread(s));
    let exact = [
        (low, high),
        (spread(DEVIATIONS.0), spread(DEVIATIONS.1)),
        (low + z * spread(DEVIATIONS.0), high + z * spread(DEVIATIONS.1)),
        (above(low, DEVIATIONS.0), above(high, DEVIATIONS.1)),
    ];
    for seed in [3, 159] {
        let bounds = bounds(&STATISTICS, true, seed, |x, z| x + z);
        for (pair, exact) in bounds.pairs.iter().zip(exact) {
            // A hundredth of a percent of the width, where 512 runs counted would leave a percent or more.
            check(pair, exact, 1e-4 * (exact.1 - exact.0));
        }
        let told = bounds.reweighted.unwrap();
        assert_eq!((bounds.runs, told.points, told.polynomials, told.untold), (5 * 512, 5, 1, 0), "{told:?}");
        assert!(told.least_effective > 64.0);
    }
}

#[test]
fn analytic_an_extreme_between_the_points_is_found_by_weights() {
    // X²: mean m² + s², least at m = 0; variance 2 s⁴ + 4 m² s².
    let deviation = |m: f64, s: f64| (2.0 * s.powi(4) + 4.0 * m * m * s * s).sqrt();
    let bounds = bounds(&STATISTICS[..2], true, 5, |x, _| x * x);
    let (least, most) = (DEVIATIONS.0, DEVIATIONS.1);
    check(&bounds.pairs[0], (least * least, MEANS.1 * MEANS.1 + most * most), 0.003);
    check(&bounds.pairs[1], (deviation(0.0, least), deviation(MEANS.1, most)), 0.003);
    assert!(bounds.outer_points.len() < 20, "{}", bounds.outer_points.len());
}

#[test]
fn analytic_a_response_that_no_polynomial_follows_is_weighted() {
    // X + sin(40 Z)/2: far more than a turn of the sine within the scatter of Z, so that its mean is 0 and its variance 1/8.
    let statistics = [Statistic::Mean, Statistic::StandardDeviation];
    let deviation = |s: f64| s.hypot(0.125_f64.sqrt());
    for seed in [2, 77] {
        let bounds = bounds(&statistics, true, seed, |x, z| x + 0.5 * (40.0 * z).sin());
        check(&bounds.pairs[0], MEANS, 0.25);
        check(&bounds.pairs[1], (deviation(DEVIATIONS.0), deviation(DEVIATIONS.1)), 0.25);
        let told = bounds.reweighted.unwrap();
        assert_eq!((told.polynomials, told.untold), (0, 0), "{told:?}");
        // A quarter of the points that the search without weights may take.
        assert!(told.points <= 16, "{told:?}");
    }
}

#[test]
fn analytic_draws_that_all_points_share_count_once() {
    // Nearly one distribution: the runs at all points are those at one, which are 512.
    let mut problem = normal_box(&STATISTICS[..1], true, 9);
    problem.epistemic = [(0.125, 0.1251), (0.8, 0.8001)].map(|(a, b)| Interval::try_new(a, b).unwrap().into()).to_vec();
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0] + 0.5 * (40.0 * x[1]).sin())).unwrap();
    let effective = bounds.reweighted.unwrap().least_effective;
    assert!(effective > 500.0 && effective <= 512.0 + 1e-6, "{effective}");
}

#[test]
fn analytic_quantiles_and_shares_of_a_response_with_a_jump() {
    // Y = X, and 2 more above 0.6: the quantile jumps with the parameters, between a deviation of 0.858 and one beyond that.
    const EDGE: f64 = 0.6;
    let above = |m: f64, s: f64| normal_cdf((m - 1.0) / s);
    let nine_tenths = normal_quantile(0.9);
    let low = MEANS.0 + nine_tenths * DEVIATIONS.0;
    let high = MEANS.1 + nine_tenths * DEVIATIONS.1 + 2.0;
    assert!(low < EDGE);
    let exact = [(low, high), (above(MEANS.0, DEVIATIONS.0), above(MEANS.1, DEVIATIONS.1))];
    for (statistic, exact) in [Statistic::Quantile(0.9), Statistic::ProbabilityAbove(3.0)].into_iter().zip(exact) {
        for seed in [6, 31] {
            let bounds = bounds(&[statistic], true, seed, |x, _| x + if x > EDGE { 2.0 } else { 0.0 });
            check(&bounds.pairs[0], exact, 0.3 * (exact.1 - exact.0));
            let told = bounds.reweighted.unwrap();
            assert!(told.untold == 0 && told.points <= 16, "{told:?}");
        }
    }
}

#[test]
fn analytic_a_support_that_moves_with_the_parameters() {
    // Uniform on [a, b]: mean (a + b)/2, variance (b - a)²/12 and 1/8 more. Every support lies within that of the widest corner.
    let (lower, upper) = ((0.1, 0.4), (0.9, 1.4));
    let mut problem = normal_box(&STATISTICS[..2], true, 12);
    problem.random[0] = RandomVariable::try_new(Distribution::Uniform { lower: 0.2, upper: 1.0 }).unwrap();
    for (parameter, of) in [Parameter::Lower, Parameter::Upper].into_iter().zip(&mut problem.parameters) {
        of.parameter = parameter;
    }
    problem.epistemic = [lower, upper].map(|(a, b)| Interval::try_new(a, b).unwrap().into()).to_vec();
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0] + 0.5 * (40.0 * x[1]).sin())).unwrap();
    let deviation = |width: f64| (width * width / 12.0 + 0.125).sqrt();
    check(&bounds.pairs[0], (0.5 * (lower.0 + upper.0), 0.5 * (lower.1 + upper.1)), 0.4);
    check(&bounds.pairs[1], (deviation(upper.0 - lower.1), deviation(upper.1 - lower.0)), 0.2);
    assert!(bounds.reweighted.is_some());
}

#[test]
fn a_quantile_that_weights_are_worth_too_little_for_is_searched_without_them() {
    // Of 512 runs none tells the quantile at 0.9999.
    let statistics = [Statistic::Quantile(0.9999)];
    let bounds = bounds(&statistics, true, 4, |x, z| x + 0.5 * (40.0 * z).sin());
    assert_eq!(bounds.reweighted, None);
    assert!(bounds.outer_points.len() > 16);
}

#[test]
fn runs_are_weighted_only_where_nothing_but_parameters_is_epistemic() {
    let mut problem = normal_box(&STATISTICS, true, 1);
    problem.epistemic.push(Interval::try_new(0.25, 0.5).unwrap().into());
    let found = DoubleLoop::try_new(problem).unwrap_err();
    let expected = ProblemError::NotReweighted(NotReweighted::NoParameter { epistemic: 2 });
    assert_eq!(found, PlanError::Problem(expected));
}
