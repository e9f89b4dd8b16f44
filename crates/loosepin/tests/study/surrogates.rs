//! Surrogates from the study file to files and page, beside the direct bounds of the same study.

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use crate::silent::{Silent, run_on};
use loosepin::model::Model;
use loosepin::report::{study_page, study_text};
use loosepin::result::json::Stored;
use loosepin::study::files::surrogates_json;
use loosepin::study::result::{
    AccuracyStop, BoundRecord, Guarantee, ResponsePoint, Statistic, StudyResult, SurrogateVerdict, TreatmentComparison,
    Verdict,
};
use loosepin::study::{RunOptions, SavedSurrogates, Study, StudyError, export_networks, run_study};
use loosepin::templates::find_template;

const OUTER: usize = 24;
const INNER: usize = 64;

/// A slider-crank without play: crank and rod scatter, of the rod the mean is known within an interval, and of the foot of the crank a position.
fn study(surrogate: &str) -> Result<Study, String> {
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", &text(surrogate), model).map_err(|diagnostics| diagnostics.to_string())
}

fn text(surrogate: &str) -> String {
    format!(
        "name = \"learned\"\nmodel = \"model.toml\"\n
        {surrogate}
        [cycle]
        transient_turns = 0
        recorded_turns = 0.2
        samples_per_turn = 60
        [sampling]
        outer = {OUTER}
        inner = {INNER}
        replicates = 4
        [random]
        \"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}
        [epistemic]
        \"parameter.rod_length\" = {{ interval = [\"119.5 mm\", \"120.7 mm\"] }}
        [[ask]]
        output = \"slider\"
        of = \"dimensional\"
        poses = {{ crank = [\"60 deg\"] }}
        statistics = [\"mean\", \"standard_deviation\", {{ probability_above = \"0.5 mm\" }}, {{ quantile = 0.9 }}]
        [[ask]]
        output = \"slider\"
        of = \"dimensional\"
        at = \"cycle\"
        statistics = [\"mean\"]
        "
    )
}

fn conducted(surrogate: &str) -> StudyResult {
    let study = study(surrogate).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    run_on(2, &study).unwrap_or_else(|error| panic!("{error}")).result
}

/// The direct and the learned bound of a statistic at the pose.
fn both(result: &StudyResult, statistic: Statistic) -> [&BoundRecord; 2] {
    let learned = &result.surrogate.as_ref().expect("a surrogate was asked for").bounds;
    [&result.bounds, learned].map(|bounds| {
        let own = |bound: &&BoundRecord| bound.statistic == statistic && matches!(bound.at, ResponsePoint::Pose { .. });
        bounds.iter().find(own).expect("the statistic is asked")
    })
}

/// The treatments of direct runs and of a surrogate, of which the ends have their errors.
fn treatments_agree(direct: &[TreatmentComparison], learned: &[TreatmentComparison]) {
    const TOLERANCE_M: f64 = 2e-6; // sampling of 64 stratified runs of a scatter of 10 µm
    assert_eq!((direct.len(), learned.len()), (1, 1));
    for (direct, learned) in direct[0].bands.iter().zip(&learned[0].bands) {
        assert_eq!(direct.treatment, learned.treatment);
        assert!(
            !direct.is_by_surrogate
                && learned.is_by_surrogate
                && direct.ends.is_some()
                && direct.lower_si < direct.upper_si
        );
        let [lower, upper] = learned.ends.as_ref().expect("a band by a surrogate has the errors of its ends");
        for (end, value, of_direct, sign) in
            [(lower, learned.lower_si, direct.lower_si, -1.0), (upper, learned.upper_si, direct.upper_si, 1.0)]
        {
            assert!((value - of_direct).abs() < TOLERANCE_M + end.error.surrogate_si, "{learned:?} {direct:?}");
            assert!(sign * (end.widened_si - value) >= end.error.surrogate_si && end.error.surrogate_si < 1e-5);
        }
        let apart = (learned.coverage_minimum - direct.coverage_minimum).abs();
        assert!(apart <= learned.coverage_error + direct.coverage_error, "{learned:?} {direct:?}");
    }
}

#[test]
fn identity_learned_bounds_agree_with_direct_ones_from_few_runs() {
    // A slider moves with its rod by 0.92 of it: the bounds of the mean are 1.2 mm apart.
    const TOLERANCE_M: f64 = 2e-6; // sampling of 64 stratified runs of a scatter of 10 µm
    let result = conducted("surrogate = { training_runs = 40, confirming_runs = 16 }");
    let record = result.surrogate.as_ref().expect("a surrogate was asked for");
    assert_eq!(record.training_runs, 40);
    // Sixteen at each witness, and one at both ends of the interval-only band.
    assert!(record.confirming_runs > 2 && (record.confirming_runs - 2).is_multiple_of(16));
    assert_eq!((record.failed, record.direct_runs), (0, result.counts.runs - 40 - record.confirming_runs));
    for statistic in [Statistic::Mean, Statistic::Quantile(0.9)] {
        let [direct, learned] = both(&result, statistic);
        for (direct, learned) in [(&direct.lower, &learned.lower), (&direct.upper, &learned.upper)] {
            let apart = (direct.widened_si - learned.widened_si).abs();
            assert!(apart < TOLERANCE_M + learned.error.surrogate_si, "{statistic:?} {direct:?} {learned:?}");
        }
    }
    let [_, mean] = both(&result, Statistic::Mean);
    assert_ne!(mean.guarantee, Guarantee::Inner);
    let [_, deviation] = both(&result, Statistic::StandardDeviation);
    assert_eq!(deviation.guarantee, Guarantee::Inner);
    for bound in &record.bounds {
        for (end, sign) in [(&bound.lower, -1.0), (&bound.upper, 1.0)] {
            let error = end.error;
            assert!(error.sampling_si >= 0.0 && error.optimisation_si >= 0.0 && error.surrogate_si >= 0.0, "{bound:?}");
            assert!(sign * (end.widened_si - end.value_si) >= 0.0, "{bound:?}");
        }
    }
    let curve = record.outputs.iter().find(|output| output.at == ResponsePoint::Whole).expect("a curve is asked for");
    let along = curve.along.as_ref().expect("a curve has its error along the cycle");
    assert_eq!(along.held_out_si.len(), along.pose_rad.len());
    assert!(
        matches!(curve.verdict, Some(SurrogateVerdict::Falling | SurrogateVerdict::Resolved)),
        "{:?}",
        curve.verdict
    );
    let picture = curve.picture.as_ref().expect("what was learned is drawn");
    assert_eq!((picture.path.as_str(), picture.run_input_si.len()), ("parameter.rod_length", 40));
    treatments_agree(&result.treatments, &record.treatments);
    let page = study_page(&result);
    assert!(page.contains("Bounds by surrogate") && page.contains("data-figure=\"held-out."));
    assert!(page.contains("Share inside"));
    let text = study_text(&result);
    // Each table says which response it is of.
    let (_, of_surrogate) = text.split_once("Bounds by surrogate").expect("it is told beside the direct one");
    let lines: Vec<&str> = of_surrogate.lines().collect();
    let is_head = |line: &&str| line.starts_with("statistic") && line.contains("by surrogate");
    let head = lines.iter().position(is_head).expect("a table");
    assert!(lines[head - 2].starts_with("slider (") && lines[head - 2].ends_with("at 60°"), "{text}");
    let again = StudyResult::from_json(&result.to_json().expect("json")).expect("summary");
    assert_eq!(again.surrogate, result.surrogate);
}

/// Of cranks about as long that the rod does not reach, nearly half: nothing was learned of which.
#[test]
fn a_surrogate_alone_says_nothing_of_what_fails_and_ends_where_too_much_does() {
    let surrogate = "[surrogate]\nkind = \"chaos\"\ntraining_runs = 30\nconfirming_runs = 8\ndirect = \"confirming\"";
    let conducted = |most_failed: &str| {
        let text = text(surrogate)
            .replace(
                "mean = \"50 mm\", standard_deviation = \"0.02 mm\"",
                "mean = \"125.5 mm\", standard_deviation = \"1 mm\"",
            )
            .replace("replicates = 4", &format!("replicates = 4\n{most_failed}"));
        // Of the mechanisms that close none stays so near.
        let text = text
            + "[[require]]\noutput = \"slider\"\nof = \"dimensional\"\nwithin = \"1 um\"\nposes = { crank = [\"60 deg\"] }\n\
               probability_at_least = 0.95\n";
        let model = find_template("slider-crank").expect("template").model;
        // A dimension has one nominal value.
        let model = model.replace("crank_length = \"50 mm\"", "crank_length = \"125.5 mm\"");
        let model = Model::from_text("model.toml", &model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let study = Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        run_on(2, &study)
    };
    assert!(matches!(conducted(""), Err(StudyError::TooManyFailed(_))));
    let result = conducted("most_failed = 1").unwrap_or_else(|error| panic!("{error}")).result;
    let share = result.counts.failed as f64 / result.counts.runs as f64;
    assert!((0.2..0.8).contains(&share), "{share}");
    let of = |statistic: fn(Statistic) -> bool| {
        let bound = result.bounds.iter().find(|bound| statistic(bound.statistic)).expect("it is asked for");
        [bound.lower.widened_si, bound.upper.widened_si]
    };
    assert_eq!(of(Statistic::is_probability), [0.0, 1.0]);
    assert_eq!(of(|of| matches!(of, Statistic::Quantile(_))), [f64::NEG_INFINITY, f64::INFINITY]);
    assert_eq!(result.requirements[0].verdict, Verdict::Undecided);
    assert!(study_text(&result).contains("so probabilities and quantiles have no bounds"), "{}", study_text(&result));
}

#[test]
fn identity_a_surrogate_leaves_the_direct_bounds_as_they_are() {
    let with = conducted("[surrogate]\nkind = \"chaos\"\ntraining_runs = 12\nconfirming_runs = 8");
    let without = conducted("surrogate = \"none\"");
    assert_eq!(with.bounds, without.bounds);
    assert!(without.surrogate.is_none() && !study_text(&without).contains("surrogate"));
    assert!(with.surrogate.is_some_and(|record| record.outputs.iter().all(|output| output.problem.is_none())));
}

#[test]
fn identity_a_surrogate_alone_makes_no_other_runs_and_agrees_with_the_direct_bounds() {
    const TOLERANCE_M: f64 = 2e-6; // sampling of 64 stratified runs of a scatter of 10 µm
    let alone =
        conducted("[surrogate]\nkind = \"chaos\"\ntraining_runs = 30\nconfirming_runs = 8\ndirect = \"confirming\"");
    let direct = conducted("");
    let record = alone.surrogate.as_ref().expect("a surrogate was asked for");
    assert_eq!((alone.counts.runs, record.direct_runs), (30 + record.confirming_runs, 0));
    assert!(10 * alone.counts.runs < direct.counts.runs, "{} {}", alone.counts.runs, direct.counts.runs);
    assert!(alone.bounds.len() == direct.bounds.len() && alone.boxes.is_empty() && record.treatments.is_empty());
    treatments_agree(&direct.treatments, &alone.treatments);
    for (own, direct) in alone.bounds.iter().zip(&direct.bounds) {
        assert_eq!((own.at, own.statistic), (direct.at, direct.statistic));
        if own.statistic == Statistic::Mean {
            for (own, direct) in [(&own.lower, &direct.lower), (&own.upper, &direct.upper)] {
                let apart = (own.value_si - direct.value_si).abs();
                assert!(apart < TOLERANCE_M + own.error.surrogate_si, "{own:?} {direct:?}");
            }
        }
    }
    assert!(study_page(&alone).contains("to train a surrogate"));
    let text = study_text(&alone);
    assert!(text.contains("from 30 runs; held-out error") && !text.contains("NaN"), "{text}");
}

#[test]
fn identity_saved_surrogates_give_the_same_again_and_nothing_outside() {
    let study =
        study("[surrogate]\nkind = \"chaos\"\ntraining_runs = 30\nconfirming_runs = 8\ndirect = \"confirming\"")
            .unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let conducted = run_study(&study, "a1", &RunOptions::new(2, &Silent, &AtomicBool::new(false)))
        .unwrap_or_else(|error| panic!("{error}"));
    let saved = conducted.surrogates.expect("a surrogate was asked for");
    let text = surrogates_json(&saved).expect("json");
    let loaded = SavedSurrogates::from_json(&text).expect("what was written");
    assert_eq!((loaded.inputs.len(), loaded.input_hash.as_str()), (2, "a1"));
    let mut values: BTreeMap<String, f64> =
        [("parameter.crank_length".to_owned(), 0.05001), ("parameter.rod_length".to_owned(), 0.1203)].into();
    for output in 0..saved.outputs.len() {
        assert_eq!(saved.predict(output, &values), loaded.predict(output, &values));
        let quality = |saved: &SavedSurrogates| saved.outputs[output].surrogate.outputs()[0].quality.clone();
        assert_eq!(quality(&saved), quality(&loaded));
    }
    // Polynomials are not made of layers.
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("surrogates.json");
    std::fs::write(&file, &text).expect("a file");
    let error = export_networks(&file, &[], &folder.path().join("onnx"), false).expect_err("polynomials").to_string();
    assert!(
        error.contains(
            "surrogates.json: output 'slider dimensional' is learned by polynomial chaos; neural networks alone can be \
             written as ONNX\nhint: its coefficients stand in surrogates.json; or learn networks, kind = \"network\" under \
             [surrogate]"
        ),
        "{error}"
    );
    assert!(!folder.path().join("onnx").exists());
    values.insert("parameter.rod_length".to_owned(), 0.1215);
    let error = loaded.predict(0, &values).expect_err("beyond the interval").to_string();
    assert!(error.starts_with("'parameter.rod_length' is 0.1215 m; learned was from 0.1195 m to 0.1207 m"), "{error}");
    values.remove("parameter.rod_length");
    assert_eq!(
        loaded.predict(0, &values).expect_err("a value is missing").to_string(),
        "no value of 'parameter.rod_length'; the surrogates depend on it"
    );
    assert!(SavedSurrogates::from_json("{\"format\": 9}").is_err_and(|error| error.to_string().contains("format 9")));
}

#[test]
fn runs_that_cannot_be_spread_over_the_replicates_are_refused_at_their_place() {
    let study = study("[surrogate]\nconfirming_runs = 7").unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let error = run_on(2, &study).err().expect("7 runs in 4 replicates");
    assert_eq!(
        error.diagnostic(&study).to_string().lines().next().unwrap_or_default(),
        "study.toml:5:19: error[E0611]: surrogate: 7 confirming runs; must be a multiple of the 4 replicates, at least 2 in each, \
         and at most the 64 inner runs"
    );
}

#[test]
fn a_single_run_to_learn_from_is_refused_at_its_place() {
    let diagnostics = study("[surrogate]\ntraining_runs = 1").expect_err("one run is not enough");
    let diagnostic = diagnostics.to_string();
    assert!(
        diagnostic.starts_with(
            "study.toml:5:17: error[E0208]: surrogate training runs is 1; must be a whole number from 4 to 2000"
        ),
        "{diagnostic}"
    );
}

/// A surrogate that stands alone, from few runs, whose bounds of means are to be 0.03 µm near.
fn approached(budget: &str) -> Result<StudyResult, StudyError> {
    let text = "[surrogate]\nkind = \"kriging\"\ntraining_runs = 8\nconfirming_runs = 8\ndirect = \"confirming\"";
    let mut study = study(text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    study.add_accuracy("slider.mean = 0.03 um").unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    if !budget.is_empty() {
        study.set_budget(budget).unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    }
    run_on(2, &study).map(|conducted| conducted.result)
}

#[test]
fn identity_an_accuracy_adds_runs_to_a_surrogate_alone() {
    let reached = approached("").unwrap_or_else(|error| panic!("{error}"));
    let record = reached.accuracy.as_ref().expect("an accuracy was asked for");
    assert_eq!(record.stop, AccuracyStop::Reached, "{record:#?}");
    assert!(record.targets.len() == 2 && record.targets.iter().all(|target| target.reached_si <= 3e-8), "{record:#?}");
    let (first, last) = (record.steps[0], record.steps[record.steps.len() - 1]);
    assert!(first.training == 8 && first.share > 1.0 && last.share <= 1.0, "{record:#?}");
    assert!(last.training + last.confirming > first.training + first.confirming, "{record:#?}");
    assert_eq!((record.runs, record.rounds as usize), (reached.counts.runs, record.steps.len()));
    // The direct bounds of the mean lie within what is stated.
    let direct = conducted("");
    for (own, direct) in reached.bounds.iter().zip(&direct.bounds).filter(|(own, _)| own.statistic == Statistic::Mean) {
        assert!((own.lower.value_si - direct.lower.value_si).abs() < 3e-8 + direct.lower.error.sampling_si, "{own:?}");
        assert!((own.upper.value_si - direct.upper.value_si).abs() < 3e-8 + direct.upper.error.sampling_si, "{own:?}");
    }
    assert!(study_text(&reached).contains("All bounds reach the required accuracy after "));
    // As many rounds as a budget make the same runs again; one round says what is left.
    let again = approached(&format!("{} rounds", record.rounds)).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.bounds, reached.bounds);
    let one = approached("1 rounds").unwrap_or_else(|error| panic!("{error}"));
    let record = one.accuracy.as_ref().expect("an accuracy was asked for");
    assert_eq!((record.stop, record.rounds, record.steps.len()), (AccuracyStop::Budget, 1, 1));
    let text = study_text(&one);
    assert!(text.contains(", surrogate ") && text.contains("would exceed the budget of 1 round"), "{text}");
    let error = approached("50 runs").expect_err("eight runs to learn from, and eight at each of some bounds");
    // Ten ends of what is asked, eight of what is drawn of the curve and narrows it, and both extremes of a band.
    let least = 8 + 8 * 18 + 2;
    let expected = format!("a budget of 50 runs; the first round and what follows it take at most {least}");
    assert_eq!(error.to_string(), expected);
}
