//! The pages of docs/files, and those of contact laws and films: their tables of keys are those of the schemas, their units and laws
//! those that are read, their examples are read. `just file-pages` rewrites tables, units and laws.

use std::fs;
use std::path::{Path, PathBuf};

use loosepin::contact::{FRICTION_LAWS, POINT_LAWS};
use loosepin::model::{Model, NormalDescription, model_schema};
use loosepin::space::spatial_model_schema;
use loosepin::study::{Study, study_schema};
use loosepin::units::UNITS;
use serde_json::{Map, Value};

use crate::{film_tables, key_tables};

/// Set by `just file-pages`.
const REWRITE: &str = "LOOSEPIN_REWRITE_PAGES";
const KEYS: &str = "<!-- keys of ";
const END_OF_KEYS: &str = "<!-- end of keys -->";
const UNITS_MARK: &str = "<!-- units -->";
const END_OF_UNITS: &str = "<!-- end of units -->";
const POINT_LAWS_MARK: &str = "<!-- point-contact laws -->";
const END_OF_POINT_LAWS: &str = "<!-- end of point-contact laws -->";
const FILMS: &str = "<!-- films: ";
const END_OF_FILMS: &str = "<!-- end of films -->";

/// Tables whose keys the row of their distribution or their example shows whole.
const SHOWN_BY_THEIR_ROW: [&str; 2] = ["study random ", "study load "];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The pages, in the order of their names.
fn pages() -> Vec<PathBuf> {
    let entries = fs::read_dir(repository().join("docs/files")).expect("the pages");
    let paths = entries.map(|entry| entry.expect("a page").path());
    let mut pages: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    pages.push(law_page());
    pages.push(repository().join("docs/lubrication.md"));
    pages.push(repository().join("measured/films.md"));
    pages.sort();
    pages
}

fn law_page() -> PathBuf {
    repository().join("docs/contact-laws.md")
}

fn schema(file: &str) -> Value {
    match file {
        "model" => model_schema(),
        "space" => spatial_model_schema(),
        "study" => study_schema(),
        _ => panic!("there is no file '{file}'"),
    }
}

/// `model: joint kind=slot` of `<!-- keys of model: joint kind=slot -->`.
fn marked(line: &str) -> Option<(&str, &str)> {
    line.strip_prefix(KEYS)?.strip_suffix(" -->")?.split_once(':')
}

/// The page with its tables made anew.
fn made_anew(page: &str) -> String {
    let mut lines = page.lines();
    let mut made = String::new();
    while let Some(line) = lines.next() {
        made.push_str(line);
        made.push('\n');
        let (table, end) = if let Some((file, path)) = marked(line) {
            let schema = schema(file);
            let table = key_tables::find(&schema, path).unwrap_or_else(|| panic!("{line}: there is no such table"));
            (key_tables::markdown(table), END_OF_KEYS)
        } else if line == UNITS_MARK {
            (units(), END_OF_UNITS)
        } else if line == POINT_LAWS_MARK {
            (point_laws(), END_OF_POINT_LAWS)
        } else if let Some(name) = line.strip_prefix(FILMS).and_then(|rest| rest.strip_suffix(" -->")) {
            (film_tables::markdown(name), END_OF_FILMS)
        } else {
            continue;
        };
        assert!(lines.any(|line| line == end), "{line} has no end");
        made.push_str(&format!("\n{table}\n\n{end}\n"));
    }
    made
}

/// The symbols of units in a line for each dimension.
fn units() -> String {
    let mut lines = vec!["| Measures | Units |".to_owned(), "|---|---|".to_owned()];
    let of_one_dimension =
        |one: &loosepin::units::Unit, other: &loosepin::units::Unit| one.dimension == other.dimension;
    for units in UNITS.chunk_by(of_one_dimension) {
        let symbols: Vec<String> = units.iter().map(|unit| format!("`{}`", unit.symbol)).collect();
        lines.push(format!("| {} | {} |", units[0].dimension, symbols.join(" ")));
    }
    lines.join("\n")
}

/// The point-contact laws with their sources and equations.
fn point_laws() -> String {
    let mut lines = vec!["| `law` | Source and χ |".to_owned(), "|---|---|".to_owned()];
    lines.extend(POINT_LAWS.iter().map(|law| format!("| `{}` | {} |", law.name, law.source)));
    lines.join("\n")
}

#[test]
fn every_law_is_on_the_page_of_laws() {
    let page = made_anew(&read(&law_page()));
    let laws = NormalDescription::all().map(|law| law.name()).chain(FRICTION_LAWS.iter().map(|law| law.name));
    for name in laws {
        let is_there = page.contains(&format!("| `{name}`")) || page.contains(&format!("\n`{name}` "));
        assert!(is_there, "no line says what {name} is");
    }
}

#[test]
fn tables_of_the_pages_are_up_to_date() {
    for path in pages() {
        let page = read(&path);
        let made = made_anew(&page);
        if std::env::var_os(REWRITE).is_some() {
            fs::write(&path, made).expect("the page is written");
        } else {
            assert!(page == made, "{} is stale: just file-pages", path.display());
        }
    }
}

#[test]
fn every_key_of_the_schemas_is_on_a_page() {
    let mut shown = Vec::new();
    for page in pages().iter().map(|path| read(path)) {
        for (file, path) in page.lines().filter_map(marked) {
            shown.push(key_tables::find(&schema(file), path).expect("a table").clone());
        }
    }
    for (file, least) in [("model", 20), ("space", 10), ("study", 20)] {
        let schema = schema(file);
        let mut tables = Vec::new();
        key_tables::all(&schema, file, &mut tables);
        assert!(tables.len() > least, "{} tables of {file}", tables.len());
        let is_shown = |(path, table): &(String, &Map<String, Value>)| {
            SHOWN_BY_THEIR_ROW.iter().any(|known| path.starts_with(known))
                || shown.iter().any(|shown: &Map<String, Value>| shown["properties"] == table["properties"])
        };
        let missing: Vec<String> =
            tables.iter().filter(|table| !is_shown(table)).map(|(path, _)| path.clone()).collect();
        assert!(missing.is_empty(), "no page shows the keys of {missing:?}");
    }
}

/// An example, and what it is a part of.
struct Example {
    text: String,
    /// The file that it replaces tables of; `None` if it is whole.
    within: Option<String>,
}

/// The examples of a page. The line before one says `<!-- in FILE -->` or `<!-- a whole model -->`.
fn examples(page: &str) -> Vec<Example> {
    let mut lines = page.lines();
    let (mut found, mut before) = (Vec::new(), "");
    while let Some(line) = lines.next() {
        if line == "```toml" {
            let within = match before.strip_prefix("<!-- in ").and_then(|rest| rest.strip_suffix(" -->")) {
                Some(file) => Some(file.to_owned()),
                None if before == "<!-- a whole model -->" => None,
                None => panic!("an example says nothing of its file: {before}"),
            };
            let text: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            found.push(Example { text: text.join("\n"), within });
        }
        before = line;
    }
    found
}

fn table(text: &str) -> toml::Table {
    text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The file with the tables of the example in place of its own: those under a name one by one.
fn put_together(file: &str, example: &str) -> String {
    let mut whole = table(file);
    for (key, value) in table(example) {
        match (whole.get_mut(&key), value) {
            (Some(toml::Value::Table(there)), toml::Value::Table(new)) => there.extend(new),
            (_, value) => drop(whole.insert(key, value)),
        }
    }
    toml::to_string(&whole).expect("TOML")
}

/// Reads an example of a page beside which the tables of its files lie.
fn check(example: &Example, page: &Path) -> Result<(), String> {
    let model_of = |name: &str, text: &str| Model::from_text(name, text).map_err(|diagnostics| diagnostics.to_string());
    let beside = |name: &str| page.with_file_name(name).display().to_string();
    let Some(within) = &example.within else {
        return model_of(&beside("model.toml"), &example.text).map(drop);
    };
    let file = repository().join(within);
    let text = put_together(&read(&file), &example.text);
    match table(&text).get("model").and_then(toml::Value::as_str) {
        Some(model) => {
            let model = model_of(model, &read(&file.with_file_name(model)))?;
            let study = Study::from_text(&beside("study.toml"), &text, model);
            study.map(drop).map_err(|diagnostics| diagnostics.to_string())
        }
        None => model_of(&beside("model.toml"), &text).map(drop),
    }
}

#[test]
fn examples_of_the_pages_are_read() {
    let (mut count, mut refused) = (0, String::new());
    for page in pages() {
        for example in examples(&read(&page)) {
            count += 1;
            if let Err(diagnostics) = check(&example, &page) {
                refused.push_str(&format!("{}\n{}\n{diagnostics}\n", page.display(), example.text));
            }
        }
    }
    assert!(refused.is_empty(), "{refused}");
    assert!(count > 25, "{count} examples");
}
