//! The runs of several shards in one store.

use std::path::Path;

use loosepin_files::Folder;

use super::error::StoreError;
use super::file::StoreFile;
use super::files::STORE_FILE;
use super::identity::StoreIdentity;
use super::row::StoredRun;
use super::shard::Shard;

/// Rows that are written together.
const ROWS_PER_COMMIT: usize = 4096;

/// Adds the runs of the stores in the folders of `shards` to `joined`; gives how many were not there before. Each row is checked; one that is
/// there already must be the same. Whenever it is stopped it can be done again.
///
/// # Errors
/// [`StoreError`]: a store is in use (its shard is at work still), damaged, of another study or version, or holds a run that
/// is another shard's.
pub(super) fn join(
    joined: &mut StoreFile,
    identity: &StoreIdentity,
    shards: &[(Shard, Folder)],
) -> Result<u64, StoreError> {
    let mut added = 0;
    for (shard, of_shard) in shards {
        let store = of_shard.path().join(STORE_FILE);
        let found = of_shard.find(Path::new(STORE_FILE)).map_err(|error| StoreError::not_usable(&store, &error))?;
        if found.is_none() {
            // Its shard has kept no run yet.
            continue;
        }
        let part = StoreFile::open(of_shard, identity)?;
        let damaged = |reason: String| StoreError::Damaged { path: of_shard.path().join(STORE_FILE), reason };
        let mut waiting: Vec<(u32, u64, StoredRun)> = Vec::new();
        part.for_each(|list, place, run| {
            if !shard.makes(place) {
                let owner = Shard::index_for_run(place, shard.of());
                return Err(damaged(format!(
                    "run {place} of list {list} is one of shard {owner}/{}, not of {shard}",
                    shard.of()
                )));
            }
            match joined.find(list, place..place + 1)?.pop().flatten() {
                Some(known) if known.is_same(&run) => return Ok(()),
                Some(_) => {
                    return Err(damaged(format!(
                        "run {place} of list {list} is in {} already, with other numbers",
                        joined.path().display()
                    )));
                }
                None => waiting.push((list, place, run)),
            }
            added += 1;
            if waiting.len() == ROWS_PER_COMMIT {
                joined.commit(&waiting)?;
                waiting.clear();
            }
            Ok(())
        })?;
        joined.commit(&waiting)?;
    }
    Ok(added)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ExistingRuns, InputsKey, RunStore};
    use loosepin_files::{FolderLock, LockKind};
    use std::sync::Arc;

    /// Rows of a list: not a multiple of the shards.
    const ROWS: u64 = 50;

    fn identity() -> StoreIdentity {
        StoreIdentity { version: "0.3.7".to_owned(), inputs: "8c1f0d2a77".to_owned() }
    }

    fn run(list: u32, place: u64) -> StoredRun {
        let outcome = if place % 7 == 2 { Err(3) } else { Ok(vec![place as f64 / 3.7, f64::from(list) + 0.3]) };
        StoredRun { inputs: InputsKey::of(format!("{list} {place}").as_bytes()), outcome }
    }

    /// The store of a shard with its rows of the lists 0 and 2.
    fn shard(desk: &Path, index: u32, of: u32) -> (Shard, Folder) {
        let shard = Shard::new(index, of).unwrap();
        let lock = lock(&shard.folder(&desk.join("bounds")));
        let store = RunStore::open(&lock, &identity()).unwrap();
        for list in [0, 2] {
            (0..ROWS).filter(|&place| shard.makes(place)).for_each(|place| store.keep(list, place, run(list, place)));
        }
        store.flush().unwrap();
        (shard, lock.folder().clone())
    }

    fn lock(folder: &Path) -> Arc<FolderLock> {
        Arc::new(FolderLock::take(folder, LockKind::Result, "test").unwrap())
    }

    /// How many rows of `shards` were new to the store in a locked folder.
    fn join_stores(lock: &Arc<FolderLock>, shards: &[(Shard, Folder)]) -> Result<u64, StoreError> {
        RunStore::begin_joined(lock, &identity(), ExistingRuns::GoOn, shards).map(|(_, added)| added)
    }

    #[test]
    fn identity_joined_shards_hold_every_row_once() {
        let desk = tempfile::tempdir().unwrap();
        let shards: Vec<(Shard, Folder)> = (1..=3).map(|index| shard(desk.path(), index, 3)).collect();
        let joined = lock(desk.path());
        assert_eq!(join_stores(&joined, &shards[..2]).unwrap(), 2 * 34);
        assert_eq!(join_stores(&joined, &shards).unwrap(), 2 * (ROWS - 34));
        assert_eq!(join_stores(&joined, &shards).unwrap(), 0, "again changes nothing");
        let store = RunStore::open(&joined, &identity()).unwrap();
        store.publish().unwrap();
        // Another shard finds in the copy what it does not have itself, whatever happens to the store meanwhile.
        let own = lock(shards[0].1.path());
        let published = joined.folder();
        let beside = RunStore::open_beside(&own, Some(published), &identity()).unwrap();
        store.keep(0, ROWS, run(0, ROWS));
        store.publish().unwrap();
        for list in [0, 2] {
            let found = beside.find(list, 0..ROWS + 1).unwrap();
            for (place, found) in (0..).zip(&found[..ROWS as usize]) {
                assert!(found.as_ref().unwrap().is_same(&run(list, place)), "{list} {place}");
            }
            assert!(found[ROWS as usize].is_none());
        }
        drop(beside);
        let later = RunStore::open_beside(&own, Some(published), &identity()).unwrap();
        assert!(later.find(0, ROWS..ROWS + 1).unwrap()[0].is_some());
    }

    #[test]
    fn rows_of_other_shards_and_other_numbers_are_refused_by_name() {
        let desk = tempfile::tempdir().unwrap();
        let (one, folder) = shard(desk.path(), 1, 2);
        let joined = lock(desk.path());
        let said = |shards: &[(Shard, Folder)]| join_stores(&joined, shards).unwrap_err().to_string();
        let other = said(&[(Shard::new(2, 2).unwrap(), folder.clone())]);
        assert!(other.ends_with("is damaged: run 0 of list 0 is one of shard 1/2, not of 2/2"), "{other}");
        join_stores(&joined, &[(one, folder.clone())]).unwrap();
        let store = RunStore::open(&lock(folder.path()), &identity()).unwrap();
        let busy = said(&[(one, folder.clone())]);
        assert!(busy.ends_with("is in use by another loosepin process"), "{busy}");
        store.keep(2, 4, StoredRun { outcome: Ok(vec![0.7]), ..run(2, 4) });
        drop(store);
        let differs = said(&[(one, folder)]);
        assert!(differs.ends_with("runs.sqlite already, with other numbers"), "{differs}");
        assert!(differs.contains("is damaged: run 4 of list 2 is in "), "{differs}");
    }
}
