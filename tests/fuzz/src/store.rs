//! Opens a store of runs as `--resume` does, and reads all of it: rows as they were kept, or a refusal.
//!
//! The first byte of an input says what the others are:
//!
//! * `F`: the file `runs.sqlite`.
//! * `L`: two bytes, the length of the file in units of 64 bytes; the file; its log `runs.sqlite-wal`.
//! * `K`: the same, and the checksums of the log are made right, so that what stands in its frames is looked at.
//! * `R`: rows of a store, written by SQLite with whatever stands in their columns, and with the right checksum where they ask
//!   for it; and the tables that they stand in.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use loosepin::files::{Folder, FolderLock, LockKind};
use loosepin::store::{
    ExistingRuns, RunStore, STORE_COMPANIONS, STORE_FILE, Shard, StoreError, StoreIdentity, remove_store,
};

use super::log::with_right_checksums;
use super::rows::write_rows;

/// Lists whose runs are asked for.
const LISTS: u32 = 3;
/// Places of each that are asked for.
const PLACES: u64 = 64;
/// The length of a file before its log counts in these, so that two bytes say it.
const UNIT_BYTES: usize = 64;
/// Folder of the store that shards are joined in.
const JOINED: &str = "joined";

/// Whose runs the stores of inputs hold.
pub fn identity() -> StoreIdentity {
    StoreIdentity { version: "0.3.7".to_owned(), inputs: "8c1f0d2a77".to_owned() }
}

/// Opens what the input says and reads it; its files are in `folder` meanwhile.
pub fn read(bytes: &[u8], folder: &Path) {
    let path = folder.join(STORE_FILE);
    let lock = lock(folder);
    remove_store(&lock).unwrap_or_else(|error| panic!("{error}"));
    // A log whose forged checksums are right may have the file written at the other end of the disk.
    let may_fail = bytes.first() == Some(&b'K');
    if lay_out(bytes, &path) {
        for refused in
            [read_rows(&lock), join_rows(lock.folder(), &folder.join(JOINED))].into_iter().filter_map(Result::err)
        {
            match refused {
                StoreError::Damaged { .. } | StoreError::OfOther { .. } => {}
                StoreError::NotUsable { .. } if may_fail => {}
                _ => panic!("{refused}"),
            }
            super::model::show_one(loosepin::diagnostics::Diagnostic::error(&refused, None));
        }
    }
}

/// The lock of a folder, which is made where it is not there.
pub fn lock(folder: &Path) -> Arc<FolderLock> {
    Arc::new(FolderLock::take(folder, LockKind::Result, "fuzz").unwrap_or_else(|error| panic!("{error:?}")))
}

/// Writes the files of an input; whether there are any.
fn lay_out(bytes: &[u8], path: &Path) -> bool {
    let write = |path: &Path, bytes: &[u8]| {
        fs::write(path, bytes).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    };
    match bytes {
        [b'F', file @ ..] => write(path, file),
        [kind @ (b'L' | b'K'), low, high, rest @ ..] => {
            let length = UNIT_BYTES * usize::from(u16::from_le_bytes([*low, *high]));
            let (file, log) = rest.split_at(length.min(rest.len()));
            write(path, file);
            let log_path = path.with_file_name(STORE_COMPANIONS[0]);
            if *kind == b'K' {
                write(&log_path, &with_right_checksums(log));
            } else {
                write(&log_path, log);
            }
        }
        [b'R', rest @ ..] => return write_rows(rest, path, &identity()),
        _ => return false,
    }
    true
}

/// Opens the store to go on with it, and looks rows up.
fn read_rows(lock: &Arc<FolderLock>) -> Result<(), StoreError> {
    let store = RunStore::begin(lock, &identity(), ExistingRuns::GoOn)?;
    for list in 0..LISTS {
        let found = store.find(list, 0..PLACES)?;
        assert_eq!(found.len() as u64, PLACES);
    }
    store.flush().map(|_| ())
}

/// Takes all rows over into another store, as `merge` does.
fn join_rows(shard: &Folder, folder: &Path) -> Result<(), StoreError> {
    let joined = lock(folder);
    remove_store(&joined)?;
    let all = Shard::new(1, 1).into_iter().map(|number| (number, shard.clone())).collect::<Vec<_>>();
    let (store, added) = RunStore::begin_joined(&joined, &identity(), ExistingRuns::GoOn, &all)?;
    assert_eq!(store.runs_at_start(), added);
    store.remove()
}
