//! Study files that are right, the templates, and what editors are told about both kinds of file.

use std::path::Path;

use loosepin::bounds::Statistic;
use loosepin::model::{Model, model_schema};
use loosepin::study::{Deviation, Limit, Reduction, Study, Where, study_schema};
use loosepin::templates::{TEMPLATES, find_template};
use loosepin::uncertainty::Distribution;

fn template(name: &str) -> Study {
    let template = find_template(name).unwrap_or_else(|| panic!("no template {name}"));
    let model = Model::from_text("model.toml", template.model).unwrap_or_else(|complaints| panic!("{complaints}"));
    Study::from_text("study.toml", template.study, model).unwrap_or_else(|complaints| panic!("{complaints}"))
}

#[test]
fn templates_load_without_complaint() {
    for each in TEMPLATES {
        let study = template(each.name);
        assert!(study.warnings.is_empty(), "{}: {:?}", each.name, study.warnings);
    }
}

#[test]
fn templates_load_from_their_folder() {
    for each in TEMPLATES {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates").join(each.name);
        let study = Study::from_path(&folder.join("study.toml")).unwrap_or_else(|complaints| panic!("{complaints}"));
        assert_eq!(study.model_path, folder.join("model.toml"));
        assert_eq!(study.model.source().text(), each.model);
    }
}

#[test]
fn a_study_is_read_in_file_order_and_si() {
    let study = template("slider-crank");
    assert_eq!((study.seed, study.sampling.outer, study.sampling.inner), (1, 16, 128));
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
    assert_eq!(study.asks[0].statistics[3], Statistic::Quantile(0.975));
    assert_eq!(study.asks[1].location, Where::Reduced(Reduction::MaximumAbsolute));
    assert_eq!(study.asks[1].statistics[2], Statistic::ProbabilityAbove(6e-4));
    assert_eq!(study.requirements[0].deviation, Deviation::Total);
    assert_eq!(
        (study.requirements[0].limit, study.requirements[0].probability_at_least),
        (Limit::Within(6e-4), 0.9973)
    );
}

#[test]
fn poses_and_limits_of_angles_are_in_radians() {
    let study = template("four-bar");
    let Where::Poses { angles_rad } = &study.asks[1].location else { panic!("poses") };
    assert_eq!(study.model.cycle_input(&study.model.quantities.nominal()).name, "crank");
    assert_eq!(*angles_rad, [60_f64.to_radians(), 240_f64.to_radians()]);
    assert_eq!(study.asks[1].statistics[1], Statistic::ProbabilityBeyond(0.1_f64.to_radians()));
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
    let model = Model::from_text("model.toml", model).unwrap_or_else(|complaints| panic!("{complaints}"));
    let study = Study::from_text("study.toml", study, model).unwrap_or_else(|complaints| panic!("{complaints}"));
    let families: Vec<&str> = study.random.iter().map(|input| input.variable.distribution().family()).collect();
    assert_eq!(families, ["truncated normal", "uniform", "beta", "lognormal", "triangular"]);
    assert_eq!((study.seed, study.sampling.outer, study.sampling.inner, study.sampling.replicates), (1, 64, 256, 4));
}

fn as_json(text: &str) -> serde_json::Value {
    let table: toml::Table = text.parse().unwrap_or_else(|error| panic!("{error}"));
    serde_json::to_value(table).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn schemas_accept_the_templates_and_refuse_unknown_keys() {
    let model = jsonschema::validator_for(&model_schema()).unwrap_or_else(|error| panic!("{error}"));
    let study = jsonschema::validator_for(&study_schema()).unwrap_or_else(|error| panic!("{error}"));
    let sketch = include_str!("files/sketch.toml");
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
