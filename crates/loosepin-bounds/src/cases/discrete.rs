//! Epistemic inputs given by a list: cases with known bounds, alone and together with intervals.

use crate::Function;
use crate::cases::exact::{ROUND_OFF, STANDARD_NORMAL, bits, check, paired, problem};
use crate::cases::noisy::{check_misses_of, expect};
use crate::plan::double_loop::DoubleLoop;
use crate::{Bound, Guarantee, Problem, SampleTable, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{Distribution, EpistemicVariable, Interval, Members, normal_cdf};

fn one_of(values: &[f64]) -> EpistemicVariable {
    Members::try_new(values.to_vec()).unwrap().into()
}

fn between(lower: f64, upper: f64) -> EpistemicVariable {
    Interval::try_new(lower, upper).unwrap().into()
}

fn witness(bound: &Bound) -> &[f64] {
    &bound.witness.as_ref().unwrap().epistemic
}

const MEMBERS: [f64; 3] = [0.75, -0.5, 2.0];
/// Φ⁻¹(0.9)
const QUANTILE_90: f64 = 1.281_551_565_544_6;

/// Y = X + u, u one of [`MEMBERS`].
fn sum(statistics: &[Statistic]) -> Problem {
    Problem { epistemic: vec![one_of(&MEMBERS)], ..problem(&[STANDARD_NORMAL], &[], statistics) }
}

#[test]
fn analytic_sum_of_a_normal_variable_and_one_of_a_list() {
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.9),
        Statistic::ProbabilityAbove(1.0),
        Statistic::ProbabilityBeyond(2.5),
    ];
    let problem = Problem { sampling: Sampling { inner: 1024, ..Sampling::default() }, ..sum(&statistics) };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[0])).unwrap();
    // Sampling errors of 1024 runs in 8 replicates.
    check(&bounds.pairs[0], (-0.5, 2.0), 0.005);
    check(&bounds.pairs[1], (1.0, 1.0), 0.03);
    check(&bounds.pairs[2], (QUANTILE_90 - 0.5, QUANTILE_90 + 2.0), 0.06);
    check(&bounds.pairs[3], (normal_cdf(-1.5), normal_cdf(1.0)), 0.008);
    let beyond = |u: f64| normal_cdf(u - 2.5) + normal_cdf(-u - 2.5);
    check(&bounds.pairs[4], (beyond(-0.5), beyond(2.0)), 0.008);
    // Every member has been run, and there is nothing between them: no search, no error of it.
    assert!(
        bounds.pairs.iter().all(|pair| pair.lower.error.optimisation == 0.0 && pair.upper.error.optimisation == 0.0)
    );
    assert_eq!(bounds.outer_points, [[0.75], [-0.5], [2.0]]);
    assert_eq!((bounds.runs, bounds.rounds, bounds.centre_point), (3 * 1024, 1, 0));
    assert_eq!((witness(&bounds.pairs[0].lower), witness(&bounds.pairs[0].upper)), (&[-0.5][..], &[2.0][..]));
    assert_eq!((witness(&bounds.pairs[3].lower), witness(&bounds.pairs[3].upper)), (&[-0.5][..], &[2.0][..]));
    assert_eq!(bounds.pairs[0].lower.guarantee, Guarantee::Sampled { confidence: 0.99 });
}

#[test]
fn analytic_a_list_without_anything_random_is_enclosed() {
    let problem = Problem { epistemic: vec![one_of(&MEMBERS)], ..problem(&[], &[], &[Statistic::Mean]) };
    let bounds = evaluate(problem, &Function(|_: &[f64], u: &[f64]| u[0] * u[0])).unwrap();
    check(&bounds.pairs[0], (0.25, 4.0), 0.0);
    assert_eq!(bounds.pairs[0].lower.guarantee, Guarantee::Enclosure);
}

#[test]
fn analytic_three_treatments_of_a_list() {
    let mut problem = sum(&[Statistic::Cdf]);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { inner: 4096, mixture: 8192, ..Sampling::default() };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| x[0] + u[0])).unwrap();
    let comparison = &bounds.comparisons[0];
    // Probability only: every member has the probability 1/3, so that F(y) = Σ Φ(y - u)/3.
    let mixture = |y: f64| MEMBERS.iter().map(|u| normal_cdf(y - u)).sum::<f64>() / 3.0;
    // Order statistics of 8192 and 4096 runs.
    const SHARE_TOLERANCE: f64 = 0.003;
    const TOLERANCE: f64 = 0.025;
    let ends = [comparison.probability_only.lower.value, comparison.probability_only.upper.value];
    for (end, share) in ends.into_iter().zip([0.025, 0.975]) {
        assert!((mixture(end) - share).abs() < SHARE_TOLERANCE, "{end} {share}");
    }
    // Mixed: from the lower quantile of the least member to the upper quantile of the greatest.
    let quantile = 1.959_963_984_540_054;
    assert!((comparison.mixed.lower.value + quantile + 0.5).abs() < TOLERANCE, "{:?}", comparison.mixed.lower);
    assert!((comparison.mixed.upper.value - quantile - 2.0).abs() < TOLERANCE, "{:?}", comparison.mixed.upper);
    // Interval only: every member with X cut at ±3.
    let [low, high] = [&comparison.interval_only.lower, &comparison.interval_only.upper];
    assert!((low.value + 3.5).abs() < ROUND_OFF && (high.value - 5.0).abs() < ROUND_OFF, "{low:?} {high:?}");
    assert_eq!((witness(low), witness(high)), (&[-0.5][..], &[2.0][..]));
    // The coverage of the probability-only band, member by member.
    let coverage = |u: f64| normal_cdf(ends[1] - u) - normal_cdf(ends[0] - u);
    for (point, u) in paired(&comparison.probability_only.coverage.points, MEMBERS) {
        assert!((point.lower - coverage(u)).abs() < 0.006, "{point:?} {u}");
    }
    // The curve of the mixture in the probability box is the same mixture.
    let probability_box = &bounds.boxes[0];
    let curve = probability_box.probability_only.as_ref().unwrap();
    for (i, y) in probability_box.values.iter().enumerate() {
        assert!((curve[i] - mixture(*y)).abs() < SHARE_TOLERANCE, "{y}");
        // The curves of the greatest and of the least member bound it, each within its sampling error.
        let (lower, upper) = (&probability_box.lower[i], &probability_box.upper[i]);
        assert!((lower.value - normal_cdf(y - 2.0)).abs() < SHARE_TOLERANCE, "{y}: {lower:?}");
        assert!((upper.value - normal_cdf(y + 0.5)).abs() < SHARE_TOLERANCE, "{y}: {upper:?}");
        assert!(lower.widened <= curve[i] && curve[i] <= upper.widened, "{y}");
    }
}

const FACTORS: [f64; 3] = [0.5, -2.0, 1.25];

/// Y = u1 X + u2 with X ~ N(0.3, 1), u1 one of [`FACTORS`], u2 in [-1, 0.5].
fn scaled_sum(statistics: &[Statistic]) -> Problem {
    let random = Distribution::Normal { mean: 0.3, standard_deviation: 1.0 };
    Problem { epistemic: vec![one_of(&FACTORS), between(-1.0, 0.5)], ..problem(&[random], &[], statistics) }
}

#[test]
fn analytic_a_list_beside_an_interval() {
    let statistics =
        [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.9), Statistic::ProbabilityAbove(2.0)];
    let problem = Problem { sampling: Sampling { inner: 1024, ..Sampling::default() }, ..scaled_sum(&statistics) };
    let bounds = evaluate(problem, &Function(|x: &[f64], u: &[f64]| u[0] * x[0] + u[1])).unwrap();
    check(&bounds.pairs[0], (-1.6, 0.875), 0.01);
    assert_eq!(
        (witness(&bounds.pairs[0].lower), witness(&bounds.pairs[0].upper)),
        (&[-2.0, -1.0][..], &[1.25, 0.5][..])
    );
    check(&bounds.pairs[1], (0.5, 2.0), 0.06);
    assert_eq!((witness(&bounds.pairs[1].lower)[0], witness(&bounds.pairs[1].upper)[0]), (0.5, -2.0));
    // 0.3 u1 + z |u1| + u2: least for u1 = 0.5, greatest for 1.25, a hair above that for -2.
    check(&bounds.pairs[2], (0.15 + 0.5 * QUANTILE_90 - 1.0, 0.375 + 1.25 * QUANTILE_90 + 0.5), 0.15);
    assert_eq!(witness(&bounds.pairs[2].lower), [0.5, -1.0]);
    // 1 - Φ((2 - u2 - 0.3 u1)/|u1|)
    check(&bounds.pairs[3], (normal_cdf(-5.7), normal_cdf(-0.9)), 0.015);
    assert_eq!(witness(&bounds.pairs[3].upper), [1.25, 0.5]);
}

#[test]
fn analytic_an_extreme_inside_the_interval_of_one_member() {
    // Mean u1 sin 4 u2 with u2 in [0, 1]: greatest 1.5 sin(-4) at u2 = 1, least -1.5 at u2 = π/8, both for u1 = -1.5.
    let problem = Problem {
        epistemic: vec![between(0.0, 1.0), one_of(&[1.0, -1.5, 0.7])],
        ..problem(&[STANDARD_NORMAL], &[], &[Statistic::Mean])
    };
    let bounds =
        evaluate(problem, &Function(|x: &[f64], u: &[f64]| 0.1 * x[0] + u[1] * libm::sin(4.0 * u[0]))).unwrap();
    check(&bounds.pairs[0], (-1.5, 1.5 * libm::sin(4.0).abs()), 0.02);
    let (low, high) = (witness(&bounds.pairs[0].lower), witness(&bounds.pairs[0].upper));
    // A tenth of the sampling error, 1e-4, is where the search for a flat extreme stops: 4e-3 of the interval.
    assert!((low[0] - core::f64::consts::FRAC_PI_8).abs() < 0.01 && low[1] == -1.5, "{low:?}");
    assert_eq!(high, [1.0, -1.5]);
}

#[test]
fn analytic_one_of_a_list_is_missed_as_rarely_as_stated() {
    let problem = sum(&[]);
    let expected = [
        expect(Statistic::Mean, -0.5, 2.0, 0.03),
        expect(Statistic::StandardDeviation, 1.0, 1.0, 0.08),
        expect(Statistic::Quantile(0.9), QUANTILE_90 - 0.5, QUANTILE_90 + 2.0, 0.15),
        expect(Statistic::ProbabilityAbove(1.0), normal_cdf(-1.5), normal_cdf(1.0), 0.03),
    ];
    check_misses_of(100, &problem, &expected, |x, u| x[0] + u[0]);
}

#[test]
fn analytic_a_list_beside_an_interval_is_missed_as_rarely_as_stated() {
    let problem = Problem { sampling: Sampling { outer: 30, ..Sampling::default() }, ..scaled_sum(&[]) };
    let expected = [
        expect(Statistic::Mean, -1.6, 0.875, 0.04),
        expect(Statistic::StandardDeviation, 0.5, 2.0, 0.12),
        expect(Statistic::Quantile(0.9), 0.15 + 0.5 * QUANTILE_90 - 1.0, 0.375 + 1.25 * QUANTILE_90 + 0.5, 0.3),
        expect(Statistic::ProbabilityAbove(2.0), normal_cdf(-5.7), normal_cdf(-0.9), 0.05),
    ];
    check_misses_of(50, &problem, &expected, |x, u| u[0] * x[0] + u[1]);
}

#[test]
fn identity_the_same_bits_with_1_2_and_16_threads_over_a_list() {
    let run = |threads: usize| {
        let statistics =
            [Statistic::Mean, Statistic::StandardDeviation, Statistic::ProbabilityAbove(2.0), Statistic::Cdf];
        let mut problem = scaled_sum(&statistics);
        problem.compared_columns = vec![0];
        problem.sampling = Sampling { inner: 64, outer: 32, ..Sampling::default() };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let function = Function(|x: &[f64], u: &[f64]| u[0] * x[0] + libm::sin(3.0 * u[1]));
        pool.install(|| bits(&evaluate(problem, &function).unwrap()))
    };
    let one = run(1);
    assert_eq!(one, run(2));
    assert_eq!(one, run(16));
}

#[test]
fn identity_every_combination_meets_the_same_random_numbers() {
    let plan = DoubleLoop::try_new(scaled_sum(&[Statistic::Mean])).unwrap();
    let round = plan.next_round(&SampleTable::new(1)).unwrap();
    let random_at = |member: f64| -> Vec<u64> {
        let first = round.iter().find(|inputs| inputs.epistemic[0] == member).unwrap().point;
        round.iter().filter(|inputs| inputs.point == first).map(|inputs| inputs.random[0].to_bits()).collect()
    };
    assert_eq!(random_at(FACTORS[0]).len(), 256);
    assert!(FACTORS.iter().all(|&member| random_at(member) == random_at(FACTORS[0])));
}

#[test]
fn rules_about_combinations_are_told_with_their_numbers() {
    let refused = |change: &dyn Fn(&mut Problem)| {
        let mut problem = scaled_sum(&[Statistic::Mean]);
        change(&mut problem);
        DoubleLoop::try_new(problem).unwrap_err().to_string()
    };
    assert_eq!(
        refused(&|problem| problem.sampling.outer = 8),
        "outer 8; 3 combinations of members, each with the corners and the centre of a box with 1 input, need at least 9\n\
         hint: 64 is a good start"
    );
    let many: Vec<f64> = (0..13).map(f64::from).collect();
    let refused = refused(&|problem| problem.epistemic = vec![one_of(&many), one_of(&many[..5])]);
    assert_eq!(
        refused,
        "65 combinations of the members of lists; must be at most 64\n\
         hint: shorten the lists, or take numbers that lie close together as an interval"
    );
}

#[test]
fn a_run_with_a_value_of_no_list_is_refused() {
    let sampling = Sampling { inner: 64, ..Sampling::default() };
    let plan = DoubleLoop::try_new(Problem { sampling, ..sum(&[Statistic::Mean]) }).unwrap();
    let mut table = SampleTable::new(1);
    for mut inputs in plan.next_round(&table).unwrap() {
        if inputs.point == 1 {
            inputs.epistemic[0] = 0.25;
        }
        let value = inputs.random[0] + inputs.epistemic[0];
        table.push(inputs, Ok(&[value])).unwrap();
    }
    let refused = plan.results(&table).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "point 1 has 0.25 for epistemic input 0, which is none of its list\nhint: add the runs as the plan gave them"
    );
}
