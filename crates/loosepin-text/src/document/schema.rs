//! JSON Schema of a file, made from its tables of keys.

use serde_json::{Map, Value, json};

use super::keys::{Key, Keys, Kind};
use crate::units::{Dimension, Rule};

/// The schema of a file whose top level has these keys.
pub fn json_schema(title: &str, keys: &Keys) -> Value {
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!("https://json-schema.org/draft/2020-12/schema"));
    schema.insert("title".to_owned(), json!(title));
    schema.extend(table(keys));
    Value::Object(schema)
}

fn table(keys: &Keys) -> Map<String, Value> {
    let properties: Map<String, Value> = keys.keys.iter().map(|key| (key.name.to_owned(), property(key))).collect();
    let required: Vec<&str> = keys.keys.iter().filter(|key| key.is_required).map(|key| key.name).collect();
    let mut schema = Map::new();
    schema.insert("type".to_owned(), json!("object"));
    schema.insert("description".to_owned(), json!(keys.doc));
    schema.insert("properties".to_owned(), Value::Object(properties));
    schema.insert("additionalProperties".to_owned(), json!(false));
    if !required.is_empty() {
        schema.insert("required".to_owned(), json!(required));
    }
    if !keys.exactly_one.is_empty() {
        let groups: Vec<Value> = keys
            .exactly_one
            .iter()
            .map(|group| json!({ "oneOf": group.iter().map(|key| json!({ "required": [key] })).collect::<Vec<_>>() }))
            .collect();
        schema.insert("allOf".to_owned(), json!(groups));
    }
    schema
}

fn property(key: &Key) -> Value {
    let mut schema = kind(&key.kind);
    if let Value::Object(object) = &mut schema {
        let description = match range(&key.kind).filter(|range| !key.doc.contains(range)) {
            Some(range) => format!("{} ({range})", key.doc),
            None => key.doc.to_owned(),
        };
        if !key.example.is_empty() {
            let with_example = format!("{description}, for example `{}`", key.example);
            object.insert("markdownDescription".to_owned(), json!(with_example));
        }
        object.insert("description".to_owned(), json!(description));
    }
    schema
}

/// The range of a number, in words; `None` if it may be any.
fn range(kind: &Kind) -> Option<&'static str> {
    match kind {
        Kind::Quantity { rule: Rule::Finite, .. } | Kind::Number { rule: Rule::Finite } => None,
        Kind::Quantity { rule, .. } | Kind::Number { rule } => Some(rule.words()),
        _ => None,
    }
}

fn kind(due: &Kind) -> Value {
    match due {
        Kind::Text | Kind::Reference(_) => json!({ "type": "string", "minLength": 1 }),
        Kind::Quantity { dimension, .. } if *dimension == Dimension::NUMBER => json!({ "type": ["number", "string"] }),
        Kind::Quantity { .. } | Kind::Stiffness => json!({ "type": "string", "minLength": 1 }),
        Kind::AnyQuantity => json!({ "type": ["number", "string"] }),
        Kind::Vector => json!({ "type": "array", "items": { "type": "string" }, "minItems": 2, "maxItems": 2 }),
        Kind::Three(each) => json!({ "type": "array", "items": kind(each), "minItems": 3, "maxItems": 3 }),
        Kind::Number { rule } => number(*rule),
        Kind::Count { least, most } => json!({ "type": "integer", "minimum": least, "maximum": most }),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::ChoiceOf(words) => json!({ "enum": words() }),
        Kind::Point => json!({ "type": "string", "pattern": "^[^.]+\\.[^.]+$" }),
        Kind::Unit => json!({ "type": "string" }),
        Kind::Table(keys) => Value::Object(table(keys)),
        Kind::Tables { keys, except } => {
            let named: Map<String, Value> =
                except.iter().map(|(name, keys)| ((*name).to_owned(), Value::Object(table(keys)))).collect();
            json!({ "type": "object", "properties": named, "additionalProperties": table(keys) })
        }
        Kind::TaggedTables { tag, variants } => {
            let tables: Vec<Value> = variants.iter().map(|(_, keys)| Value::Object(table(keys))).collect();
            json!({ "type": "object", "additionalProperties": { "type": "object", "required": [tag], "oneOf": tables } })
        }
        Kind::Tagged { tag, variants } => {
            let tables: Vec<Value> = variants.iter().map(|(_, keys)| Value::Object(table(keys))).collect();
            json!({ "type": "object", "required": [tag], "oneOf": tables })
        }
        Kind::Values(each) => json!({ "type": "object", "additionalProperties": kind(each) }),
        Kind::List(each) => json!({ "type": "array", "items": kind(each) }),
        Kind::AnyOf(kinds) => json!({ "anyOf": kinds.iter().map(kind).collect::<Vec<_>>() }),
    }
}

fn number(rule: Rule) -> Value {
    match rule {
        Rule::Finite => json!({ "type": "number" }),
        Rule::Positive => json!({ "type": "number", "exclusiveMinimum": 0 }),
        Rule::NonNegative => json!({ "type": "number", "minimum": 0 }),
        Rule::Restitution => json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1 }),
        Rule::PoissonRatio => json!({ "type": "number", "minimum": 0, "maximum": 0.5 }),
        Rule::Turns => json!({ "type": "number", "minimum": 0, "maximum": 1e6 }),
        Rule::SomeTurns => json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1e6 }),
        Rule::Probability => json!({ "type": "number", "exclusiveMinimum": 0, "exclusiveMaximum": 1 }),
        Rule::RequiredProbability => json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 1 }),
        Rule::PressureAngle => json!({ "type": "number", "minimum": 0 }),
        Rule::AtLeastOne => json!({ "type": "number", "minimum": 1 }),
    }
}
