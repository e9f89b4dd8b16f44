//! What a statistic states of itself, held against drawn samples: each test looks for a sample that refutes the statement. All statistics of the
//! list are asked, so that a new one which copies a statement from its neighbour is found out; what is false of a statistic that is no part of the
//! program is found out here.

use super::kind::as_kind;
use super::mean_absolute_deviation::MeanAbsoluteDeviation;
use super::standard_deviation::StandardDeviation;
use super::{ErrorEffect, Estimation, Mirrored, Statistic, StatisticKind, between_order_statistics};
use crate::drawn::drawn;

/// Share of the largest magnitude of a sample that sums may be off.
const ROUND_OFF: f64 = 1e-12;

/// Most values of a drawn sample.
const MOST: u64 = 12;
/// Drawn samples of each family.
const DRAWN: usize = 200;

/// All values have the same weight. Most are small and one is large: the mean lies beyond the upper quantile.
pub(super) const SAMPLE: [f64; 10] = [-1.5, -0.25, 0.125, 0.5, 0.75, 0.875, 1.25, 1.5, 1.75, 400.0];

/// Numbers of statistics that have one, where they are allowed: among them values that drawn samples have.
const NUMBERS: [f64; 14] = [-2.0, -1.0, -0.5, 0.0, 0.05, 0.25, 0.4, 0.5, 0.6, 0.85, 0.95, 1.0, 1.625, 500.0];

/// Every statistic, those with a number with several that are allowed.
pub(super) fn all() -> Vec<Statistic> {
    let with_number = NUMBERS.into_iter().flat_map(Statistic::with_parameter);
    Statistic::PLAIN.into_iter().chain(with_number).filter(|statistic| statistic.has_allowed_number()).collect()
}

/// Those that are one number.
pub(super) fn single() -> Vec<Statistic> {
    all().into_iter().filter(|statistic| statistic.is_single()).collect()
}

pub(super) fn sorted(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_unstable_by(f64::total_cmp);
    values
}

/// Small samples, sorted: that is where statistics come closest to each other, and beyond what is true of many values.
pub(super) fn samples() -> Vec<Vec<f64>> {
    let mut draw = drawn(1);
    let mut count = drawn(2);
    let mut found: Vec<Vec<f64>> = [&SAMPLE[..], &SAMPLE[..9], &SAMPLE[2..]].map(<[f64]>::to_vec).into();
    let mut family = |value: &mut dyn FnMut() -> f64| {
        found.extend((0..DRAWN).map(|_| sorted((0..1 + count(MOST)).map(|_| value()))));
    };
    // Many equal ones: two values, three, a rare one.
    family(&mut || draw(2) as f64 - 0.5);
    family(&mut || draw(3) as f64 - 1.0);
    family(&mut || f64::from(u8::from(draw(8) == 0)));
    // Hardly any equal ones, around zero and on one side of it.
    family(&mut || (draw(65) as f64 - 32.0) / 16.0);
    family(&mut || 0.25 + draw(1000) as f64 / 64.0);
    // Heavy tails: magnitudes over six orders, on both sides and on one.
    family(&mut || (2.0 * draw(2) as f64 - 1.0) * f64::powi(2.0, draw(20) as i32 - 6));
    family(&mut || f64::powi(2.0, draw(20) as i32 - 6));
    // The same value throughout.
    found.extend((0..DRAWN / 10).map(|_| vec![(draw(65) as f64 - 32.0) / 16.0; 1 + count(MOST) as usize]));
    // Symmetric about a middle.
    found.extend((0..DRAWN).map(|_| {
        let middle = draw(3) as f64 - 1.0;
        let half: Vec<f64> = (0..1 + count(MOST / 2)).map(|_| draw(9) as f64 / 4.0).collect();
        sorted(half.into_iter().flat_map(|distance| [middle - distance, middle + distance]))
    }));
    found
}

/// What round-off may make of a statistic of a sample.
fn round_off(sample: &[f64]) -> f64 {
    ROUND_OFF * sample.iter().fold(1.0, |most: f64, value| most.max(value.abs()))
}

/// A sample that refutes a statement, with what is wrong.
type Refuted = Option<(Vec<f64>, String)>;

fn first(samples: &[Vec<f64>], wrong: impl Fn(&[f64], f64) -> Option<String>) -> Refuted {
    samples.iter().find_map(|sample| Some((sample.clone(), wrong(sample, round_off(sample))?)))
}

/// A sample of which `lesser` exceeds `greater`.
fn against_order(lesser: &dyn StatisticKind, greater: &dyn StatisticKind, samples: &[Vec<f64>]) -> Refuted {
    first(samples, |sample, round_off| {
        let [less, more] = [lesser, greater].map(|kind| kind.of_sorted(sample));
        (!(less <= more + round_off)).then(|| format!("{less} exceeds {more}"))
    })
}

/// A sample whose statistic is beyond what is stated for variables between its ends.
fn against_range(kind: &dyn StatisticKind, samples: &[Vec<f64>]) -> Refuted {
    let [lowest, highest] = kind.range_within([f64::NEG_INFINITY, f64::INFINITY]);
    first(samples, |sample, round_off| {
        let value = kind.of_sorted(sample);
        let [least, greatest] = kind.range_within([sample[0], sample[sample.len() - 1]]);
        let is_within = value >= least - round_off && value <= greatest + round_off;
        let is_narrower = lowest <= least && greatest <= highest;
        (!(is_within && is_narrower)).then(|| format!("{value} is not within [{least}, {greatest}]"))
    })
}

/// A sample whose statistic goes down, where one value goes up: by `sign` -1 one whose statistic goes up.
fn against_growth(kind: &dyn StatisticKind, sign: f64, samples: &[Vec<f64>]) -> Refuted {
    first(samples, |sample, round_off| {
        let before = kind.of_sorted(sample);
        (0..sample.len()).find_map(|moved| {
            let larger = sorted(sample.iter().enumerate().map(|(k, y)| if k == moved { y + 0.75 } else { *y }));
            let behind = kind.of_sorted(&larger);
            (!(sign * (behind - before) >= -round_off)).then(|| format!("{before} becomes {behind} of {larger:?}"))
        })
    })
}

/// A sample of which S(-Y) is not -T(Y).
fn against_mirror(kind: &dyn StatisticKind, mirrored: &dyn StatisticKind, samples: &[Vec<f64>]) -> Refuted {
    first(samples, |sample, round_off| {
        let [own, other] = [kind.of_sorted(&sorted(sample.iter().map(|y| -y))), -mirrored.of_sorted(sample)];
        (!((own - other).abs() <= round_off || own == other)).then(|| format!("{own} is not {other}"))
    })
}

/// A sample whose statistic errors move further than it states.
fn against_errors(kind: &dyn StatisticKind, samples: &[Vec<f64>]) -> Refuted {
    const MOST: f64 = 0.5;
    let mut draw = drawn(3);
    // Errors of all values, and of one alone.
    let mut errors = |count: usize| -> [Vec<f64>; 3] {
        let one = draw(count as u64) as usize;
        [
            (0..count).map(|_| (draw(5) as f64 - 2.0) / 4.0).collect(),
            (0..count).map(|k| if k == one { MOST } else { 0.0 }).collect(),
            (0..count).map(|k| if k == one { -MOST } else { 0.0 }).collect(),
        ]
    };
    let drawn: Vec<(&Vec<f64>, [Vec<f64>; 3])> = samples.iter().map(|sample| (sample, errors(sample.len()))).collect();
    drawn.into_iter().find_map(|(sample, errors)| {
        let (own, round_off) = (kind.of_sorted(sample), round_off(sample));
        errors.iter().find_map(|errors| {
            let found = kind.of_sorted(&sorted(sample.iter().zip(errors).map(|(y, error)| y + error)));
            let [least, greatest] = match kind.effect_of_errors() {
                ErrorEffect::Shifts => {
                    let shifted = [-MOST, MOST].map(|shift| kind.of_sorted(&sorted(sample.iter().map(|y| y + shift))));
                    [shifted.into_iter().fold(own, f64::min), shifted.into_iter().fold(own, f64::max)]
                }
                ErrorEffect::RootMeanSquare => {
                    let mean_square = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
                    [own - mean_square.sqrt(), own + mean_square.sqrt()]
                }
                ErrorEffect::Unknown => return None,
            };
            let is_within = found >= least - round_off && found <= greatest + round_off;
            (!is_within).then(|| (sample.clone(), format!("{found} is not within [{least}, {greatest}]: {errors:?}")))
        })
    })
}

/// A sample of which the estimator that is stated for it is another number.
fn against_estimation(kind: &dyn StatisticKind, samples: &[Vec<f64>]) -> Refuted {
    let estimation = kind.estimation();
    first(samples, |sample, round_off| {
        let count = sample.len() as f64;
        let mean = || sample.iter().sum::<f64>() / count;
        let estimated = match estimation {
            Estimation::Mean => mean(),
            // Of all pairs: 2 n² Var = Σ (y_i - y_k)².
            Estimation::RootOfVariance => {
                let pairs = sample.iter().flat_map(|a| sample.iter().map(move |b| (a - b) * (a - b)));
                (0.5 * pairs.sum::<f64>()).sqrt() / count
            }
            Estimation::Counted(event) => sample.iter().filter(|&&value| event.holds(value)).count() as f64 / count,
            Estimation::Ordered(p) => between_order_statistics(sample.len(), p * count, |place| sample[place]),
            Estimation::Sampled => return None,
        };
        let value = kind.of_sorted(sample);
        (!((value - estimated).abs() <= round_off)).then(|| format!("{value} is not {estimated}, {estimation:?}"))
    })
}

/// A magnitude near its limit on both sides is the one exception, which its file names.
fn has_exact_effect(statistic: Statistic) -> bool {
    statistic.word() != "probability_beyond"
}

#[test]
fn analytic_no_sample_is_against_the_order_that_is_stated() {
    let (all, samples) = (single(), samples());
    let mut stated = 0;
    for (a, b) in all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))).filter(|(a, b)| a.never_exceeds(*b)) {
        stated += 1;
        let refuted = a.with_kind(|lesser| b.with_kind(|greater| against_order(lesser, greater, &samples)));
        assert_eq!(refuted, None, "{a:?} {b:?}");
    }
    assert!(stated > 60, "{stated}");
    let value = |statistic: Statistic| statistic.of_sorted(&SAMPLE);
    let (mean, upper) = (Statistic::Mean, Statistic::Quantile(0.85));
    assert!(value(mean) > value(upper) && !mean.never_exceeds(upper));
}

#[test]
fn analytic_no_sample_is_against_what_a_statistic_states_of_itself() {
    let samples = samples();
    for statistic in single() {
        let refuted = |against: fn(&dyn StatisticKind, &[Vec<f64>]) -> Refuted| {
            statistic.with_kind(|kind| against(kind, &samples))
        };
        assert_eq!(refuted(against_range), None, "range: {statistic:?}");
        assert_eq!(refuted(against_estimation), None, "estimation: {statistic:?}");
        if has_exact_effect(statistic) {
            assert_eq!(refuted(against_errors), None, "errors: {statistic:?}");
        }
        let growth = |sign: f64| statistic.with_kind(|kind| against_growth(kind, sign, &samples));
        if statistic.grows_with_variable() {
            assert_eq!(growth(1.0), None, "growth: {statistic:?}");
        }
        if statistic.is_monotone() {
            assert!(growth(1.0).is_none() || growth(-1.0).is_none(), "monotone: {statistic:?}");
        }
        if let Some(mirrored) = statistic.mirrored() {
            let refuted = statistic.with_kind(|own| mirrored.with_kind(|other| against_mirror(own, other, &samples)));
            assert_eq!(refuted, None, "mirror: {statistic:?}");
        }
    }
}

/// A statistic that is no part of the program, and states what others do.
struct Copied {
    of_sorted: fn(&[f64]) -> f64,
    estimation: Estimation,
}

/// The median of the distances from the median.
fn median_absolute_deviation(sample: &[f64]) -> f64 {
    let median = Statistic::quantile_at(0.5).of_sorted(sample);
    Statistic::quantile_at(0.5).of_sorted(&sorted(sample.iter().map(|value| (value - median).abs())))
}

/// From the least to the greatest value.
fn extent(sample: &[f64]) -> f64 {
    sample[sample.len() - 1] - sample[0]
}

/// All that the mean absolute deviation, a mean and a quantile state.
impl StatisticKind for Copied {
    fn of_sorted(&self, sample: &[f64]) -> f64 {
        (self.of_sorted)(sample)
    }

    fn estimation(&self) -> Estimation {
        self.estimation
    }

    fn range_within(&self, values: [f64; 2]) -> [f64; 2] {
        MeanAbsoluteDeviation.range_within(values)
    }

    fn never_exceeds(&self, other: &dyn StatisticKind) -> bool {
        as_kind::<StandardDeviation>(other).is_some()
    }

    fn grows_with_variable(&self) -> bool {
        true
    }

    fn mirrored(&self) -> Mirrored {
        Mirrored::Opposite
    }

    fn effect_of_errors(&self) -> ErrorEffect {
        MeanAbsoluteDeviation.effect_of_errors()
    }
}

#[test]
fn analytic_each_statement_that_a_neighbour_could_lend_is_refuted() {
    let samples = samples();
    let copied = |of_sorted: fn(&[f64]) -> f64, estimation| Copied { of_sorted, estimation };
    let sampled = || copied(median_absolute_deviation, Estimation::Sampled);
    // Three of -1, four of 0 and three of 1: the median of the distances is 1, the variance 0.6.
    let shown = sorted([-1.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!((sampled().of_sorted(&shown), StandardDeviation.of_sorted(&shown)), (1.0, 0.6_f64.sqrt()));
    assert!(sampled().never_exceeds(&StandardDeviation));
    assert!(against_order(&sampled(), &StandardDeviation, &samples).is_some());
    assert!(against_order(&StandardDeviation, &MeanAbsoluteDeviation, &samples).is_some());
    assert!(against_range(&copied(extent, Estimation::Sampled), &samples).is_some());
    assert!(sampled().grows_with_variable() && against_growth(&sampled(), 1.0, &samples).is_some());
    assert!(against_growth(&sampled(), -1.0, &samples).is_some());
    assert!(sampled().mirrored() == Mirrored::Opposite && against_mirror(&sampled(), &sampled(), &samples).is_some());
    assert!(against_errors(&sampled(), &samples).is_some());
    for estimation in [Estimation::Mean, Estimation::RootOfVariance, Estimation::Ordered(0.5)] {
        assert!(against_estimation(&copied(median_absolute_deviation, estimation), &samples).is_some());
    }
    // What is true of it is not refuted: half of all values are no further from the median than half of the way between the ends.
    assert_eq!(against_range(&sampled(), &samples), None);
}

#[test]
fn every_form_of_sample_is_drawn() {
    let samples = samples();
    let has = |is_it: fn(&[f64]) -> bool| samples.iter().filter(|sample| is_it(sample)).count() >= 20;
    for count in 1..=MOST as usize {
        assert!(samples.iter().any(|sample| sample.len() == count), "{count}");
    }
    assert!(has(|sample| sample.len() > 1 && sample[0] == sample[sample.len() - 1]), "constant");
    assert!(has(|sample| sample.len() > 4 && sample.windows(2).all(|pair| pair[0] < pair[1])), "without ties");
    assert!(
        has(|sample| {
            let twice = sample[0] + sample[sample.len() - 1];
            sample.len() > 2 && sample.iter().zip(sample.iter().rev()).all(|(a, b)| a + b == twice)
        }),
        "symmetric"
    );
    assert!(has(|sample| sample.len() > 4 && extent(sample) > 100.0 * extent(&sample[..sample.len() - 1])), "tail");
}
