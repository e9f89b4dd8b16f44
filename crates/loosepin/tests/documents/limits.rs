//! The page of limits states the numbers of the code.

use loosepin::model::{MAX_BODIES, MAX_ENTRIES, MAX_JOINTS};
use loosepin::simulate::{MAX_NUMBERS, MAX_ROWS, Settings};
use loosepin::space::SpatialModel;
use loosepin::study::{MAX_COLUMNS, MAX_POSES, MAX_RUNS, STATED_BYTES};

#[test]
fn every_limit_stands_on_its_page() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/files/limits.md");
    let page = std::fs::read_to_string(path).expect("the page is there");
    let stated = |what: &str, most: u64| {
        let row = page.lines().find(|line| line.starts_with(&format!("| {what}")));
        let row = row.unwrap_or_else(|| panic!("there is no row '{what}'"));
        let cell = row.split('|').nth(2).expect("a table");
        let number = cell.split_whitespace().next().unwrap_or_default();
        assert_eq!(number, most.to_string(), "{row}");
    };
    stated("moving bodies", MAX_BODIES as u64);
    stated("joints", MAX_JOINTS as u64);
    stated("contacts", MAX_ENTRIES as u64);
    for (table, what) in [
        ("body", "moving bodies in space"),
        ("joint", "joints in space"),
        ("drive", "drives, outputs"),
        ("output", "drives, outputs"),
    ] {
        stated(what, largest_in_space(table));
    }
    stated("rows of a history", MAX_ROWS as u64);
    stated("numbers of a history", MAX_NUMBERS as u64);
    stated("evaluations of the equations of motion", Settings::for_simulation().largest_evaluations);
    stated("poses of a question", MAX_POSES as u64);
    stated("numbers of a run", MAX_COLUMNS as u64);
    stated("runs", MAX_RUNS);
    stated("others", STATED_BYTES >> 30);
}

/// How many entries of a table a model in space may have, by the message of a model that has too many.
fn largest_in_space(table: &str) -> u64 {
    let entries: String = (0..2000).map(|number| format!("[{table}.a{number}]\n")).collect();
    let text = format!("name = \"large\"\ngeometry = \"space\"\n{entries}");
    let diagnostics = SpatialModel::from_text("model.toml", &text).expect_err("it is too large").to_string();
    let (_, limit) = diagnostics.split_once("at most ").unwrap_or_else(|| panic!("{diagnostics}"));
    limit.split_whitespace().next().and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("{diagnostics}"))
}
