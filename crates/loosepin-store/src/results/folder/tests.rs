//! Folders are claimed, refused, taken over and finished.

use super::*;
use crate::results::{Claim, Destination, InputsHasher};
use loosepin_text::diagnostics::Problem;
use std::fs;

fn claim(path: &Path, input: &str, with_force: bool) -> Claim {
    Claim {
        kind: ResultKind::Simulation,
        name: "Worn pin / 5000 rpm".to_owned(),
        inputs: InputsHasher::new(ResultKind::Simulation).add("model", input).finish(),
        destination: Destination::Folder(path.to_owned()),
        with_force,
    }
}

fn lock(path: &Path) -> FolderLock {
    FolderLock::take(path, LockKind::Result, "test").expect("nobody holds it")
}

fn finished(path: &Path, input: &str) {
    let mut folder = claim(path, input, false).take().expect("a new folder");
    assert!(!folder.is_finished());
    folder.write("history.csv", b"time_s\n").expect("writable");
    folder.finish().expect("writable");
}

#[test]
fn names_become_folder_names() {
    for (name, folder) in [
        ("Worn pin / 5000 rpm", "worn-pin-5000-rpm"),
        ("  ", "unnamed"),
        ("../../etc", "etc"),
        ("Kurbel-Schubgetriebe (groß)", "kurbel-schubgetriebe-groß"),
        ("...", "unnamed"),
        // What Windows keeps for devices, and what it cuts off.
        ("CON", "con-results"),
        ("nul.", "nul-results"),
        ("Aux", "aux-results"),
        ("COM1", "com1-results"),
        ("lpt9 ", "lpt9-results"),
        ("COM¹", "com¹-results"),
        ("COM10", "com10"),
        ("Console", "console"),
        ("trailing dots ...", "trailing-dots"),
    ] {
        assert_eq!(folder_name(name), folder);
    }
    assert_eq!(folder_name(&"a b".repeat(100)).chars().count(), LONGEST_NAME_CHARS);
}

#[test]
fn each_set_of_inputs_has_its_folder() {
    let root = tempfile::tempdir().expect("a folder");
    let below =
        |input| Claim { destination: Destination::Below(root.path().to_owned()), ..claim(root.path(), input, false) };
    let (first, second) = (below("a"), below("b"));
    assert_ne!(first.path(), second.path());
    assert_eq!(first.path().parent(), Some(root.path().join("worn-pin-5000-rpm").as_path()));
    assert_eq!(first.path().file_name().and_then(|name| name.to_str()), Some(first.inputs.short().as_str()));
}

#[test]
fn a_finished_result_is_kept_and_an_unfinished_one_taken_over() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    let mut folder = claim(&path, "a", false).take().expect("a new folder");
    folder.write("history.csv", b"half").expect("writable");
    assert!(matches!(FinishedResult::open(&path), Err(ResultsError::Unfinished { .. })));
    drop(folder);
    finished(&path, "a");
    assert!(claim(&path, "a", false).take().expect("ours").is_finished());
    assert!(!claim(&path, "a", true).take().expect("ours").is_finished());
    assert!(!path.join("history.csv").exists(), "made anew");
}

#[test]
fn a_marker_that_was_being_written_when_the_process_was_stopped_is_ours() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    fs::create_dir(&path).expect("writable");
    fs::write(path.join(".loosepin-0123456789abcdef.partial"), b"{\"kin").expect("writable");
    finished(&path, "a");
    assert!(!path.join(".loosepin-0123456789abcdef.partial").exists());
    fs::remove_file(path.join(MARKER_FILE)).expect("writable");
    fs::write(path.join(".loosepin-0123456789abcdef.partial"), b"{\"kin").expect("writable");
    let error = claim(&path, "a", false).take().expect_err("there is a file that nothing says is ours");
    assert!(matches!(&error, ResultsError::HoldsOtherFiles { example, .. } if example == "history.csv"), "{error}");
}

#[test]
fn results_of_other_inputs_are_refused_or_replaced() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    fs::write(path.join("notes.txt"), "mine").expect("writable");
    let error = claim(&path, "b", false).take().expect_err("another simulation");
    let inputs = claim(&path, "a", false).inputs.short();
    let version = loosepin_text::VERSION;
    assert_eq!(
        error.to_string(),
        format!(
            "{} contains another simulation, 'Worn pin / 5000 rpm' (inputs {inputs}, version {version}); nothing is overwritten",
            path.display()
        )
    );
    assert_eq!(error.hint().as_deref(), Some("give another folder, or replace these results with --force"));
    let study = Claim { kind: ResultKind::Study, ..claim(&path, "b", false) };
    assert!(study.take().expect_err("a simulation").to_string().contains(" contains a simulation, 'Worn pin"));
    claim(&path, "b", true).take().expect("forced");
    assert!(!path.join("history.csv").exists(), "the old result is gone");
    assert!(path.join("notes.txt").exists(), "other files stay");
}

#[test]
fn folders_that_hold_no_results_are_refused() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    fs::create_dir(&path).expect("writable");
    claim(&path, "a", false).take().expect("an empty folder is as good as none");
    let other = root.path().join("photos");
    fs::create_dir(&other).expect("writable");
    fs::write(other.join("summer.jpg"), "x").expect("writable");
    let error = claim(&other, "a", false).take().expect_err("photos");
    assert_eq!(
        error.to_string(),
        format!(
            "{} contains files that are not results, for example 'summer.jpg'; nothing is overwritten",
            other.display()
        )
    );
    assert!(claim(&other, "a", true).take().is_ok());
    assert!(other.join("summer.jpg").exists());
    let file = root.path().join("file");
    fs::write(&file, "x").expect("writable");
    assert_eq!(
        claim(&file, "a", true).take().expect_err("a file").to_string(),
        format!("{} is a file; expected a folder", file.display())
    );
    assert!(matches!(FinishedResult::open(&root.path().join("none")), Err(ResultsError::NoSuchFolder { .. })));
    assert!(matches!(FinishedResult::open(root.path()), Err(ResultsError::NoMarker { .. })));
}

#[test]
fn a_marker_cannot_remove_files_elsewhere() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    let outside = root.path().join("outside.txt");
    fs::write(&outside, "x").expect("writable");
    let text = fs::read_to_string(path.join(MARKER_FILE)).expect("the marker");
    fs::write(path.join(MARKER_FILE), text.replace("history.csv", "../outside.txt")).expect("writable");
    claim(&path, "b", true).take().expect("forced");
    assert!(outside.exists());
    fs::write(path.join(MARKER_FILE), "{}").expect("writable");
    assert!(matches!(claim(&path, "b", false).take(), Err(ResultsError::ForeignMarker { .. })));
}

#[test]
fn an_abandoned_result_leaves_nothing_behind() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("deep").join("out");
    let mut folder = claim(&path, "a", false).take().expect("a new folder");
    folder.write("history.csv", b"half").expect("writable");
    folder.abandon().expect("removable");
    assert!(!root.path().join("deep").exists() && root.path().exists());
    fs::create_dir_all(&path).expect("writable");
    fs::write(path.join("notes.txt"), "mine").expect("writable");
    claim(&path, "a", true).take().expect("forced").abandon().expect("removable");
    assert!(path.join("notes.txt").exists());
    assert!(!path.join(MARKER_FILE).exists());
}

/// Everything in a folder by name, with its text.
fn contents(path: &Path) -> Vec<(String, String)> {
    let entries = fs::read_dir(path).expect("readable").map(|entry| entry.expect("readable"));
    let named = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut all: Vec<(String, String)> =
        named.map(|name| (name.clone(), fs::read_to_string(path.join(name)).expect("text"))).collect();
    all.sort();
    all
}

#[test]
fn what_was_to_be_replaced_survives_a_crash() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    let before = contents(&path);
    // Forced, and ended by Ctrl-C or by a crash: nothing is called after that.
    let mut crashed = claim(&path, "b", true).take().expect("forced");
    crashed.write("history.csv", b"half").expect("writable");
    crashed.leave_unfinished().expect("writable");
    drop(crashed);
    drop(claim(&path, "b", false).take().expect("the same inputs"));
    claim(&path, "b", false).take().expect("the same inputs").abandon().expect("removable");
    assert_eq!(contents(&path), before, "the finished result is back");
    // Once more; this time the result comes to its end.
    drop(claim(&path, "b", true).take().expect("forced"));
    finished(&path, "b");
    let names: Vec<String> = contents(&path).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["history.csv", MARKER_FILE]);
    assert_eq!(
        FinishedResult::open(&path).expect("finished").marker.inputs_blake3,
        claim(&path, "b", false).inputs.to_string()
    );
}

#[test]
fn a_crash_while_files_are_renamed_loses_nothing() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    let before = contents(&path);
    drop(claim(&path, "a", true).take().expect("forced"));
    // As if the machine had stopped between the marker and the first file that is renamed.
    fs::rename(path.join("history.csv.replaced"), path.join("history.csv")).expect("it waits");
    let folder = claim(&path, "a", false).take().expect("the same inputs");
    assert!(path.join("history.csv.replaced").exists() && !path.join("history.csv").exists());
    folder.abandon().expect("removable");
    assert_eq!(contents(&path), before);
    // As if it had stopped between the end of the new result and the removal of the old one.
    fs::write(path.join("history.csv.replaced"), "old").expect("writable");
    let text = fs::read_to_string(path.join(MARKER_FILE)).expect("the marker");
    let mut marker: Marker = serde_json::from_str(&text).expect("a marker");
    marker.replaced.push("history.csv".to_owned());
    marker.write(&lock(&path)).expect("writable");
    assert!(claim(&path, "a", false).take().expect("ours").is_finished());
    assert_eq!(contents(&path), before);
}

#[test]
fn a_lock_that_is_given_back_changes_nothing() {
    let root = tempfile::tempdir().expect("a folder");
    let fresh = root.path().join("a/b/out");
    drop(claim(&fresh, "a", false).lock(&[]).expect("a new folder"));
    assert!(!root.path().join("a").exists(), "folders that were made for it are gone");
    finished(&fresh, "a");
    let before = contents(&fresh);
    drop(claim(&fresh, "b", true).lock(&[]).expect("forced"));
    assert_eq!(contents(&fresh), before);
    let error = claim(&fresh, "b", false).lock(&[]).expect_err("of another");
    assert!(matches!(error, ResultsError::HoldsOtherResults { .. }));
    assert_eq!(contents(&fresh), before);
}

#[test]
fn a_folder_in_use_is_refused_and_its_holder_named() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    let mut first = claim(&path, "a", false).take().expect("a new folder");
    first.write("history.csv", b"of a").expect("writable");
    for with_force in [false, true] {
        let error = claim(&path, "a", with_force).take().expect_err("in use");
        assert_eq!(error.code(), loosepin_text::diagnostics::Code::FolderInUse);
        let words = error.to_string();
        let holder = format!("is in use by process {}", std::process::id());
        assert!(words.contains(&holder) && words.contains("simulation 'Worn pin / 5000 rpm'"), "{words}");
    }
    // Other inputs, with force: the two that were mixed.
    assert!(matches!(claim(&path, "b", true).take(), Err(ResultsError::InUse { .. })));
    first.finish().expect("writable");
    assert!(matches!(ResultsFolder::reopen(&path), Err(ResultsError::InUse { .. })));
    FinishedResult::open(&path).expect("to read, it is free");
    drop(first);
    assert_eq!(ResultsFolder::reopen(&path).expect("free").read("history.csv").expect("listed"), b"of a");
}

#[test]
fn files_made_under_the_lock_alone_say_nothing() {
    let root = tempfile::tempdir().expect("a folder");
    let left = root.path().join("left");
    fs::create_dir(&left).expect("writable");
    fs::write(left.join("runs.sqlite"), "").expect("writable");
    claim(&left, "a", false).lock(&[]).expect_err("a file of somebody's");
    claim(&left, "a", false).lock(&["runs.sqlite"]).expect("nobody's");
}

#[test]
fn every_reader_holds_the_files_against_their_hashes() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    let mut folder = claim(&path, "a", false).take().expect("a new folder");
    folder.write("history.csv", b"time_s\n0\n").expect("writable");
    folder.write_without_hash("timing.json", b"{}").expect("writable");
    folder.finish().expect("writable");
    drop(folder);
    let before = contents(&path);
    let refused = |expected: &str| {
        for error in [
            FinishedResult::open(&path).expect_err("not whole"),
            ResultsFolder::reopen(&path).expect_err("not whole"),
            claim(&path, "a", false).take().expect_err("not whole"),
        ] {
            assert_eq!(error.code(), loosepin_text::diagnostics::Code::ResultNotWhole);
            assert!(error.to_string().contains(expected), "{error}");
            assert!(error.hint().is_some_and(|hint| hint.contains("--force")));
        }
    };
    fs::write(path.join("history.csv"), "time_s\n1\n").expect("writable");
    refused("history.csv is not the file that the simulation 'Worn pin / 5000 rpm' wrote");
    fs::remove_file(path.join("history.csv")).expect("writable");
    refused("history.csv is missing; it belongs to the finished simulation 'Worn pin / 5000 rpm'");
    fs::write(path.join("history.csv"), "time_s\n0\n").expect("writable");
    // Times differ from run to run, and may.
    fs::write(path.join("timing.json"), "{\"runs\": 1}").expect("writable");
    let read = FinishedResult::open(&path).expect("whole again");
    assert_eq!(read.read_text("history.csv").expect("listed"), "time_s\n0\n");
    assert!(matches!(read.read("notes.txt"), Err(ResultsError::NotListed { .. })));
    let marker = |all: &[(String, String)]| all.iter().find(|(name, _)| name == MARKER_FILE).cloned();
    assert_eq!(marker(&contents(&path)), marker(&before));
}

/// A folder in the place of a file lets nothing be written under its name, as a full disk does.
#[test]
fn what_could_not_be_written_leaves_nothing_behind() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    let before = contents(&path);
    let mut folder = claim(&path, "b", true).take().expect("forced");
    fs::create_dir(path.join("summary.json")).expect("writable");
    folder.write("summary.json", b"{}").expect_err("a folder is there");
    fs::remove_dir(path.join("summary.json")).expect("removable");
    // The last of its files is the marker: the result is not finished where that is not there.
    fs::remove_file(path.join(MARKER_FILE)).expect("removable");
    fs::create_dir(path.join(MARKER_FILE)).expect("writable");
    folder.finish().expect_err("a folder is there");
    assert!(!folder.is_finished());
    fs::remove_dir(path.join(MARKER_FILE)).expect("removable");
    folder.abandon().expect("removable");
    assert_eq!(contents(&path), before, "the finished result is back, and nothing beside it");
}

#[test]
fn a_page_that_is_written_again_enters_the_list_again() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    let mut folder = ResultsFolder::reopen(&path).expect("finished");
    folder.write("report.html", b"first").expect("writable");
    folder.write("report.html", b"second").expect("writable");
    drop(folder);
    assert_eq!(FinishedResult::open(&path).expect("whole").read("report.html").expect("listed"), b"second");
    // As if the machine had stopped between the page and its entry.
    let text = fs::read_to_string(path.join(MARKER_FILE)).expect("the marker");
    let mut marker: Marker = serde_json::from_str(&text).expect("a marker");
    marker.files.remove("report.html");
    marker.write(&lock(&path)).expect("writable");
    fs::write(path.join("report.html"), "third").expect("writable");
    FinishedResult::open(&path).expect("the result is whole without its page");
    // As if somebody had changed it: it is written again.
    ResultsFolder::reopen(&path).expect("finished").write("report.html", b"second").expect("writable");
    fs::write(path.join("report.html"), "changed").expect("writable");
    FinishedResult::open(&path).expect_err("its page is not as it was written");
    ResultsFolder::reopen(&path).expect("its page does not matter").write("report.html", b"second").expect("writable");
    assert_eq!(FinishedResult::open(&path).expect("whole").read("report.html").expect("listed"), b"second");
}

#[test]
fn a_clock_before_1970_is_left_out() {
    let epoch = SystemTime::UNIX_EPOCH;
    assert_eq!(since(epoch - std::time::Duration::from_secs(1)), "");
    assert_eq!(since(epoch), ", since 1970-01-01T00:00:00Z");
}

#[cfg(unix)]
#[test]
fn no_link_below_the_root_of_results_is_followed() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().expect("a folder");
    let outside = desk.path().join("outside");
    fs::create_dir(&outside).expect("writable");
    fs::create_dir(desk.path().join("disk")).expect("writable");
    // The root itself may be a link: results often go to a larger disk.
    let root = desk.path().join("results");
    symlink("disk", &root).expect("writable");
    let served = Folder::open(desk.path()).expect("readable");
    let places = [Destination::Below(root.clone()), Destination::Within(served, "results".into())];
    let [below, within] = places.map(|place| Claim { destination: place, ..claim(&root, "a", false) });
    let is_link = |error: ResultsError| match error {
        ResultsError::Read { source, .. } => Refused::of(&source) == Some(Refused::Link),
        _ => false,
    };
    drop(below.take().expect("the root is followed"));
    assert!(is_link(within.take().expect_err("below an open folder no link is followed")));
    symlink("../outside", root.join("other")).expect("writable");
    let other = Claim { name: "other".to_owned(), ..below };
    assert!(is_link(other.take().expect_err("NAME is a link")));
    assert_eq!(fs::read_dir(&outside).expect("readable").count(), 0);
}

#[cfg(unix)]
#[test]
fn links_in_a_folder_of_results_lead_nowhere() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().expect("a folder");
    let [path, victim, secret] = ["out", "victim", "secret"].map(|name| desk.path().join(name));
    finished(&path, "a");
    fs::write(&victim, "of somebody").expect("writable");
    fs::write(&secret, "{\"secret\": 1}").expect("writable");
    // Names that earlier versions wrote to.
    for name in ["loosepin.json.partial", "history.csv.partial"] {
        symlink("../victim", path.join(name)).expect("writable");
    }
    finished_again(&path);
    assert_eq!(fs::read_to_string(&victim).expect("it stays"), "of somebody");
    for name in ["history.csv", MARKER_FILE] {
        let kept = fs::read(path.join(name)).expect("a file");
        fs::remove_file(path.join(name)).expect("removable");
        symlink("../secret", path.join(name)).expect("writable");
        let error = FinishedResult::open(&path).expect_err("a link").to_string();
        assert!(error.ends_with("it is a symbolic link, and links are not followed here"), "{error}");
        fs::remove_file(path.join(name)).expect("removable");
        fs::write(path.join(name), kept).expect("writable");
    }
}

#[cfg(unix)]
fn finished_again(path: &Path) {
    let mut folder = claim(path, "a", true).take().expect("ours");
    folder.write("history.csv", b"time_s\n").expect("writable");
    folder.finish().expect("writable");
}

#[test]
fn a_file_of_the_user_is_not_taken_for_one_that_waits() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    fs::write(path.join("history.csv.replaced"), "of the user").expect("writable");
    let before = contents(&path);
    let error = claim(&path, "b", true).take().expect_err("it is in the way");
    assert!(matches!(&error, ResultsError::AsideTaken { path } if path.ends_with("history.csv.replaced")), "{error}");
    assert_eq!(contents(&path), before);
}
