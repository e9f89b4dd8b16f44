//! Tables of keys in Markdown, from the JSON Schema of a file.

use serde_json::{Map, Value};

/// The table of keys in `schema` at `path`: names of tables, and `kind=NAME` for one of several kinds of a table. Names that
/// people choose are left out: `joint kind=revolute friction`.
pub fn find<'s>(schema: &'s Value, path: &str) -> Option<&'s Map<String, Value>> {
    let step = |node: &'s Value, word: &str| match word.split_once('=') {
        Some((tag, kind)) => {
            let is_kind = |variant: &&Value| variant["properties"][tag]["enum"][0] == kind;
            let holder = inner(node, &|node| kinds_of(node).any(|variant| is_kind(&variant)))?;
            kinds_of(holder).find(is_kind)
        }
        None => inner(node, &|node| properties(node).is_some_and(|keys| keys.contains_key(word)))
            .map(|node| &node["properties"][word]),
    };
    let node = path.split_whitespace().try_fold(schema, step)?;
    inner(node, &|node| properties(node).is_some() && !node["additionalProperties"].is_object())?.as_object()
}

/// The forms of a node, where it has several.
fn kinds_of(node: &Value) -> impl Iterator<Item = &Value> {
    ["oneOf", "anyOf"].into_iter().filter_map(|forms| node.get(forms)?.as_array()).flatten()
}

fn properties(node: &Value) -> Option<&Map<String, Value>> {
    node.get("properties")?.as_object()
}

/// The node itself, or a table in it behind a name that people choose, in a list, or as one of several forms.
fn inner<'s>(node: &'s Value, is_meant: &dyn Fn(&Value) -> bool) -> Option<&'s Value> {
    if is_meant(node) {
        return Some(node);
    }
    let below = ["additionalProperties", "items"].into_iter().filter_map(|word| node.get(word));
    let forms = node.get("anyOf").and_then(Value::as_array).into_iter().flatten();
    below.chain(forms).find_map(|node| inner(node, is_meant))
}

/// Every table of keys in a schema, with a path for messages.
pub fn all<'s>(node: &'s Value, path: &str, found: &mut Vec<(String, &'s Map<String, Value>)>) {
    if let Some(keys) = properties(node) {
        if node["additionalProperties"] == false {
            found.push((path.to_owned(), node.as_object().expect("a table")));
        }
        for (key, below) in keys {
            all(below, &format!("{path} {key}"), found);
        }
    }
    for below in ["additionalProperties", "items"].into_iter().filter_map(|word| node.get(word)) {
        all(below, path, found);
    }
    for below in ["anyOf", "oneOf"].into_iter().filter_map(|word| node.get(word)?.as_array()).flatten() {
        all(below, path, found);
    }
}

/// The lines of a table: key, whether it must be there, what it is, an example.
pub fn markdown(table: &Map<String, Value>) -> String {
    let required: Vec<&str> = table.get("required").map_or(Vec::new(), |keys| texts(keys).collect());
    let mut lines = vec!["| Key | Required | Meaning | Example |".to_owned(), "|---|---|---|---|".to_owned()];
    for (key, about) in table["properties"].as_object().expect("keys") {
        let required = if required.contains(&key.as_str()) { "yes" } else { "" };
        let description = about["description"].as_str().expect("a description");
        let example = about["markdownDescription"].as_str().and_then(|text| text.strip_prefix(description));
        let example = example.and_then(|text| text.strip_prefix(", for example ")).unwrap_or_default();
        let meaning = [description, &values(about, description)].concat();
        lines.push(format!("| `{key}` | {required} | {} | {} |", in_cell(&meaning), in_cell(example)));
    }
    for group in table.get("allOf").and_then(Value::as_array).into_iter().flatten() {
        let keys: Vec<&str> =
            group["oneOf"].as_array().expect("keys").iter().flat_map(|of| texts(&of["required"])).collect();
        let [first @ .., last] = &keys[..] else { panic!("a group without keys") };
        lines.push(String::new());
        lines.push(format!("Exactly one of `{}` and `{last}`.", first.join("`, `")));
    }
    lines.join("\n")
}

/// What may stand behind a key, where its description does not say it: words, or a range.
fn values(about: &Value, description: &str) -> String {
    let choices = [about, &about["anyOf"][0], &about["items"]["anyOf"][0]].into_iter().find_map(|of| of.get("enum"));
    let words: Vec<&str> = choices.map_or(Vec::new(), |words| texts(words).collect());
    if words.len() > 1 && words.iter().any(|word| !description.contains(word)) {
        return format!(": `{}`", words.join("`, `"));
    }
    match (about["minimum"].as_u64(), about["maximum"].as_u64()) {
        (Some(least), Some(most)) => format!(" ({least} to {most})"),
        _ => String::new(),
    }
}

fn texts(list: &Value) -> impl Iterator<Item = &str> {
    list.as_array().into_iter().flatten().filter_map(Value::as_str)
}

fn in_cell(text: &str) -> String {
    text.replace('|', "\\|")
}

#[test]
fn a_table_shows_what_its_schema_says() {
    let slot = serde_json::json!({
        "type": "object",
        "additionalProperties": false,
        "required": ["kind"],
        "properties": {
            "kind": { "enum": ["slot"], "description": "the kind" },
            "end": { "enum": ["round", "flat"], "description": "its ends" },
            "count": { "minimum": 1, "maximum": 9, "description": "how many", "markdownDescription": "how many, for example `2`" },
            "size": { "description": "|size| (> 0)" },
        },
        "allOf": [{ "oneOf": [{ "required": ["count"] }, { "required": ["size"] }] }],
    });
    let kinds = serde_json::json!({ "additionalProperties": { "oneOf": [slot.clone()] } });
    let schema = serde_json::json!({ "properties": { "joint": kinds } });
    let found = find(&schema, "joint kind=slot").expect("the table");
    assert_eq!(Some(found), slot.as_object());
    assert!(find(&schema, "joint kind=hinge").is_none() && find(&schema, "joints").is_none());
    assert_eq!(
        markdown(found),
        "| Key | Required | Meaning | Example |\n\
         |---|---|---|---|\n\
         | `kind` | yes | the kind |  |\n\
         | `end` |  | its ends: `round`, `flat` |  |\n\
         | `count` |  | how many (1 to 9) | `2` |\n\
         | `size` |  | \\|size\\| (> 0) |  |\n\
         \n\
         Exactly one of `count` and `size`."
    );
}
