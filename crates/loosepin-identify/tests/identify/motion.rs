//! Identification from motion: sets that are known in closed form, misfits, and what a plan says.

use super::study;
use loosepin_identify::motion_record::MotionSpecimen;
use loosepin_identify::{MotionValues, NO_CALLBACK, Options, identify, known_bounds, narrowed, plan_motion};
use loosepin_study::Study;

/// The worn pin without its play: the stroke of the slider is twice the crank.
pub fn ideal_model() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/slider_crank_worn_pin/model.toml");
    let text = std::fs::read_to_string(path).expect("the case is there");
    let is_play =
        |line: &&str| !["bearing_radius", "radial_clearance", "contact = "].iter().any(|key| line.starts_with(key));
    let kept: Vec<&str> = text.lines().filter(is_play).collect();
    assert_eq!(kept.len() + 3, text.lines().count());
    kept.join("\n")
}

/// Scatter of the rod, of which the stroke knows nothing.
pub const ROD: &str =
    "[random]\n\"parameter.rod_length\" = { normal = { mean = \"120 mm\", standard_deviation = \"0.03 mm\" } }\n\n";

/// A study of the crank between 49 and 51 mm, with these tables.
pub fn of_crank(tables: &str) -> Study {
    let text = format!(
        "name = \"crank\"\nmodel = \"model.toml\"\n\n[cycle]\ntransient_turns = 0\nrecorded_turns = 1\n\
         samples_per_turn = 360\n\n\
         [epistemic]\n\"parameter.crank_length\" = {{ interval = [\"49 mm\", \"51 mm\"] }} # of the shop\n\n\
         [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n\n{tables}"
    );
    study(&ideal_model(), &text)
}

pub fn stroke(value: &str, errors: &str) -> String {
    format!("[[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"range\"\nvalue = {value}\n{errors}\n")
}

fn only(study: &Study) -> MotionSpecimen {
    let mut answer =
        identify(study, &Options::default(), NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(answer.motion.len(), 1);
    answer.motion.remove(0)
}

#[test]
fn analytic_a_stroke_fixes_the_crank_within_its_common_error() {
    // 2 r = 100.3 mm ± 0.2 mm, whatever the rod: r is 50.05 to 50.25 mm.
    let found = only(&of_crank(&stroke("\"100.3 mm\"", "error = \"± 0.2 mm\"")));
    assert_eq!(found.misfit, None);
    let [lower, upper] = found.unknowns[0].after_si.map(|end_si| 1e3 * end_si);
    // The set ends at the middle of the cell that is rejected: at most a cell and a half of 1/20 of the set.
    let most = 1.5 * 0.2 / 20.0 + 1e-9;
    assert!(lower <= 50.05 && lower > 50.05 - most, "{lower}");
    assert!(upper >= 50.25 && upper < 50.25 + most, "{upper}");
    // Repeats do not make a common error smaller.
    let three = only(&of_crank(&stroke("[\"100.3 mm\", \"100.3 mm\", \"100.3 mm\"]", "error = \"± 0.2 mm\"")));
    assert_eq!(three.unknowns[0].after_si, found.unknowns[0].after_si);
}

#[test]
#[ignore = "minutes of processor time"]
fn analytic_scatter_counts_with_the_root_of_the_repeats() {
    // The rank of a normal error among 199 is near |z| = 2.58 of its standard deviation, 0.04 mm; of nine repeats a third.
    let width = |value: &str, most: f64, least: f64| {
        let found = only(&of_crank(&stroke(value, "scatter = \"0.04 mm\"")));
        let [lower, upper] = found.unknowns[0].after_si.map(|end_si| 1e3 * end_si);
        assert!(lower < 50.15 && 50.15 < upper, "{lower} {upper}");
        assert!((least..most).contains(&(upper - lower)), "{value}: {}", upper - lower);
    };
    // 2 z σ / 2 = 0.103 mm; the distance of the 198th of 199 runs scatters by 0.2 of 2.58, and cells widen it by a tenth.
    width("\"100.3 mm\"", 0.103 * 1.35, 0.103 * 0.8);
    width("\"100.3 mm\"\nrepeats = 9", 0.0343 * 1.35, 0.0343 * 0.8);
}

#[test]
fn analytic_a_stroke_that_no_crank_has_is_a_misfit_with_its_distance() {
    let found = only(&of_crank(&stroke("\"103 mm\"", "error = \"± 0.2 mm\"")));
    let misfit = found.misfit.expect("2 r is at most 102 mm");
    assert!(misfit.least_distance > 1.0);
    // 102.8 mm is the least that the error allows; the longest tested crank is half a cell below 51 mm.
    let apart_mm = 1e3 * misfit.culprits[0].apart_si;
    assert!(apart_mm > 0.8 && apart_mm < 0.8 + 2.0 / 16.0 + 1e-9, "{apart_mm}");
    assert_eq!(found.unknowns[0].after_si, found.unknowns[0].before_si);
}

#[test]
fn a_motion_narrows_the_study_as_written() {
    let study = of_crank(&stroke("\"100.3 mm\"", "error = \"± 0.2 mm\""));
    let answer =
        identify(&study, &Options::default(), NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let known = known_bounds(&answer).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let (text, changes) = narrowed(&study, &known);
    assert_eq!(changes.len(), 1);
    assert!(text.contains("# of the shop") && !text.contains("49 mm"), "{text}");
}

#[test]
fn no_study_is_narrowed_by_several_specimens_or_by_a_misfit() {
    let of = |specimen: &str, value: &str| stroke(value, &format!("error = \"± 0.2 mm\"\nspecimen = \"{specimen}\""));
    let two = of_crank(&format!("{}{}", of("A", "\"100.3 mm\""), of("B", "\"100.1 mm\"")));
    let options = Options { points: 30, ..Options::default() };
    let mut answer = identify(&two, &options, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    // A and B of the readings, and A and B of the motion: two specimens, not four.
    answer.motion.extend(answer.motion.clone());
    let refused = known_bounds(&answer).expect_err("two specimens").to_string();
    assert!(refused.contains("from 2 specimens"), "{refused}");
    let wrong = of_crank(&of("A", "\"103 mm\""));
    let answer = identify(&wrong, &options, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let refused = known_bounds(&answer).expect_err("a misfit").to_string();
    assert!(refused.contains("no values explain the measurements of specimen 'A'"), "{refused}");
}

#[test]
fn refusals_of_a_motion_name_its_specimens_and_keep_code_and_hint() {
    let study = of_crank(&stroke("\"100.3 mm\"", "error = \"± 0.2 mm\"\nspecimen = \"A\""));
    let options = Options { specimen: Some("C".to_owned()), ..Options::default() };
    let refused = identify(&study, &options, NO_CALLBACK).expect_err("no such specimen").to_string();
    assert!(
        refused.contains("there are no measurements of a specimen 'C'") && refused.contains("available: 'A'"),
        "{refused}"
    );
    let asked = MotionValues { confidence: 0.99, points: 64, threads: 0, with_posterior: false, with_lengths: false };
    let refused = plan_motion(&study, Some("C"), &asked, NO_CALLBACK).expect_err("no such specimen").to_string();
    assert!(refused.contains("available: 'A'"), "{refused}");
    // A crank that is longer than its rod does not turn: the words of the run, not that "runs cannot be made".
    let text = "name = \"long\"\nmodel = \"model.toml\"\n\n[epistemic]\n\
        \"parameter.crank_length\" = { interval = [\"200 mm\", \"210 mm\"] }\n\n\
        [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n\n";
    let long = Study::from_text(
        "study.toml",
        &format!("{text}{}", stroke("\"400 mm\"", "error = \"± 0.2 mm\"")),
        loosepin_mechanics::model::Model::from_text("model.toml", &ideal_model()).expect("a model"),
    );
    let long = long.unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let refused = identify(&long, &Options::default(), NO_CALLBACK).expect_err("it does not turn").to_string();
    assert!(
        refused.contains("error[E0704]") && refused.contains("hint: that is 'parameter.crank_length'"),
        "{refused}"
    );
}

#[test]
fn identity_the_set_is_the_same_for_any_number_of_threads() {
    let study = of_crank(&format!("{ROD}{}", stroke("\"100.3 mm\"", "scatter = \"0.1 mm\"")));
    let with = |threads: usize| {
        let options = Options { threads, points: 30, ..Options::default() };
        identify(&study, &options, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn a_plan_says_which_feature_tells() {
    let at = |feature: &str, more: &str| {
        format!(
            "[[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"{feature}\"\nerror = \"± 0.2 mm\"\n{more}\n"
        )
    };
    // The mean of the drive's turn counts the rod, whose length is known far better than the error; the stroke counts the crank.
    let study = of_crank(&format!("{ROD}{}{}", at("range", ""), at("order", "order = 7")));
    let asked = MotionValues { confidence: 0.99, points: 64, threads: 0, with_posterior: false, with_lengths: false };
    let plan = plan_motion(&study, None, &asked, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(plan.features[0].name, "slider, range");
    assert!(plan.features[0].share_of_box < 0.5, "{plan:?}");
    assert!(plan.features[1].share_of_box > 0.99, "{plan:?}");
    let refused = identify(&study, &Options::default(), NO_CALLBACK).expect_err("nothing was measured").to_string();
    assert!(refused.contains("'slider, range' has no value"), "{refused}");
}

#[test]
fn analytic_two_unknowns_of_a_stroke_and_a_largest_position_form_a_band() {
    // Stroke 2 r = 100 mm ± 0.4 mm and largest position r + l = 170 mm ± 0.2 mm, by two instruments: r in 49.8 to 50.2 mm, and l in
    // 169.8 - r to 170.2 - r: 119.6 to 120.4 mm, of which the corners are cut off.
    let text = "name = \"two\"\nmodel = \"model.toml\"\n\n[cycle]\ntransient_turns = 0\nrecorded_turns = 1\n\n\
        [epistemic]\n\"parameter.crank_length\" = { interval = [\"49 mm\", \"51 mm\"] }\n\
        \"parameter.rod_length\" = { interval = [\"118 mm\", \"122 mm\"] }\n\n\
        [[ask]]\noutput = \"slider\"\nof = \"total\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n\n\
        [[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"range\"\nvalue = \"100 mm\"\nerror = \"0.4 mm\"\ninstrument = \"a\"\n\
        [[measured]]\nkind = \"motion\"\noutput = \"slider\"\nfeature = \"maximum\"\nvalue = \"170 mm\"\nerror = \"0.2 mm\"\ninstrument = \"b\"\n";
    let found = only(&study(&ideal_model(), text));
    let [crank, rod] = [0, 1].map(|place: usize| found.unknowns[place].after_si.map(|end_si| 1e3 * end_si));
    for (name, [low, high], [least, most]) in [("crank", crank, [49.8, 50.2]), ("rod", rod, [119.6, 120.4])] {
        // The tips of the band are narrower than a cell: a cell and a half of 1/20 of the set may be missed or added.
        let cell = 1.5 * (most - least) / 20.0;
        assert!((low - least).abs() <= 2.0 * cell && (high - most).abs() <= 2.0 * cell, "{name} {low} {high}");
    }
    // The area of the band is 0.4 mm · 0.4 mm of 2 mm · 4 mm.
    assert!((found.share_of_box[0] - 0.02).abs() < 0.004, "{:?}", found.share_of_box);
    assert!(found.share_of_box[1] > found.share_of_box[0]);
}
