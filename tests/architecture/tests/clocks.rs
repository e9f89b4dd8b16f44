//! No test asserts how long something takes: seconds are those of the machine, and of what else it does. Tests count work; times are
//! measured by campaigns (`tests/campaigns`) and by tests that are asked for by name.

use architecture::sources::{Source, files_below, sources_below};
use std::collections::BTreeSet;
use std::path::Path;

/// How tests read a clock.
const CLOCKS: [&str; 9] = [
    "Instant::now",
    "SystemTime::now",
    ".elapsed()",
    "schedstat",
    "getrusage",
    "time.monotonic(",
    "time.perf_counter(",
    "time.process_time(",
    "time.time(",
];

/// Tests that read one, and what for. What they wait for has a limit, by which a test fails that would never end.
const READERS: [(&str, &str); 16] = [
    ("crates/loosepin-cli/src/progress.rs", "gives runs the begin that they are calculated from"),
    ("crates/loosepin-cli/tests/command/serve.rs", "waits"),
    ("crates/loosepin-python/tests/test_cluster.py", "waits"),
    ("crates/loosepin/tests/study/kept_runs.rs", "gives a result its date"),
    ("crates/loosepin-space/tests/space/proven_ends.rs", "a campaign, which prints the times"),
    ("crates/loosepin-space/tests/space/random_mechanisms/mod.rs", "a campaign, which prints the times"),
    ("crates/loosepin-store/src/tests.rs", "waits"),
    ("crates/loosepin-studio/src/length_tests.rs", "a campaign, which prints the times"),
    ("crates/loosepin-studio/tests/studio/disk.rs", "sets the date of a file"),
    ("crates/loosepin-studio/tests/studio/shelf.rs", "sets the date of a file"),
    ("crates/loosepin-studio/tests/studio/slow.rs", "waits"),
    ("crates/loosepin-study/src/written/tables/timing.rs", "is a clock that was set back"),
    ("tests/browser/chromium.py", "waits"),
    ("tests/browser/test_studio.py", "waits"),
    ("tests/browser/test_studio_drafts.py", "waits"),
    ("tests/browser/test_studio_shelf.py", "sets the date of a file"),
];

/// All tests with their paths, of sources with tests the part behind `#[cfg(test)]`.
fn tests() -> Vec<Source> {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let below = |folder: &str, found: fn(&Path) -> Vec<Source>| {
        let sources = found(&repository.join(folder));
        let prefix = folder.to_owned();
        sources.into_iter().map(move |source| Source { path: format!("{prefix}/{}", source.path), text: source.text })
    };
    let python = |folder: &Path| files_below(folder, &["py"]);
    let rust = below("crates", sources_below).filter_map(|source| {
        let is_test = source.path.contains("/tests/") || source.path.ends_with("tests.rs");
        let start = if is_test { Some(0) } else { source.text.find("#[cfg(test)]") };
        start.map(|start| Source { text: source.text[start..].to_owned(), path: source.path })
    });
    rust.chain(below("crates/loosepin-python/tests", python)).chain(below("tests/browser", python)).collect()
}

/// Lines of code that read a clock: comments do not.
fn clock_lines(source: &Source) -> Vec<&str> {
    let is_code = |line: &&str| !line.trim_start().starts_with(['#', '/']);
    source.text.lines().filter(is_code).filter(|line| CLOCKS.iter().any(|clock| line.contains(clock))).collect()
}

#[test]
fn tests_read_a_clock_to_wait_alone() {
    let tests = tests();
    assert!(tests.len() > 300, "{} files with tests", tests.len());
    let found: BTreeSet<&str> =
        tests.iter().filter(|test| !clock_lines(test).is_empty()).map(|test| test.path.as_str()).collect();
    let known: BTreeSet<&str> = READERS.iter().map(|(path, _)| *path).collect();
    assert_eq!(found, known, "tests that read a clock, and those that may (READERS, with the reason)");
    for test in &tests {
        let asserted: Vec<&str> = clock_lines(test).into_iter().filter(|line| line.contains("assert")).collect();
        assert!(asserted.is_empty(), "{} asserts a time: {asserted:#?}", test.path);
    }
}

#[test]
fn a_clock_is_found_in_every_language() {
    let of = |path: &str, text: &str| clock_lines(&Source { path: path.to_owned(), text: text.to_owned() }).len();
    assert_eq!(of("a.rs", "let began = Instant::now();\nassert!(began.elapsed() < LIMIT);\n// Instant::now()\n"), 2);
    assert_eq!(of("a.py", "began = time.monotonic()\n# time.monotonic()\nassert time.perf_counter() - began < 5\n"), 2);
}
