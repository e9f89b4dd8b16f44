//! Cases with known bounds: the exact value must lie within the stated error, and the error must be small.

use crate::{
    BoundPair, Bounds, Failure, Function, Guarantee, Problem, Request, Response, Sampling, Statistic,
    TreatmentComparison, evaluate,
};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, normal_cdf};

/// A problem with one column.
pub(crate) fn problem(random: &[Distribution], epistemic: &[(f64, f64)], statistics: &[Statistic]) -> Problem {
    let random = random.iter().cloned().map(|distribution| RandomVariable::try_new(distribution).unwrap()).collect();
    let epistemic = epistemic.iter().map(|&(lower, upper)| Interval::try_new(lower, upper).unwrap().into()).collect();
    let requests = statistics.iter().map(|&statistic| Request { column: 0, statistic }).collect();
    Problem::new(random, epistemic, requests)
}

/// Pairs of found and expected values; fails if one list is longer.
#[track_caller]
pub(crate) fn paired<F, E>(
    found: &[F],
    expected: impl IntoIterator<Item = E, IntoIter: ExactSizeIterator>,
) -> impl Iterator<Item = (&F, E)> {
    let expected = expected.into_iter();
    assert_eq!(found.len(), expected.len(), "found and expected");
    found.iter().zip(expected)
}

pub(crate) const STANDARD_NORMAL: Distribution = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };

/// Fails where `exact` lies outside the widened bounds or an error exceeds `most_error`; prints all numbers.
#[track_caller]
pub(crate) fn check(pair: &BoundPair, exact: (f64, f64), most_error: f64) {
    let covers = pair.lower.widened <= exact.0 + ROUND_OFF && pair.upper.widened >= exact.1 - ROUND_OFF;
    let is_tight = pair.lower.error.total() <= most_error && pair.upper.error.total() <= most_error;
    // What is attained may miss the exact value inwards or, by sampling error, outwards.
    let is_near = (pair.lower.value - exact.0).abs() <= most_error && (pair.upper.value - exact.1).abs() <= most_error;
    assert!(covers && is_tight && is_near, "exact {exact:?}, within {most_error}: {pair:#?}");
}

/// Of numbers about 1.
pub(crate) const ROUND_OFF: f64 = 1e-12;

#[test]
fn analytic_sum_of_a_normal_variable_and_an_interval() {
    let (quantile, tail) = (1.959_963_984_540_054, 2.0);
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.975),
        Statistic::ProbabilityAbove(tail),
        Statistic::ProbabilityBelow(-tail),
        Statistic::ProbabilityBeyond(tail),
    ];
    let mut problem = problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &statistics);
    problem.sampling = Sampling { inner: 1024, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[0])).unwrap();
    // Sampling errors of 1024 runs in 8 replicates: stratified means and deviations, quantile by order statistics.
    check(&bounds.pairs[0], (-1.0, 1.0), 0.005);
    check(&bounds.pairs[1], (1.0, 1.0), 0.03);
    check(&bounds.pairs[2], (quantile - 1.0, quantile + 1.0), 0.12);
    check(&bounds.pairs[3], (normal_cdf(-3.0), normal_cdf(-1.0)), 0.006);
    check(&bounds.pairs[4], (normal_cdf(-3.0), normal_cdf(-1.0)), 0.006);
    let beyond = |u: f64| normal_cdf(-tail - u) + normal_cdf(u - tail);
    check(&bounds.pairs[5], (beyond(0.0), beyond(1.0)), 0.008);
    let witness = |bound: &crate::Bound| bound.witness.as_ref().unwrap().epistemic[0];
    assert_eq!((witness(&bounds.pairs[2].lower), witness(&bounds.pairs[2].upper)), (-1.0, 1.0));
    assert_eq!(bounds.pairs[0].lower.guarantee, Guarantee::Sampled { confidence: 0.99 });
}

#[test]
fn analytic_three_treatments_of_a_sum() {
    let mut problem = problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &[]);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { inner: 4096, mixture: 8192, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[0])).unwrap();
    let TreatmentComparison { probability_only, interval_only, mixed, .. } = &bounds.comparisons[0];
    // Order statistics of 8192 and 4096 runs; the coverage changes by 0.18 times an end at u = 1.
    const HALF_WIDTH_TOLERANCE: f64 = 0.025;
    const COVERAGE_TOLERANCE: f64 = 0.006;
    assert!((probability_only.half_width - 2.2541).abs() < HALF_WIDTH_TOLERANCE, "{}", probability_only.half_width);
    assert!((mixed.half_width - 2.9600).abs() < HALF_WIDTH_TOLERANCE, "{}", mixed.half_width);
    assert!((interval_only.half_width - 4.0).abs() < ROUND_OFF, "{}", interval_only.half_width);
    assert!(interval_only.upper.error.total() < 1e-5, "{:?}", interval_only.upper.error);
    assert!(probability_only.upper.widened >= 2.2541 && mixed.upper.widened >= 2.95996);
    assert!((probability_only.coverage.maximum - 0.976).abs() < COVERAGE_TOLERANCE, "{:?}", probability_only.coverage);
    assert!((probability_only.coverage.minimum - 0.895).abs() < COVERAGE_TOLERANCE, "{:?}", probability_only.coverage);
    assert!((mixed.coverage.minimum - 0.97496).abs() < COVERAGE_TOLERANCE, "{}", mixed.coverage.minimum);
    assert!(interval_only.coverage.minimum > 0.998);
    let at_least = probability_only.coverage.minimum_witness.as_ref().unwrap().epistemic[0];
    assert_eq!(at_least.abs(), 1.0);
}

#[test]
fn analytic_product_has_its_least_deviation_inside() {
    let statistics = [Statistic::StandardDeviation, Statistic::Mean];
    let bounds = evaluate(
        problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &statistics),
        &Function(|x: &[f64], u: &[f64]| u[0] * x[0]),
    )
    .unwrap();
    check(&bounds.pairs[0], (0.0, 1.0), 0.05);
    check(&bounds.pairs[1], (0.0, 0.0), 0.02);
    // The minimum is exact: no sample of 0·X scatters.
    assert!(bounds.pairs[0].lower.value < 1e-6 && bounds.pairs[0].lower.error.total() < 1e-5);
    // An interval that is not symmetric: neither a corner nor the centre.
    let bounds = evaluate(
        problem(&[STANDARD_NORMAL], &[(-0.37, 1.0)], &statistics),
        &Function(|x: &[f64], u: &[f64]| u[0] * x[0]),
    )
    .unwrap();
    check(&bounds.pairs[0], (0.0, 1.0), 0.05);
    assert!(bounds.pairs[0].lower.value < 1e-4, "{:?}", bounds.pairs[0].lower);
}

#[test]
fn analytic_power_of_two_intervals() {
    let bounds = evaluate(
        problem(&[], &[(0.1, 1.0), (0.0, 1.0)], &[Statistic::Mean, Statistic::StandardDeviation]),
        &Function(|_: &[f64], u: &[f64]| libm::pow(u[0] + u[1], u[0])),
    )
    .unwrap();
    let least = libm::exp(-1.0 / core::f64::consts::E);
    check(&bounds.pairs[0], (least, 2.0), 0.005);
    // What is attained is far nearer than what the model vouches for.
    assert!((bounds.pairs[0].lower.value - least).abs() < 1e-5, "{:?}", bounds.pairs[0].lower);
    assert_eq!(bounds.pairs[0].upper.value, 2.0);
    assert_eq!(bounds.pairs[0].lower.guarantee, Guarantee::Optimised);
    assert_eq!(bounds.pairs[0].lower.error.sampling, 0.0);
    check(&bounds.pairs[1], (0.0, 0.0), 0.0);
}

/// Closed-form slider-crank, lengths in mm.
pub(crate) fn slider_crank(x: &[f64], u: &[f64]) -> f64 {
    const CRANK_ANGLE_RAD: f64 = core::f64::consts::FRAC_PI_3;
    const NOMINAL_MM: f64 = 136.915_146_427_996_96;
    let (crank_mm, rod_mm, clearance_mm, direction_rad) = (x[0], x[1], u[0], u[1]);
    let height_mm = crank_mm * libm::sin(CRANK_ANGLE_RAD) + clearance_mm * libm::sin(direction_rad);
    crank_mm * libm::cos(CRANK_ANGLE_RAD)
        + (rod_mm * rod_mm - height_mm * height_mm).sqrt()
        + clearance_mm * libm::cos(direction_rad)
        - NOMINAL_MM
}

pub(crate) const SLIDER_CRANK_RANDOM: [Distribution; 2] = [
    Distribution::Normal { mean: 50.0, standard_deviation: 0.02 },
    Distribution::Normal { mean: 120.0, standard_deviation: 0.03 },
];

pub(crate) const SLIDER_CRANK_EPISTEMIC: [(f64, f64); 2] = [(0.1, 0.5), (0.0, core::f64::consts::TAU)];

#[test]
fn analytic_slider_crank_with_play() {
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::ProbabilityBeyond(0.45),
        Statistic::ProbabilityBeyond(0.60),
    ];
    let mut problem = problem(&SLIDER_CRANK_RANDOM, &SLIDER_CRANK_EPISTEMIC, &statistics);
    problem.sampling = Sampling { inner: 1024, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(slider_crank)).unwrap();
    check(&bounds.pairs[0], (-0.536_290_6, 0.535_951_9), 0.005);
    // The whole range of the deviation is 0.3 % of it: 1024 runs resolve 1 to 2 %.
    check(&bounds.pairs[1], (0.032_290_24, 0.032_382_72), 0.001);
    check(&bounds.pairs[2], (0.0, 0.996_176_4), 0.01);
    check(&bounds.pairs[3], (0.0, 0.024_466_6), 0.015);
    // A tenth of the sampling error, 3e-4 mm, is where the search for a flat extreme stops: 0.03 rad.
    const WITNESS_TOLERANCE_RAD: f64 = 0.05;
    let witness = |bound: &crate::Bound| bound.witness.clone().unwrap().epistemic;
    let (low, high) = (witness(&bounds.pairs[0].lower), witness(&bounds.pairs[0].upper));
    const WITNESS_TOLERANCE_MM: f64 = 0.001; // the same, for a slope of 1
    assert!(low[0] > 0.5 - WITNESS_TOLERANCE_MM && high[0] > 0.5 - WITNESS_TOLERANCE_MM);
    assert!((low[1] - 2.7708).abs() < WITNESS_TOLERANCE_RAD && (high[1] - 5.9156).abs() < WITNESS_TOLERANCE_RAD);
}

#[test]
fn analytic_response_with_a_jump() {
    // Y = X + 2 where u > 0.37, else X: mean in [0, 2], P(Y > 1) in [Φ(-1), Φ(1)].
    let bounds = evaluate(
        problem(&[STANDARD_NORMAL], &[(0.0, 1.0)], &[Statistic::Mean, Statistic::ProbabilityAbove(1.0)]),
        &Function(|x: &[f64], u: &[f64]| x[0] + if u[0] > 0.37 { 2.0 } else { 0.0 }),
    )
    .unwrap();
    // A smooth model overshoots beside a jump: a third of it is conceded.
    check(&bounds.pairs[0], (0.0, 2.0), 0.7);
    check(&bounds.pairs[1], (normal_cdf(-1.0), normal_cdf(1.0)), 0.2);
    assert!(bounds.pairs[0].lower.value.abs() < 0.02 && (bounds.pairs[0].upper.value - 2.0).abs() < 0.02);
}

#[test]
fn analytic_extreme_inside_four_intervals() {
    // mean = exp(-2 |u - m|²): 1 at m, inside; least at the corner furthest from m.
    let centre = [0.31, 0.62, 0.45, 0.58];
    let mut problem = problem(&[STANDARD_NORMAL], &[(0.0, 1.0); 4], &[Statistic::Mean]);
    problem.sampling = Sampling { outer: 96, ..Sampling::default() };
    let bounds = evaluate(
        problem,
        &Function(|x: &[f64], u: &[f64]| {
            let square: f64 = u.iter().zip(centre).map(|(u, m)| (u - m) * (u - m)).sum();
            0.1 * x[0] + libm::exp(-2.0 * square)
        }),
    )
    .unwrap();
    let furthest: f64 = centre.iter().map(|m: &f64| m.max(1.0 - m).powi(2)).sum();
    let pair = &bounds.pairs[0];
    check(pair, (libm::exp(-2.0 * furthest), 1.0), 0.08);
    assert!((pair.upper.value - 1.0).abs() < 0.003, "{:?}", pair.upper);
}

#[test]
fn analytic_failed_runs_are_taken_as_unknown() {
    struct Failing;
    impl Response for Failing {
        fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
            if random[0] > 0.9 {
                return Err(Failure(3));
            }
            columns[0] = random[0] + epistemic[0];
            Ok(())
        }
    }
    // Y = X + u, X uniform, u in [0, 0.5]; one in ten fails: P(Y > 0.6) between 0.3 and 0.8 + 0.1.
    let uniform = Distribution::Uniform { lower: 0.0, upper: 1.0 };
    let statistics = [Statistic::ProbabilityAbove(0.6), Statistic::Mean, Statistic::Quantile(0.5)];
    let bounds = evaluate(problem(&[uniform], &[(0.0, 0.5)], &statistics), &Failing).unwrap();
    check(&bounds.pairs[0], (0.3, 0.9), 0.03);
    assert!(bounds.pairs[0].failed_runs > 0 && !bounds.pairs[0].unbounded_by_failures);
    check(&bounds.pairs[1], (0.45, 0.95), 0.03);
    assert!(bounds.pairs[1].unbounded_by_failures);
    // The median of all runs: failures below everything, or above everything.
    check(&bounds.pairs[2], (0.4, 1.0), 0.04);
    let share = bounds.failed_runs as f64 / bounds.runs as f64;
    assert!((share - 0.1).abs() < 0.01);
}

#[test]
fn nothing_finished_leaves_everything_open() {
    struct Broken;
    impl Response for Broken {
        fn evaluate(&self, _: &[f64], _: &[f64], _: &mut [f64]) -> Result<(), Failure> {
            Err(Failure(1))
        }
    }
    let statistics = [Statistic::Mean, Statistic::ProbabilityAbove(1.0), Statistic::Cdf];
    let mut problem = problem(&[STANDARD_NORMAL], &[(0.0, 1.0)], &statistics);
    problem.compared_columns = vec![0];
    let bounds = evaluate(problem, &Broken).unwrap();
    assert!(bounds.pairs[0].lower.value.is_nan() && bounds.pairs[0].lower.widened == f64::NEG_INFINITY);
    assert_eq!((bounds.pairs[1].lower.widened, bounds.pairs[1].upper.widened), (0.0, 1.0));
    assert!(bounds.boxes[0].values.is_empty());
    assert!(bounds.comparisons[0].mixed.upper.widened == f64::INFINITY);
    assert_eq!(bounds.failed_runs, bounds.runs);
}

#[test]
fn analytic_without_intervals_both_bounds_are_the_statistic() {
    let mut problem = problem(&[STANDARD_NORMAL], &[], &[Statistic::Mean, Statistic::Quantile(0.975)]);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { inner: 2048, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| 0.3 + x[0])).unwrap();
    check(&bounds.pairs[0], (0.3, 0.3), 0.005);
    check(&bounds.pairs[1], (2.259_964, 2.259_964), 0.1);
    assert_eq!(bounds.pairs[0].lower.value, bounds.pairs[0].upper.value);
    assert_eq!(bounds.pairs[0].lower.error.optimisation, 0.0);
    let comparison = &bounds.comparisons[0];
    assert_eq!(comparison.mixed.half_width, comparison.probability_only.half_width);
    assert!((comparison.interval_only.half_width - 3.0).abs() < ROUND_OFF);
}

#[test]
fn analytic_without_anything_uncertain_the_bound_is_the_number() {
    let mut problem =
        problem(&[], &[], &[Statistic::Mean, Statistic::StandardDeviation, Statistic::ProbabilityAbove(2.0)]);
    problem.compared_columns = vec![0];
    let bounds = evaluate(problem, &Function(|_: &[f64], _: &[f64]| 2.7)).unwrap();
    check(&bounds.pairs[0], (2.7, 2.7), 0.0);
    check(&bounds.pairs[1], (0.0, 0.0), 0.0);
    check(&bounds.pairs[2], (1.0, 1.0), 0.0);
    assert_eq!(bounds.pairs[0].lower.guarantee, Guarantee::Enclosure);
    assert_eq!((bounds.runs, bounds.comparisons[0].interval_only.half_width), (1, 0.0));
}

#[test]
fn analytic_probability_box_of_a_sum() {
    let mut problem = problem(&[STANDARD_NORMAL], &[(-1.0, 1.0)], &[Statistic::Cdf]);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { inner: 1024, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[0])).unwrap();
    const MAX_ERROR: f64 = 0.03;
    let probability_box = &bounds.boxes[0];
    for (i, y) in probability_box.values.iter().enumerate() {
        let (lower, upper) = (&probability_box.lower[i], &probability_box.upper[i]);
        let (exact_lower, exact_upper) = (normal_cdf(y - 1.0), normal_cdf(y + 1.0));
        assert!(lower.widened <= exact_lower && upper.widened >= exact_upper, "{y}: {lower:?} {upper:?}");
        let mixture = probability_box.probability_only.as_ref().unwrap()[i];
        assert!(lower.widened <= mixture && mixture <= upper.widened, "{y}: {mixture}");
        assert!(exact_lower - lower.widened < MAX_ERROR && upper.widened - exact_upper < MAX_ERROR, "{y} {lower:?}");
    }
}

/// All numbers of a result as text: equal text means equal bits.
pub(crate) fn bits(bounds: &Bounds) -> String {
    format!("{bounds:?}")
}

#[test]
fn identity_the_same_bits_with_1_2_and_16_threads() {
    let run = |threads: usize| {
        let statistics =
            [Statistic::Mean, Statistic::StandardDeviation, Statistic::ProbabilityBeyond(0.45), Statistic::Cdf];
        let mut problem = problem(&SLIDER_CRANK_RANDOM, &SLIDER_CRANK_EPISTEMIC, &statistics);
        problem.compared_columns = vec![0];
        problem.sampling = Sampling { inner: 64, outer: 32, ..Sampling::default() };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| bits(&evaluate(problem, &Function(slider_crank)).unwrap()))
    };
    let one = run(1);
    assert_eq!(one, run(2));
    assert_eq!(one, run(16));
}

#[test]
fn identity_no_response_makes_the_plan_panic() {
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.01),
        Statistic::ProbabilityAbove(0.0),
        Statistic::ProbabilityBeyond(0.0),
        Statistic::Cdf,
    ];
    type Scalar = fn(&[f64], &[f64]) -> f64;
    let nasty: [Scalar; 9] = [
        |_, _| f64::NAN,
        |x, _| x.iter().sum::<f64>() * 1e300 * 1e8,
        |x, _| x.iter().sum::<f64>() * 1e-310,
        |x, u| if u.first().is_some_and(|u| *u > 0.2) { f64::INFINITY } else { x.iter().sum() },
        |x, u| if u.iter().sum::<f64>() > 0.7 { f64::NAN } else { x.iter().sum::<f64>() + 1.0 },
        |_, u| 1.0 / u.iter().sum::<f64>(),
        |_, _| 3.0,
        |x, u| (x.iter().sum::<f64>() * 1e9).sin() * u.iter().product::<f64>(),
        |x, _| if x.first().is_some_and(|x| *x > 2.0) { 1e200 } else { 0.0 },
    ];
    for (random, epistemic) in [(0, 0), (0, 2), (1, 0), (1, 1), (2, 5)] {
        for function in nasty {
            let random = vec![STANDARD_NORMAL; random];
            let epistemic = vec![(0.0, 0.5); epistemic];
            let mut problem = problem(&random, &epistemic, &statistics);
            problem.compared_columns = vec![0];
            problem.sampling = Sampling { outer: 24, inner: 16, mixture: 16, extreme: 40, ..Sampling::default() };
            let bounds = evaluate(problem, &Function(function)).unwrap();
            for pair in &bounds.pairs {
                let value_is_inside = |lower: f64, value: f64| lower <= value || value.is_nan() || lower.is_nan();
                assert!(value_is_inside(pair.lower.widened, pair.lower.value), "{pair:?}");
                assert!(value_is_inside(pair.upper.value, pair.upper.widened), "{pair:?}");
                assert!(!pair.lower.widened.is_nan() && !pair.upper.widened.is_nan(), "{pair:?}");
            }
        }
    }
}

#[test]
fn analytic_an_interval_of_no_width_is_a_number() {
    let bounds = evaluate(
        problem(&[STANDARD_NORMAL], &[(-1.0, 1.0), (0.25, 0.25)], &[Statistic::Mean]),
        &Function(|x: &[f64], u: &[f64]| x[0] + u[0] + u[1]),
    )
    .unwrap();
    check(&bounds.pairs[0], (-0.75, 1.25), 0.05);
    assert!(bounds.outer_points.iter().all(|point| point[1] == 0.25));
}
