//! Reads a study file: diagnostics that can be shown, or a study.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::OnceLock;

use loosepin::model::Model;
use loosepin::study::{Study, distribution_words};
use loosepin::templates::TEMPLATES;

use super::files::Files;
use super::model::{FILE, show, source};

/// A model with everything that a model can have.
const EVERY_TABLE: &str = include_str!("../../../crates/loosepin/tests/files/every_table.toml");
/// The model of a study that names none of those known here.
const USUAL: &str = "slider-crank";

/// Reads a study file with its tables. The model that it names is one of the templates.
pub fn read(bytes: &[u8]) -> Option<Study> {
    let read = match Files::of(bytes) {
        Some(files) => {
            let model = model_of(&files.text);
            Study::of_model(&source(&files), models()[model].clone(), Path::new(model))
        }
        None => Study::from_text(FILE, &String::from_utf8_lossy(bytes), models()[USUAL].clone()),
    };
    let study = read.map_err(|diagnostics| show(&diagnostics)).ok()?;
    assert!(!study.random.is_empty() || !study.epistemic.is_empty());
    for input in &study.random {
        let dimension = input.dimension(&study.model);
        assert!(!distribution_words(input.variable.distribution(), dimension).is_empty());
        for probability in [0.001, 0.37, 0.999] {
            let value = input.variable.quantile(probability);
            assert!(value.is_finite(), "{} is {value} at {probability}", input.path);
        }
    }
    Some(study)
}

/// The name of the model that a study is about.
pub fn model_of(text: &str) -> &'static str {
    let named = text.split_once("model = \"").and_then(|(_, rest)| rest.split_once('"'));
    named.and_then(|(name, _)| models().keys().find(|known| **known == name)).copied().unwrap_or(USUAL)
}

/// The models that studies may name, read once.
fn models() -> &'static BTreeMap<&'static str, Model> {
    static MODELS: OnceLock<BTreeMap<&'static str, Model>> = OnceLock::new();
    MODELS.get_or_init(|| {
        let templates = TEMPLATES.iter().map(|template| (template.name, template.model));
        let read = |text: &str| Model::from_text(FILE, text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        templates.chain([("every-table", EVERY_TABLE)]).map(|(name, text)| (name, read(text))).collect()
    })
}
