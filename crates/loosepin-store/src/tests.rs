//! Rows come back as they went in, or the store is refused.

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use loosepin_files::{FolderLock, LockKind, Refused};

use super::results::LOCK_FILE;
use super::{ExistingRuns, InputsKey, RunStore, STORE_FILE, StoreError, StoreIdentity, StoredRun, remove_store};

/// Rows of the stores of these tests.
const ROWS: u64 = 300;

fn identity() -> StoreIdentity {
    StoreIdentity { version: "0.3.7".to_owned(), inputs: "8c1f0d2a77".to_owned() }
}

/// An empty folder that is locked, and the path of a store in it.
fn folder() -> (tempfile::TempDir, Arc<FolderLock>, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(STORE_FILE);
    let lock = FolderLock::take(folder.path(), LockKind::Result, "test").unwrap();
    (folder, Arc::new(lock), path)
}

/// The run at a place: every seventh has failed, the others have some numbers, one of them not finite.
fn run(list: u32, place: u64) -> StoredRun {
    let inputs = InputsKey::of(format!("{list} {place}").as_bytes());
    let number = |k: u64| if k == 3 { f64::NAN } else { (place as f64 + 0.1) / (k as f64 + f64::from(list) + 0.7) };
    let outcome = if place % 7 == 2 { Err(place as u16) } else { Ok((0..5).map(number).collect()) };
    StoredRun { inputs, outcome }
}

fn is_same(a: &StoredRun, b: &StoredRun) -> bool {
    let bits = |run: &StoredRun| run.outcome.clone().map(|row| row.iter().map(|x| x.to_bits()).collect::<Vec<u64>>());
    a.inputs == b.inputs && bits(a) == bits(b)
}

fn fill(lock: &Arc<FolderLock>) {
    let store = RunStore::open(lock, &identity()).unwrap();
    for place in 0..ROWS {
        store.keep(0, place, run(0, place));
        store.keep(4, place + 1_000_000_007, run(4, place + 1_000_000_007));
    }
    assert_eq!(store.flush().unwrap(), 2 * ROWS);
}

#[test]
fn identity_rows_come_back_as_they_went_in() {
    let (_folder, lock, path) = folder();
    fill(&lock);
    let store = RunStore::open(&lock, &identity()).unwrap();
    assert_eq!(store.runs_at_start(), 2 * ROWS);
    for (list, first) in [(0, 0), (4, 1_000_000_007)] {
        let found = store.find(list, first + 10..first + ROWS + 20).unwrap();
        for (offset, found) in found.iter().enumerate() {
            let place = first + 10 + offset as u64;
            match found {
                Some(kept) => assert!(is_same(kept, &run(list, place)), "{place} {kept:?}"),
                None => assert!(place >= first + ROWS, "{place}"),
            }
        }
    }
    assert!(store.find(1, 0..8).unwrap().iter().all(Option::is_none));
    store.remove().unwrap();
    let left: Vec<_> = fs::read_dir(path.parent().unwrap()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, [LOCK_FILE]);
}

#[test]
fn what_is_kept_is_written_without_being_asked_for() {
    let (_folder, lock, path) = folder();
    let store = RunStore::open(&lock, &identity()).unwrap();
    store.keep(0, 3, run(0, 3));
    let log = path.with_file_name(super::STORE_COMPANIONS[0]);
    let before = fs::metadata(&log).unwrap().len();
    let patience = std::time::Instant::now();
    while fs::metadata(&log).unwrap().len() == before {
        if patience.elapsed() > 40 * super::LONGEST_UNSAVED {
            panic!("nothing was written");
        }
        std::thread::sleep(super::LONGEST_UNSAVED / 10);
    }
}

#[test]
fn a_second_one_is_refused_while_the_first_is_open() {
    let (_folder, lock, path) = folder();
    let store = RunStore::open(&lock, &identity()).unwrap();
    for beginning in [ExistingRuns::GoOn, ExistingRuns::Anew, ExistingRuns::Empty] {
        let error = RunStore::begin(&lock, &identity(), beginning).unwrap_err();
        assert_eq!(error, StoreError::InUse { path: path.clone() });
    }
    drop(store);
    assert!(RunStore::open(&lock, &identity()).is_ok());
}

#[test]
fn runs_of_another_study_or_version_are_refused_by_name() {
    let (_folder, lock, path) = folder();
    fill(&lock);
    let refused = |other: StoreIdentity| RunStore::open(&lock, &other).unwrap_err().to_string();
    let said = refused(StoreIdentity { version: "0.3.8".to_owned(), ..identity() });
    assert!(said.ends_with("contains runs of another version (0.3.7; this one is 0.3.8)"), "{said}");
    let said = refused(StoreIdentity { inputs: "77aa00bb11".to_owned(), ..identity() });
    assert!(said.ends_with("contains runs of another study (8c1f0d2a; this one is 77aa00bb)"), "{said}");
    let error = RunStore::begin(&lock, &identity(), ExistingRuns::Empty).unwrap_err();
    assert_eq!(error, StoreError::HoldsRuns { path: path.clone(), runs: 2 * ROWS });
    let anew = RunStore::begin(&lock, &identity(), ExistingRuns::Anew).unwrap();
    assert_eq!(anew.runs_at_start(), 0);
}

#[test]
fn a_file_of_something_else_is_refused() {
    let (_folder, lock, path) = folder();
    fs::write(&path, "slider [mm]\n".repeat(900)).unwrap();
    assert!(matches!(RunStore::open(&lock, &identity()), Err(StoreError::Damaged { .. })));
    remove_store(&lock).unwrap();
    rusqlite::Connection::open(&path).unwrap().execute_batch("CREATE TABLE notes (note TEXT)").unwrap();
    let error = RunStore::open(&lock, &identity()).unwrap_err();
    assert!(error.to_string().ends_with("it is a database, but not one of loosepin"), "{error}");
}

/// Whoever writes a file that is opened here could have whatever he likes run, without end or with all memory there is.
#[test]
fn tables_that_are_not_those_of_a_store_are_refused_before_they_are_read() {
    let endless = "WITH RECURSIVE n(k) AS (SELECT 0 UNION ALL SELECT k + 1 FROM n) SELECT";
    for (change, expected) in [
        (
            format!("DROP TABLE run; CREATE VIEW run AS {endless} 0 AS list, k AS place FROM n"),
            "'run' in it is no table of a store",
        ),
        (
            format!("DROP TABLE identity; CREATE VIEW identity AS {endless} 'version' AS name, k AS value FROM n"),
            "'identity' in it is no table of a store",
        ),
        ("ALTER TABLE run ADD COLUMN more AS (zeroblob(900000000))".to_owned(), "'run' in it is no table of a store"),
        (
            "CREATE TRIGGER grow AFTER INSERT ON run BEGIN DELETE FROM run; END".to_owned(),
            "'grow' in it is no table of a store",
        ),
        ("CREATE INDEX by_key ON run (hex(inputs))".to_owned(), "'by_key' in it is no table of a store"),
        ("DROP TABLE run".to_owned(), "it has no table 'run'"),
    ] {
        let (_folder, lock, path) = folder();
        fill(&lock);
        rusqlite::Connection::open(&path).unwrap().execute_batch(&change).unwrap();
        let error = RunStore::open(&lock, &identity()).unwrap_err();
        assert!(matches!(&error, StoreError::Damaged { reason, .. } if reason == expected), "{change}: {error}");
    }
}

/// The header of the file says by what version it may be written and by what format its tables are described.
#[test]
fn a_file_of_a_format_that_does_not_exist_is_damaged() {
    for (place, expected) in [(18, "its header is from another version of SQLite"), (47, "unsupported file format")] {
        let (_folder, lock, path) = folder();
        fill(&lock);
        let mut bytes = fs::read(&path).unwrap();
        bytes[place] = 9;
        fs::write(&path, bytes).unwrap();
        let written = RunStore::open(&lock, &identity()).and_then(|store| {
            store.keep(0, ROWS, run(0, ROWS));
            store.flush()
        });
        let error = written.unwrap_err();
        assert!(matches!(&error, StoreError::Damaged { reason, .. } if reason.contains(expected)), "{place}: {error}");
    }
}

/// Opens what is left of a store and reads all of it: every row that comes back must be the right one.
fn read_what_is_left(lock: &Arc<FolderLock>) -> Result<usize, StoreError> {
    let store = RunStore::open(lock, &identity())?;
    let mut known = 0;
    for (list, first) in [(0, 0), (4, 1_000_000_007)] {
        for (offset, found) in store.find(list, first..first + ROWS)?.iter().enumerate() {
            if let Some(kept) = found {
                assert!(is_same(kept, &run(list, first + offset as u64)), "{offset} {kept:?}");
                known += 1;
            }
        }
    }
    Ok(known)
}

/// A store as it lies on disk after the process was killed: the file, and the log if there was one.
fn killed(with_log: bool) -> Vec<(&'static str, Vec<u8>)> {
    let (_folder, lock, path) = folder();
    let mut names = vec![STORE_FILE];
    if with_log {
        let store = RunStore::open(&lock, &identity()).unwrap();
        for place in 0..ROWS {
            store.keep(0, place, run(0, place));
            if place % 20 == 19 {
                store.flush().unwrap();
            }
        }
        names.push(super::STORE_COMPANIONS[0]);
        names.iter().map(|name| (*name, fs::read(path.with_file_name(name)).unwrap())).collect()
    } else {
        fill(&lock);
        names.iter().map(|name| (*name, fs::read(path.with_file_name(name)).unwrap())).collect()
    }
}

fn lay_out(lock: &FolderLock, files: &[(&str, Vec<u8>)]) {
    remove_store(lock).unwrap();
    for (name, bytes) in files {
        fs::write(lock.folder().path().join(name), bytes).unwrap();
    }
}

/// A sequence of numbers that looks random, the same every time.
fn scattered(index: u64, below: usize) -> usize {
    (index.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(23) % below as u64) as usize
}

#[test]
fn identity_a_truncated_store_gives_right_rows_or_is_refused() {
    let (_folder, lock, _) = folder();
    let (mut refused, mut most, mut least) = (0, 0, usize::MAX);
    for with_log in [true, false] {
        let files = killed(with_log);
        for index in 0..250 {
            // Of a store that was killed the log is what was being written.
            let mut files = files.clone();
            let Some((_, bytes)) = files.last_mut() else { unreachable!() };
            bytes.truncate(scattered(index, bytes.len()));
            lay_out(&lock, &files);
            match read_what_is_left(&lock) {
                Ok(known) => (most, least) = (most.max(known), least.min(known)),
                Err(StoreError::Damaged { .. }) => refused += 1,
                Err(error) => panic!("{index}: {error}"),
            }
        }
    }
    // All three ends must have been met, or nothing was tried.
    assert!(refused > 100 && most > ROWS as usize / 2 && least == 0, "{refused} {least} {most}");
}

#[test]
fn identity_a_flipped_bit_gives_right_rows_or_is_refused() {
    let (_folder, lock, _) = folder();
    let mut refused = 0;
    for with_log in [true, false] {
        let files = killed(with_log);
        for index in 0..250 {
            let mut files = files.clone();
            let Some((_, bytes)) = files.last_mut() else { unreachable!() };
            let byte = scattered(index, bytes.len());
            bytes[byte] ^= 1 << (index % 8);
            lay_out(&lock, &files);
            match read_what_is_left(&lock) {
                Ok(_) => {}
                Err(StoreError::Damaged { .. } | StoreError::OfOther { .. }) => refused += 1,
                Err(error) => panic!("{index}: {error}"),
            }
        }
    }
    assert!(refused > 100, "{refused}");
}

#[cfg(unix)]
#[test]
fn links_and_pipes_in_the_place_of_a_file_of_the_store_are_refused() {
    use std::os::unix::fs::symlink;
    let (desk, _, _) = folder();
    let victim = desk.path().join("victim");
    fs::write(&victim, "").unwrap();
    for name in [STORE_FILE, "runs.sqlite-wal", "runs.sqlite-journal"] {
        for is_link in [true, false] {
            let (_folder, lock, path) = folder();
            let place = path.with_file_name(name);
            if is_link {
                symlink(&victim, &place).unwrap();
            } else {
                assert!(std::process::Command::new("mkfifo").arg(&place).status().unwrap().success());
            }
            let reason = if is_link { Refused::Link } else { Refused::NotAFile };
            let error = RunStore::open(&lock, &identity()).unwrap_err();
            assert_eq!(error, StoreError::NotUsable { path, reason: reason.to_string() }, "{name}");
            assert!(matches!(remove_store(&lock), Err(StoreError::NotUsable { .. })), "{name}");
        }
    }
    assert_eq!(fs::read(&victim).unwrap(), b"");
}

/// An old process whose folder was emptied and taken by another one writes no more, and does not remove the log of the new one.
#[cfg(unix)]
#[test]
fn a_store_that_was_replaced_is_left_alone_by_the_old_process() {
    let (_desk, lock, path) = folder();
    let old = RunStore::open(&lock, &identity()).unwrap();
    old.keep(0, 1, run(0, 1));
    old.flush().unwrap();
    for entry in fs::read_dir(path.parent().unwrap()).unwrap() {
        fs::remove_file(entry.unwrap().path()).unwrap();
    }
    let new_lock = Arc::new(FolderLock::take(path.parent().unwrap(), LockKind::Result, "test").unwrap());
    let new = RunStore::open(&new_lock, &identity()).unwrap();
    new.keep(0, 2, run(0, 2));
    assert_eq!(new.flush().unwrap(), 1);
    old.keep(0, 3, run(0, 3));
    assert!(old.flush().is_err() && old.publish().is_err());
    let log = path.with_file_name("runs.sqlite-wal");
    assert!(log.exists());
    drop(old);
    assert!(log.exists(), "the log of the new store");
    drop(new);
    let new = RunStore::open(&new_lock, &identity()).unwrap();
    assert_eq!(new.runs_at_start(), 1);
    assert!(new.find(0, 2..3).unwrap()[0].is_some());
}
