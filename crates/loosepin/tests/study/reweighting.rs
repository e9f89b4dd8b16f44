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
/// Ends of the mean and of the standard deviation of the crank's length, m. It is longer than the nominal one in all runs, so that the
/// greatest error of the cycle, which every study reports, is as smooth as the error itself: of rough responses the tails take runs.
const MEANS_M: [f64; 2] = [50.97 * MM, 51.05 * MM];
const DEVIATIONS_M: [f64; 2] = [0.04 * MM, 0.11 * MM];

fn conducted() -> StudyResult {
    let text = "name = \"what is known of the crank\"\nmodel = \"model.toml\"
        [cycle]
        transient_turns = 0
        recorded_turns = 0.17
        [sampling]
        outer = 64
        inner = 256
        replicates = 8
        reweighting = \"always\"
        [random]
        \"parameter.crank_length\" = { normal = { mean = { interval = [\"50.97 mm\", \"51.05 mm\"] }, \
         standard_deviation = { interval = [\"0.04 mm\", \"0.11 mm\"] } } }
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

/// Position of the slider at 60° for this length of the crank, m, the rod 120 mm.
fn position_m(crank_m: f64) -> f64 {
    let (sine, cosine) = std::f64::consts::FRAC_PI_3.sin_cos();
    crank_m * cosine + ((120.0 * MM).powi(2) - (crank_m * sine).powi(2)).sqrt()
}

/// Mean and standard deviation of the position, m, by the trapezoidal rule over 12 deviations, whose error is round-off.
fn moments_m(mean_m: f64, deviation_m: f64) -> [f64; 2] {
    const STEPS: i32 = 600;
    let at = |k: i32| 0.02 * f64::from(k);
    let weight = |z: f64| (-0.5 * z * z).exp();
    let sum = |of: &dyn Fn(f64) -> f64| (-STEPS / 2..=STEPS / 2).map(|k| weight(at(k)) * of(at(k))).sum::<f64>();
    let position = |z: f64| position_m(mean_m + deviation_m * z);
    let mean = sum(&position) / sum(&|_| 1.0);
    let square = |z: f64| (position(z) - mean) * (position(z) - mean);
    [mean, (sum(&square) / sum(&|_| 1.0)).sqrt()]
}

#[test]
fn analytic_a_box_of_distributions_by_runs_at_few_of_them() {
    // Runs are accurate to 1e-8 m each.
    const RUNS_M: f64 = 1e-8;
    let weighted = conducted();
    // The ideal motion has the nominal crank of the model. The slope falls with the crank, so that it is steepest where the crank is
    // shortest.
    let ideal = position_m(50.0 * MM);
    let (short, long) = (moments_m(MEANS_M[0], DEVIATIONS_M[1]), moments_m(MEANS_M[1], DEVIATIONS_M[0]));
    let exact = [[short[0] - ideal, long[0] - ideal], [long[1], short[1]]];
    for (bound, exact) in weighted.bounds.iter().zip(exact) {
        let [lower, upper] = [bound.lower.widened_si, bound.upper.widened_si];
        assert!(lower <= exact[0] + RUNS_M && upper >= exact[1] - RUNS_M, "{exact:?} {bound:?}");
        assert!(upper - lower < 1.01 * (exact[1] - exact[0]), "{exact:?} {bound:?}");
    }
    let told = weighted.reweighting.as_ref().expect("runs were weighted");
    // A quarter of the values that the search may look at.
    assert!(told.is_used && told.points <= 16 && told.polynomials > 0, "{told:?}");
    let text = study_text(&weighted).split_whitespace().collect::<Vec<&str>>().join(" ");
    assert!(text.contains(&format!("Runs were made at {} values of the", told.points)), "{text}");
}
