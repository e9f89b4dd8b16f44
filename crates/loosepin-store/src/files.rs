//! The files of a store in a folder of results.

use std::path::Path;

use super::error::StoreError;

/// Name of the file in a folder of results.
pub const STORE_FILE: &str = "runs.sqlite";
/// Names of the files that may stand beside it while it is open, or after it was left by force.
pub const STORE_COMPANIONS: [&str; 2] = ["runs.sqlite-wal", "runs.sqlite-journal"];

/// Name of the copy that shards of a study read of what was merged, beside the store.
pub const PUBLISHED_FILE: &str = "merged.sqlite";

/// Removes the files of a store that is not open, and the copy beside it; nothing where there is none.
///
/// # Errors
/// An error of the file system.
pub fn remove_store(path: &Path) -> Result<(), StoreError> {
    let companions = STORE_COMPANIONS.iter().map(|name| path.with_file_name(name));
    for file in companions.chain([path.with_file_name(PUBLISHED_FILE), path.to_owned()]) {
        match std::fs::remove_file(&file) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(StoreError::NotUsable { path: file, reason: error.to_string() });
            }
            _ => {}
        }
    }
    Ok(())
}
