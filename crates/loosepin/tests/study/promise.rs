//! Whole studies with a promise for a share of the box.

use crate::silent::run_on;
use loosepin::result::json::to_json;
use loosepin::study::result::{PromiseRecord, Purpose, Side, Statistic, StudyResult, Verdict};
use loosepin::study::{Study, estimate_cost};
/// The worn pin in few and short runs, with `rest` of the study.
fn study(rest: &str) -> Study {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_worn_pin");
    let text = format!(
        "name = \"promised\"\nmodel = \"model.toml\"\n\
         [cycle]\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 12\n\
         [sampling]\nouter = 32\ninner = 16\ntolerance = \"1e-6 m\"\n\
         [random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
         {rest}"
    );
    Study::from_text_at(&folder.join("study.toml").display().to_string(), &text)
        .unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn conducted(study: &Study, threads: usize) -> StudyResult {
    run_on(threads, study).unwrap_or_else(|error| panic!("{error}")).result
}

const CLEARANCE: &str = "[epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n";
const PROMISE: &str = "[promise]\nshare = 0.9\nconfidence = 0.9\ninner = 8\n";

/// Dimensional deviations have no play: the rod and the crank alone, known in closed form at the dead centre.
const ASK: &str = "[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\nposes = { crank = [\"0 deg\"] }\n\
                   statistics = [{ quantile = 0.5 }]\npromise = \"both\"\n";

fn requirement(within: &str) -> String {
    format!(
        "[[require]]\noutput = \"slider\"\nof = \"total\"\nwithin = \"{within}\"\nover = \"cycle\"\n\
         probability_at_least = 0.5\ndecided_by = \"promise\"\n"
    )
}

#[test]
fn what_is_promised_is_run_and_stored() {
    let study = study(&format!("{CLEARANCE}{PROMISE}{ASK}{}", requirement("9 mm")));
    let estimate = estimate_cost(&study).unwrap().promise.expect("something is promised");
    let result = conducted(&study, 2);
    let promise = result.promise.as_ref().expect("something is promised");
    let PromiseRecord { share, confidence, boxes, values, inner, runs, .. } = *promise;
    // Three ends share 10 %: ln(0.1/3)/ln(1 - 0.1·0.99) = 32.6.
    assert_eq!((share, confidence, boxes, values, inner, runs), (0.9, 0.9, 1, 33, 8, 33 * 8));
    assert_eq!((estimate.ends, estimate.values, estimate.runs), (3, 33, 33 * 8));
    let counted = result.counts.by_purpose.iter().find(|part| part.purpose == Purpose::Promise);
    assert_eq!(counted.expect("its runs are counted").runs, 33 * 8);
    let [lower, upper, outside] = &promise.ends[..] else { panic!("three ends: {promise:?}") };
    assert_eq!((lower.side, upper.side, outside.side), (Side::Lower, Side::Upper, Side::Upper));
    assert_eq!((lower.statistic, upper.statistic), (Statistic::Quantile(0.5), Statistic::Quantile(0.5)));
    // At the dead centre the slider moves as the crank is longer: normal with 20 um, of which the median is 0. With 8 runs its limits are
    // the least and the greatest of all 264 draws.
    const FOUR_DEVIATIONS_M: f64 = 8e-5;
    assert!(lower.bound_si > -FOUR_DEVIATIONS_M && lower.bound_si < 0.0, "{lower:?}");
    assert!(upper.bound_si > 0.0 && upper.bound_si < FOUR_DEVIATIONS_M, "{upper:?}");
    assert!(outside.statistic == Statistic::ProbabilityBeyond(9e-3) && outside.failed_values == 0, "{outside:?}");
    let [required] = &result.requirements[..] else { panic!("one is required") };
    // None of 8 runs outside anywhere: 1 - 0.01^(1/8) may be.
    assert!((required.promised.unwrap() - 0.01_f64.powf(0.125)).abs() < 1e-12, "{required:?}");
    assert_eq!((required.verdict, result.verdict()), (Verdict::Promised, Some(Verdict::Promised)));
}

#[test]
fn identity_a_promise_does_not_depend_on_threads_and_moves_no_bound() {
    let with = study(&format!("{CLEARANCE}{PROMISE}{ASK}"));
    let without = study(&format!("{CLEARANCE}{}", ASK.replace("promise = \"both\"\n", "")));
    let [one, two, none] = [conducted(&with, 1), conducted(&with, 2), conducted(&without, 2)];
    assert!(one.promise.is_some());
    assert_eq!(to_json(&one).unwrap(), to_json(&two).unwrap());
    assert_eq!(to_json(&none.bounds).unwrap(), to_json(&one.bounds).unwrap());
    assert_eq!(none.promise, None);
}

#[test]
fn a_band_over_a_curve_is_one_end_of_a_promise() {
    let ask = "[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\nat = \"cycle\"\n\
               statistics = [{ simultaneous_band = 0.5 }]\npromise = \"upper\"\n";
    let result = conducted(&study(&format!("{CLEARANCE}{PROMISE}{ask}")), 2);
    let promise = result.promise.expect("something is promised");
    // ln 0.1/ln(1 - 0.099) = 22.1.
    assert_eq!((promise.values, promise.ends.len(), promise.bands.len()), (23, 0, 1));
    let band = &promise.bands[0];
    let poses = result.curves[0].pose_rad.len();
    assert_eq!((band.share, band.band.lower_si.len(), band.band.upper_si.len(), poses), (0.5, 12, 12, 12));
    // The limit at a value is the largest of 8 excesses: above the median of them, which is above 1.
    assert!(band.factor > 1.0 && band.factor < 10.0 && band.failed_values == 0, "{band:?}");
    assert!(band.band.lower_si.iter().zip(&band.band.upper_si).all(|(low, high)| low <= high));
}

#[test]
fn a_requirement_that_cannot_be_promised_is_not_met() {
    // Half of the clearance is beyond 0.3 mm, and the deviation is about as large as the clearance.
    let result = conducted(&study(&format!("{CLEARANCE}{PROMISE}{}", requirement("0.02 mm"))), 2);
    let required = &result.requirements[0];
    assert!(required.promised.unwrap() < 0.5 && required.verdict != Verdict::Promised, "{required:?}");
    assert!(matches!(result.verdict(), Some(Verdict::NotMet | Verdict::Undecided)));
}

#[test]
fn every_member_and_every_focal_element_has_a_box_of_its_own() {
    let epistemic = "[epistemic]\n\
        \"joint.gudgeon.radial_clearance\" = { evidence = [{ interval = [\"0.1 mm\", \"0.2 mm\"], mass = 0.4 }, \
        { interval = [\"0.2 mm\", \"0.5 mm\"], mass = 0.6 }] }\n\
        \"contact.steel_pin.restitution\" = { any_of = [0.7, 0.9] }\n";
    let study = study(&format!("{epistemic}{PROMISE}{ASK}"));
    let estimate = estimate_cost(&study).unwrap().promise.expect("something is promised");
    // Two ends: ln 0.05/ln(1 - 0.099) = 28.7.
    assert_eq!((estimate.boxes, estimate.values, estimate.runs), (4, 29, 4 * 29 * 8));
}
