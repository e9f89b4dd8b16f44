//! The runs of several shards in one store.

use std::path::{Path, PathBuf};

use super::error::StoreError;
use super::file::StoreFile;
use super::row::KeptRun;
use super::{Shard, StoreIdentity};

/// Rows that are written together.
const ROWS_PER_COMMIT: usize = 4096;

/// Adds the runs of `shards` to the store at `path`, which is made where there is none; gives how many were not there before. Each
/// row is checked; one that is there already must be the same. Whenever it is stopped it can be done again.
///
/// # Errors
/// [`StoreError`]: a store is in use (its shard is at work still), damaged, of another study or version, or holds a run that
/// is another shard's.
pub fn join_stores(path: &Path, identity: &StoreIdentity, shards: &[(Shard, PathBuf)]) -> Result<u64, StoreError> {
    let mut joined = StoreFile::open(path, identity)?;
    let mut added = 0;
    for (shard, of_shard) in shards {
        let part = StoreFile::open(of_shard, identity)?;
        let damaged = |reason: String| StoreError::Damaged { path: of_shard.clone(), reason };
        let mut waiting: Vec<(u32, u64, KeptRun)> = Vec::new();
        part.for_each(|list, place, run| {
            if !shard.makes(place) {
                let maker = Shard::maker(place, shard.of());
                return Err(damaged(format!(
                    "run {place} of list {list} is one of shard {maker}/{}, not of {shard}",
                    shard.of()
                )));
            }
            match joined.find(list, place..place + 1)?.pop().flatten() {
                Some(known) if known.is_same(&run) => return Ok(()),
                Some(_) => {
                    return Err(damaged(format!(
                        "run {place} of list {list} is in {} already, with other numbers",
                        path.display()
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
