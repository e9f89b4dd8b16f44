//! The kept corpus of the guided fuzzer (`just campaign fuzz-guided`): the fewest inputs that together reach all code of the readers that
//! it has reached, and every input that was once a defect. Each is read as the fuzzer reads it: diagnostics that can be shown, no panic. How
//! long that takes the fuzzer measures.

use std::path::{Path, PathBuf};

#[path = "../../../../tests/fuzz/src/files.rs"]
mod files;
#[path = "../../../../tests/fuzz/src/log.rs"]
mod log;
#[path = "../../../../tests/fuzz/src/model.rs"]
mod model;
#[path = "../../../../tests/fuzz/src/plan.rs"]
mod plan;
#[path = "../../../../tests/fuzz/src/rows.rs"]
mod rows;
#[path = "../../../../tests/fuzz/src/store.rs"]
mod store;
#[path = "../../../../tests/fuzz/src/study.rs"]
mod study;

/// A corpus that has lost most of its inputs checks nothing.
const FEWEST: usize = 50;

/// The inputs of a target with their names, in their order.
fn inputs(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/fuzz/corpus").join(target);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    assert!(paths.len() >= FEWEST, "{} holds {} inputs", folder.display(), paths.len());
    paths.into_iter().map(|path| (path.clone(), std::fs::read(&path).expect("an input is read"))).collect()
}

fn read_all(target: &str, read: impl Fn(&[u8])) {
    for (path, bytes) in inputs(target) {
        let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| read(&bytes)));
        assert!(done.is_ok(), "{} makes the reader panic", path.display());
    }
}

#[test]
fn no_kept_model_file_makes_the_reader_panic() {
    read_all("model", |bytes| drop(model::read(bytes)));
}

#[test]
fn no_kept_study_file_makes_the_reader_panic() {
    read_all("study", |bytes| drop(study::read(bytes)));
}

#[test]
fn no_kept_file_makes_planning_panic() {
    read_all("plan", plan::read);
}

#[test]
fn no_kept_store_makes_the_reader_panic() {
    let folder = tempfile::tempdir().expect("a folder for the store");
    read_all("store", |bytes| store::read(bytes, folder.path()));
}
