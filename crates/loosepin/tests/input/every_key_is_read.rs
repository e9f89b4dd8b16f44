//! The schemas promise what the reader reads: every key of every table is looked at.
//!
//! Readers and schemas share one table of keys, so that an unknown key is refused. What is tested here is the other
//! direction: each key that a schema lists is set to a truth value, which stands nowhere, and the file must be refused.

use loosepin::model::{Model, model_schema};
use loosepin::study::{Study, study_schema};
use serde_json::Value;

const MODEL: &str = include_str!("../files/every_table.toml");
/// A mechanism with a flexible body, beside which not every table may stand.
const FLEXIBLE: &str = include_str!("../../../../cases/flexible_slider_crank/model.toml");
const STUDY: &str = include_str!("../files/every_table_study.toml");

fn as_json(text: &str) -> Value {
    let table: toml::Table = text.parse().unwrap_or_else(|error| panic!("{error}"));
    serde_json::to_value(table).unwrap_or_else(|error| panic!("{error}"))
}

/// JSON pointers of every key that `schema` allows in a table of `sample`.
fn keys(schema: &Value, sample: &Value, pointer: &str, found: &mut Vec<String>) {
    for variant in ["oneOf", "anyOf"].iter().filter_map(|word| schema.get(*word)?.as_array()).flatten() {
        // Tagged tables: the variant whose tag the sample bears. Otherwise: the variant of the sample's type.
        let tag = variant.pointer("/properties/kind/enum/0");
        if tag.map_or(sample.is_object(), |tag| sample.get("kind") == Some(tag)) {
            keys(variant, sample, pointer, found);
        }
    }
    match sample {
        Value::Object(entries) => {
            let properties = schema.get("properties").and_then(Value::as_object);
            for (key, below) in properties.into_iter().flatten() {
                // A name of the person's choosing that has keys of its own (the ground) is a table, not a key.
                let is_table_of_names = schema.get("additionalProperties").is_some_and(Value::is_object);
                if !is_table_of_names {
                    found.push(format!("{pointer}/{key}"));
                }
                if let Some(entry) = entries.get(key) {
                    keys(below, entry, &format!("{pointer}/{key}"), found);
                }
            }
            if let Some(below) = schema.get("additionalProperties").filter(|below| below.is_object()) {
                for (key, entry) in
                    entries.iter().filter(|(key, _)| properties.is_none_or(|keys| !keys.contains_key(*key)))
                {
                    keys(below, entry, &format!("{pointer}/{key}"), found);
                }
            }
        }
        Value::Array(elements) => {
            for (index, element) in elements.iter().enumerate() {
                keys(&schema["items"], element, &format!("{pointer}/{index}"), found);
            }
        }
        _ => {}
    }
}

/// The sample with a truth value at the pointer.
fn broken(sample: &Value, pointer: &str) -> String {
    let mut broken = sample.clone();
    let (table, key) = pointer.rsplit_once('/').unwrap_or_default();
    let table = broken.pointer_mut(table).and_then(Value::as_object_mut).expect("a table of the sample");
    table.insert(key.to_owned(), Value::Bool(true));
    toml::to_string(&broken).unwrap_or_else(|error| panic!("{error}"))
}

fn check(schema: &Value, sample: &str, at_least: usize, read: impl Fn(&str) -> Option<String>) {
    assert_eq!(read(sample), None, "the sample is right");
    let sample = as_json(sample);
    let mut found = Vec::new();
    keys(schema, &sample, "", &mut found);
    assert!(found.len() >= at_least, "only {} keys found", found.len());
    let unread: Vec<&String> = found.iter().filter(|pointer| read(&broken(&sample, pointer)).is_none()).collect();
    assert!(unread.is_empty(), "keys of the schema that the reader ignores: {unread:?}");
}

#[test]
fn every_key_of_a_model_is_read() {
    for (text, at_least) in [(MODEL, 90), (FLEXIBLE, 60)] {
        check(&model_schema(), text, at_least, |text| {
            Model::from_text("model.toml", text).err().map(|said| said.to_string())
        });
    }
}

#[test]
fn every_key_of_a_study_is_read() {
    let model = Model::from_text("model.toml", MODEL).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    check(&study_schema(), STUDY, 60, |text| {
        Study::from_text("study.toml", text, model.clone()).err().map(|said| said.to_string())
    });
}
