//! A statistic that has no estimator of its own, from the study file to its sentence: the mean absolute deviation.

use crate::silent::run;
use loosepin::model::Model;
use loosepin::report::study_text;
use loosepin::study::Study;
use loosepin::study::result::{BoundRecord, ResponsePoint, Statistic, StudyResult};
use loosepin::templates::find_template;

/// A fiftieth of a turn, so that thousands of runs take seconds.
fn conducted(keys: &str, ask: &str) -> StudyResult {
    let text = format!(
        "{keys}
        name = \"how far from the mean\"
        model = \"model.toml\"
        [cycle]
        transient_turns = 0
        recorded_turns = 0.02
        samples_per_turn = 200
        [sampling]
        outer = 9
        inner = 64
        [random]
        \"parameter.rod_length\" = {{ normal = {{ mean = \"120 mm\", standard_deviation = \"0.02 mm\" }} }}
        [epistemic]
        \"joint.gudgeon.radial_clearance\" = {{ interval = [\"0.01 mm\", \"0.05 mm\"] }}
        [[ask]]
        output = \"slider\"
        of = \"total\"
        {ask}
        "
    );
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    run(&study).result
}

fn of(result: &StudyResult, statistic: Statistic) -> Vec<&BoundRecord> {
    let found: Vec<&BoundRecord> = result.bounds.iter().filter(|bound| bound.statistic == statistic).collect();
    assert!(!found.is_empty(), "no bounds of {statistic:?}");
    found
}

#[test]
fn analytic_the_deviation_of_a_rod_is_that_of_its_slider() {
    // Near the dead centre the slider follows a rod of N(120, 0.02) mm one to one: 0.02 √(2/π) = 0.01596 mm.
    const EXACT_M: f64 = 0.02e-3 * 0.797_884_56;
    let statistics = "statistics = [\"mean_absolute_deviation\", \"standard_deviation\"]";
    let result = conducted("", &format!("at = \"cycle\"\n{statistics}"));
    for (own, deviation) in
        of(&result, Statistic::MeanAbsoluteDeviation).iter().zip(of(&result, Statistic::StandardDeviation))
    {
        assert!(matches!(own.at, ResponsePoint::Curve { .. }) && own.at == deviation.at);
        let [lower, upper] = [&own.lower, &own.upper].map(|end| end.widened_si);
        assert!(lower >= 0.0 && lower <= upper && upper.is_finite(), "{own:?}");
        // It never exceeds the standard deviation, and both are narrowed by that.
        assert!(upper <= deviation.upper.widened_si && lower <= deviation.lower.widened_si, "{own:?} {deviation:?}");
    }
    // Before the play is felt.
    let first = of(&result, Statistic::MeanAbsoluteDeviation)[0];
    assert!(first.lower.widened_si <= EXACT_M && first.upper.widened_si >= EXACT_M, "{first:?}");
    assert!(first.upper.widened_si < 1.5 * EXACT_M && first.lower.widened_si > 0.5 * EXACT_M, "{first:?}");
}

#[test]
fn its_words_and_what_is_not_known_of_it_are_told() {
    let ask = "reduce = \"maximum_absolute\"\nstatistics = [\"mean_absolute_deviation\"]";
    let result = conducted("reading = [\"fixed\", \"random-set\"]", ask);
    let found = of(&result, Statistic::MeanAbsoluteDeviation);
    let [fixed, set] = found[..] else { panic!("two readings: {found:?}") };
    assert!(fixed.lower.widened_si >= 0.0 && fixed.upper.widened_si < 1e-4, "{fixed:?}");
    assert!(set.lower.widened_si == 0.0 && set.upper.widened_si.is_infinite(), "{set:?}");
    let text = study_text(&result);
    assert!(text.contains("mean absolute deviation"), "{text}");
    assert!(!text.contains("-inf") && !text.contains("NaN"), "{text}");
}
