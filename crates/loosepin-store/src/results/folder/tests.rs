//! Folders are claimed, refused, taken over and finished.

use super::*;
use crate::results::InputsHasher;
use loosepin_text::diagnostics::Problem;

fn claim(path: &Path, input: &str, with_force: bool) -> Claim {
    Claim {
        kind: ResultKind::Simulation,
        name: "Worn pin / 5000 rpm".to_owned(),
        inputs: InputsHasher::new(ResultKind::Simulation).add("model", input).finish(),
        place: Place::Folder(path.to_owned()),
        with_force,
    }
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
    ] {
        assert_eq!(folder_name(name), folder);
    }
    assert_eq!(folder_name(&"a b".repeat(100)).chars().count(), LONGEST_NAME_CHARS);
}

#[test]
fn each_set_of_inputs_has_its_folder() {
    let root = tempfile::tempdir().expect("a folder");
    let below = |input| Claim { place: Place::Below(root.path().to_owned()), ..claim(root.path(), input, false) };
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
    assert!(matches!(ResultsFolder::open(&path), Err(ResultsError::Unfinished { .. })));
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
    fs::write(path.join("loosepin.json.partial"), b"{\"kin").expect("writable");
    finished(&path, "a");
    assert!(!path.join("loosepin.json.partial").exists());
    fs::remove_file(path.join(MARKER_FILE)).expect("writable");
    fs::write(path.join("loosepin.json.partial"), b"{\"kin").expect("writable");
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
            "{} holds another simulation, 'Worn pin / 5000 rpm' (inputs {inputs}, version {version}); nothing is overwritten",
            path.display()
        )
    );
    assert_eq!(error.hint().as_deref(), Some("give another folder, or --force to replace these results"));
    let study = Claim { kind: ResultKind::Study, ..claim(&path, "b", false) };
    assert!(study.take().expect_err("a simulation").to_string().contains(" holds a simulation, 'Worn pin"));
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
        format!("{} holds files that are not results, 'summer.jpg' for one; nothing is overwritten", other.display())
    );
    assert!(claim(&other, "a", true).take().is_ok());
    assert!(other.join("summer.jpg").exists());
    let file = root.path().join("file");
    fs::write(&file, "x").expect("writable");
    assert_eq!(
        claim(&file, "a", true).take().expect_err("a file").to_string(),
        format!("{} is a file; expected a folder", file.display())
    );
    assert!(matches!(ResultsFolder::open(&root.path().join("none")), Err(ResultsError::NoSuchFolder { .. })));
    assert!(matches!(ResultsFolder::open(root.path()), Err(ResultsError::NoMarker { .. })));
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
        ResultsFolder::open(&path).expect("finished").marker.inputs_blake3,
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
    let text =
        text.replace("\"history.csv\"\n  ]", "\"history.csv\"\n  ],\n  \"replaced\": [\n    \"history.csv\"\n  ]");
    fs::write(path.join(MARKER_FILE), text).expect("writable");
    assert!(claim(&path, "a", false).take().expect("ours").is_finished());
    assert_eq!(contents(&path), before);
}

#[test]
fn a_lock_that_is_refused_changes_nothing() {
    let root = tempfile::tempdir().expect("a folder");
    let refuse = |_: &Path| -> Result<(), Complaints> {
        Err(Complaints::one(&ResultsError::NoSuchFolder { folder: "busy".into() }, None))
    };
    let fresh = root.path().join("a/b/out");
    claim(&fresh, "a", false).take_locked(&[], refuse).expect_err("busy");
    assert!(first_entry(root.path(), &[]).expect("readable").is_none(), "folders that were made for it are gone");
    finished(&fresh, "a");
    let before = fs::read(fresh.join(MARKER_FILE)).expect("the marker");
    claim(&fresh, "b", true).take_locked(&[], refuse).expect_err("busy");
    assert_eq!(fs::read(fresh.join(MARKER_FILE)).expect("the marker"), before);
    assert!(fresh.join("history.csv").exists());
    assert!(claim(&fresh, "a", false).take_locked(&[], refuse).expect("finished").1.is_none(), "without the lock");
}

#[test]
fn what_is_finished_while_the_lock_is_waited_for_is_found() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    let lock = |folder: &Path| -> Result<(), Complaints> {
        if !folder.join(MARKER_FILE).exists() {
            finished(folder, "a");
        }
        Ok(())
    };
    let (folder, held) = claim(&path, "a", false).take_locked(&["lock"], lock).expect("finished meanwhile");
    assert!(folder.is_finished() && held.is_none());
    // What a process leaves that was killed between lock and marker says nothing of the folder.
    let left = root.path().join("left");
    fs::create_dir(&left).expect("writable");
    fs::write(left.join("lock"), "").expect("writable");
    let take = |lock_files: &[&str]| claim(&left, "a", false).take_locked(lock_files, |_| Ok(()));
    take(&[]).expect_err("a file of somebody's");
    take(&["lock"]).expect("nobody's");
}
