//! Probability boxes by parameters, against closed forms.

use crate::Function;
use crate::cases::exact::{check, problem};
use crate::{Problem, Response, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{
    Distribution, EpistemicParameter, EpistemicVariable, Interval, Members, Parameter, normal_cdf, normal_quantile,
};

const MEANS: (f64, f64) = (-0.5, 0.75);
const DEVIATIONS: (f64, f64) = (0.4, 1.2);
const SHIFTS: (f64, f64) = (-0.3, 0.2);
/// Seeds of which every one must contain the truth: each of the statistics misses with less than 1 %.
const SEEDS: [u64; 2] = [3, 159];

fn between(ends: (f64, f64)) -> EpistemicVariable {
    Interval::try_new(ends.0, ends.1).unwrap().into()
}

/// X ~ N(m, s) with m and s in intervals, and u in an interval.
fn normal_box(statistics: &[Statistic], seed: u64) -> Problem {
    let central = Distribution::Normal { mean: 0.125, standard_deviation: 0.8 };
    Problem {
        epistemic: vec![between(SHIFTS), between(MEANS), between(DEVIATIONS)],
        parameters: vec![
            EpistemicParameter { random: 0, parameter: Parameter::StandardDeviation, epistemic: 2 },
            EpistemicParameter { random: 0, parameter: Parameter::Mean, epistemic: 1 },
        ],
        sampling: Sampling { outer: 40, inner: 1024, seed, ..Sampling::default() },
        ..problem(&[central], &[], statistics)
    }
}

/// The response must not look at parameters: they are not numbers here.
struct WithoutParameters<F>(F);

impl<F: Fn(f64, f64) -> f64 + Sync> Response for WithoutParameters<F> {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), crate::Failure> {
        columns[0] = (self.0)(random[0], epistemic[0]);
        Ok(())
    }
}

#[test]
fn analytic_sum_of_a_normal_box_and_an_interval() {
    let limit = 1.5;
    let statistics =
        [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.975), Statistic::ProbabilityAbove(limit)];
    for seed in SEEDS {
        let bounds = evaluate(normal_box(&statistics, seed), &WithoutParameters(|x: f64, u: f64| x + u)).unwrap();
        let (low, high) = (MEANS.0 + SHIFTS.0, MEANS.1 + SHIFTS.1);
        let z = normal_quantile(0.975);
        check(&bounds.pairs[0], (low, high), 0.02);
        check(&bounds.pairs[1], DEVIATIONS, 0.06);
        check(&bounds.pairs[2], (low + z * DEVIATIONS.0, high + z * DEVIATIONS.1), 0.2);
        let above = |mean: f64, deviation: f64| normal_cdf((mean - limit) / deviation);
        check(&bounds.pairs[3], (above(low, DEVIATIONS.0), above(high, DEVIATIONS.1)), 0.03);
        let witness = bounds.pairs[3].upper.witness.clone().unwrap().epistemic;
        assert_eq!(witness, [SHIFTS.1, MEANS.1, DEVIATIONS.1]);
    }
}

#[test]
fn analytic_product_of_a_normal_box_and_an_interval() {
    // Y = uX: mean u m, deviation |u| s, whose least value 0 lies inside.
    for seed in SEEDS {
        let statistics = [Statistic::Mean, Statistic::StandardDeviation];
        let bounds = evaluate(normal_box(&statistics, seed), &WithoutParameters(|x: f64, u: f64| u * x)).unwrap();
        check(&bounds.pairs[0], (SHIFTS.0 * MEANS.1, SHIFTS.0 * MEANS.0), 0.02);
        check(&bounds.pairs[1], (0.0, -SHIFTS.0 * DEVIATIONS.1), 0.03);
    }
}

#[test]
fn analytic_three_treatments_of_a_normal_box() {
    let mut problem = normal_box(&[], 7);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { inner: 1024, mixture: 8192, ..Sampling::default() };
    let bounds = evaluate(problem, &WithoutParameters(|x: f64, u: f64| x + u)).unwrap();
    let comparison = &bounds.comparisons[0];
    // Cut at ±3 of the widest: the parameters themselves are no dimensions of what is searched.
    const ROUND_OFF: f64 = 1e-9;
    let ends = (MEANS.0 - 3.0 * DEVIATIONS.1 + SHIFTS.0, MEANS.1 + 3.0 * DEVIATIONS.1 + SHIFTS.1);
    assert!((comparison.interval_only.lower.value - ends.0).abs() < ROUND_OFF, "{:?}", comparison.interval_only.lower);
    assert!((comparison.interval_only.upper.value - ends.1).abs() < ROUND_OFF, "{:?}", comparison.interval_only.upper);
    // Quantiles of X + u, all uniform: the mean of Φ over a fine grid of the three.
    let mixture_cdf = |y: f64| {
        const STEPS: usize = 40;
        let at = |ends: (f64, f64), k: usize| ends.0 + (ends.1 - ends.0) * (k as f64 + 0.5) / STEPS as f64;
        let mut sum = 0.0;
        for i in 0..STEPS {
            for j in 0..STEPS {
                for k in 0..STEPS {
                    sum += normal_cdf((y - at(SHIFTS, i) - at(MEANS, j)) / at(DEVIATIONS, k));
                }
            }
        }
        sum / (STEPS * STEPS * STEPS) as f64
    };
    // 8192 stratified runs know a share of 2.5 % to about 0.001.
    const SHARE_TOLERANCE: f64 = 0.003;
    let [low, high] = [comparison.probability_only.lower.value, comparison.probability_only.upper.value];
    assert!((mixture_cdf(low) - 0.025).abs() < SHARE_TOLERANCE, "{}", mixture_cdf(low));
    assert!((mixture_cdf(high) - 0.975).abs() < SHARE_TOLERANCE, "{}", mixture_cdf(high));
    assert!(comparison.mixed.lower.value < low && comparison.mixed.upper.value > high);
}

#[test]
fn analytic_uniform_box_with_a_list_of_ends() {
    // X ~ U(a, b), a one of three, b in an interval: mean (a + b)/2, deviation (b - a)/√12.
    let uniform = Distribution::Uniform { lower: 0.3, upper: 2.0 };
    let problem = Problem {
        epistemic: vec![Members::try_new(vec![0.3, -0.2, 0.1]).unwrap().into(), between((1.5, 2.5))],
        parameters: vec![
            EpistemicParameter { random: 0, parameter: Parameter::Lower, epistemic: 0 },
            EpistemicParameter { random: 0, parameter: Parameter::Upper, epistemic: 1 },
        ],
        sampling: Sampling { inner: 1024, ..Sampling::default() },
        ..problem(&[uniform], &[], &[Statistic::Mean, Statistic::StandardDeviation])
    };
    let bounds = evaluate(problem, &Function(|x: &[f64], _: &[f64]| x[0])).unwrap();
    check(&bounds.pairs[0], (0.65, 1.4), 0.01);
    check(&bounds.pairs[1], (1.2 / 12.0_f64.sqrt(), 2.7 / 12.0_f64.sqrt()), 0.01);
}
