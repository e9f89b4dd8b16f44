//! What is drawn inside of a band lies inside of it: on the pages of every case with a study and of some templates, with fewer samples
//! and poses. With `LOOSEPIN_WHOLE_STUDIES=1` in the environment the studies of all templates and cases are made as they are written, which
//! takes half an hour.

use std::path::Path;

use crate::silent::run;
use loosepin::model::Model;
use loosepin::study::Study;
use loosepin::study::result::{CurveRange, DeviationCurve, ProbabilityBox, StudyResult};
use loosepin::templates::TEMPLATES;

/// Templates whose studies take a second.
const FAST: [&str; 3] = ["slider-crank", "offset-slider-crank", "scotch-yoke"];

/// Name, model and study of every case that has one, and of templates.
fn studies(is_short: bool) -> Vec<(String, String, String)> {
    let chosen = TEMPLATES.iter().filter(|of| !is_short || FAST.contains(&of.name));
    let templates = chosen.map(|of| (of.name.to_owned(), of.model.to_owned(), of.study.to_owned())).collect::<Vec<_>>();
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let folders = std::fs::read_dir(cases).expect("the cases").map(|entry| entry.expect("a case").path());
    let with_study = folders.filter(|folder| folder.join("study.toml").exists());
    let of_case = with_study.map(|folder| {
        let read = |file: &str| std::fs::read_to_string(folder.join(file)).expect("a text");
        (folder.display().to_string(), read("model.toml"), read("study.toml"))
    });
    templates.into_iter().chain(of_case).collect()
}

/// The study of `text`, with as few samples and poses as `is_short` says.
fn conducted(name: &str, model: &str, text: &str, is_short: bool) -> StudyResult {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics}"));
    let study = Study::from_text("study.toml", text, model);
    let mut study = study.unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics}"));
    if is_short {
        // A box needs its corners and its centre.
        study.sampling.outer = 6.max((1 << study.epistemic.len()) + 1);
        study.sampling.inner = 64;
        study.cycle.transient_turns = 0.0;
        study.cycle.samples_per_turn = 12;
    }
    run(&study).result
}

/// How many places of `inner` are not within `outer`, and how many there are.
fn outside(inner: &CurveRange, outer: &CurveRange) -> (usize, usize) {
    assert_eq!(inner.lower_si.len(), outer.lower_si.len());
    let ends = (0..inner.lower_si.len()).map(|k| {
        let (lower, upper) = (inner.lower_si[k], inner.upper_si[k]);
        !(outer.lower_si[k] <= lower && lower <= upper && upper <= outer.upper_si[k])
    });
    let places = inner.lower_si.len();
    (ends.filter(|is_outside| *is_outside).count(), places)
}

fn check_curve(name: &str, curve: &DeviationCurve) {
    let (beyond, places) = outside(&curve.random, &curve.mixed);
    assert!(places > 1, "{name}: a curve without places");
    assert_eq!(beyond, 0, "{name}, {:?}: scatter alone lies outside of the band of all unknown values", curve.of);
    for each in &curve.at_values {
        assert_eq!(
            outside(&each.band, &curve.mixed).0,
            0,
            "{name}, {:?}: the band at {:?} lies outside",
            curve.of,
            each.at
        );
    }
    for each in curve.simultaneous.iter().filter(|each| !each.band.lower_si.is_empty()) {
        let pointwise = curve.probabilities[1] - curve.probabilities[0];
        if each.share >= pointwise {
            assert_eq!(
                outside(&curve.mixed, &each.band).0,
                0,
                "{name}: a point lies outside of the whole curve's band"
            );
        }
    }
}

/// Within the sampling error that the page states: the mixture is a sample of its own. What the search of a few points misses comes on top,
/// so that only whole studies are held to it.
fn check_box(name: &str, pbox: &ProbabilityBox) {
    assert_eq!(pbox.probability_only.len(), pbox.value_si.len(), "{name}");
    for (k, share) in pbox.probability_only.iter().enumerate() {
        let is_within =
            pbox.lower[k] - pbox.numerical_error <= *share && *share <= pbox.upper[k] + pbox.numerical_error;
        assert!(
            is_within,
            "{name}, {:?}: {share} at {}, not {} to {}",
            pbox.at, pbox.value_si[k], pbox.lower[k], pbox.upper[k]
        );
    }
}

#[test]
fn identity_inner_bands_lie_inside_of_outer_ones_on_every_page() {
    let is_short = std::env::var_os("LOOSEPIN_WHOLE_STUDIES").is_none();
    let studies = studies(is_short);
    let expected = if is_short { FAST.len() } else { TEMPLATES.len() };
    assert!(studies.len() > expected, "only {} studies", studies.len());
    let mut curves = 0;
    for (name, model, text) in &studies {
        let result = conducted(name, model, text, is_short);
        result.curves.iter().for_each(|curve| check_curve(name, curve));
        if !is_short {
            result.boxes.iter().for_each(|pbox| check_box(name, pbox));
        }
        curves += result.curves.len();
    }
    assert!(curves > expected, "only {curves} curves");
}

/// Readings and kinds of unknown inputs that no template has.
#[test]
fn identity_scatter_alone_lies_inside_whatever_is_known_of_the_inputs() {
    let inputs = |known: &str| {
        format!(
            "[random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"0.02 mm\" }} }}\n\
             [epistemic]\n\"parameter.rod_length\" = {known}\n"
        )
    };
    let interval = inputs("{ interval = [\"119.9 mm\", \"120.2 mm\"] }");
    let fuzzy = inputs("{ fuzzy = { triangular = [\"119.9 mm\", \"119.95 mm\", \"120.2 mm\"] } }");
    let list = inputs("{ any_of = [\"119.9 mm\", \"120.2 mm\"] }");
    let evidence = inputs(
        "{ evidence = [{ interval = [\"119.9 mm\", \"119.92 mm\"], mass = 0.97 }, { interval = [\"120.1 mm\", \"120.2 mm\"], mass = 0.03 }] }",
    );
    for (what, top, inputs, has_scatter) in [
        ("interval", "", &interval, true),
        ("random set", "reading = \"random-set\"\n", &interval, true),
        ("unknown distribution", "reading = \"unknown-distribution\"\n", &interval, true),
        ("fuzzy number", "", &fuzzy, true),
        ("list", "", &list, true),
        // One value has no part of the evidence, and its band is drawn nowhere.
        ("evidence", "", &evidence, false),
    ] {
        let text = format!(
            "name = \"{what}\"\nmodel = \"model.toml\"\n{top}[cycle]\ntransient_turns = 0\nsamples_per_turn = 12\n\
             [sampling]\nouter = 16\ninner = 64\n{inputs}[[ask]]\noutput = \"slider\"\nof = \"dimensional\"\nat = \"cycle\"\n\
             statistics = [\"mean\", {{ quantile = 0.025 }}, {{ quantile = 0.975 }}]\n"
        );
        let model = loosepin::templates::find_template("slider-crank").expect("a template").model;
        let result = conducted(what, model, &text, false);
        let [curve] = &result.curves[..] else { panic!("{what}: one curve is asked for") };
        // Of evidence the band of all values holds for shares of them, not at each.
        assert_eq!(curve.at_values.is_empty(), what == "evidence", "{what}");
        if has_scatter {
            check_curve(what, curve);
        } else {
            assert!(curve.random.lower_si.iter().all(|value| value.is_nan()), "{what}: {:?}", curve.random);
        }
    }
}
