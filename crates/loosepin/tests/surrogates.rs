//! Surrogates from the study file to files and page, beside the direct bounds of the same study.

use std::sync::atomic::AtomicBool;

use loosepin::model::Model;
use loosepin::report::{study_page, study_text};
use loosepin::study::files::{read_json, to_json};
use loosepin::study::result::{
    BoundRecord, GuaranteeKind, ResponsePoint, StatisticKind, StudyResult, SurrogateVerdict,
};
use loosepin::study::{Means, Progress, Study, conduct};
use loosepin::templates::find_template;

struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
}

const OUTER: usize = 24;
const INNER: usize = 64;

/// A slider-crank without play: crank and rod scatter, of the rod the mean is known within an interval, and of the foot of the crank a position.
fn study(surrogate: &str) -> Result<Study, String> {
    let text = format!(
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
    );
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|complaints| panic!("{complaints}"));
    Study::from_text("study.toml", &text, model).map_err(|complaints| complaints.to_string())
}

fn conducted(surrogate: &str) -> StudyResult {
    let study = study(surrogate).unwrap_or_else(|complaints| panic!("{complaints}"));
    conduct(&study, "", &Means { threads: 2, progress: &Silent, stop: &AtomicBool::new(false), store: None })
        .unwrap_or_else(|error| panic!("{error}"))
        .result
}

/// The direct and the learned bound of a statistic at the pose.
fn both(result: &StudyResult, statistic: StatisticKind) -> [&BoundRecord; 2] {
    let learned = &result.surrogate.as_ref().expect("a surrogate was asked for").bounds;
    [&result.bounds, learned].map(|bounds| {
        let own = |bound: &&BoundRecord| bound.statistic == statistic && matches!(bound.at, ResponsePoint::Pose { .. });
        bounds.iter().find(own).expect("the statistic is asked")
    })
}

#[test]
fn identity_learned_bounds_agree_with_direct_ones_from_few_runs() {
    // A slider moves with its rod by 0.92 of it: the bounds of the mean are 1.2 mm apart.
    const TOLERANCE_M: f64 = 2e-6; // sampling of 64 stratified runs of a scatter of 10 µm
    let result = conducted("surrogate = { training_runs = 40, confirming_runs = 16 }");
    let record = result.surrogate.as_ref().expect("a surrogate was asked for");
    assert_eq!(record.training_runs, 40);
    assert!(record.confirming_runs > 0 && record.confirming_runs.is_multiple_of(16));
    assert_eq!((record.failed, record.direct_runs), (0, result.counts.runs - 40 - record.confirming_runs));
    for statistic in [StatisticKind::Mean, StatisticKind::Quantile { probability: 0.9 }] {
        let [direct, learned] = both(&result, statistic);
        for (direct, learned) in [(&direct.lower, &learned.lower), (&direct.upper, &learned.upper)] {
            let apart = (direct.widened_si - learned.widened_si).abs();
            assert!(apart < TOLERANCE_M + learned.error.surrogate_si, "{statistic:?} {direct:?} {learned:?}");
        }
    }
    let [_, mean] = both(&result, StatisticKind::Mean);
    assert_ne!(mean.guarantee, GuaranteeKind::Inner);
    let [_, deviation] = both(&result, StatisticKind::StandardDeviation);
    assert_eq!(deviation.guarantee, GuaranteeKind::Inner);
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
    let page = study_page(&result);
    assert!(page.contains("The same by surrogate") && page.contains("held-out-0"));
    let text = study_text(&result);
    assert!(text.contains("The same by surrogate") && text.contains("by surrogate"), "{text}");
    let again: StudyResult = read_json("summary.json", &to_json(&result).expect("json")).expect("summary");
    assert_eq!(again.surrogate, result.surrogate);
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
fn runs_that_cannot_be_spread_over_the_replicates_are_refused_at_their_place() {
    let study = study("[surrogate]\nconfirming_runs = 7").unwrap_or_else(|complaints| panic!("{complaints}"));
    let error =
        conduct(&study, "", &Means { threads: 2, progress: &Silent, stop: &AtomicBool::new(false), store: None })
            .err()
            .expect("7 runs in 4 replicates");
    assert_eq!(error.complaint(&study).to_string().lines().next().unwrap_or_default(), "");
}
