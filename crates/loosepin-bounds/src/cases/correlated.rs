//! Correlated random inputs: bounds that are known in closed form.

use crate::Function;
use crate::cases::exact::{check, problem};
use crate::{Problem, Sampling, Statistic, TreatmentComparison, evaluate};
use loosepin_uncertainty::{Copula, Distribution, EpistemicParameter, GaussianCopula, Pair, Parameter, normal_cdf};

/// Y = A X1 + B X2 + C X3 + u: X1 and X2 correlated, X3 by itself.
const FACTORS: [f64; 3] = [0.7, -1.3, 0.4];
const MEANS: [f64; 3] = [3.0, -2.0, 0.5];
const DEVIATIONS: [f64; 3] = [0.8, 0.5, 0.9];
const NORMAL_CORRELATION: f64 = 0.65;

fn sum(statistics: &[Statistic], correlation: f64) -> Problem {
    let distributions: Vec<Distribution> = MEANS
        .iter()
        .zip(DEVIATIONS)
        .map(|(&mean, standard_deviation)| Distribution::Normal { mean, standard_deviation })
        .collect();
    let pairs = vec![Pair { first: 0, second: 1, normal: correlation }];
    let sampling = Sampling { inner: 1024, ..Sampling::default() };
    let copula = Some(Copula::Gaussian(GaussianCopula::try_new(3, pairs).unwrap()));
    Problem { copula, sampling, ..problem(&distributions, &[(-0.6, 0.9)], statistics) }
}

fn response(x: &[f64], u: &[f64]) -> f64 {
    FACTORS.iter().zip(x).map(|(factor, x)| factor * x).sum::<f64>() + u[0]
}

fn exact_moments(correlation: f64) -> (f64, f64) {
    let mean = FACTORS.iter().zip(MEANS).map(|(factor, mean)| factor * mean).sum();
    let [a, b, c]: [f64; 3] = std::array::from_fn(|i| FACTORS[i] * DEVIATIONS[i]);
    (mean, (a * a + b * b + c * c + 2.0 * correlation * a * b).sqrt())
}

#[test]
fn analytic_sum_of_correlated_normal_variables_and_an_interval() {
    let (mean, deviation) = exact_moments(NORMAL_CORRELATION);
    let limit = 6.0;
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.975),
        Statistic::Quantile(0.1),
        Statistic::ProbabilityAbove(limit),
    ];
    let bounds = evaluate(sum(&statistics, NORMAL_CORRELATION), &Function(response)).unwrap();
    // Sampling errors of 1024 runs in 8 replicates, as without correlation; the deviation without it would be 0.27 greater.
    check(&bounds.pairs[0], (mean - 0.6, mean + 0.9), 0.01);
    check(&bounds.pairs[1], (deviation, deviation), 0.04);
    let (upper, lower) = (1.959_963_984_540_054 * deviation, -1.281_551_565_544_600_4 * deviation);
    check(&bounds.pairs[2], (mean + upper - 0.6, mean + upper + 0.9), 0.12);
    check(&bounds.pairs[3], (mean + lower - 0.6, mean + lower + 0.9), 0.08);
    let above = |u: f64| normal_cdf((mean + u - limit) / deviation);
    check(&bounds.pairs[4], (above(-0.6), above(0.9)), 0.02);
}

#[test]
fn analytic_three_treatments_of_a_sum_of_correlated_variables() {
    // Order statistics of 8192 and 4096 runs.
    const HALF_WIDTH_TOLERANCE: f64 = 0.03;
    const ROUND_OFF: f64 = 1e-9;
    for correlation in [NORMAL_CORRELATION, -NORMAL_CORRELATION] {
        let (_, deviation) = exact_moments(correlation);
        let mut problem = sum(&[], correlation);
        problem.compared_columns = vec![0];
        problem.sampling = Sampling { inner: 4096, mixture: 8192, ..Sampling::default() };
        let bounds = evaluate(problem, &Function(response)).unwrap();
        let TreatmentComparison { probability_only, interval_only, mixed, .. } = &bounds.comparisons[0];
        let mixed_width = 1.959_963_984_540_054 * deviation + 0.75;
        assert!((mixed.half_width - mixed_width).abs() < HALF_WIDTH_TOLERANCE, "{} {mixed_width}", mixed.half_width);
        // The box of cuts knows no correlation.
        let cuts: f64 =
            FACTORS.iter().zip(DEVIATIONS).map(|(factor, deviation)| 3.0 * (factor * deviation).abs()).sum();
        assert!((interval_only.half_width - (cuts + 0.75)).abs() < ROUND_OFF, "{}", interval_only.half_width);
        // Normal plus uniform on ±0.75: P(|Y - mean| <= h) = 0.95, found by halving.
        let coverage = |h: f64| {
            let steps = 2000;
            let at = |i: i32| -0.75 + 1.5 * (f64::from(i) + 0.5) / f64::from(steps);
            let inside = |u: f64| normal_cdf((h - u) / deviation) - normal_cdf((-h - u) / deviation);
            (0..steps).map(|i| inside(at(i))).sum::<f64>() / f64::from(steps)
        };
        let (mut low, mut high) = (0.0, 10.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if coverage(middle) < 0.95 { low = middle } else { high = middle }
        }
        assert!(
            (probability_only.half_width - low).abs() < HALF_WIDTH_TOLERANCE,
            "{} {low}",
            probability_only.half_width
        );
    }
}

#[test]
fn analytic_correlation_within_a_probability_box() {
    // The deviation of X2 lies between 0.2 and 0.5: its share of the sum is negative, so that more of it first takes away.
    let statistics = [Statistic::Mean, Statistic::StandardDeviation];
    let mut problem = sum(&statistics, NORMAL_CORRELATION);
    problem.epistemic.push(loosepin_uncertainty::Interval::try_new(0.2, 0.5).unwrap().into());
    let parameter = Parameter::StandardDeviation;
    problem.parameters = vec![EpistemicParameter { random: 1, parameter, epistemic: 1 }];
    let bounds = evaluate(problem, &Function(response)).unwrap();
    let deviation = |of_second: f64| {
        let [a, b, c] = [FACTORS[0] * DEVIATIONS[0], FACTORS[1] * of_second, FACTORS[2] * DEVIATIONS[2]];
        (a * a + b * b + c * c + 2.0 * NORMAL_CORRELATION * a * b).sqrt()
    };
    // Least where b = -r a, within the box.
    let least = deviation(-NORMAL_CORRELATION * FACTORS[0] * DEVIATIONS[0] / FACTORS[1]);
    let most = deviation(0.2).max(deviation(0.5));
    let (mean, _) = exact_moments(0.0);
    check(&bounds.pairs[0], (mean - 0.6, mean + 0.9), 0.01);
    check(&bounds.pairs[1], (least, most), 0.04);
}
