//! Probability boxes, evidence and fuzzy numbers from the study file to bounds, files and page, against the closed form of a
//! slider-crank without play.

use crate::silent::run;
use loosepin::model::Model;
use loosepin::report::{study_page, study_text};
use loosepin::study::Study;
use loosepin::study::files::bounds_csv;
use loosepin::study::result::{BoundRecord, InputKind, Reading, StudyResult, WitnessValue};
use loosepin::templates::find_template;

const MM: f64 = 1e-3;
/// Of a mean over 16 stratified samples of a slider that scatters by 0.33 µm; the interval of the crank moves it by 4.9 µm.
const MEAN_TOLERANCE_M: f64 = 1.5e-7;

fn conducted(top: &str, inputs: &str) -> StudyResult {
    let poses = "poses = { crank = [\"60 deg\"] }
        statistics = [\"mean\", \"standard_deviation\", { probability_above = \"0.02 mm\" }, { quantile = 0.5 }]";
    conducted_at(top, 16, inputs, poses)
}

fn conducted_at(top: &str, inner: usize, inputs: &str, question: &str) -> StudyResult {
    let text = format!(
        "name = \"what is known\"\nmodel = \"model.toml\"\n{top}
        [cycle]
        transient_turns = 0
        recorded_turns = 0.2
        [sampling]
        outer = 16
        inner = {inner}
        replicates = 4
        {inputs}
        [[ask]]
        output = \"slider\"
        of = \"dimensional\"
        {question}
        "
    );
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    run(&study).result
}

/// Deviation of the slider at 60° for these lengths of crank and rod, m; the ideal motion has unknown inputs in the middle of
/// all that is possible.
fn deviation_m(crank_m: f64, rod_m: f64, middle_m: f64) -> f64 {
    let position = |crank: f64, rod: f64| {
        let angle_rad = std::f64::consts::FRAC_PI_3;
        let height = crank * angle_rad.sin();
        crank * angle_rad.cos() + (rod * rod - height * height).sqrt()
    };
    position(crank_m, rod_m) - position(50.0 * MM, middle_m)
}

fn near(bound: &BoundRecord, exact_m: [f64; 2]) {
    let found = [bound.lower.value_si, bound.upper.value_si];
    for (found, exact) in found.into_iter().zip(exact_m) {
        assert!((found - exact).abs() < MEAN_TOLERANCE_M, "{exact_m:?} {bound:?}");
    }
    assert!(bound.lower.widened_si <= found[0] && bound.upper.widened_si >= found[1]);
}

const CRANK_BOX: &str = "[random]\n\"parameter.crank_length\" = { normal = { mean = { interval = [\"49.99 mm\", \
                         \"50.02 mm\"] }, standard_deviation = \"0.002 mm\" } }";

#[test]
fn analytic_a_probability_box_from_file_to_page() {
    let result = conducted("", CRANK_BOX);
    near(&result.bounds[0], [deviation_m(49.99 * MM, 0.12, 0.12), deviation_m(50.02 * MM, 0.12, 0.12)]);
    let witness = &result.bounds[0].upper.witness["parameter.crank_length mean"];
    assert_eq!(*witness, WitnessValue::Number(0.05002));
    assert_eq!(
        result.inputs[0].words,
        "normal, mean 50.005 mm, standard deviation 0.002 mm; its mean unknown, between 49.99 mm and 50.02 mm"
    );
    assert!(study_page(&result).contains("parameter.crank_length mean"));
    assert!(study_text(&result).contains("crank length mean"), "{}", study_text(&result));
}

#[test]
fn analytic_evidence_beside_a_probability_box_from_file_to_page() {
    let evidence = "[epistemic]\n\"parameter.rod_length\" = { evidence = [{ interval = [\"119.98 mm\", \"120 mm\"], mass = \
                    0.3 }, { interval = [\"120 mm\", \"120.03 mm\"], mass = 0.7 }] }";
    let result = conducted("reading = \"unknown-distribution\"", &format!("{CRANK_BOX}\n{evidence}"));
    const MIDDLE_M: f64 = 120.005 * MM;
    let added = |crank_mm: f64, rods_mm: [f64; 2]| {
        let [first, second] = rods_mm.map(|rod_mm| deviation_m(crank_mm * MM, rod_mm * MM, MIDDLE_M));
        0.3 * first + 0.7 * second
    };
    near(&result.bounds[0], [added(49.99, [119.98, 120.0]), added(50.02, [120.0, 120.03])]);
    assert!(result.bounds[0].upper.witness.is_empty());
    assert_eq!(result.bounds[0].reading, Reading::UnknownDistribution);
    // The median inverts the added distribution functions: between the ends of the element that holds it.
    let median = &result.bounds[3];
    let ends = [deviation_m(49.99 * MM, 0.12, MIDDLE_M), deviation_m(50.02 * MM, 120.03 * MM, MIDDLE_M)];
    let tolerance_m = 0.001 * MM; // three standard deviations of the scatter
    assert!((median.lower.value_si - ends[0]).abs() < tolerance_m, "{median:?}");
    assert!((median.upper.value_si - ends[1]).abs() < tolerance_m, "{median:?}");
    let rod = result.inputs.iter().find(|input| input.path == "parameter.rod_length").expect("an input");
    assert!(matches!(&rod.kind, InputKind::Evidence { elements, is_scattering: false } if elements.len() == 2));
    let page = study_page(&result);
    assert!(page.contains("A bound from evidence adds the masses") && page.contains("with mass 0.3"));
}

#[test]
fn analytic_several_readings_stand_side_by_side() {
    let crank = CRANK_BOX.replace("{ interval = [\"49.99 mm\", \"50.02 mm\"] }", "\"50 mm\"");
    let inputs = crank + "\n[epistemic]\n\"parameter.rod_length\" = { interval = [\"119.98 mm\", \"120.02 mm\"] }";
    let both = conducted("reading = [\"fixed\", \"unknown-distribution\"]", &inputs);
    let alone = conducted("", &inputs);
    assert_eq!(both.bounds[..4], alone.bounds[..]);
    assert!(both.bounds[4..].iter().all(|bound| bound.reading == Reading::UnknownDistribution));
    for (fixed, other) in both.bounds[..4].iter().zip(&both.bounds[4..]) {
        assert_eq!((fixed.statistic, fixed.at), (other.statistic, other.at));
        assert_eq!(fixed.lower.value_si, other.lower.value_si, "only the upper end of a deviation differs");
    }
    // Half of the mechanisms at either end of the rod's interval, Δ apart: variance σ² + (Δ/2)².
    let [short, long] = [119.98, 120.02].map(|rod_mm| deviation_m(0.05, rod_mm * MM, 0.12));
    let (fixed, other) = (&both.bounds[1].upper, &both.bounds[5].upper);
    let exact_m = fixed.value_si.hypot(0.5 * (long - short));
    const TOLERANCE_M: f64 = 1e-3 * MM; // the scatter itself: 16 samples tell it to a tenth
    assert!((other.value_si - exact_m).abs() < TOLERANCE_M && other.widened_si >= exact_m, "{exact_m} {other:?}");
    let page = study_page(&both);
    assert!(page.contains("reading A2") && study_text(&both).contains("reading A2"));
    assert!(!study_text(&alone).contains("reading A)"));
}

#[test]
fn analytic_a_curve_of_one_random_length_moves_as_a_whole() {
    // The deviation at every pose is a multiple of that of the crank's length, to 1e-4 of it: whoever stays inside at one pose stays
    // inside at all, so that the band for the whole cycle is that for each pose, but for order statistics of 256 runs at a
    // confidence of 99 %.
    let question = "at = \"cycle\"\nstatistics = [\"mean\", { simultaneous_band = 0.9 }]";
    let crank = CRANK_BOX.replace("{ interval = [\"49.99 mm\", \"50.02 mm\"] }", "\"50 mm\"");
    let result = conducted_at("", 256, &crank, question);
    let curve = &result.curves[0];
    let band = &curve.simultaneous[0];
    const MAX_FACTOR: f64 = 1.2;
    assert!(band.share == 0.9 && band.factor >= 1.0 && band.factor < MAX_FACTOR, "{band:?}");
    assert_eq!(band.band.lower_si.len(), curve.pose_rad.len());
    let rows: Vec<&BoundRecord> =
        result.bounds.iter().filter(|bound| bound.statistic.word() == "simultaneous_band").collect();
    assert_eq!(rows.len(), curve.pose_rad.len());
    assert!(rows.iter().zip(&band.band.upper_si).all(|(row, upper)| row.upper.widened_si == *upper));
    let csv = String::from_utf8(bounds_csv(&result).expect("CSV")).expect("UTF-8");
    assert_eq!(csv.lines().filter(|line| line.contains(",simultaneous_band,0.9,")).count(), rows.len());
    assert!(study_page(&result).contains("stay between the dashed lines for the whole cycle"));
}

#[test]
fn analytic_a_parameter_with_a_distribution_from_file_to_page() {
    // The mean of the rod's length is normal: to 1e-9 of the range the mean of the slider is linear in it.
    let rod = "\"parameter.rod_length\" = { normal = { mean = { normal = { mean = \"120 mm\", standard_deviation = \"0.01 mm\" } }, \
               standard_deviation = \"0.001 mm\" } }";
    let result = conducted("percentiles = [0.1, 0.9]", &format!("[random]\n{rod}"));
    let standard_normal = 1.281_551_565_544_6;
    let percentiles: Vec<f64> = result.percentiles.iter().map(|each| each.percentile).collect();
    assert_eq!(percentiles, [0.1, 0.9]);
    for (each, sign) in result.percentiles.iter().zip([-1.0, 1.0]) {
        let exact_m = deviation_m(0.05, (120.0 + sign * 0.01 * standard_normal) * MM, 0.12);
        let mean = &each.bounds[0];
        assert!(mean.lower.widened_si <= exact_m && exact_m <= mean.upper.widened_si, "{exact_m}: {mean:?}");
        // A twentieth of the deviation of the mean, 0.01 mm, by 2048 values of it and 16 runs at each of 16.
        const TOLERANCE_M: f64 = 5e-4 * MM;
        assert!((mean.lower.value_si - exact_m).abs() < TOLERANCE_M, "{exact_m}: {mean:?}");
        assert!(mean.lower.witness.is_empty() && each.bounds.len() == result.bounds.len());
    }
    assert!(matches!(result.inputs[1].kind, InputKind::SecondOrder { .. }), "{:?}", result.inputs);
    let csv = String::from_utf8(bounds_csv(&result).expect("CSV")).expect("UTF-8");
    assert_eq!(csv.lines().filter(|line| line.contains(",0.9,sampled")).count(), result.bounds.len());
    let page = study_page(&result);
    assert!(page.contains("Percentiles of the statistics") && page.contains("percentile"));
    assert!(study_text(&result).contains("percentile"), "{}", study_text(&result));
    let stored = serde_json::to_string(&result).expect("JSON");
    assert_eq!(serde_json::from_str::<StudyResult>(&stored).expect("a result"), result);
}

#[test]
fn analytic_a_fuzzy_number_from_file_to_page() {
    let fuzzy = "\n[epistemic]\n\"parameter.rod_length\" = { fuzzy = { triangular = [\"119.97 mm\", \"120 mm\", \"120.05 mm\"] } }";
    let crank = CRANK_BOX.replace("{ interval = [\"49.99 mm\", \"50.02 mm\"] }", "\"50 mm\"");
    let result = conducted("", &(crank + fuzzy));
    let degrees: Vec<f64> = result.cuts.iter().map(|cut| cut.alpha).collect();
    assert_eq!(degrees, [0.0, 0.25, 0.5, 0.75, 1.0]);
    for cut in &result.cuts {
        let rods_mm = [119.97 + 0.03 * cut.alpha, 120.05 - 0.05 * cut.alpha];
        near(&cut.bounds[0], rods_mm.map(|rod_mm| deviation_m(0.05, rod_mm * MM, 120.01 * MM)));
    }
    assert_eq!(result.cuts[0].bounds, result.bounds);
    let csv = String::from_utf8(bounds_csv(&result).expect("CSV")).expect("UTF-8");
    assert!(csv.lines().next().is_some_and(|header| header.ends_with(",guarantee,alpha")));
    assert_eq!(csv.lines().filter(|line| line.ends_with(",0.75")).count(), result.bounds.len());
    let page = study_page(&result);
    assert!(page.contains("Bounds by degree of possibility") && page.contains("Degree 0.75"));
    let stored = serde_json::to_string(&result).expect("JSON");
    assert_eq!(serde_json::from_str::<StudyResult>(&stored).expect("a result"), result);
}
