//! The loosest ISO 286 fit of a list that still meets the requirements.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use loosepin::model::Model;
use loosepin::report::study_text;
use loosepin::study::result::{Loosened, StudyResult, Verdict};
use loosepin::study::{Progress, RunOptions, Study, run_study};
use loosepin::templates::find_template;

/// Holds that the runs of all studies are counted on. Of two threads one may report its 64 runs behind those of the other.
struct Rising(AtomicUsize);

impl Progress for Rising {
    fn runs(&self, finished: usize, _: usize) {
        let before = self.0.fetch_max(finished, Ordering::Relaxed);
        assert!(finished + 2 * 64 >= before, "{finished} runs after {before}");
    }
}

/// A fiftieth of a turn, so that thousands of runs take seconds.
pub fn conducted(inputs: &str) -> StudyResult {
    conducted_with("", inputs)
}

/// The same, with keys before the tables.
pub fn conducted_with(keys: &str, inputs: &str) -> StudyResult {
    let text = format!(
        "{keys}
        name = \"which fit\"
        model = \"model.toml\"
        seed = 7
        [cycle]
        transient_turns = 0
        recorded_turns = 0.02
        samples_per_turn = 200
        [sampling]
        outer = 9
        inner = 64
        [random]
        \"parameter.rod_length\" = {{ normal = {{ mean = \"120 mm\", standard_deviation = \"0.02 mm\" }} }}
        {inputs}
        [[require]]
        output = \"slider\"
        of = \"total\"
        within = \"0.12 mm\"
        over = \"cycle\"
        probability_at_least = 0.9
        "
    );
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let stop = AtomicBool::new(false);
    let rising = Rising(AtomicUsize::new(0));
    run_study(&study, "", &RunOptions::new(2, &rising, &stop)).unwrap_or_else(|error| panic!("{error}")).result
}

pub const CLEARANCE: &str = "\"joint.gudgeon.radial_clearance\"";

/// In any order: by the greatest clearance H7/g6 20.5 µm, H8/f7 37 µm, H9/e9 72 µm, H11/d11 162.5 µm.
const FITS: &str = "[\"H8/f7\", \"H11/d11\", \"H7/g6\", \"H9/e9\"]";

#[test]
fn identity_a_direct_study_agrees_with_the_loosest_fit_and_with_the_next_one() {
    let with_fit = |fit: &str| format!("[epistemic]\n{CLEARANCE} = {{ fit = \"{fit}\", diameter = \"20 mm\" }}\n");
    let allow = format!("[allow]\n{CLEARANCE} = {{ fit = {FITS}, diameter = \"20 mm\" }}\n");
    let result = conducted(&format!("{}{allow}", with_fit("H7/g6")));
    let found = &result.allowances[0];
    assert_eq!(found.what, Loosened::Fit);
    // The shaft is at most 195 µm below 20 mm, the hole at most 130 µm above: 162.5 µm on the radius (ISO 286-1, tables 1 and 4).
    const ROUND_OFF_M: f64 = 1e-12;
    assert!((found.up_to_si - 162.5e-6).abs() < ROUND_OFF_M, "{found:?}");
    let (allowed, beyond) =
        (found.allowed_fit.as_deref().expect("one fits"), found.beyond_fit.as_deref().expect("not all do"));
    let looser = ["H7/g6", "H8/f7", "H9/e9", "H11/d11"];
    let place = looser.iter().position(|fit| *fit == allowed).expect("one of the list");
    assert_eq!(looser[place + 1], beyond);
    assert_eq!(conducted(&with_fit(allowed)).requirements[0].verdict, Verdict::Met);
    let refused =
        found.checks.iter().any(|check| check.fit.as_deref() == Some(beyond) && check.answer.verdict != Verdict::Met);
    assert!(refused, "{found:?}");
    let confirmed = found.checks.last().expect("checks");
    assert!(
        confirmed.answer.is_confirmation
            && confirmed.answer.verdict == Verdict::Met
            && confirmed.fit.as_deref() == Some(allowed)
    );
    let text = study_text(&result).split_whitespace().collect::<Vec<&str>>().join(" ");
    let words = format!("The gudgeon radial clearance may have the fit {allowed}: all requirements are met");
    assert!(text.contains(&words) && text.contains(&format!("With {beyond}, the next looser fit")), "{text}");
}
