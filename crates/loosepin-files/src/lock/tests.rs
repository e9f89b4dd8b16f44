use super::*;
use std::fs;
use std::sync::atomic::{AtomicUsize, Ordering};

const KIND: LockKind = LockKind::Result;
const NAME: &str = KIND.file_name();

fn take(folder: &Path) -> Result<FolderLock, LockError> {
    FolderLock::take(folder, KIND, "process 4711")
}

fn refused(error: LockError) -> Option<Refused> {
    match error {
        LockError::File { source, .. } => Refused::of(&source),
        LockError::InUse { .. } => None,
    }
}

#[test]
fn the_second_writer_is_told_of_the_first() {
    let desk = tempfile::tempdir().unwrap();
    let folder = desk.path().join("a/b");
    let first = take(&folder).expect("a new folder");
    let LockError::InUse { holder } = take(&folder).expect_err("it is held") else { panic!("not in use") };
    assert_eq!(holder.as_deref(), Some("process 4711"));
    drop(first);
    assert!(!desk.path().join("a").exists(), "nothing is left of it");
    // Left behind by a process that was killed: it is not locked any more.
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(NAME), "loosepin lock\nprocess 1\nand more").unwrap();
    drop(take(&folder).expect("nobody holds it"));
    assert!(folder.exists(), "it was there before");
}

#[test]
fn a_file_in_the_place_of_the_folder_is_refused_at_once() {
    let desk = tempfile::tempdir().unwrap();
    let file = desk.path().join("out");
    fs::write(&file, "results of somebody").unwrap();
    assert!(matches!(take(&file), Err(LockError::File { .. })));
    assert_eq!(fs::read_to_string(&file).unwrap(), "results of somebody");
}

#[cfg(unix)]
#[test]
fn links_and_pipes_are_no_locks() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().unwrap();
    let victim = desk.path().join("victim");
    fs::write(&victim, "of somebody").unwrap();
    let folder = desk.path().join("out");
    fs::create_dir(&folder).unwrap();
    symlink("../victim", folder.join(NAME)).unwrap();
    assert_eq!(refused(take(&folder).unwrap_err()), Some(Refused::Link));
    assert_eq!(fs::read_to_string(&victim).unwrap(), "of somebody");
    fs::remove_file(folder.join(NAME)).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(folder.join(NAME)).status().unwrap().success());
    assert_eq!(refused(take(&folder).unwrap_err()), Some(Refused::NotAFile));
    // A link that leads nowhere is no folder to be made.
    symlink("nowhere", desk.path().join("dangling")).unwrap();
    assert_eq!(refused(take(&desk.path().join("dangling/out")).unwrap_err()), Some(Refused::Link));
    // Links above the folder are the choice of the user; below an open folder they are not followed.
    symlink("out", desk.path().join("results")).unwrap();
    fs::remove_file(folder.join(NAME)).unwrap();
    drop(take(&desk.path().join("results")).unwrap());
    let base = Folder::open(desk.path()).unwrap();
    let below = FolderLock::wait_below(&base, Path::new("results/name"), KIND, "process 4711", Duration::ZERO);
    assert_eq!(refused(below.unwrap_err()), Some(Refused::Link));
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
}

/// What a user has put there under our name is neither changed nor removed.
#[test]
fn a_file_of_somebody_else_is_no_lock() {
    let desk = tempfile::tempdir().unwrap();
    let long = format!("loosepin lock\n{}", "x".repeat(5000));
    for kind in [LockKind::Result, LockKind::Text] {
        for text in ["of the user", "of the user\nand more\n", "loosepin locks\n", &long] {
            let path = desk.path().join(kind.file_name());
            fs::write(&path, text).unwrap();
            for is_read_only in [false, true] {
                let mut permissions = fs::metadata(&path).unwrap().permissions();
                permissions.set_readonly(is_read_only);
                fs::set_permissions(&path, permissions).unwrap();
                let refusal = FolderLock::take(desk.path(), kind, "process 4711").unwrap_err();
                assert_eq!(refused(refusal), Some(Refused::ForeignLock), "{text}");
                assert_eq!(fs::read_to_string(&path).unwrap(), text);
            }
            fs::remove_file(&path).unwrap();
        }
        // Of a process that was stopped between making it and the end of writing into it.
        for text in ["", "loosepin l", "loosepin lock\nproc"] {
            fs::write(desk.path().join(kind.file_name()), text).unwrap();
            drop(FolderLock::take(desk.path(), kind, "process 4711").unwrap());
        }
    }
}

#[cfg(unix)]
#[test]
fn a_hard_link_is_no_lock() {
    let desk = tempfile::tempdir().unwrap();
    let victim = desk.path().join("victim");
    for text in ["", "loosepin lock\nprocess 4711\n", "of the user"] {
        fs::write(&victim, text).unwrap();
        let folder = desk.path().join("out");
        fs::create_dir(&folder).unwrap();
        fs::hard_link(&victim, folder.join(NAME)).unwrap();
        assert_eq!(refused(take(&folder).unwrap_err()), Some(Refused::HardLink), "{text}");
        assert_eq!(fs::read_to_string(&victim).unwrap(), text);
        assert_eq!(fs::read_to_string(folder.join(NAME)).unwrap(), text);
        fs::remove_dir_all(&folder).unwrap();
    }
}

#[cfg(unix)]
#[test]
fn a_process_that_lost_the_lock_changes_nothing_more() {
    let desk = tempfile::tempdir().unwrap();
    let folder = desk.path().join("out");
    let old = take(&folder).unwrap();
    old.write("summary.json", b"old").unwrap();
    // Emptied, and taken by another process that finishes.
    for entry in fs::read_dir(&folder).unwrap() {
        fs::remove_file(entry.unwrap().path()).unwrap();
    }
    let new = take(&folder).unwrap();
    new.write("summary.json", b"new").unwrap();
    let lost = |found: io::Result<()>| Refused::of(&found.unwrap_err()) == Some(Refused::LockLost);
    assert!(lost(old.write("summary.json", b"old again")));
    assert!(lost(old.write_new(&[("other", b"old")])));
    assert!(lost(old.write_new_folder("folder", &[("other", b"old")])));
    assert!(lost(old.remove("summary.json")));
    assert!(lost(old.rename("summary.json", "other")));
    drop(old);
    assert!(folder.join(NAME).exists(), "the lock of the new holder stays");
    assert_eq!(fs::read(folder.join("summary.json")).unwrap(), b"new");
    drop(new);
    let left: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["summary.json"]);
}

#[cfg(unix)]
#[test]
fn a_folder_that_was_removed_is_not_made_anew() {
    let desk = tempfile::tempdir().unwrap();
    let path = desk.path().join("served");
    fs::create_dir(&path).unwrap();
    let served = Folder::open(&path).unwrap();
    fs::remove_dir(&path).unwrap();
    assert!(FolderLock::wait(&served, KIND, "process 4711", Duration::ZERO).is_err());
    assert!(FolderLock::wait_below(&served, Path::new("results"), KIND, "process 4711", Duration::ZERO).is_err());
    assert!(!path.exists());
}

#[test]
fn what_a_stopped_writer_left_goes_and_nothing_else() {
    let desk = tempfile::tempdir().unwrap();
    let left = desk.path().join(".loosepin-0123456789abcdef.partial");
    fs::write(&left, "half").unwrap();
    let left_folder = desk.path().join(".loosepin-fedcba9876543210.partial");
    fs::create_dir(&left_folder).unwrap();
    fs::write(left_folder.join("model.toml"), "half").unwrap();
    for own in ["model.toml.partial", "loosepin.json.partial", ".loosepin-notes.partial"] {
        fs::write(desk.path().join(own), "of the user").unwrap();
    }
    drop(take(desk.path()).unwrap());
    assert!(!left.exists() && !left_folder.exists());
    assert_eq!(fs::read_dir(desk.path()).unwrap().count(), 3);
}

#[test]
fn never_two_at_once() {
    const WRITERS: usize = 8;
    const ROUNDS: usize = 200;
    let desk = tempfile::tempdir().unwrap();
    let folder = desk.path().join("out");
    let (inside, held) = (AtomicUsize::new(0), AtomicUsize::new(0));
    std::thread::scope(|scope| {
        for _ in 0..WRITERS {
            scope.spawn(|| {
                for _ in 0..ROUNDS {
                    match take(&folder) {
                        Ok(lock) => {
                            assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0, "two hold the folder");
                            held.fetch_add(1, Ordering::SeqCst);
                            assert!(folder.join(NAME).exists(), "the file of the holder is gone");
                            inside.fetch_sub(1, Ordering::SeqCst);
                            drop(lock);
                        }
                        Err(LockError::InUse { .. }) => {}
                        Err(error) => panic!("{error:?}"),
                    }
                }
            });
        }
    });
    // How often depends on how the threads are scheduled.
    assert!(held.into_inner() > 0, "nobody ever held it");
    // It may stay, where another one had made it than held it last.
    let left = fs::read_dir(&folder).map_or(0, Iterator::count);
    assert_eq!(left, 0, "no file is left");
}

#[test]
fn identity_each_of_many_waiting_writers_adds_one() {
    const WRITERS: usize = 8;
    const ROUNDS: usize = 50;
    let desk = tempfile::tempdir().unwrap();
    fs::write(desk.path().join("count"), "0").unwrap();
    std::thread::scope(|scope| {
        for _ in 0..WRITERS {
            scope.spawn(|| {
                let folder = Folder::open(desk.path()).unwrap();
                for _ in 0..ROUNDS {
                    let lock = FolderLock::wait(&folder, KIND, "process 4711", Duration::from_secs(60)).unwrap();
                    let count = folder.read(Path::new("count"), 100).unwrap();
                    let count: usize = String::from_utf8(count).unwrap().parse().unwrap();
                    lock.write("count", (count + 1).to_string().as_bytes()).unwrap();
                }
            });
        }
    });
    assert_eq!(fs::read_to_string(desk.path().join("count")).unwrap(), (WRITERS * ROUNDS).to_string());
}

#[test]
fn writers_under_the_other_lock_of_a_folder_keep_their_temporary_files() {
    let desk = tempfile::tempdir().unwrap();
    let result = take(desk.path()).unwrap();
    let copy = desk.path().join(result.temporary_name().unwrap());
    let journal = copy.with_extension("partial-journal");
    fs::write(&copy, "a copy that takes long").unwrap();
    fs::write(&journal, "its journal").unwrap();
    let folder = Folder::open(desk.path()).unwrap();
    let text = FolderLock::wait(&folder, LockKind::Text, "process 4711", Duration::ZERO).unwrap();
    let half = desk.path().join(text.temporary_name().unwrap());
    fs::write(&half, "half a text").unwrap();
    assert!(copy.exists() && journal.exists());
    drop(result);
    drop(take(desk.path()).unwrap());
    assert!(!copy.exists() && !journal.exists() && half.exists());
    drop(text);
    drop(FolderLock::wait(&folder, LockKind::Text, "process 4711", Duration::ZERO).unwrap());
    assert!(!half.exists());
}

#[test]
fn what_cannot_be_removed_keeps_nobody_from_the_lock() {
    let desk = tempfile::tempdir().unwrap();
    let left = desk.path().join(".loosepin-0123456789abcdef.partial");
    fs::create_dir_all(left.join("inner")).unwrap();
    let lock = take(desk.path()).unwrap();
    lock.write("a", b"text").unwrap();
    assert!(left.exists());
}

/// A file system without locks: what is written is whole all the same.
#[test]
fn a_file_is_written_without_a_lock() {
    let desk = tempfile::tempdir().unwrap();
    let lock = FolderLock::without(&Folder::open(desk.path()).unwrap(), LockKind::Text);
    lock.write("a", b"text").unwrap();
    drop(lock);
    let left: Vec<_> = fs::read_dir(desk.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["a"]);
}
