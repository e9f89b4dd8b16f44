//! Runs at few distributions weighted for all others, from the study file to the page, against the closed form of a slider-crank
//! without play.

use std::sync::atomic::AtomicBool;

use loosepin::model::Model;
use loosepin::report::study_text;
use loosepin::study::result::StudyResult;
use loosepin::study::{Means, Progress, Study, conduct};
use loosepin::templates::find_template;

struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
}

const MM: f64 = 1e-3;
/// Ends of the mean and of the standard deviation of the crank's length, m.
const MEANS_M: [f64; 2] = [49.99 * MM, 50.02 * MM];
const DEVIATIONS_M: [f64; 2] = [0.004 * MM, 0.011 * MM];

fn conducted() -> StudyResult {
    let text = "name = \"what is known of the crank\"\nmodel = \"model.toml\"
        [cycle]
        transient_turns = 0
        recorded_turns = 0.2
        [sampling]
        outer = 16
        inner = 64
        replicates = 8
        [random]
        \"parameter.crank_length\" = { normal = { mean = { interval = [\"49.99 mm\", \"50.02 mm\"] }, \
         standard_deviation = { interval = [\"0.004 mm\", \"0.011 mm\"] } } }
        [[ask]]
        output = \"slider\"
        of = \"dimensional\"
        poses = { crank = [\"60 deg\"] }
        statistics = [\"mean\", \"standard_deviation\"]
        ";
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|complaints| panic!("{complaints}"));
    let study = Study::from_text("study.toml", text, model).unwrap_or_else(|complaints| panic!("{complaints}"));
    let stop = AtomicBool::new(false);
    let means = Means { threads: 2, progress: &Silent, stop: &stop, store: None };
    conduct(&study, "", &means).unwrap_or_else(|error| panic!("{error}")).result
}

/// Position of the slider at 60° for this length of the crank, m, the rod 120 mm, and its slope.
fn position(crank_m: f64) -> (f64, f64) {
    let (sine, cosine) = std::f64::consts::FRAC_PI_3.sin_cos();
    let along = ((120.0 * MM).powi(2) - (crank_m * sine).powi(2)).sqrt();
    (crank_m * cosine + along, cosine - crank_m * sine * sine / along)
}

#[test]
fn analytic_a_box_of_distributions_by_runs_at_few_of_them() {
    let weighted = conducted();
    // The response bends by 6 per metre: over 11 µm of scatter that moves mean and deviation by less than 1 nm.
    const BEND_M: f64 = 1e-9;
    // The ideal motion has the nominal crank of the model.
    let ideal = position(50.0 * MM).0;
    let exact = [
        MEANS_M.map(|crank| position(crank).0 - ideal),
        [0, 1].map(|end| DEVIATIONS_M[end] * position(MEANS_M[1 - end]).1),
    ];
    assert!((nominal - ideal).abs() > 1e-6, "a pose at which the crank matters");
    for result in [&weighted, &direct] {
        for (bound, exact) in result.bounds.iter().zip(exact) {
            assert!(
                bound.lower.widened_si <= exact[0] + BEND_M && bound.upper.widened_si >= exact[1] - BEND_M,
                "{bound:?}"
            );
            let width = bound.upper.widened_si - bound.lower.widened_si;
            assert!(width < 1.01 * (exact[1] - exact[0]), "{bound:?}");
        }
    }
    let told = weighted.reweighting.as_ref().expect("runs were weighted");
    assert!(told.is_used && told.points == 5 && told.unconfirmed == 0, "{told:?}");
    assert_eq!((weighted.counts.outer, weighted.counts.inner), (5, 64));
    let text = study_text(&weighted).split_whitespace().collect::<Vec<&str>>().join(" ");
    assert!(text.contains("Runs were made at 5 values of the"), "{text}");
    assert!(text.contains("polynomials that follow every run stand in between."), "{text}");
}
