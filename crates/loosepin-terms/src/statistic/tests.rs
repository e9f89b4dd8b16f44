//! What every statistic states of itself, held against samples: a new one is in the list, and so in these tests.

use super::standard_deviation::StandardDeviation;
use super::{ErrorEffect, Form, Mirrored, Number, NumberKind, Statistic, StatisticKind};
use crate::drawn::drawn;

/// All values have the same weight. Most are small and one is large: the mean lies beyond the upper quantile.
const SAMPLE: [f64; 10] = [-1.5, -0.25, 0.125, 0.5, 0.75, 0.875, 1.25, 1.5, 1.75, 400.0];

const ROUND_OFF: f64 = 1e-12;

const JSON: [(Statistic, &str); 9] = [
    (Statistic::Mean, r#"{"kind":"mean"}"#),
    (Statistic::StandardDeviation, r#"{"kind":"standard_deviation"}"#),
    (Statistic::MeanAbsoluteDeviation, r#"{"kind":"mean_absolute_deviation"}"#),
    (Statistic::Cdf, r#"{"kind":"cdf"}"#),
    (Statistic::Quantile(0.975), r#"{"kind":"quantile","probability":0.975}"#),
    (Statistic::SimultaneousBand(0.9), r#"{"kind":"simultaneous_band","share":0.9}"#),
    (Statistic::ProbabilityAbove(-0.25), r#"{"kind":"probability_above","limit_si":-0.25}"#),
    (Statistic::ProbabilityBelow(0.5), r#"{"kind":"probability_below","limit_si":0.5}"#),
    (Statistic::ProbabilityBeyond(0.125), r#"{"kind":"probability_beyond","limit_si":0.125}"#),
];

/// Every statistic, those with a number with several that are allowed.
fn all() -> Vec<Statistic> {
    let numbers = [-2.0, -0.5, 0.05, 0.25, 0.5, 0.85, 1.0, 1.625, 500.0];
    let with_number = numbers.into_iter().flat_map(Statistic::with_parameter);
    Statistic::PLAIN.into_iter().chain(with_number).filter(|statistic| statistic.has_allowed_number()).collect()
}

/// Those that are one number.
fn single() -> Vec<Statistic> {
    all().into_iter().filter(|statistic| statistic.is_single()).collect()
}

fn sorted(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_unstable_by(f64::total_cmp);
    values
}

/// Drawn samples of one to ten values. Those of every second one are -1, 0 and 1, so that many are equal: that is where statistics
/// come closest to each other.
fn drawn_samples() -> Vec<Vec<f64>> {
    let mut draw = drawn(1);
    let of_number = |number: usize| {
        let count = 1 + draw(10);
        sorted((0..count).map(|_| match number % 2 {
            0 => draw(3) as f64 - 1.0,
            _ => (draw(65) as f64 - 32.0) / 16.0,
        }))
    };
    (0..600).map(of_number).collect()
}

fn every_sample() -> Vec<Vec<f64>> {
    let by_hand = [&SAMPLE[..], &SAMPLE[..9], &SAMPLE[2..]].map(<[f64]>::to_vec);
    by_hand.into_iter().chain(drawn_samples()).collect()
}

/// The first sample of which `lesser` is larger than `greater`.
fn counterexample<'s>(
    lesser: &dyn StatisticKind,
    greater: &dyn StatisticKind,
    samples: &'s [Vec<f64>],
) -> Option<&'s Vec<f64>> {
    samples.iter().find(|sample| lesser.of_sorted(sample) > greater.of_sorted(sample) + ROUND_OFF)
}

#[test]
fn identity_results_keep_their_names() {
    for (statistic, text) in JSON {
        assert_eq!(serde_json::to_string(&statistic).unwrap(), text);
        assert_eq!(serde_json::from_str::<Statistic>(text).unwrap(), statistic);
    }
}

#[test]
fn identity_every_statistic_is_read_back_from_its_text_and_from_its_word() {
    for statistic in all() {
        let text = serde_json::to_string(&statistic).unwrap();
        assert_eq!(serde_json::from_str::<Statistic>(&text).unwrap(), statistic, "{text}");
        assert_eq!(Statistic::from_word(statistic.word(), statistic.parameter()), Some(statistic));
    }
}

#[test]
fn a_parameter_of_another_statistic_is_refused() {
    let read = |text: &str| serde_json::from_str::<Statistic>(text).map_err(|error| error.to_string());
    assert!(read(r#"{"kind":"mean","share":0.9}"#).is_err());
    assert!(read(r#"{"kind":"quantile"}"#).is_err());
    assert!(read(r#"{"kind":"quantile","share":0.9}"#).is_err());
    assert!(read(r#"{"kind":"median"}"#).unwrap_err().contains("'median'"));
    assert!(read(r#"{"share":0.9}"#).unwrap_err().contains("missing field `kind`"));
    assert_eq!(Statistic::from_word("mean", Some(0.5)), None);
}

#[test]
fn every_statistic_has_words_of_its_own() {
    let every = || Statistic::PLAIN.into_iter().chain(Statistic::with_parameter(0.5)).map(Statistic::description);
    for own in every() {
        assert_eq!(every().filter(|other| other.word == own.word).count(), 1, "{}", own.word);
        assert_eq!(every().filter(|other| other.words == own.words).count(), 1, "{}", own.words);
        assert_eq!(own.words.matches("{}").count(), usize::from(own.number.is_some()), "{}", own.words);
        for (other, form) in own.synonyms {
            assert!(every().all(|known| known.word != *other) && form.contains(own.word), "{other}: {form}");
        }
        // The example can be read.
        let is_text = own.number.is_some_and(|Number { example, .. }| example.starts_with('"'));
        let is_limit = own.number.is_some_and(|number| number.kind != NumberKind::Share);
        assert_eq!(is_text, is_limit, "{}", own.word);
    }
}

#[test]
fn analytic_statistics_of_a_sample_are_in_the_order_that_is_stated() {
    use Statistic::{Mean, Quantile};
    let mut stated = 0;
    let (all, samples) = (single(), every_sample());
    for (a, b) in all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))) {
        if a.never_exceeds(b) {
            stated += 1;
            let found = a.with_kind(|lesser| b.with_kind(|greater| counterexample(lesser, greater, &samples)));
            assert_eq!(found, None, "{a:?} {b:?}");
        }
    }
    assert!(stated > 60, "{stated}");
    let value = |statistic: Statistic| statistic.of_sorted(&SAMPLE);
    assert!(value(Mean) > value(Quantile(0.85)) && !Mean.never_exceeds(Quantile(0.85)));
}

/// The median of the distances from the median: no part of the program. Copied from the mean absolute deviation, it would state that it
/// never exceeds the standard deviation.
struct MedianAbsoluteDeviation;

impl StatisticKind for MedianAbsoluteDeviation {
    fn of_sorted(&self, sample: &[f64]) -> f64 {
        let median = Statistic::quantile_at(0.5).of_sorted(sample);
        Statistic::quantile_at(0.5).of_sorted(&sorted(sample.iter().map(|value| (value - median).abs())))
    }
}

#[test]
fn a_false_order_is_found_among_the_drawn_samples() {
    let samples = drawn_samples();
    assert!(counterexample(&MedianAbsoluteDeviation, &StandardDeviation, &samples).is_some());
    // Of the samples that were written by hand none shows it.
    let by_hand = [&SAMPLE[..], &SAMPLE[..9], &SAMPLE[2..]].map(<[f64]>::to_vec);
    assert_eq!(counterexample(&MedianAbsoluteDeviation, &StandardDeviation, &by_hand), None);
}

#[test]
fn identity_the_order_of_quantiles_and_probabilities_is_that_of_their_numbers() {
    use Statistic::{ProbabilityAbove, ProbabilityBelow, ProbabilityBeyond, Quantile};
    for (a, b) in [(0.25, 0.75), (0.75, 0.25), (0.5, 0.5), (-0.25, 0.25), (-0.75, 0.5)] {
        assert_eq!(Quantile(a).never_exceeds(Quantile(b)), a <= b);
        assert_eq!(ProbabilityAbove(a).never_exceeds(ProbabilityAbove(b)), a >= b);
        assert_eq!(ProbabilityBelow(a).never_exceeds(ProbabilityBelow(b)), a <= b);
        assert_eq!(ProbabilityBeyond(a).never_exceeds(ProbabilityBeyond(b)), a >= b);
        assert_eq!(ProbabilityAbove(a).never_exceeds(ProbabilityBeyond(b)), a >= b);
        assert_eq!(ProbabilityBelow(a).never_exceeds(ProbabilityBeyond(b)), -a >= b);
        assert!(!ProbabilityBeyond(a).never_exceeds(ProbabilityAbove(b)));
    }
}

#[test]
fn identity_a_sample_stays_in_the_range_that_is_stated_and_two_values_reach_it() {
    let two = [-0.75, 1.5];
    for statistic in single() {
        let [least, greatest] = statistic.range_within(two);
        assert!(statistic.range()[0] <= least && greatest <= statistic.range()[1], "{statistic:?}");
        for upper in 0..=8 {
            // So many of eight values at the upper end.
            let sample: Vec<f64> = (0..8).map(|k| two[usize::from(k >= 8 - upper)]).collect();
            let value = statistic.of_sorted(&sample);
            assert!(value >= least - ROUND_OFF && value <= greatest + ROUND_OFF, "{statistic:?}: {value}");
        }
        for sample in every_sample() {
            let value = statistic.of_sorted(&sample);
            let [least, greatest] = statistic.range_within([sample[0], sample[sample.len() - 1]]);
            assert!(value >= least - ROUND_OFF && value <= greatest + ROUND_OFF, "{statistic:?}: {value} {sample:?}");
        }
    }
}

#[test]
fn identity_what_grows_with_the_variable_does_not_fall_where_values_grow() {
    let samples = every_sample();
    for statistic in single().into_iter().filter(|statistic| statistic.grows_with_variable()) {
        for sample in &samples {
            for moved in 0..sample.len() {
                let larger = sorted(sample.iter().enumerate().map(|(k, y)| if k == moved { y + 0.75 } else { *y }));
                let [before, behind] = [sample, &larger].map(|values| statistic.of_sorted(values));
                assert!(behind >= before - ROUND_OFF, "{statistic:?} {sample:?}");
            }
        }
    }
}

#[test]
fn identity_what_is_mirrored_is_that_of_the_negative_variable() {
    let samples = every_sample();
    for statistic in single() {
        let Some(mirrored) = statistic.mirrored() else { continue };
        for sample in &samples {
            let negative = sorted(sample.iter().map(|y| -y));
            let [own, other] = [statistic.of_sorted(&negative), -mirrored.of_sorted(sample)];
            let is_equal = (own - other).abs() <= ROUND_OFF * own.abs().max(1.0) || own == other;
            assert!(is_equal, "{statistic:?}: {own} {other} {sample:?}");
        }
    }
}

#[test]
fn identity_errors_move_no_statistic_further_than_it_states() {
    const ERRORS: [f64; 10] = [0.5, -0.25, 0.5, 0.0, -0.5, 0.5, -0.5, 0.25, -0.5, 0.5];
    // A magnitude near its limit on both sides is the one exception, which its file names.
    let statistics = || single().into_iter().filter(|statistic| statistic.word() != "probability_beyond");
    for sample in every_sample() {
        let errors = || ERRORS.iter().take(sample.len());
        let moved = sorted(sample.iter().zip(errors()).map(|(y, error)| y + error));
        let mean_square = errors().map(|error| error * error).sum::<f64>() / sample.len() as f64;
        for statistic in statistics() {
            let [own, found] = [&sample, &moved].map(|values| statistic.of_sorted(values));
            let shifted = [-0.5, 0.0, 0.5].map(|shift| statistic.of_sorted(&sorted(sample.iter().map(|y| y + shift))));
            let [least, greatest] = match statistic.effect_of_errors() {
                ErrorEffect::Shifts => {
                    [shifted.iter().copied().fold(own, f64::min), shifted.iter().copied().fold(own, f64::max)]
                }
                ErrorEffect::RootMeanSquare => [own - mean_square.sqrt(), own + mean_square.sqrt()],
                ErrorEffect::Unknown => continue,
            };
            let is_within = found >= least - ROUND_OFF && found <= greatest + ROUND_OFF;
            assert!(is_within, "{statistic:?}: {found} {sample:?}");
        }
    }
}

#[test]
fn what_states_nothing_gets_the_careful_answers() {
    struct Silent;
    impl StatisticKind for Silent {
        fn of_sorted(&self, sorted: &[f64]) -> f64 {
            sorted.len() as f64
        }
    }
    assert_eq!(Silent.range_within([0.25, 0.5]), [f64::NEG_INFINITY, f64::INFINITY]);
    assert!(!Silent.grows_with_variable() && !Silent.never_exceeds(&Silent) && !Silent.never_falls_short_of(&Silent));
    assert_eq!((Silent.mirrored(), Silent.effect_of_errors()), (Mirrored::Unrelated, ErrorEffect::Unknown));
}

#[test]
fn what_is_more_than_a_number_has_no_estimate() {
    for statistic in all().into_iter().filter(|statistic| !statistic.is_single()) {
        assert!(statistic.estimation().is_none() && statistic.of_sorted(&SAMPLE).is_nan(), "{statistic:?}");
        assert_eq!(statistic.is_of_curve(), statistic.description().form == Form::Curve);
    }
}
