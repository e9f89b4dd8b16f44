//! Contact laws as a discrete epistemic input: one study over three laws against the studies of each law by itself.

use crate::silent::run_on;
use loosepin::model::Model;
use loosepin::report::{study_page, study_text};
use loosepin::study::files::{bounds_csv, runs_parquet};
use loosepin::study::result::{BoundEnd, BoundRecord, InputKind, StudyResult, WitnessValue};
use loosepin::study::{RunData, RunsTable};
use loosepin::study::{Study, StudyRun};
use loosepin::templates::find_template;

const LAWS: [&str; 3] = ["lankarani-nikravesh", "flores", "johnson"];

/// The slider-crank of the template with a bearing length, so that line-contact laws are complete too.
fn model(law: &str) -> Model {
    let text = find_template("slider-crank").expect("template").model;
    let text = text.replace("bearing_radius = \"10 mm\"", "bearing_radius = \"10 mm\"\nbearing_length = \"20 mm\"");
    let text = text.replace("law = \"lankarani-nikravesh\"", &format!("law = \"{law}\""));
    Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// A study of the peak force over a part of a turn; in an eighth of it the pin strikes about five times.
fn study(law: &str, turns: f64, outer: usize, epistemic: &str) -> Study {
    let text = format!(
        "
        name = \"which law\"
        model = \"model.toml\"
        [cycle]
        transient_turns = 0
        recorded_turns = {turns}
        [sampling]
        outer = {outer}
        inner = 16
        replicates = 4
        [random]
        \"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}
        {epistemic}
        [[ask]]
        output = \"pin_force\"
        of = \"value\"
        reduce = \"maximum\"
        statistics = [\"mean\", \"standard_deviation\", {{ quantile = 0.9 }}]
        "
    );
    Study::from_text("study.toml", &text, model(law)).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn bounds(study: &Study, threads: usize) -> StudyRun {
    run_on(threads, study).unwrap_or_else(|error| panic!("{error}"))
}

const LIST: &str = "\"contact.steel_pin.law\" = { any_of = [\"lankarani-nikravesh\", \"flores\", \"johnson\"] }";
const PLAY: &str = "\"joint.gudgeon.radial_clearance\" = { interval = [\"0.3 mm\", \"0.5 mm\"] }";

/// The bounds of the studies of single laws, law by law.
fn single_laws(turns: f64, outer: usize, epistemic: &str) -> Vec<Vec<BoundRecord>> {
    LAWS.iter().map(|law| bounds(&study(law, turns, outer, epistemic), 2).result.bounds).collect()
}

fn law_at(end: &BoundEnd) -> &str {
    match &end.witness["contact.steel_pin.law"] {
        WitnessValue::Choice(law) => law,
        WitnessValue::Number(value) => panic!("{value} is no law"),
    }
}

/// The single law whose study goes furthest towards `sign`, and its end.
fn furthest(singles: &[Vec<BoundRecord>], index: usize, sign: f64) -> (&'static str, &BoundEnd) {
    let end = |bounds: &'_ [BoundRecord]| -> f64 {
        let bound = &bounds[index];
        sign * if sign > 0.0 { bound.upper.value_si } else { bound.lower.value_si }
    };
    let best = (0..LAWS.len()).max_by(|&a, &b| end(&singles[a]).total_cmp(&end(&singles[b]))).expect("three laws");
    let bound = &singles[best][index];
    (LAWS[best], if sign > 0.0 { &bound.upper } else { &bound.lower })
}

#[test]
fn identity_bounds_over_laws_are_the_envelope_of_the_laws() {
    let singles = single_laws(0.125, 1, "");
    let StudyRun { result, runs, .. } = bounds(&study(LAWS[0], 0.125, 3, &format!("[epistemic]\n{LIST}")), 2);
    assert_eq!((result.counts.failed, result.bounds.len()), (0, 3));
    for (index, bound) in result.bounds.iter().enumerate() {
        // The same random numbers and nothing between the laws: the same bits, and the law that has them.
        let ((low_law, low), (high_law, high)) = (furthest(&singles, index, -1.0), furthest(&singles, index, 1.0));
        assert_eq!(bound.lower.value_si.to_bits(), low.value_si.to_bits(), "{:?}", bound.statistic);
        assert_eq!(bound.upper.value_si.to_bits(), high.value_si.to_bits(), "{:?}", bound.statistic);
        assert_eq!((law_at(&bound.lower), law_at(&bound.upper)), (low_law, high_law), "{:?}", bound.statistic);
        assert_eq!((bound.lower.error.optimisation_si, bound.upper.error.optimisation_si), (0.0, 0.0));
    }
    // The laws matter: the stiffest one strikes more than ten times its sampling error harder.
    let mean = &result.bounds[0];
    assert!(mean.upper.value_si - mean.lower.value_si > 10.0 * mean.upper.error.total_si(), "{mean:?}");
    words_are_right(&result, &runs);
}

/// What files and pages say of a law among the inputs.
fn words_are_right(result: &StudyResult, runs: &RunsTable) {
    let law = result.inputs.iter().find(|input| input.path == "contact.steel_pin.law").expect("the law is an input");
    assert_eq!(law.kind, InputKind::Choice { of: LAWS.map(str::to_owned).to_vec() });
    assert_eq!(law.words, "one of lankarani-nikravesh, flores and johnson");
    let column = runs.columns.iter().find(|column| column.name == "contact.steel_pin.law").expect("a column");
    let RunData::Text(names) = &column.data else { panic!("names of laws") };
    let purpose = runs.columns.iter().find(|column| column.name == "purpose").expect("a column");
    let RunData::Text(purposes) = &purpose.data else { panic!("words") };
    let count = |purpose: &str, law: &str| {
        names.iter().zip(purposes).filter(|(name, own)| *name == law && *own == purpose).count()
    };
    // 16 samples of each; every third one of the 1024 where all is random, to the grain of the points; every law as interval.
    for law in LAWS {
        assert_eq!(count("mixed", law), 16);
        assert!(count("probability_only", law).abs_diff(1024 / 3) <= 4, "{}", count("probability_only", law));
        assert!(count("interval_only", law) >= 64);
    }
    let csv = String::from_utf8(bounds_csv(result).expect("CSV")).expect("UTF-8");
    assert!(csv.contains(",contact.steel_pin.law=johnson,"), "{csv}");
    let text = study_text(result);
    assert!(text.contains("Bounds for all values of the unknown inputs"), "{text}");
    // Lines end at hyphens, too.
    let flat = text.split_whitespace().collect::<Vec<_>>().join(" ").replace("- ", "-");
    assert!(flat.contains("each steel pin law of the list (lankarani-nikravesh, flores and johnson)"), "{text}");
    assert!(flat.contains("gives all members of a list the same probability"), "{text}");
    let page = study_page(result);
    for words in ["one of a list", "gives all members of a list the same probability", "steel pin law johnson"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn identity_bounds_over_laws_and_play_are_the_envelope_within_their_errors() {
    let singles = single_laws(0.07, 8, &format!("[epistemic]\n{PLAY}"));
    let mixed = study(LAWS[1], 0.07, 24, &format!("[epistemic]\n{LIST}\n{PLAY}"));
    let result = bounds(&mixed, 2).result;
    for (index, bound) in result.bounds.iter().enumerate() {
        for (sign, own) in [(-1.0, &bound.lower), (1.0, &bound.upper)] {
            let (_, single) = furthest(&singles, index, sign);
            // What one has attained lies inside what the other relies on, and the errors are finite.
            let (own_error, single_error) = (own.error.total_si(), single.error.total_si());
            assert!(sign * (own.widened_si - single.value_si) >= 0.0, "{:?}: {own:?} {single:?}", bound.statistic);
            assert!(sign * (single.widened_si - own.value_si) >= 0.0, "{:?}: {own:?} {single:?}", bound.statistic);
            assert!(own_error.is_finite() && single_error.is_finite());
            assert!(LAWS.contains(&law_at(own)));
        }
    }
}

#[test]
fn identity_a_study_over_laws_has_the_same_bits_on_1_2_and_16_threads() {
    let study = study(LAWS[0], 0.03, 12, &format!("[epistemic]\n{LIST}\n{PLAY}"));
    let [one, two, many] = [1, 2, 16].map(|threads| bounds(&study, threads));
    assert!(one.result == two.result && one.result == many.result);
    // As bytes: what a run has not is no number, and equal to nothing.
    let [one, two, many] = [one, two, many].map(|conducted| runs_parquet(&conducted.runs).expect("Parquet"));
    assert!(one == two && one == many);
}
