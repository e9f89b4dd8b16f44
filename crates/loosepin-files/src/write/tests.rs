use super::*;
use crate::lock::LockKind;
use std::fs;

const NAME: &str = LockKind::Result.file_name();

fn taken(folder: &Path) -> FolderLock {
    FolderLock::take(folder, LockKind::Result, "process 4711").unwrap()
}

/// Names in a folder without that of the lock.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = entries.filter(|name| name != NAME).collect();
    names.sort();
    names
}

#[test]
fn a_file_is_written_replaced_renamed_and_removed() {
    let desk = tempfile::tempdir().unwrap();
    let lock = taken(desk.path());
    lock.write("a", b"one").unwrap();
    lock.write("a", b"two").unwrap();
    lock.write("b", b"three").unwrap();
    lock.rename("a", "b").unwrap();
    assert_eq!((names(desk.path()), fs::read(desk.path().join("b")).unwrap()), (vec!["b".to_owned()], b"two".to_vec()));
    lock.remove("b").unwrap();
    lock.remove("b").unwrap();
    assert_eq!(names(desk.path()), [""; 0]);
    for name in ["", ".", "..", "a/b", "/a", "a/", "a\0"] {
        assert_eq!(Refused::of(&lock.write(name, b"").unwrap_err()), Some(Refused::BadName), "{name:?}");
    }
}

#[cfg(unix)]
#[test]
fn the_mode_of_a_file_is_kept_and_a_read_only_one_stays() {
    use std::os::unix::fs::PermissionsExt;
    let desk = tempfile::tempdir().unwrap();
    let lock = taken(desk.path());
    let path = desk.path().join("model.toml");
    for mode in [0o600, 0o640, 0o664, 0o755] {
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
        lock.write("model.toml", b"new").unwrap();
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o7777, mode);
        assert_eq!(fs::read(&path).unwrap(), b"new");
    }
    fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
    assert_eq!(Refused::of(&lock.write("model.toml", b"newer").unwrap_err()), Some(Refused::ReadOnly));
    assert_eq!((names(desk.path()), fs::read(&path).unwrap()), (vec!["model.toml".to_owned()], b"new".to_vec()));
}

#[cfg(unix)]
#[test]
fn links_pipes_and_folders_are_not_replaced() {
    use std::os::unix::fs::symlink;
    let desk = tempfile::tempdir().unwrap();
    let folder = desk.path().join("folder");
    let lock = taken(&folder);
    fs::write(desk.path().join("victim"), "of somebody").unwrap();
    symlink("../victim", folder.join("link")).unwrap();
    fs::create_dir(folder.join("inner")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(folder.join("pipe")).status().unwrap().success());
    fs::write(folder.join("file"), "text").unwrap();
    for (name, reason) in [("link", Some(Refused::Link)), ("pipe", Some(Refused::NotAFile)), ("inner", None)] {
        for outcome in
            [lock.write(name, b"text"), lock.rename("file", name), lock.rename(name, "new"), lock.remove(name)]
        {
            assert_eq!(Refused::of(&outcome.unwrap_err()), reason, "{name}");
        }
        assert_eq!(lock.write_new(&[(name, b"text")]).unwrap_err().kind(), io::ErrorKind::AlreadyExists, "{name}");
    }
    assert_eq!(names(&folder), ["file", "inner", "link", "pipe"]);
    assert_eq!(fs::read_to_string(desk.path().join("victim")).unwrap(), "of somebody");
}

#[test]
fn new_files_come_all_or_not_at_all() {
    let desk = tempfile::tempdir().unwrap();
    let lock = taken(desk.path());
    fs::write(desk.path().join("b"), "of the user").unwrap();
    let both: [(&str, &[u8]); 2] = [("a", b"1"), ("b", b"2")];
    assert_eq!(lock.write_new(&both).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
    assert_eq!(
        (names(desk.path()), fs::read(desk.path().join("b")).unwrap()),
        (vec!["b".to_owned()], b"of the user".to_vec())
    );
    fs::remove_file(desk.path().join("b")).unwrap();
    lock.write_new(&both).unwrap();
    assert_eq!(names(desk.path()), ["a", "b"]);
}

#[test]
fn a_new_folder_comes_with_all_its_files_or_not_at_all() {
    let desk = tempfile::tempdir().unwrap();
    let lock = taken(desk.path());
    lock.write_new_folder("press", &[("model.toml", b"1"), ("study.toml", b"2")]).unwrap();
    assert_eq!(names(&desk.path().join("press")), ["model.toml", "study.toml"]);
    let again = lock.write_new_folder("press", &[("model.toml", b"3")]).unwrap_err();
    assert_eq!(again.kind(), io::ErrorKind::AlreadyExists);
    // The second name is none: the first file goes with the folder.
    assert!(lock.write_new_folder("arm", &[("model.toml", b"1"), ("..", b"2")]).is_err());
    assert_eq!(names(desk.path()), ["press"]);
    assert_eq!(fs::read(desk.path().join("press/model.toml")).unwrap(), b"1");
}

#[test]
fn a_move_between_folders_replaces_nothing() {
    let desk = tempfile::tempdir().unwrap();
    let [from, to] = ["from", "to"].map(|name| desk.path().join(name));
    fs::create_dir(&from).unwrap();
    fs::create_dir(&to).unwrap();
    let [source, target] = [taken(&from), taken(&to)];
    fs::write(from.join("a"), "1").unwrap();
    fs::create_dir(from.join("inner")).unwrap();
    fs::write(from.join("inner/b"), "2").unwrap();
    for name in ["a", "inner"] {
        source.move_new(name, &target).unwrap();
    }
    assert!(names(&from).is_empty());
    assert_eq!(
        (names(&to), names(&to.join("inner"))),
        (vec!["a".to_owned(), "inner".to_owned()], vec!["b".to_owned()])
    );
    fs::write(from.join("a"), "3").unwrap();
    fs::create_dir(from.join("inner")).unwrap();
    for name in ["a", "inner"] {
        assert_eq!(source.move_new(name, &target).unwrap_err().kind(), io::ErrorKind::AlreadyExists, "{name}");
    }
    assert_eq!(fs::read(to.join("a")).unwrap(), b"1");
    for name in ["../a", "", "."] {
        assert_eq!(Refused::of(&source.move_new(name, &target).unwrap_err()), Some(Refused::BadName), "{name}");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("a", from.join("link")).unwrap();
        assert_eq!(Refused::of(&source.move_new("link", &target).unwrap_err()), Some(Refused::Link));
    }
    // Empty folders go up to one that is not.
    fs::create_dir_all(desk.path().join("x/y/z")).unwrap();
    fs::write(desk.path().join("x/kept"), "").unwrap();
    let folder = Folder::open(desk.path()).unwrap();
    folder.remove_empty_below(Path::new("x/y/z")).unwrap();
    assert_eq!(names(&desk.path().join("x")), ["kept"]);
    assert_eq!(Refused::of(&folder.remove_empty_below(Path::new("x/../x")).unwrap_err()), Some(Refused::BadName));
}

#[cfg(unix)]
#[test]
fn a_writer_that_was_ousted_before_its_rename_has_nothing_to_rename() {
    let desk = tempfile::tempdir().unwrap();
    let old = taken(desk.path());
    let temporary = old.write_temporary(b"old", NEW_MODE, None).unwrap();
    old.check().unwrap();
    // Here it was stopped. Another process removes the lock, takes the folder and finishes.
    fs::remove_file(desk.path().join(NAME)).unwrap();
    let new = taken(desk.path());
    new.write("summary.json", b"new").unwrap();
    let renamed = old.folder.directory.rename(OsStr::new(&temporary.name), OsStr::new("summary.json"));
    assert_eq!(renamed.unwrap_err().kind(), io::ErrorKind::NotFound);
    assert_eq!(fs::read(desk.path().join("summary.json")).unwrap(), b"new");
}
