//! Curves of many poses whose extremes lie between the places at which models are evaluated.

use crate::cases::exact::{STANDARD_NORMAL, paired};
use crate::{Failure, Problem, Request, Response, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{Interval, RandomVariable};
use std::f64::consts::TAU;

/// Poses, with three statistics each: more than are taken for single numbers.
const POSES: usize = 90;

/// The waves: amplitude sin(order θ + phase + slope u), u from 0 to 1.
const WAVES: [[f64; 4]; 2] = [[1.0, 1.0, 0.2, 2.3], [0.6, 2.0, 1.1, 2.9]];

/// Deviation of the scatter.
const SCATTER: f64 = 0.1;

fn angle(pose: usize) -> f64 {
    TAU * pose as f64 / POSES as f64
}

/// The least and the greatest of a wave at `angle`.
fn ends([amplitude, order, phase, slope]: [f64; 4], angle: f64) -> [f64; 2] {
    let (from, to) = (order * angle + phase, order * angle + phase + slope);
    // Whether it passes through a phase of 2πk + `summit`.
    let passes = |summit: f64| ((to - summit) / TAU).floor() >= ((from - summit) / TAU).ceil();
    let low = if passes(-0.25 * TAU) { -1.0 } else { from.sin().min(to.sin()) };
    let high = if passes(0.25 * TAU) { 1.0 } else { from.sin().max(to.sin()) };
    [amplitude * low, amplitude * high]
}

/// The sum of both waves and the scatter at every pose.
struct Waves;

impl Response for Waves {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        for (pose, column) in columns.iter_mut().enumerate() {
            let wave = |k: usize| {
                let [amplitude, order, phase, slope] = WAVES[k];
                amplitude * (order * angle(pose) + phase + slope * epistemic[k]).sin()
            };
            *column = wave(0) + wave(1) + SCATTER * random[0];
        }
        Ok(())
    }
}

#[test]
fn analytic_ends_of_smooth_curves_lie_within_their_bounds() {
    // Of widths about 2.
    const ROUND_OFF: f64 = 1e-9;
    const MOST: f64 = 0.01;
    // Normal quantiles of 2.5 and 97.5 %.
    const STATISTICS: [(Statistic, f64); 3] = [
        (Statistic::Mean, 0.0),
        (Statistic::Quantile(0.025), -1.959_963_984_540_054),
        (Statistic::Quantile(0.975), 1.959_963_984_540_054),
    ];
    let of_pose = |column: usize| STATISTICS.map(|(statistic, _)| Request { column, statistic });
    let requests: Vec<Request> = (0..POSES).flat_map(of_pose).collect();
    let unit = || Interval::try_new(0.0, 1.0).unwrap().into();
    let normal = RandomVariable::try_new(STANDARD_NORMAL).unwrap();
    let mut problem = Problem::new(vec![normal], vec![unit(), unit()], requests);
    problem.sampling = Sampling { outer: 32, inner: 64, ..Sampling::default() };
    let bounds = evaluate(problem, &Waves).unwrap();
    let exact = (0..POSES).flat_map(|pose| {
        let [a, b] = WAVES.map(|wave| ends(wave, angle(pose)));
        STATISTICS.map(|(_, z)| [a[0] + b[0], a[1] + b[1]].map(|end| end + SCATTER * z))
    });
    let exact: Vec<[f64; 2]> = exact.collect();
    for (pair, [least, greatest]) in paired(&bounds.pairs, exact) {
        let beyond = [least - pair.lower.widened, pair.upper.widened - greatest];
        let are_held = beyond.iter().all(|beyond| *beyond > -ROUND_OFF && *beyond < MOST);
        assert!(are_held, "column {}, {:?}: {beyond:?}", pair.column, pair.statistic);
    }
}

/// A kink, size |sin(order θ + phase + slope u₁)|, beside the first wave.
struct Kinked;

const KINK: [f64; 4] = [0.5, 1.0, 0.4, 2.2];

impl Response for Kinked {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        for (pose, column) in columns.iter_mut().enumerate() {
            let part = |[amplitude, order, phase, slope]: [f64; 4], u: f64| {
                amplitude * (order * angle(pose) + phase + slope * u).sin()
            };
            *column = part(WAVES[0], epistemic[0]) + part(KINK, epistemic[1]).abs() + SCATTER * random[0];
        }
        Ok(())
    }
}

#[test]
fn analytic_ends_of_curves_with_kinks_are_missed_half_as_often() {
    // A hard case: a kink along an axis, least values on faces and near corners. Of 1,080 ends 123 were missed before kinks were conceded, 51 are.
    const MAX_MISSED: usize = 60;
    const ROUND_OFF: f64 = 1e-9;
    const MEDIAN: f64 = 0.0;
    let quantile = 1.959_963_984_540_054;
    let statistics =
        [(Statistic::Mean, MEDIAN), (Statistic::Quantile(0.025), -quantile), (Statistic::Quantile(0.975), quantile)];
    let of_pose = |column: usize| statistics.map(|(statistic, _)| Request { column, statistic });
    let unit = || Interval::try_new(0.0, 1.0).unwrap().into();
    let normal = RandomVariable::try_new(STANDARD_NORMAL).unwrap();
    let (mut missed, mut ends_of_all) = (0, 0);
    for seed in 1..=2 {
        let requests: Vec<Request> = (0..POSES).flat_map(of_pose).collect();
        let mut problem = Problem::new(vec![normal.clone()], vec![unit(), unit()], requests);
        problem.sampling = Sampling { outer: 32, inner: 64, seed, ..Sampling::default() };
        let bounds = evaluate(problem, &Kinked).unwrap();
        let exact = (0..POSES).flat_map(|pose| {
            let wave = ends(WAVES[0], angle(pose));
            let [low, high] = ends(KINK, angle(pose));
            // 0 where the kink is in the interval.
            let kink =
                [if low < 0.0 && high > 0.0 { 0.0 } else { low.abs().min(high.abs()) }, low.abs().max(high.abs())];
            statistics.map(|(_, z)| [wave[0] + kink[0], wave[1] + kink[1]].map(|end| end + SCATTER * z))
        });
        let exact: Vec<[f64; 2]> = exact.collect();
        for (pair, [least, greatest]) in paired(&bounds.pairs, exact) {
            for beyond in [least - pair.lower.widened, pair.upper.widened - greatest] {
                ends_of_all += 1;
                missed += usize::from(beyond < -ROUND_OFF);
            }
        }
    }
    assert_eq!(ends_of_all, 2 * 2 * 3 * POSES);
    assert!(missed <= MAX_MISSED, "{missed} of {ends_of_all}");
}
