//! The files of a store in a folder of results.

use loosepin_files::FolderLock;

use super::error::StoreError;

/// Name of the file in a folder of results.
pub const STORE_FILE: &str = "runs.sqlite";
/// Names of the files that may stand beside it while it is open, or after it was left by force.
pub const STORE_COMPANIONS: [&str; 2] = ["runs.sqlite-wal", "runs.sqlite-journal"];

/// Name of the copy of the merged store that shards of a study read, beside the store.
pub const PUBLISHED_FILE: &str = "merged.sqlite";

/// Removes the files of the store in a folder, which is not open, and the copy beside it, as far as they are there.
///
/// # Errors
/// An error of the file system.
pub fn remove_store(lock: &FolderLock) -> Result<(), StoreError> {
    for name in STORE_COMPANIONS.into_iter().chain([PUBLISHED_FILE, STORE_FILE]) {
        lock.remove(name).map_err(|error| StoreError::not_usable(&lock.folder().path().join(name), &error))?;
    }
    Ok(())
}
