//! What the README shows is what the repository holds: the fenced excerpts stand in the files of the case that its first
//! command runs, and what its commands and links name exists.

use std::path::{Path, PathBuf};

const CASE: &str = "cases/slider_crank_worn_pin";

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    std::fs::read_to_string(repository().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A line without the comment that ends it.
fn without_comment(line: &str) -> &str {
    line.split(" #").next().unwrap_or(line).trim()
}

#[test]
fn fenced_excerpts_stand_in_the_case_in_the_same_order() {
    let page = read("README.md");
    let excerpts: Vec<&str> = page.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    let files = ["model.toml", "study.toml"];
    assert_eq!(excerpts.len(), files.len(), "one excerpt of each of {files:?}");
    for (excerpt, file) in excerpts.iter().zip(files) {
        let text = read(&format!("{CASE}/{file}"));
        let mut lines = text.lines().map(without_comment);
        for wanted in excerpt.lines().filter(|line| !line.trim().is_empty()) {
            assert!(lines.any(|line| line == wanted), "README.md shows a line that {file} does not hold: {wanted}");
        }
    }
}

#[test]
fn named_files_exist() {
    let page = read("README.md");
    let links = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let arguments = page.split_whitespace().filter(|word| word.starts_with("cases/"));
    let mut count = 0;
    for path in links.chain(arguments).filter(|path| !path.contains("://")) {
        let path = path.split('#').next().unwrap_or(path);
        assert!(repository().join(path).exists(), "README.md names {path}, which does not exist");
        count += 1;
    }
    assert!(count > 3, "README.md names files");
}

/// `cargo run` without a name runs the only program there is: a second one would make the first command of the page ambiguous.
#[test]
fn the_workspace_holds_one_program() {
    let mut programs = Vec::new();
    for entry in std::fs::read_dir(repository().join("crates")).expect("crates") {
        let folder = entry.expect("a folder of crates").path();
        programs.extend([folder.join("src/main.rs"), folder.join("src/bin")].into_iter().filter(|path| path.exists()));
    }
    assert_eq!(programs, [repository().join("crates/loosepin-cli/src/main.rs")]);
}
