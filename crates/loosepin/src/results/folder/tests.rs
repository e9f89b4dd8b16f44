//! Folders are claimed, refused, taken over and finished.

use super::*;
use crate::diagnostics::Problem;
use crate::results::InputsHasher;

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
fn results_of_other_inputs_are_refused_or_replaced() {
    let root = tempfile::tempdir().expect("a folder");
    let path = root.path().join("out");
    finished(&path, "a");
    fs::write(path.join("notes.txt"), "mine").expect("writable");
    let error = claim(&path, "b", false).take().expect_err("another simulation");
    let inputs = claim(&path, "a", false).inputs.short();
    let version = crate::VERSION;
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
        format!("{} is a file; a folder is due", file.display())
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
