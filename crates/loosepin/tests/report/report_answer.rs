//! The sentences that a reader takes away: what they claim, that they never claim more than the bounds hold, and that
//! they say so when something is missing.

use std::collections::BTreeMap;

use loosepin::report::{motion_page, motion_text, simulation_text, study_page, study_text};
use loosepin::simulate::record::StopReason;
use loosepin::study::result::{
    AllocationStop, CountedMechanisms, CoveragePoint, CutBounds, Deviation, Guarantee, InputDescription, InputKind,
    NumericalError, PercentileBounds, Purpose, PurposeRuns, Reduction, ResponsePoint, Statistic, StudyResult,
    Treatment, TreatmentBand, TreatmentComparison, TreatmentEnd, Verdict,
};
use loosepin::units::SiUnit;

use super::report_fixture::{self, study::worn_pin};

/// The text on one line, so that a sentence can be looked for wherever it was wrapped.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn assert_says(result: &StudyResult, sentence: &str) {
    let text = one_line(&study_text(result));
    assert!(text.contains(sentence), "'{sentence}' is not in: {text}");
}

fn quantile_bound_m(value: f64, error: f64) -> StudyResult {
    let mut result = worn_pin();
    result.bounds.truncate(1);
    let bound = &mut result.bounds[0];
    assert_eq!(bound.at, ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute });
    bound.upper.value_si = value - error;
    bound.upper.widened_si = value;
    bound.upper.error.sampling_si = error;
    bound.upper.error.optimisation_si = 0.0;
    result
}

#[test]
fn analytic_headline_rounds_the_bound_outwards() {
    let headline = "With the gudgeon radial clearance anywhere between 0.1 and 0.5 mm and the steel pin restitution \
                    anywhere between 0.7 and 0.9, the slider (x of slider.pin) stays within";
    assert_says(&quantile_bound_m(5.3421e-4, 4e-6), &format!("{headline} ±0.535 mm of its ideal motion"));
    assert_says(&quantile_bound_m(5.3421e-4, 4e-5), &format!("{headline} ±0.54 mm of its ideal motion"));
    assert_says(&quantile_bound_m(5.34e-4, 4e-6), &format!("{headline} ±0.534 mm of its ideal motion"));
    assert_says(&quantile_bound_m(5.3421e-4, 4e-6), "in at least 97.5 % of mechanisms.");
    assert_says(&quantile_bound_m(5.3421e-4, 4e-6), "Numerical error of this answer: at most 0.004 mm");
}

#[test]
fn a_bound_that_does_not_exist_makes_no_headline() {
    // Failed runs leave no bound of a quantile above their share: the curve answers instead.
    let mut result = worn_pin();
    result.bounds[0].upper.widened_si = f64::INFINITY;
    assert_says(&result, "of its ideal motion in at least 95 % of mechanisms, at each angle of crank taken by itself.");
    let page = study_page(&result);
    assert!(page.contains("∞"), "the table shows that there is no upper bound");
}

#[test]
fn without_quantile_and_curve_a_statistic_answers() {
    let mut result = worn_pin();
    result.curves.clear();
    result.bounds.retain(|bound| bound.statistic == Statistic::Mean);
    result.bounds.truncate(1);
    assert_says(
        &result,
        "the mean of slider (x of slider.pin) (deviation, largest in the cycle, in either direction) lies between",
    );
    result.bounds.clear();
    assert_says(&result, "no more was asked for than whether the requirements are met.");
    result.requirements.clear();
    assert_says(&result, "nothing was asked for.");
}

#[test]
fn without_intervals_only_scatter_is_named() {
    let mut result = worn_pin();
    result.inputs.retain(|input| input.kind == InputKind::Random);
    assert_says(&result, "With the stated scatter, the slider");
}

#[test]
fn a_choice_of_laws_is_listed() {
    let mut result = worn_pin();
    result.inputs = vec![InputDescription {
        path: "contact.steel_pin.law".to_owned(),
        kind: InputKind::Choice { of: ["lankarani-nikravesh", "flores", "johnson"].map(str::to_owned).to_vec() },
        unit: SiUnit::NONE,
        words: "any of lankarani-nikravesh, flores, johnson".to_owned(),
    }];
    assert_says(&result, "With the steel pin law any of lankarani-nikravesh, flores and johnson, the slider");
}

#[test]
fn inputs_that_would_read_the_same_keep_their_paths() {
    let mut result = worn_pin();
    result.inputs[2].path = "joint.pin.play".to_owned();
    result.inputs[3].path = "body.pin.play".to_owned();
    assert_says(&result, "With the joint.pin.play anywhere between 0.1 and 0.5 mm and the body.pin.play anywhere");
}

#[test]
fn verdicts_stand_first_and_with_their_numbers() {
    let mut result = worn_pin();
    result.requirements.truncate(1);
    assert_says(
        &result,
        "The requirement that the deviation of slider stays within ±0.7 mm over the whole cycle in at least 99.73 % of \
         mechanisms is met: the true share is 99.96 % to 100 %.",
    );
    result.requirements[0].verdict = Verdict::Undecided;
    result.requirements[0].probability = [0.99712, 0.99741];
    assert_says(
        &result,
        "is undecided, because the numerical error reaches over it (larger 'inner' and 'outer' make it smaller): the true share is 99.71 % to 99.75 %.",
    );
    assert!(study_page(&result).contains("Requirement undecided"));
    // None of 256 lies outside: a share of 6 in 256 may still do so.
    result.requirements[0].probability = [1.0 - 6.0 / 256.0, 1.0];
    result.requirements[0].counted =
        Some(CountedMechanisms { mechanisms: 256, outside: 0, sampling_error: 6.0 / 256.0 });
    assert_says(
        &result,
        "(of 256 mechanisms none lies outside, and so few show no larger share: 'inner' should be 4096 or more): the true share is 97.6 % to 100 %.",
    );
    result.requirements[0].lower_si = f64::NEG_INFINITY;
    result.requirements[0].of = Deviation::Value;
    assert_says(&result, "The requirement that the value of slider stays below 0.7 mm over the whole cycle");
}

#[test]
fn unconfirmed_bounds_and_failed_runs_are_owned_up_to() {
    let mut result = worn_pin();
    result.bounds.truncate(3);
    result.bounds[1].guarantee = Guarantee::Inner;
    assert_says(
        &result,
        "1 of 3 bounds is not confirmed, by the search or for want of samples beyond them (larger 'inner'), and may be wider.",
    );
    let mut answer = result.clone();
    answer.bounds[0].guarantee = Guarantee::Inner;
    assert_says(&answer, "added on the outside. It and 1 of the 2 other bounds are not confirmed, by the search");
    answer.bounds[1].guarantee = answer.bounds[2].guarantee;
    assert_says(&answer, "added on the outside. It is not confirmed, by the search");
    assert_says(
        &result,
        "3 of them failed: they are counted as not known in probabilities and quantiles; means and deviations are those of \
         the finished runs and have no bound.",
    );
    result.counts.failed = 0;
    assert_says(&result, "From 17536 runs; none failed.");
}

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
    }];
    result
}

#[test]
fn analytic_treatments_of_a_normal_plus_an_interval() {
    let result = sum_of_normal_and_interval();
    assert_says(
        &result,
        "Its band breaks the promise of 95 %: where the truth is unkind, only 89.5 % lie inside, for it is only 0.76 times \
         as wide as the band that does.",
    );
    assert_says(
        &result,
        "Its band keeps the promise: at least 99.86 % of mechanisms lie inside, whatever is true, at 1.35 times the width \
         that is needed.",
    );
    assert_says(&result, "Its band keeps the promise: at least 97.4 % of mechanisms lie inside, whatever is true.");
    assert_says(&result, "Everything as probability -2.26 mm to 2.26 mm 4.51 mm 89.5 % to 97.6 % broken");
    assert_says(&result, "Each as what it is -2.96 mm to 2.96 mm 5.92 mm 97.4 % to 99.69 % kept");
}

#[test]
fn a_promise_within_its_numerical_error_is_not_called_broken() {
    let mut result = sum_of_normal_and_interval();
    let band = &mut result.treatments[0].bands[2];
    band.coverage_minimum = 0.948;
    band.coverage_error = 0.003;
    assert_says(&result, "Each as what it is -2.96 mm to 2.96 mm 5.92 mm 94.8 % to 99.69 % kept");
    assert_says(
        &result,
        "Its band keeps the promise of 95 % within numerical error: where the truth is unkind, 94.8 % ± 0.3 % lie inside.",
    );
}

#[test]
fn a_promise_broken_by_a_surrogate_is_told_with_its_error_as_in_the_table() {
    let mut result = sum_of_normal_and_interval();
    let end = |widened_si| TreatmentEnd {
        widened_si,
        error: NumericalError { surrogate_si: 1e-4, ..NumericalError::default() },
    };
    let band = &mut result.treatments[0].bands[2];
    (band.coverage_minimum, band.coverage_maximum, band.coverage_error) = (0.0625, 1.0, 0.25);
    band.ends = Some([end(-3.06e-3), end(3.06e-3)]);
    // The column of the surrogate's error wraps the one before it.
    assert_says(&result, "Each as what it is -2.96 mm to 0.1 mm 5.92 mm 0 % to 100 % broken 2.96 mm");
    assert_says(
        &result,
        "Its band breaks the promise of 95 %: where the truth is unkind, only 0 % to 6.3 % lie inside.",
    );
}

#[test]
fn a_failed_run_says_why() {
    let mut record = report_fixture::simulation::worn_pin();
    record.stop = StopReason::Failed {
        code: "step_below_minimum".to_owned(),
        words: "step 8.1e-15 s is under the minimum of 1e-14 s at t = 0.0213 s".to_owned(),
    };
    let text = one_line(&simulation_text(&record));
    assert!(text.contains("the run failed: step 8.1e-15 s is under the minimum of 1e-14 s at t = 0.0213 s"), "{text}");
}

#[test]
fn a_mechanism_without_play_says_so() {
    let mut record = report_fixture::motion::worn_pin();
    record.outputs[0].clearance = loosepin::accuracy::record::ClearanceAnswer::default();
    // The rod moves the slider by Δl/cos b, the crank by Δr (cos t + tan b sin t), sin b = -(r/l) sin t; of whole degrees most at
    // 225°: 0.03644020 mm.
    let text = one_line(&motion_text(&record));
    let scatter = "No joint has play. Scatter of the parts moves the slider with a standard deviation of at most 0.03645 mm (at 225°).";
    assert!(text.contains(scatter), "{text}");
    assert!(!text.contains("ideally"), "{text}");
    let page = motion_page(&record);
    assert!(
        page.contains("What scatter of the parts does") && page.contains("parameter.rod_length"),
        "it has its section"
    );
    record.outputs[0].dimensional_standard_deviation_si.clear();
    record.outputs[0].dimensional_contributors.clear();
    let text = one_line(&motion_text(&record));
    assert!(text.contains("No joint has play: the mechanism moves ideally."), "{text}");
    assert!(!text.contains("not known"), "{text}");
    assert!(!motion_page(&record).contains("What scatter of the parts does"));
}

/// The curve of the study from `lowest_m` to `highest_m`, half as far in the middle of the ranges, and nothing else to answer with.
fn curve_between(of: Deviation, lowest_m: f64, highest_m: f64) -> StudyResult {
    let mut result = worn_pin();
    result.bounds.clear();
    let curve = &mut result.curves[0];
    curve.of = of;
    let middle_m = 0.5 * (lowest_m + highest_m);
    for (range, share) in [(&mut curve.mixed, 1.0), (&mut curve.random, 0.5)] {
        range.lower_si.fill(middle_m + share * (lowest_m - middle_m));
        range.upper_si.fill(middle_m + share * (highest_m - middle_m));
    }
    result
}

#[test]
fn analytic_what_lies_on_one_side_is_not_within_plus_or_minus() {
    let one_sided = curve_between(Deviation::Total, 4.3e-4, 5.9e-4);
    assert_says(&one_sided, "stays between 0.43 mm and 0.59 mm of its ideal motion");
    let nearly_even = curve_between(Deviation::Total, 5.003e-4, 5.196e-4);
    assert_says(&nearly_even, "stays between 0.500 mm and 0.520 mm of its ideal motion");
    let even = curve_between(Deviation::Total, -4.97e-4, 5.13e-4);
    assert_says(&even, "stays within ±0.52 mm of its ideal motion");
    assert_says(
        &even,
        "would stay within ±0.27 mm at each angle; not knowing them, with the numerical error, widens this to ±0.52 mm.",
    );
    let value = curve_between(Deviation::Value, 0.1552, 0.1698);
    assert_says(&value, "lies between 155 mm and 170 mm: 95 % of mechanisms at any angle.");
    let text = one_line(&study_text(&value));
    assert!(!text.contains("If the unknown values were in the middle"), "{text}");
    let even_value = curve_between(Deviation::Value, -0.1698, 0.1693);
    assert_says(&even_value, "lies between -170 mm and 170 mm: 95 % of mechanisms at any angle.");
}

#[test]
fn identity_runs_are_told_by_what_they_were_for() {
    let mut result = worn_pin();
    let parts = [(Purpose::Contributors, 640), (Purpose::Rare, 5120)];
    result.counts.by_purpose.extend(parts.map(|(purpose, runs)| PurposeRuns { purpose, runs }));
    result.counts.runs += 640 + 5120;
    let page = one_line(&study_page(&result));
    let account = "23 296 = 64 values of the interval inputs × 256 random samples (8 independent replicates of 32) + 1024 with everything \
                   as probability + 128 with everything as interval + 640 for what contributes + 5120 for small probabilities";
    assert!(page.contains(account), "{page}");
    assert!(!page.contains("for the two other treatments"));
}

#[test]
fn without_intervals_nothing_is_said_to_hold_over_them() {
    let mut result = worn_pin();
    result.inputs.retain(|input| input.kind == InputKind::Random);
    result.counts.outer = 1;
    result.counts.by_purpose.truncate(1);
    result.counts.runs = 256;
    let text = one_line(&study_text(&result));
    assert!(text.contains("Bounds, widened by their numerical error"), "{text}");
    assert!(!text.contains("interval inputs"), "{text}");
    let page = one_line(&study_page(&result));
    assert!(page.contains("256 = 256 random samples (8 independent replicates of 32)"), "{page}");
    assert!(page.contains("Each share includes its numerical error."), "{page}");
    assert!(page.contains("Each statistic lies between its two bounds. "), "{page}");
}

#[test]
fn lists_of_uneven_length_leave_gaps() {
    let mut result = worn_pin();
    let bounds = result.bounds.clone();
    let fewer = bounds[..1].to_vec();
    result.percentiles = vec![
        PercentileBounds { percentile: 0.05, bounds: bounds.clone() },
        PercentileBounds { percentile: 0.95, bounds: fewer.clone() },
    ];
    result.cuts = vec![CutBounds { alpha: 0.0, bounds }, CutBounds { alpha: 0.5, bounds: fewer }];
    assert!(study_text(&result).contains("5 % percentile"));
    assert!(study_page(&result).contains("Degree 0.5"));
}

#[test]
fn the_share_below_a_limit_is_the_same_in_the_picture_as_in_the_table() {
    let mut result = worn_pin();
    let asked = result.bounds.iter_mut().find(|bound| matches!(bound.statistic, Statistic::ProbabilityAbove(_)));
    let asked = asked.expect("the fixture asks for a probability");
    (asked.lower.widened_si, asked.upper.widened_si) = (0.125, 0.75);
    let page = one_line(&study_page(&result));
    assert!(page.contains("Below 0.4 mm: between 25 % and 87.5 % of mechanisms, numerical error included."), "{page}");
    result.bounds.retain(|bound| !bound.statistic.is_probability());
    let pbox = &mut result.boxes[0];
    (pbox.value_si, pbox.lower, pbox.upper) = (vec![3e-4, 3.9e-4, 4.1e-4], vec![0.0, 0.5, 0.75], vec![0.0, 0.875, 1.0]);
    let page = one_line(&study_page(&result));
    assert!(page.contains("Below 0.4 mm: between 50 % and 100 % of mechanisms, without the sampling error."), "{page}");
}

#[test]
fn where_only_curves_were_asked_for_no_empty_table_is_shown() {
    let mut result = worn_pin();
    result.bounds.retain(|bound| matches!(bound.at, ResponsePoint::Curve { .. }));
    let count = result.bounds.len();
    let page = one_line(&study_page(&result));
    assert!(
        page.contains(&format!("The bounds are those of curves, angle by angle: {count} rows in bounds.csv.")),
        "{page}"
    );
    assert!(!page.contains("Lower bound, attained at"));
    assert_says(&result, "The bounds are those of curves, angle by angle");
}

#[test]
fn names_send_no_commands_to_a_terminal() {
    let mut result = worn_pin();
    result.name = "a\u{1b}[31mb\u{202e}c".to_owned();
    assert!(study_text(&result).starts_with("a\u{fffd}[31mb\u{fffd}c\n"), "{}", study_text(&result));
}

#[test]
fn a_search_for_offers_says_why_it_ended() {
    let mut result = worn_pin();
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    allocation.choices.clear();
    (allocation.combinations, allocation.excluded, allocation.studies) = (9, 9, 1);
    allocation.stop = AllocationStop::AllExcluded;
    assert_says(
        &result,
        "No offer named: none of 9 combinations meets the requirements, each being run and refused, or looser than such a one \
         (1 direct study).",
    );
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    (allocation.combinations, allocation.excluded, allocation.studies) = (81, 30, 27);
    allocation.stop = AllocationStop::TriedEnough;
    assert_says(
        &result,
        "No offer named: the search ended after 27 direct studies. Of 81 combinations, 30 are excluded, being run and refused, or \
         looser than such a one; nothing is known of the 51 others that cost more.",
    );
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    (allocation.combinations, allocation.excluded, allocation.studies) = (160_000, 0, 0);
    allocation.stop = AllocationStop::TooManyCombinations;
    assert_says(&result, "No offer named: 160000 combinations are more than are searched.");
}
