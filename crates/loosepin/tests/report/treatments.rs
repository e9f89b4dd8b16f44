//! The three treatments in words and in their table, held against each other, the bounds and what is proven without dynamics.

use std::collections::BTreeMap;

use loosepin::report::study_text;
use loosepin::study::result::{
    CoveragePoint, Deviation, NumericalError, ResponsePoint, Statistic, StudyResult, Treatment, TreatmentBand,
    TreatmentComparison, TreatmentEnd,
};
use loosepin::units::SiUnit;

use super::report_answer::{assert_says, one_line};
use super::report_fixture::study::worn_pin;

/// Y = X + u, X standard normal, u in [-1, 1], central 95 % band (method: exact case), in millimetres.
fn sum_of_normal_and_interval() -> StudyResult {
    const MM: f64 = 1e-3;
    let band = |treatment, half_width: f64, coverage_minimum, coverage_maximum| TreatmentBand {
        treatment,
        lower_si: -half_width * MM,
        upper_si: half_width * MM,
        coverage_minimum,
        coverage_maximum,
        coverage_error: 0.0,
        coverage_at: vec![CoveragePoint { at: BTreeMap::new(), coverage: coverage_minimum }],
        ends: None,
        is_by_surrogate: false,
    };
    let mut result = worn_pin();
    result.treatments = vec![TreatmentComparison {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at: ResponsePoint::Whole,
        unit: SiUnit::LENGTH,
        promised_coverage: 0.95,
        bands: vec![
            band(Treatment::ProbabilityOnly, 2.2541, 0.895, 0.976),
            band(Treatment::IntervalOnly, 4.0, 0.998_65, 0.999_94),
            band(Treatment::Mixed, 2.9600, 0.974_96, 0.9969),
        ],
        proven_without_dynamics_si: None,
    }];
    result
}

#[test]
fn analytic_treatments_of_a_normal_plus_an_interval() {
    let result = sum_of_normal_and_interval();
    assert_says(
        &result,
        "Probability only takes every unknown value as random. At the worst unknown values, only 89.5 % of mechanisms lie inside the \
         band, not 95 %. The band is 24 % narrower than the mixed band.",
    );
    assert_says(
        &result,
        "At all unknown values tested, at least 99.86 % of mechanisms lie inside the band. The band is 35 % wider than the mixed band.",
    );
    assert_says(
        &result,
        "from the least 2.5 % to the largest 97.5 % quantile. At all unknown values tested, at least 97.4 % of mechanisms lie inside the band.",
    );
    // Where the ends are less well known than the bands differ, that is said of what was found only.
    let mut changed = result.clone();
    let mut ends = |error_mm: f64| {
        let error = NumericalError { sampling_si: 0.0, optimisation_si: 1e-3 * error_mm, surrogate_si: 0.0 };
        let end = |side: f64| TreatmentEnd { widened_si: 1e-3 * side * (4.0 + error_mm), error };
        changed.treatments[0].bands[1].ends = Some([-1.0, 1.0].map(end));
        changed.clone()
    };
    let unsure = ends(5.0);
    assert_says(
        &unsure,
        "The band found is 35 % wider than the mixed band, but the error of its ends, 5 mm, is larger than this difference.",
    );
    // An error of more than the band says no more than that.
    let lost = ends(9.0);
    assert_says(&lost, "Interval only -4.00 mm to 4.00 mm > band 99.86 % to 99.994 % yes");
    assert_says(
        &lost,
        "The band found is 35 % wider than the mixed band. How far worse cases go, its search does not show.",
    );
    assert_says(&result, "treatment band share inside holds 95 %?");
    assert_says(&result, "Probability only -2.26 mm to 2.26 mm 89.5 % to 97.6 % no, 89.5 %");
    assert_says(&result, "Mixed -2.96 mm to 2.96 mm 97.4 % to 99.69 % yes");
}

/// The interval-only band beside the worst case that `motion` proves, and the mixed one beside the bound that the answer begins with.
#[test]
fn analytic_bands_are_held_against_the_proven_worst_case_and_the_bounds() {
    let mut result = sum_of_normal_and_interval();
    result.impacts[0].largest_penetration_share = 0.1429;
    let proven = "Worst case without dynamics, proven:";
    assert!(!study_text(&result).contains(proven));
    for (ends_mm, words) in [
        ([0.0, 4.000_4], "at most 4.001 mm"),
        ([-4.000_4, 4.000_4], "within ±4.001 mm"),
        ([-3.9, 4.000_4], "between -3.900 mm and 4.001 mm"),
    ] {
        result.treatments[0].proven_without_dynamics_si = Some(ends_mm.map(|end| 1e-3 * end));
        assert_says(
            &result,
            &format!(
                "{proven} {words}, with parts within their limits or ±3 standard deviations, and any position within the play. In the runs, \
                 parts also penetrate each other, by up to 14.3 % of the clearance: this adds to it."
            ),
        );
    }
    result.impacts.clear();
    assert!(!one_line(&study_text(&result)).contains("penetrate each other"));
    // E(X + u) has the 97.5 % quantile u + 1.95996, at most 2.9600; with an error of 0.004 the bound is 2.964.
    let mut bound = result.bounds[0].clone();
    (bound.output, bound.of, bound.at) = ("slider".to_owned(), Deviation::Total, ResponsePoint::Whole);
    bound.statistic = Statistic::Quantile(0.975);
    (bound.upper.value_si, bound.upper.widened_si) = (2.96e-3, 2.964e-3);
    bound.upper.error = NumericalError { sampling_si: 4e-6, ..NumericalError::default() };
    assert!(!one_line(&study_text(&result)).contains("as in the bounds"));
    result.bounds.push(bound);
    assert_says(
        &result,
        "to the largest 97.5 % quantile. With its error, the upper end is 2.97 mm, as in the bounds. At all",
    );
}

#[test]
fn a_share_within_its_numerical_error_is_not_called_too_small() {
    let mut result = sum_of_normal_and_interval();
    let band = &mut result.treatments[0].bands[2];
    band.coverage_minimum = 0.948;
    band.coverage_error = 0.003;
    assert_says(&result, "Mixed -2.96 mm to 2.96 mm 94.8 % to 99.69 % yes");
    assert_says(
        &result,
        "At the worst unknown values, 94.8 % ± 0.3 % of mechanisms lie inside the band. This agrees with 95 %.",
    );
}

#[test]
fn a_share_that_is_too_small_by_a_surrogate_is_told_with_its_error_as_in_the_table() {
    let mut result = sum_of_normal_and_interval();
    let end = |widened_si| TreatmentEnd {
        widened_si,
        error: NumericalError { surrogate_si: 1e-4, ..NumericalError::default() },
    };
    let band = &mut result.treatments[0].bands[2];
    (band.coverage_minimum, band.coverage_maximum, band.coverage_error) = (0.0625, 1.0, 0.25);
    band.ends = Some([end(-3.06e-3), end(3.06e-3)]);
    band.is_by_surrogate = true;
    assert_says(&result, "Mixed -2.96 mm to 2.96 mm 0.1 mm 0 % to 100 % no, 0 %");
    assert_says(&result, "At the worst unknown values, only 0 % to 6.3 % of mechanisms lie inside the band, not 95 %.");
}
