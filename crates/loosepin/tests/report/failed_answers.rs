//! What is said of failed runs: first how many there are, and no bound that they leave none of.

use loosepin::report::{simulation_text, study_page, study_text};
use loosepin::simulate::record::StopReason;
use loosepin::study::result::Guarantee;

use super::report_answer::{assert_says, one_line};
use super::report_fixture::{self, study::with_failed_runs, study::worn_pin};

#[test]
fn failed_runs_come_first_and_what_they_leave_is_no_bound() {
    let result = with_failed_runs();
    let text = one_line(&study_text(&result));
    let place = |sentence: &str| text.find(sentence).unwrap_or_else(|| panic!("'{sentence}' is not in: {text}"));
    // 276/2944 is 9.375 %.
    let failed = place("9.4 % of the runs failed (276 of 2944): the mechanism cannot be put together.");
    let mean = place(
        "the mean has no bound, since a failed run may have had any value (over the finished runs it lies between 0.090 mm and 0.410 mm)",
    );
    let quantile = place(
        "the 95 % quantile is at least 0.2000 mm and has no upper bound, since so many runs failed that the quantile may be among them.",
    );
    assert!(failed < mean && mean < quantile, "{text}");
    place("Numerical error of the numbers over the finished runs: at most 0.01 mm, included in them.");
    let table = place("no bound: a failed run may have had any value; finished runs: 0.090 mm to 0.410 mm");
    place("no bound: so many runs failed that the quantile may be among them");
    assert!(table > quantile);
    for wrong in
        ["the mean lies between", "increase 'inner'", "and ∞", "narrower than the mixed", "wider than the mixed"]
    {
        assert!(!text.contains(wrong), "'{wrong}' is in: {text}");
    }
    let page = one_line(&study_page(&result).replace('\u{a0}', " "));
    let shown = |sentence: &str| page.find(sentence).unwrap_or_else(|| panic!("'{sentence}' is not in: {page}"));
    assert!(shown("9.4 % of the runs failed (276 of 2944)") < shown("the mean has no bound, since a failed run"));
    shown("none: found over the finished runs only");
    assert!(!page.contains("the mean lies between") && !page.contains("increase 'inner'"));
}

#[test]
fn failed_runs_that_leave_every_bound_are_no_headline() {
    let mut result = worn_pin();
    // 3 of 17536.
    assert!(!study_text(&result).contains("of the runs failed"));
    result.counts.failed = 176;
    assert_says(&result, "1.1 % of the runs failed (176 of 17536).");
    let further = result.failures[0].clone();
    (result.failures[0].code, result.failures[0].count) = ("cannot_close".to_owned(), 100);
    result.failures.push(further);
    assert_says(&result, "(176 of 17536), most of them for one reason: the links cannot close.");
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
fn unconfirmed_bounds_and_failed_runs_are_owned_up_to() {
    let mut result = worn_pin();
    result.bounds.truncate(3);
    result.bounds[1].guarantee = Guarantee::Inner;
    assert_says(&result, "1 of 3 bounds may be too narrow: increase 'inner'.");
    let mut answer = result.clone();
    answer.bounds[0].guarantee = Guarantee::Inner;
    assert_says(
        &answer,
        "up to 0.005 mm, included in it. 2 of 3 bounds, this answer included, may be too narrow: increase 'inner'.",
    );
    answer.bounds[1].guarantee = answer.bounds[2].guarantee;
    assert_says(&answer, "up to 0.005 mm, included in it. This answer may be too narrow: increase 'inner'.");
    assert_says(
        &result,
        "17536 runs, 3 failed. Probabilities and quantiles allow for both outcomes of a failed run. Means and standard deviations use \
         the finished runs only and have no bound.",
    );
    result.counts.failed = 0;
    assert_says(&result, "17536 runs, none failed.");
}
