//! What every statistic states of itself, held against samples: a new one is in the list, and so in these tests.

use super::{ErrorEffect, Form, Mirrored, Number, NumberKind, Statistic, StatisticKind};

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
    let all = single();
    for (a, b) in all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))) {
        if a.never_exceeds(b) {
            stated += 1;
            for sample in [&SAMPLE[..], &SAMPLE[..9], &SAMPLE[2..]] {
                assert!(a.of_sorted(sample) <= b.of_sorted(sample) + ROUND_OFF, "{a:?} {b:?}");
            }
        }
    }
    assert!(stated > 60, "{stated}");
    let value = |statistic: Statistic| statistic.of_sorted(&SAMPLE);
    assert!(value(Mean) > value(Quantile(0.85)) && !Mean.never_exceeds(Quantile(0.85)));
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
        let value = statistic.of_sorted(&SAMPLE);
        let [least, greatest] = statistic.range_within([SAMPLE[0], SAMPLE[9]]);
        assert!(value >= least - ROUND_OFF && value <= greatest + ROUND_OFF, "{statistic:?}: {value}");
    }
}

#[test]
fn identity_what_grows_with_the_variable_does_not_fall_where_values_grow() {
    for statistic in single().into_iter().filter(|statistic| statistic.grows_with_variable()) {
        for moved in 0..SAMPLE.len() {
            let larger = sorted(SAMPLE.iter().enumerate().map(|(k, y)| if k == moved { y + 0.75 } else { *y }));
            assert!(statistic.of_sorted(&larger) >= statistic.of_sorted(&SAMPLE) - ROUND_OFF, "{statistic:?}");
        }
    }
}

#[test]
fn identity_what_is_mirrored_is_that_of_the_negative_variable() {
    let negative = sorted(SAMPLE.iter().map(|y| -y));
    for statistic in single() {
        let Some(mirrored) = statistic.mirrored() else { continue };
        let [own, other] = [statistic.of_sorted(&negative), -mirrored.of_sorted(&SAMPLE)];
        assert!((own - other).abs() <= ROUND_OFF * own.abs() || own == other, "{statistic:?}: {own} {other}");
    }
}

#[test]
fn identity_errors_move_no_statistic_further_than_it_states() {
    let errors = [0.5, -0.25, 0.5, 0.0, -0.5, 0.5, -0.5, 0.25, -0.5, 0.5];
    let moved = sorted(SAMPLE.iter().zip(errors).map(|(y, error)| y + error));
    let root_mean_square = (errors.iter().map(|error| error * error).sum::<f64>() / 10.0).sqrt();
    // A magnitude near its limit on both sides is the one exception, which its file names.
    for statistic in single().into_iter().filter(|statistic| statistic.word() != "probability_beyond") {
        let [own, found] = [&SAMPLE[..], &moved].map(|values| statistic.of_sorted(values));
        let shifted = [-0.5, 0.0, 0.5].map(|shift| statistic.of_sorted(&sorted(SAMPLE.iter().map(|y| y + shift))));
        let [least, greatest] = match statistic.effect_of_errors() {
            ErrorEffect::Shifts => {
                [shifted.iter().copied().fold(own, f64::min), shifted.iter().copied().fold(own, f64::max)]
            }
            ErrorEffect::RootMeanSquare => [own - root_mean_square, own + root_mean_square],
            ErrorEffect::Unknown => continue,
        };
        assert!(found >= least - ROUND_OFF && found <= greatest + ROUND_OFF, "{statistic:?}: {found}");
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
