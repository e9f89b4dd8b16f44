//! Study files that are right, the templates, and what editors are told about both kinds of file.

use std::path::Path;

use loosepin::bounds::Statistic;
use loosepin::model::{Model, model_schema};
use loosepin::study::{Asked, Deviation, Limit, Reduction, Study, Where, study_schema};
use loosepin::templates::{TEMPLATES, find_template};
use loosepin::uncertainty::Distribution;

fn template(name: &str) -> Study {
    let template = find_template(name).unwrap_or_else(|| panic!("no template {name}"));
    let model = Model::from_text("model.toml", template.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", template.study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

#[test]
fn templates_load_without_diagnostics() {
    for each in TEMPLATES {
        let study = template(each.name);
        assert!(study.warnings.is_empty(), "{}: {:?}", each.name, study.warnings);
    }
}

#[test]
fn templates_load_from_their_folder() {
    for each in TEMPLATES {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../loosepin-import/templates").join(each.name);
        let study = Study::from_path(&folder.join("study.toml")).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        assert_eq!(study.model_path, folder.join("model.toml"));
        assert_eq!(study.model.source().text(), each.model);
    }
}

#[test]
fn a_study_is_read_in_file_order_and_si() {
    let study = template("slider-crank");
    assert_eq!((study.seed, study.sampling.outer, study.sampling.inner), (1, 16, 256));
    assert_eq!(
        (study.cycle.transient_turns, study.cycle.recorded_turns, study.cycle.samples_per_turn),
        (2.0, 1.0, 180)
    );
    let paths: Vec<&str> = study.random.iter().map(|input| input.path.as_str()).collect();
    assert_eq!(paths, ["parameter.crank_length", "parameter.rod_length"]);
    assert_eq!(*study.random[1].variable.distribution(), Distribution::Normal { mean: 0.12, standard_deviation: 3e-5 });
    assert_eq!(study.epistemic[0].path, "joint.gudgeon.radial_clearance");
    assert_eq!(study.epistemic[0].variable.ends(), [1e-4, 5e-4]);
    assert_eq!(study.asks[0].location, Where::Cycle);
    assert_eq!(study.asks[0].asked[3], Asked::Statistic(Statistic::Quantile(0.975)));
    assert_eq!(study.asks[1].location, Where::reduced(Reduction::MaximumAbsolute));
    assert_eq!(study.asks[1].asked[2], Asked::Statistic(Statistic::ProbabilityAbove(6e-4)));
    assert_eq!(study.requirements[0].deviation, Deviation::Total);
    assert_eq!((study.requirements[0].limit, study.requirements[0].probability_at_least), (Limit::Within(6e-4), 0.95));
}

#[test]
fn poses_and_limits_of_angles_are_in_radians() {
    let study = template("four-bar");
    let Some(angles_rad) = study.asks[1].location.angles_rad() else { panic!("poses") };
    assert_eq!(study.model.cycle_input(&study.model.quantities().nominal()).name, "crank");
    assert_eq!(*angles_rad, [60_f64.to_radians(), 240_f64.to_radians()]);
    assert_eq!(study.asks[1].asked[1], Asked::Statistic(Statistic::ProbabilityBeyond(0.1_f64.to_radians())));
}

#[test]
fn a_small_probability_of_a_curve_is_that_of_its_furthest_value() {
    let study = |ask: &str| {
        let text = format!(
            "name = \"rare\"\nmodel = \"model.toml\"\n[random]\n\"parameter.crank_length\" = {{ normal = {{ mean = \"50 mm\", \
             standard_deviation = \"0.02 mm\" }} }}\n{ask}"
        );
        let model = template("slider-crank").model;
        Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}")).asks
    };
    let head = "[[ask]]\noutput = \"slider\"\nof = \"total\"\n";
    let rare = |side: &str| format!("{{ {side} = \"0.1 mm\", method = \"importance\" }}");
    let [above, below, beyond] = ["probability_above", "probability_below", "probability_beyond"].map(rare);
    let curve = study(&format!("{head}at = \"cycle\"\nstatistics = [\"mean\", {above}, {below}, {beyond}]\n"));
    let each = study(&format!(
        "{head}at = \"cycle\"\nstatistics = [\"mean\"]\n{head}reduce = \"maximum\"\nstatistics = [{above}]\n\
         {head}reduce = \"minimum\"\nstatistics = [{below}]\n{head}reduce = \"maximum_absolute\"\nstatistics = [{beyond}]\n"
    ));
    assert_eq!(curve, each);
    assert_eq!(study(&format!("{head}at = \"cycle\"\nstatistics = [{above}]\n")), each[1..2]);
}

#[test]
fn every_family_of_distributions_is_read() {
    let model = find_template("slider-crank").expect("template").model;
    let study = r#"
        name = "families"
        model = "model.toml"
        random."parameter.crank_length".truncated_normal = { mean = "50 mm", standard_deviation = "20 µm", lower = "49.95 mm", upper = "50.05 mm" }
        random."parameter.rod_length" = { uniform = { lower = "119.9 mm", upper = "120.1 mm" } }
        random."contact.steel_pin.restitution" = { beta = { alpha = 2, beta = 3.5, lower = 0.7, upper = 0.9 } }
        random."joint.gudgeon.radial_clearance" = { lognormal = { mean = "0.3 mm", standard_deviation = "0.05 mm" } }
        random."body.rod.mass" = { triangular = { lower = "200 g", mode = "210 g", upper = "230 g" } }
        [[ask]]
        output = "slider"
        of = "value"
        reduce = "range"
        statistics = ["mean"]
    "#;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let study = Study::from_text("study.toml", study, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let families: Vec<&str> = study.random.iter().map(|input| input.variable.distribution().family()).collect();
    assert_eq!(families, ["truncated normal", "uniform", "beta", "lognormal", "triangular"]);
    assert_eq!((study.seed, study.sampling.outer, study.sampling.inner, study.sampling.replicates), (1, 64, 256, 4));
}

/// A study of the slider-crank with these lines before its question.
fn study_with(lines: &str) -> Study {
    let model = find_template("slider-crank").expect("template").model;
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let ask = "[[ask]]\noutput = \"slider\"\nof = \"value\"\nreduce = \"range\"\nstatistics = [\"mean\"]\n";
    let text = format!("name = \"further\"\nmodel = \"model.toml\"\n{lines}\n{ask}");
    Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

/// The only random input: its mean, its standard deviation, and where it comes from.
fn only_input(statement: &str) -> (f64, f64, String) {
    let study = study_with(&format!("[random]\n{statement}"));
    let input = &study.random[0];
    (input.variable.mean(), input.variable.standard_deviation(), input.origin.clone().unwrap_or_default())
}

#[test]
fn analytic_tolerances_are_normal_distributions() {
    const RELATIVE_TOLERANCE: f64 = 1e-12; // round-off of millimetres in metres
    for (written, mean, deviation, words) in [
        ("tolerance = \"50 ± 0.06 mm\"", 0.05, 2e-5, "limits taken as 3 standard deviations from a centred mean"),
        ("tolerance = \"50 ± 0.06 mm\", cpk = 1.25", 0.05, 1.6e-5, "Cpk 1.25, taken as centred"),
        ("tolerance = \"50 ± 0.06 mm\", cp = 1.25", 0.05, 1.6e-5, "Cp 1.25, taken as centred since no Cpk is given"),
        ("tolerance = \"50 +0.09 -0.03 mm\", cp = 2, cpk = 2", 0.05003, 1e-5, "Cp 2, Cpk 2, centred"),
    ] {
        let found = only_input(&format!("\"parameter.crank_length\" = {{ {written} }}"));
        assert!((found.0 / mean - 1.0).abs() < RELATIVE_TOLERANCE, "{written}: {found:?}");
        assert!((found.1 / deviation - 1.0).abs() < RELATIVE_TOLERANCE, "{written}: {found:?}");
        assert!(found.2.ends_with(words), "{written}: {found:?}");
    }
}

#[test]
fn analytic_what_names_no_nominal_value_follows_the_model() {
    const ROUND_OFF_M: f64 = 1e-15;
    for (written, deviation) in [
        ("tolerance = \"± 0.06 mm\"", 2e-5),
        ("normal = { standard_deviation = \"0.02 mm\" }", 2e-5),
        ("lognormal = { standard_deviation = \"0.02 mm\" }", 2e-5),
    ] {
        let (mean, found, _) = only_input(&format!("\"parameter.crank_length\" = {{ {written} }}"));
        assert!(
            (mean - 0.05).abs() < ROUND_OFF_M && (found - deviation).abs() < ROUND_OFF_M,
            "{written}: {mean} {found}"
        );
    }
}

/// A study of the slider-crank that requires this share, with these keys under [sampling].
fn required(share: f64, sampling: &str) -> (usize, String) {
    let study = study_with(&format!(
        "[sampling]\n{sampling}\n[random]\n\"parameter.crank_length\" = {{ tolerance = \"± 0.06 mm\" }}\n[[require]]\n\
         output = \"slider\"\nof = \"total\"\nwithin = \"1 mm\"\nover = \"cycle\"\nprobability_at_least = {share}\n"
    ));
    let warnings: Vec<String> = study.warnings.iter().map(ToString::to_string).collect();
    (study.sampling.inner, warnings.join("\n"))
}

#[test]
fn analytic_inner_is_as_large_as_a_required_share_needs() {
    // 0.9973^1959 > 0.005 > 0.9973^1960: the limit of Clopper and Pearson for none of so many.
    assert!(0.9973_f64.powi(1959) > 0.005 && 0.9973_f64.powi(1960) < 0.005);
    assert_eq!(required(0.9973, ""), (2048, String::new()));
    assert_eq!(required(0.95, ""), (256, String::new()));
    assert_eq!(required(0.9973, "inner = 1960"), (1960, String::new()));
    assert_eq!(required(0.9973, "budget = \"1 min\"").1, "", "a budget limits the samples on purpose");
    let (inner, warnings) = required(0.9973, "inner = 1959");
    assert_eq!(inner, 1959, "what is written is kept");
    assert_eq!(
        warnings,
        "study.toml:12:24: warning[E0617]: [[require]] 1: probability at least is 0.9973; 1959 runs at each value can refute it, and \
         show it only where the output is smooth in the random inputs: by counting it takes 1960\nhint: write inner = 2048 under \
         [sampling], or leave inner out"
    );
    let (inner, warnings) = required(0.999999, "");
    assert_eq!(inner, 256, "five million runs at each value are somebody's decision");
    assert!(
        warnings.contains("by counting it takes 5298315\nhint: write inner = 8388608 under [sampling], or require a"),
        "{warnings}"
    );
}

#[test]
fn analytic_a_process_off_centre_has_an_interval_of_means() {
    const ROUND_OFF_M: f64 = 1e-16;
    let study = study_with(
        "[random]\n\"parameter.crank_length\" = { tolerance = \"50 ± 0.06 mm\", cp = 1.6, cpk = 1.25, truncated = { lower = \"49.9 mm\" } }",
    );
    // Standard deviation 60 µm/(3 · 1.6) = 12.5 µm; shift 0.35 · 37.5 µm = 13.125 µm.
    let mean = &study.epistemic[0];
    assert_eq!(mean.path, "parameter.crank_length mean");
    for (end, expected) in mean.variable.ends().into_iter().zip([0.049_986_875, 0.050_013_125]) {
        assert!((end - expected).abs() < ROUND_OFF_M, "{end}");
    }
    let moved = study.random[0].variables(&study.epistemic, |known| known.ends().to_vec());
    assert!((moved[1].mean() - moved[0].mean() - 26.25e-6).abs() < 1e-12, "{moved:?}");
    assert!((study.random[0].variable.standard_deviation() - 12.5e-6).abs() < 1e-12);
    let words = study.random[0].origin.clone().unwrap_or_default();
    assert_eq!(words, "50 ± 0.06 mm, Cp 1.6, Cpk 1.25, the mean off centre by an unknown amount, to either side");
}

#[test]
fn analytic_a_fit_is_an_interval_or_a_distribution() {
    // 20 H7/g6: hole 0 to 21 µm, shaft -20 to -7 µm.
    const RELATIVE_TOLERANCE: f64 = 1e-12;
    let fit = "\"joint.gudgeon.radial_clearance\" = { fit = \"H7/g6\", diameter = \"20 mm\" }";
    let study = study_with(&format!("[epistemic]\n{fit}"));
    for (end, expected) in study.epistemic[0].variable.ends().into_iter().zip([3.5e-6, 20.5e-6]) {
        assert!((end / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{end}");
    }
    let (mean, deviation, words) = only_input(fit);
    let expected = 0.5 * (3.5e-6_f64.powi(2) + (13e-6_f64 / 6.0).powi(2)).sqrt();
    assert!((mean / 12e-6 - 1.0).abs() < RELATIVE_TOLERANCE, "{mean}");
    assert!((deviation / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{deviation}");
    assert_eq!(words, "fit H7/g6 at 20 mm, limits of hole and shaft taken as 3 standard deviations from centred means");
}

#[test]
fn analytic_samples_are_taken_as_they_are_or_fitted() {
    const ROUND_OFF_M: f64 = 1e-15;
    let sample = |more: &str| {
        only_input(&format!(
            "\"parameter.crank_length\" = {{ samples = \"tests/files/measured_cranks.csv\", column = \"crank\"{more} }}"
        ))
    };
    // 50.01, 49.99, 50.02, 50.00, 49.98, 50.03 mm; one cell is empty.
    let (mean, deviation, words) = sample("");
    assert!((mean - 0.050005).abs() < ROUND_OFF_M, "{mean}");
    let squares = [5.0, 15.0, 15.0, 5.0, 25.0, 25.0].map(|off: f64| off * off * 1e-12).iter().sum::<f64>();
    assert!((deviation - (squares / 6.0).sqrt()).abs() < ROUND_OFF_M, "{deviation}");
    assert_eq!(words, "values of 'crank' in tests/files/measured_cranks.csv");
    let (mean, deviation, words) = sample(", fitted = \"normal\"");
    assert!((mean - 0.050005).abs() < ROUND_OFF_M && (deviation - (squares / 5.0).sqrt()).abs() < ROUND_OFF_M);
    assert!(
        words.starts_with("fitted (mean, standard deviation with n - 1; Kolmogorov-Smirnov distance 0."),
        "{words}"
    );
    assert!(words.ends_with(" to 6 values of 'crank' in tests/files/measured_cranks.csv"), "{words}");
}

#[test]
fn the_tables_of_a_study_are_among_its_inputs() {
    let study = study_with(
        "[random]\n\"parameter.crank_length\" = { samples = \"tests/files/measured_cranks.csv\", column = \"crank\" }",
    );
    let text = std::fs::read_to_string("tests/files/measured_cranks.csv").expect("the table");
    assert_eq!(study.tables().iter().map(|table| table.text()).collect::<Vec<_>>(), [text]);
}

#[test]
fn analytic_what_is_cut_stays_within() {
    let study = study_with(
        "[random]\n\"contact.steel_pin.restitution\" = { normal = { mean = 0.97, standard_deviation = 0.05 }, truncated = { upper = 1 } }",
    );
    let variable = &study.random[0].variable;
    assert!(variable.quantile(1.0) == 1.0 && variable.at_standard_normal(9.0) <= 1.0);
    // Φ(0.6) = 0.725747: the median lies at Φ⁻¹(0.362873).
    assert!((variable.quantile(0.5) - (0.97 - 0.05 * 0.350_9)).abs() < 1e-5, "{}", variable.quantile(0.5));
}

#[test]
fn analytic_correlations_become_those_of_normal_variables() {
    const ROUND_OFF: f64 = 1e-9;
    let study = study_with(
        "[random]\n\"parameter.crank_length\" = { tolerance = \"50 ± 0.06 mm\" }\n\
         \"parameter.rod_length\" = { tolerance = \"120 ± 0.06 mm\" }\n\
         \"body.rod.mass\" = { lognormal = { mean = \"0.2 kg\", standard_deviation = \"50 g\" } }\n\
         [[correlation]]\nof = [\"parameter.rod_length\", \"parameter.crank_length\"]\nrank = 0.5\n\
         [[correlation]]\nof = [\"parameter.rod_length\", \"body.rod.mass\"]\nlinear = 0.4",
    );
    let correlation = study.correlation.as_ref().expect("correlations");
    // 2 sin(π/12); and Cov(Z, exp(σ Z')) = r σ E: r = 0.4 √(e^σ² - 1)/σ with σ² = ln(1 + 1/16).
    let sigma = (1.0_f64 / 16.0).ln_1p().sqrt();
    for (stated, expected) in correlation.stated.iter().zip([(6.0_f64.sqrt() - 2.0_f64.sqrt()) / 2.0, 0.1 / sigma]) {
        assert!((stated.normal - expected).abs() < ROUND_OFF, "{stated:?} {expected}");
    }
    let pairs: Vec<(usize, usize)> = correlation.stated.iter().map(|stated| (stated.first, stated.second)).collect();
    assert_eq!(pairs, [(1, 0), (1, 2)]);
    // Normal variables have the same linear correlation as those behind them.
    let linear = study.linear_correlations();
    assert!((linear[0].linear - correlation.stated[0].normal).abs() < ROUND_OFF && linear[1].linear == 0.4);
}

fn as_json(text: &str) -> serde_json::Value {
    let table: toml::Table = text.parse().unwrap_or_else(|error| panic!("{error}"));
    serde_json::to_value(table).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn schemas_accept_the_templates_and_refuse_unknown_keys() {
    let model = jsonschema::validator_for(&model_schema()).unwrap_or_else(|error| panic!("{error}"));
    let study = jsonschema::validator_for(&study_schema()).unwrap_or_else(|error| panic!("{error}"));
    let sketch = include_str!("../files/sketch.toml");
    let models = TEMPLATES.iter().map(|template| template.model).chain([sketch]);
    for text in models {
        let errors: Vec<String> = model.iter_errors(&as_json(text)).map(|error| error.to_string()).collect();
        assert!(errors.is_empty(), "{errors:?}");
    }
    for template in TEMPLATES {
        let errors: Vec<String> = study.iter_errors(&as_json(template.study)).map(|error| error.to_string()).collect();
        assert!(errors.is_empty(), "{errors:?}");
    }
    assert!(!model.is_valid(&as_json(&sketch.replace("inertia", "inertai"))));
    assert!(!model.is_valid(&as_json(&sketch.replace("kind = \"prismatic\"", "kind = \"sliding\""))));
    assert!(!model.is_valid(&as_json(&sketch.replace("gravity = \"9.81 m/s^2\"", "gravity = 9.81"))));
    let text = find_template("four-bar").expect("template").study;
    assert!(!study.is_valid(&as_json(&text.replace("uniform", "unifrom"))));
    assert!(!study.is_valid(&as_json(&text.replace("at = \"cycle\"", "at = \"cycle\"\nreduce = \"mean\""))));
}

/// A tolerance is held against the smallest clearance that the inputs allow: the end of an interval, the tail of a distribution,
/// the difference of two dimensions.
#[test]
fn a_tolerance_is_held_against_the_smallest_clearance_of_the_inputs() {
    let found = find_template("slider-crank").expect("a template");
    let of = |inputs: &str, tolerance: &str| {
        let model = Model::from_text("model.toml", found.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let text = format!(
            "name = \"play\"\nmodel = \"model.toml\"\n[sampling]\ntolerance = \"{tolerance}\"\n{inputs}\n[[ask]]\noutput = \
             \"slider\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n"
        );
        let warnings =
            |study: Study| study.warnings.iter().map(ToString::to_string).collect::<Vec<String>>().join("\n");
        match Study::from_text("study.toml", &text, model) {
            Ok(study) => format!("warned of: {}", warnings(study)),
            Err(diagnostics) => diagnostics.to_string(),
        }
    };
    let interval = "[epistemic]\n\"joint.gudgeon.radial_clearance\" = { interval = [\"0.02 mm\", \"0.5 mm\"] }";
    assert_eq!(of(interval, "2e-7 m"), "warned of: ");
    assert!(
        of(interval, "2.1e-7 m").starts_with(
            "warned of: study.toml:4:13: warning[E0822]: the tolerance 0.00021 mm is more than a hundredth of the smallest \
             clearance, 0.02 mm in joint 'gudgeon'"
        ),
        "{}",
        of(interval, "2.1e-7 m")
    );
    assert!(of(interval, "0.03 mm").contains("study.toml:4:13: error[E0822]"), "{}", of(interval, "0.03 mm"));
    // One in a thousand lies 3.09 standard deviations below the mean: at 0.1073 mm.
    let random = "[random]\n\"joint.gudgeon.radial_clearance\" = { normal = { mean = \"0.2 mm\", standard_deviation = \"0.03 mm\" } }";
    assert!(
        of(random, "0.108 mm").contains("larger than the smallest clearance, 0.1072"),
        "{}",
        of(random, "0.108 mm")
    );
    assert!(of(random, "0.107 mm").starts_with("warned of: "), "{}", of(random, "0.107 mm"));
}

/// Wear is one number for each run: other questions about it are refused.
#[test]
fn wear_is_asked_for_as_one_number_of_a_run() {
    let wear = "bearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\nradial_clearance";
    let output = "\n[output.hole]\nwear_of = \"joint.gudgeon\"\ncomponent = \"bearing_volume\"\n";
    let text = find_template("slider-crank").expect("a template").model.replacen("radial_clearance", wear, 1) + output;
    let of = |asked: &str| {
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let input = "[epistemic]\n\"joint.gudgeon.wear.bearing.coefficient\" = { interval = [\"1e-16 m^2/N\", \"1e-14 m^2/N\"] }";
        let text = format!("name = \"wear\"\nmodel = \"model.toml\"\n{asked}\n{input}\n");
        Study::from_text("study.toml", &text, model)
            .err()
            .map_or("read".to_owned(), |diagnostics| diagnostics.to_string())
    };
    let ask = |rest: &str| of(&format!("[[ask]]\noutput = \"hole\"\nstatistics = [\"mean\"]\n{rest}"));
    let require = |rest: &str| of(&format!("[[require]]\noutput = \"hole\"\nprobability_at_least = 0.9\n{rest}"));
    assert_eq!(ask("of = \"value\"\nreduce = \"maximum\""), "read");
    assert_eq!(require("of = \"value\"\nover = \"cycle\"\nbelow = \"3 mm^3\""), "read");
    assert_eq!(
        ask("of = \"total\"\nreduce = \"maximum\""),
        "study.toml:6:6: error[E0608]: [[ask]] 1: of: wear is not a deviation from an ideal motion; must be \"value\"\n\
         hint: write of = \"value\""
    );
    for place in ["at = \"cycle\"", "reduce = \"mean\"", "poses = { crank = [\"60 deg\"] }"] {
        let said = ask(&format!("of = \"value\"\n{place}"));
        assert!(said.contains("wear is one number for each run; must be reduce = \"maximum\""), "{said}");
    }
    for limit in ["over = \"cycle\"\nabove = \"3 mm^3\"", "over = \"cycle\"\nwithin = \"3 mm^3\""] {
        let said = require(&format!("of = \"value\"\n{limit}"));
        assert!(said.contains("wear has an upper limit over the cycle only"), "{said}");
    }
}

/// A life is followed for the cycles of `[wear]` alone: beyond them nothing is known of it.
#[test]
fn lives_are_asked_for_within_the_cycles_of_wear() {
    let joint = "bearing_length = \"20 mm\"\nwear.bearing.coefficient = \"1e-15 m^2/N\"\nradial_clearance";
    let tail = "\n[output.life]\nwear_of = \"joint.gudgeon\"\ncomponent = \"life\"\n[wear]\ncycles = 4000\n\
                geometry = \"worn\"\nlimit_of = \"slider\"\nlimit = \"0.6 mm\"\n";
    let text = find_template("slider-crank").expect("a template").model.replacen("radial_clearance", joint, 1) + tail;
    let of = |input: &str, asked: &str| {
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let text = format!("name = \"life\"\nmodel = \"model.toml\"\n{asked}\n[epistemic]\n{input}\n");
        match Study::from_text("study.toml", &text, model) {
            Ok(study) => study.warnings.iter().map(ToString::to_string).collect::<Vec<String>>().join("\n"),
            Err(diagnostics) => diagnostics.to_string(),
        }
    };
    let coefficient = "\"joint.gudgeon.wear.bearing.coefficient\" = { interval = [\"1e-16 m^2/N\", \"1e-14 m^2/N\"] }";
    let require = |limit: &str| {
        format!("[[require]]\noutput = \"life\"\nof = \"value\"\nprobability_at_least = 0.9\nover = \"cycle\"\n{limit}")
    };
    assert_eq!(of(coefficient, &require("above = 4000")), "");
    assert_eq!(
        of(coefficient, &require("above = 4001")),
        "study.toml:8:9: error[E0608]: [[require]] 1: above is 4001, but lives are computed only up to the cycles of [wear], 4000\n\
         hint: a longer life counts as all cycles: require fewer, or increase cycles in the model"
    );
    // Each run has its own cycles.
    let cycles = "\"wear.cycles\" = { interval = [3000, 5000] }";
    assert_eq!(of(cycles, &require("above = 4001")), "");
    let said = of(coefficient, &require("below = 3000"));
    assert!(said.contains("a life has a lower limit over the cycle only") && said.contains("above = 2000"), "{said}");
    let ask = |statistics: &str| {
        format!("[[ask]]\noutput = \"life\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [{statistics}]")
    };
    assert_eq!(of(coefficient, &ask("{ quantile = 0.1 }")), "");
    assert_eq!(
        of(coefficient, &ask("\"mean\"")),
        "study.toml:7:15: warning[E0608]: [[ask]] 1: statistics 1: a life longer than all cycles of [wear] counts as all cycles, so this may be too small\n\
         hint: use quantiles below all cycles, or increase cycles in the model until all lives end"
    );
    assert!(of(coefficient, &ask("\"standard_deviation\"")).contains("warning[E0608]"));
}
