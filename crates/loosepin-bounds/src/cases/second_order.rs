//! Statistics whose distribution over uncertain parameters is known in closed form.

use crate::Function;
use crate::cases::exact::problem;
use crate::{Bound, Bounds, Problem, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{
    Distribution, EpistemicParameter, EpistemicVariable, Interval, Parameter, RandomVariable, SecondOrder,
    normal_quantile,
};

/// Percentiles that all problems ask for.
const PERCENTILES: [f64; 3] = [0.05, 0.5, 0.95];

fn second_order(distribution: Distribution) -> EpistemicVariable {
    SecondOrder::try_new(RandomVariable::try_new(distribution).unwrap()).unwrap().into()
}

/// X normal, with structures for its parameters; `others` follow.
fn normal_box(
    mean: EpistemicVariable,
    deviation: Option<EpistemicVariable>,
    others: &[(f64, f64)],
    statistics: &[Statistic],
) -> Problem {
    let normal = Distribution::Normal { mean: mean.middle(), standard_deviation: 0.5 };
    let mut problem = problem(&[normal], &[], statistics);
    problem.epistemic.push(mean);
    problem.parameters.push(EpistemicParameter { random: 0, parameter: Parameter::Mean, epistemic: 0 });
    if let Some(deviation) = deviation {
        problem.epistemic.push(deviation);
        let parameter = Parameter::StandardDeviation;
        problem.parameters.push(EpistemicParameter { random: 0, parameter, epistemic: 1 });
    }
    let interval = |&(lower, upper): &(f64, f64)| Interval::try_new(lower, upper).unwrap().into();
    problem.epistemic.extend(others.iter().map(interval));
    problem.sampling = Sampling { inner: 1024, ..Sampling::default() };
    problem
}

/// Fails where an exact percentile lies outside of the widened ends or an error exceeds `most_error`.
#[track_caller]
fn check(bounds: &Bounds, place: usize, exact: impl Fn(f64) -> (f64, f64), most_error: f64) {
    let found = &bounds.percentiles[place];
    assert_eq!(found.percentiles.len(), PERCENTILES.len());
    for (percentile, probability) in found.percentiles.iter().zip(PERCENTILES) {
        assert_eq!(percentile.probability, probability);
        let (least, greatest) = exact(probability);
        let is_near =
            |bound: &Bound, exact: f64| (bound.value - exact).abs() <= most_error && bound.error.total() <= most_error;
        assert!(
            percentile.lower.widened <= least && percentile.upper.widened >= greatest,
            "{least} .. {greatest} at {probability}: {percentile:#?}"
        );
        assert!(
            is_near(&percentile.lower, least) && is_near(&percentile.upper, greatest),
            "{least} .. {greatest} at {probability}, within {most_error}: {percentile:#?}"
        );
    }
}

#[test]
fn analytic_mean_and_quantile_of_a_normal_variable_whose_mean_is_normal() {
    // X ~ N(θ, 0.5), θ ~ N(2, 0.3): its mean is θ, its 97.5 % quantile θ + 0.5 * 1.96; both have the percentiles of θ.
    let statistics = [Statistic::Mean, Statistic::Quantile(0.975), Statistic::ProbabilityAbove(2.5)];
    let mean = second_order(Distribution::Normal { mean: 2.0, standard_deviation: 0.3 });
    let problem = normal_box(mean, None, &[], &statistics);
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0])).unwrap();
    let theta = |p: f64| 2.0 + 0.3 * normal_quantile(p);
    // 1024 runs give a mean to 0.002; 2048 values of θ give a percentile to a twentieth of its deviation.
    check(&bounds, 0, |p| (theta(p), theta(p)), 0.03);
    // A quantile by order statistics of 1024 runs: 0.08.
    let quantile = |p: f64| theta(p) + 0.5 * normal_quantile(0.975);
    check(&bounds, 1, |p| (quantile(p), quantile(p)), 0.12);
    // P(X > 2.5) = Φ((θ - 2.5)/0.5), which grows with θ.
    let share = |p: f64| loosepin_uncertainty::normal_cdf((theta(p) - 2.5) / 0.5);
    check(&bounds, 2, |p| (share(p), share(p)), 0.06);
}

#[test]
fn analytic_percentiles_of_a_deviation_and_of_a_product_of_parameters() {
    // X ~ N(θ, τ), θ uniform in 1 .. 3, τ lognormal with mean 0.5 and deviation 0.1, Y = X: the deviation of Y is τ.
    let tau = Distribution::Lognormal { mean: 0.5, standard_deviation: 0.1 };
    let of_tau = RandomVariable::try_new(tau.clone()).unwrap();
    let theta = second_order(Distribution::Uniform { lower: 1.0, upper: 3.0 });
    let statistics = [Statistic::StandardDeviation, Statistic::Mean];
    let problem = normal_box(theta, Some(second_order(tau)), &[], &statistics);
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0])).unwrap();
    // A deviation of 0.7 is known to 2 % from 1024 runs.
    check(&bounds, 0, |p| (of_tau.quantile(p), of_tau.quantile(p)), 0.04);
    check(&bounds, 1, |p| (1.0 + 2.0 * p, 1.0 + 2.0 * p), 0.08);
}

#[test]
fn analytic_an_interval_beside_a_distribution_gives_bounds_on_each_percentile() {
    // Y = X + v - 0.3 v², X ~ N(θ, 0.5), θ ~ N(2, 0.3), v in -0.5 .. 2.5: the mean is θ + v - 0.3 v², least at v = -0.5, greatest at
    // v = 5/3, inside.
    let mean = second_order(Distribution::Normal { mean: 2.0, standard_deviation: 0.3 });
    let problem = normal_box(mean, None, &[(-0.5, 2.5)], &[Statistic::Mean]);
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[1] - 0.3 * u[1] * u[1])).unwrap();
    let theta = |p: f64| 2.0 + 0.3 * normal_quantile(p);
    let of_v = |v: f64| v - 0.3 * v * v;
    check(&bounds, 0, |p| (theta(p) + of_v(-0.5), theta(p) + of_v(5.0 / 3.0)), 0.05);
    for percentile in &bounds.percentiles[0].percentiles {
        let v = |bound: &Bound| bound.witness.as_ref().unwrap().epistemic.clone();
        let (low, high) = (v(&percentile.lower), v(&percentile.upper));
        // The parameter has no single value there; of the greatest of 40 values of v none is further than 0.1 away.
        assert!(low[0].is_nan() && high[0].is_nan());
        assert!(low[1] == -0.5 && (high[1] - 5.0 / 3.0).abs() < 0.1, "{low:?} {high:?}");
    }
}

#[test]
fn analytic_taken_as_probability_the_parameter_is_integrated_out() {
    // X ~ N(θ, 0.5), θ ~ N(2, 0.3): X itself ~ N(2, √0.34).
    let mean = second_order(Distribution::Normal { mean: 2.0, standard_deviation: 0.3 });
    let mut problem = normal_box(mean, None, &[], &[]);
    problem.compared_columns = vec![0];
    problem.sampling.mixture = 8192;
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0])).unwrap();
    const TOLERANCE: f64 = 0.03; // order statistics of 8192 runs
    let half_width = 0.34_f64.sqrt() * normal_quantile(0.975);
    let found = bounds.comparisons[0].probability_only.half_width;
    assert!((found - half_width).abs() < TOLERANCE, "{found} {half_width}");
}

#[test]
fn identity_what_leaves_a_statistic_without_one_value_is_refused() {
    let mean = second_order(Distribution::Normal { mean: 2.0, standard_deviation: 0.3 });
    let mut problem = normal_box(mean, None, &[], &[Statistic::Mean]);
    problem.reading = crate::Reading::RandomSet;
    let refused = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0])).unwrap_err().to_string();
    assert_eq!(
        refused,
        "a parameter with a distribution stands beside another reading of intervals; must be the only one with probabilities, \
         intervals read as fixed but unknown"
    );
}
