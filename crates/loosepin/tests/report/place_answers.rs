//! Sentences on statistics of one number: where its mean lies, how wide the band about it is, and how large the errors of all of them are.

use loosepin::study::result::{
    BoundEnd, BoundRecord, Deviation, Guarantee, NumericalError, PathError, PathOutput, Reduction, ResponsePoint,
    Statistic, StudyResult,
};

use super::report_answer::assert_says;
use super::report_fixture::study::worn_pin;

/// Holds for all of these studies: where the fixture's unknown inputs lie.
const CONDITIONS: &str =
    "This holds for every gudgeon radial clearance from 0.1 to 0.5 mm and every steel pin restitution from 0.7 to 0.9.";

/// A bound between two ends, in micrometres, with an error.
fn bound(statistic: Statistic, [lower_um, upper_um]: [f64; 2], error_um: f64) -> BoundRecord {
    let like = worn_pin().bounds[0].clone();
    let end = |widened_um: f64, inward: f64| BoundEnd {
        value_si: 1e-6 * (widened_um + inward * error_um),
        widened_si: 1e-6 * widened_um,
        error: NumericalError { sampling_si: 1e-6 * error_um, ..NumericalError::default() },
        ..like.upper.clone()
    };
    BoundRecord {
        statistic,
        of: Deviation::Total,
        at: ResponsePoint::Pose { pose_rad: 0.0 },
        lower: end(lower_um, 1.0),
        upper: end(upper_um, -1.0),
        ..like
    }
}

/// A study that asks for nothing but these.
fn asked(bounds: &[BoundRecord]) -> StudyResult {
    let mut result = worn_pin();
    result.requirements.clear();
    result.curves.clear();
    result.bounds = bounds.to_vec();
    result
}

/// The press of issue 75 at its bottom dead centre: the mean is 0.0405 to 0.1209 mm low, and 95 % of the mechanisms go from 0.0123 to 0.1501 mm.
fn press() -> [BoundRecord; 4] {
    [
        bound(Statistic::Mean, [-120.9, -40.5], 0.002),
        bound(Statistic::StandardDeviation, [14.1567, 14.16], 0.003),
        bound(Statistic::Quantile(0.975), [-93.8, -12.3], 0.6),
        bound(Statistic::Quantile(0.025), [-150.1, -67.2], 2.0),
    ]
}

#[test]
fn analytic_a_question_at_a_pose_says_where_the_mean_lies_and_how_wide_the_band_about_it_is() {
    // 150.1 - 120.9 = 29.2 below, 40.5 - 12.3 = 28.2 above.
    assert_says(
        &asked(&press()),
        &format!(
            "At 0°, the slider (x of slider.pin) is on average 0.040 mm to 0.121 mm below its ideal value, and 95 % of mechanisms lie within \
             ±0.030 mm of this range. {CONDITIONS}"
        ),
    );
    let [mean, deviation, high, low] = press();
    let without_quantiles = asked(&[mean.clone(), deviation]);
    assert_says(
        &without_quantiles,
        "is on average 0.040 mm to 0.121 mm below its ideal value, with a standard deviation of at most 0.014160 mm. This",
    );
    assert_says(&asked(std::slice::from_ref(&mean)), "is on average 0.040 mm to 0.121 mm below its ideal value. This");
    assert_says(
        &asked(&[mean, high.clone()]),
        "below its ideal value, and the deviation is at most -0.0123 mm in 97.5 % of mechanisms. This",
    );
    assert_says(
        &asked(&[high.clone(), low]),
        "At 0°, the slider (x of slider.pin) lies 0.012 mm to 0.151 mm below its ideal value in at least 95 % of mechanisms. This",
    );
    assert_says(
        &asked(&[high]),
        "At 0°, the deviation of slider is at most -0.0123 mm in at least 97.5 % of mechanisms. This",
    );
}

#[test]
fn analytic_a_mean_on_both_sides_and_a_band_that_is_not_even() {
    let mean = bound(Statistic::Mean, [-20.0, 50.0], 0.1);
    let low = bound(Statistic::Quantile(0.025), [-30.0, 10.0], 0.1);
    let high = bound(Statistic::Quantile(0.975), [20.0, 150.0], 0.1);
    // 10 below and 100 above: one number for both would be ten times too wide on one side.
    assert_says(
        &asked(&[mean.clone(), low, high.clone()]),
        "is on average between 0.020 mm below and 0.050 mm above its ideal value, and 95 % of mechanisms lie between 0.030 mm below and \
         0.150 mm above its ideal value. This",
    );
    // A mean of a few large values lies beyond the quantile.
    let beyond = bound(Statistic::Quantile(0.025), [-10.0, 10.0], 0.1);
    assert_says(
        &asked(&[mean, beyond, high]),
        "and 95 % of mechanisms lie between 0.010 mm below and 0.150 mm above its",
    );
    let above = bound(Statistic::Mean, [20.0, 20.0], 0.0);
    assert_says(&asked(&[above]), "is on average 0.0200 mm above its ideal value. This");
}

#[test]
fn analytic_values_paths_and_numbers_of_the_cycle_have_no_side() {
    let [mean, _, high, low] = press();
    let of_value = |mut bound: BoundRecord| {
        bound.of = Deviation::Value;
        bound
    };
    assert_says(
        &asked(&[of_value(mean.clone()), of_value(high.clone())]),
        "At 0°, the slider (x of slider.pin) is on average between -0.121 mm and -0.040 mm, and at most -0.0123 mm in 97.5 % of mechanisms. This",
    );
    let reduced = |mut bound: BoundRecord| {
        bound.at = ResponsePoint::Reduced { reduction: Reduction::Minimum };
        bound
    };
    assert_says(
        &asked(&[reduced(mean.clone()), reduced(low.clone()), reduced(high.clone())]),
        "The deviation of slider (smallest value in the cycle) is on average between -0.121 mm and -0.040 mm, and 95 % of mechanisms lie within \
         ±0.030 mm of this range. This",
    );
    let mut path = asked(&[mean, low, high]);
    path.outputs[0].path = Some(PathOutput { point: "tool (coupler.tool)".to_owned(), part: PathError::Normal });
    assert_says(&path, "At 0°, the error of tool (coupler.tool) across its path is on average between -0.121 mm and");
}

#[test]
fn statistics_beside_mean_and_quantiles_follow_and_a_missing_end_is_told_with_its_reason() {
    let [mean, deviation, high, low] = press();
    let mut above = bound(Statistic::ProbabilityAbove(-5e-5), [0.0, 0.0], 0.0);
    (above.lower.widened_si, above.upper.widened_si) = (0.0, 0.25);
    assert_says(
        &asked(&[mean.clone(), high.clone(), low.clone(), above.clone()]),
        "of this range. The probability above -0.05 mm lies between 0 % and 25 %. This",
    );
    assert_says(
        &asked(&[deviation.clone(), above]),
        "For slider (x of slider.pin) (deviation, at 0°), the standard deviation lies between",
    );
    let mut endless = high;
    endless.upper.widened_si = f64::INFINITY;
    assert_says(
        &asked(&[mean.clone(), endless]),
        "For slider (x of slider.pin) (deviation, at 0°), the mean lies between -0.1209 mm and -0.0405 mm and the 97.5 % quantile is at least",
    );
    let mut finished = mean;
    finished.guarantee = Guarantee::FinishedRuns;
    assert_says(&asked(&[finished, low]), "the mean has no bound");
}

#[test]
fn analytic_the_numerical_error_is_that_of_all_numbers_that_it_stands_under() {
    let all = press();
    assert_says(&asked(&all), "- Numerical error of these numbers: at most 0.002 mm, included in them. -");
    assert_says(&asked(&all[..1]), "- Numerical error of the bound: at most 2e-6 mm, included in it. -");
    let mut share = bound(Statistic::ProbabilityAbove(-5e-5), [0.0, 0.0], 0.0);
    (share.upper.widened_si, share.upper.error.sampling_si) = (0.25, 0.02);
    assert_says(
        &asked(&[all[0].clone(), share]),
        "- Numerical error of these numbers: at most 2e-6 mm (probabilities 2 %), included in them. -",
    );
    // Twelve times the error of the first one, and more than a tenth of the largest number.
    let large = bound(Statistic::Quantile(0.025), [-150.1, -67.2], 24.0);
    assert_says(&asked(&[all[0].clone(), large]), "at most 0.03 mm, included in them. This is large:");
    let mut several = asked(&all);
    let mut other = all[0].clone();
    other.output = "lift".to_owned();
    several.bounds.push(other);
    assert_says(
        &several,
        "- Numerical error of the first answer: at most 0.002 mm, included in it. The table of bounds",
    );
}

#[test]
fn impacts_beyond_the_law_say_when_the_answer_may_be_used() {
    let mut result = worn_pin();
    assert_says(
        &result,
        "- 98.1 % of the impacts in gudgeon are faster than the contact law is valid for; real parts rebound less. Use the answer \
         only if a study with a lower restitution gives nearly the same. -",
    );
    result.impacts[0].nominal_restitution = None;
    assert_says(&result, "valid for. Use the answer only if a study with another contact law gives nearly the same.");
}
