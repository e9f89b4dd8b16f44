//! Every folder of `cases/` holds what `cases/README.md` says: a source, a model, numbers with unit, tolerance, origin
//! and reason. Whether the program meets the numbers is asked elsewhere.

use std::path::{Path, PathBuf};

const ORIGINS: [&str; 4] = ["analytic", "published", "peer", "pinned"];

fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases")
}

/// Folders with a model.
fn case_folders() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(cases()).expect("there is a folder cases");
    let folders = entries.map(|entry| entry.expect("a folder entry can be read").path());
    folders.filter(|path| path.join("model.toml").is_file()).collect()
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn table(path: &Path) -> toml::Table {
    toml::from_str(&read(path)).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// What is wrong with an entry `[expected.name]` or `[history.name]`.
fn entry_faults(entry: &toml::Value, keys: &[&str]) -> Vec<String> {
    let mut faults: Vec<String> =
        keys.iter().filter(|key| entry.get(**key).is_none()).map(|key| format!("has no {key}")).collect();
    if !entry.get("origin").and_then(toml::Value::as_str).is_some_and(|origin| ORIGINS.contains(&origin)) {
        faults.push(format!("has an origin other than {ORIGINS:?}"));
    }
    faults
}

#[test]
fn every_case_says_where_it_comes_from_and_is_listed() {
    let list = read(&cases().join("README.md"));
    let mut count = 0;
    for folder in case_folders() {
        let name = folder.file_name().expect("a folder has a name").to_string_lossy().into_owned();
        assert!(folder.join("README.md").is_file(), "cases/{name} has no README.md");
        assert!(folder.join("expected.toml").is_file(), "cases/{name} has no expected.toml");
        assert!(list.contains(&format!("| `{name}` |")), "cases/README.md does not list {name}");
        count += 1;
    }
    assert!(count > 3, "there are cases");
}

#[test]
fn every_expected_number_has_tolerance_origin_source_and_reason() {
    let mut faults = Vec::new();
    for folder in case_folders() {
        let expected = table(&folder.join("expected.toml"));
        for (name, entry) in expected.get("expected").and_then(toml::Value::as_table).into_iter().flatten() {
            let keys = ["value", "tolerance", "source", "reason", "quantity"];
            faults.extend(
                entry_faults(entry, &keys).into_iter().map(|fault| format!("{}: {name} {fault}", folder.display())),
            );
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn every_history_has_its_file_and_columns() {
    let mut count = 0;
    for folder in case_folders() {
        let expected = table(&folder.join("expected.toml"));
        for (name, entry) in expected.get("history").and_then(toml::Value::as_table).into_iter().flatten() {
            let place = format!("{}: {name}", folder.display());
            assert_eq!(entry_faults(entry, &["file", "source", "reason", "columns"]), Vec::<String>::new(), "{place}");
            let file = entry["file"].as_str().expect("file is a text");
            let text = read(&folder.join(file));
            let header: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
            for row in text.lines() {
                assert_eq!(row.split(',').count(), header.len(), "{place}: a row of {file} has another length: {row}");
            }
            for column in entry["columns"].as_array().expect("columns is a list") {
                let wanted = column["column"].as_str().expect("column is a text");
                assert!(header.contains(&wanted), "{place}: {file} has no column {wanted}");
                assert!(column.get("tolerance").is_some(), "{place}: column {wanted} has no tolerance");
                assert!(column.get("output").is_some() != column.get("state").is_some(), "{place}: {wanted}");
            }
            // Two thirds of the columns are positions and velocities: none of them may be left out.
            let compared: Vec<&str> = entry["columns"]
                .as_array()
                .expect("columns is a list")
                .iter()
                .filter_map(|column| column["column"].as_str())
                .collect();
            for due in &header[1..1 + (header.len() - 1) / 3 * 2] {
                assert!(compared.contains(due), "{place}: column {due} of {file} is not compared");
            }
            count += 1;
        }
    }
    assert!(count > 1, "there are histories");
}

#[test]
fn every_study_names_a_model_that_exists() {
    for folder in case_folders() {
        let path = folder.join("study.toml");
        if path.is_file() {
            let study = table(&path);
            let model = study.get("model").and_then(toml::Value::as_str).expect("a study names its model");
            assert!(folder.join(model).is_file(), "{}: there is no {model}", path.display());
        }
    }
}
