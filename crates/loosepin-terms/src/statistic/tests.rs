//! Names of statistics, and the order and the range of those that are known: a new one is in the list, and so in these tests. `claims.rs` holds
//! what each states of itself against samples.

use super::claims::{SAMPLE, all, single};
use super::{ErrorEffect, Form, Mirrored, Number, NumberKind, Statistic, StatisticKind};

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
fn identity_shares_of_two_values_stay_in_the_range_that_is_stated() {
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
