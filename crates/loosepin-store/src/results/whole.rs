//! Files that are there whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::error::ResultsError;

/// Suffix of the name of a file until it is whole.
pub(super) const PARTIAL: &str = ".partial";

/// Writes a file so that it is there whole or not at all, whenever the machine stops: under another name first, flushed to the
/// device, then renamed.
///
/// # Errors
/// An error of the file system.
pub fn write_whole(path: &Path, contents: &[u8]) -> Result<(), ResultsError> {
    let mut partial_name = path.as_os_str().to_owned();
    partial_name.push(PARTIAL);
    let partial = PathBuf::from(partial_name);
    let written = || {
        let mut file = fs::File::create(&partial)?;
        file.write_all(contents)?;
        file.sync_all()?;
        fs::rename(&partial, path)?;
        flush_folder(path)
    };
    written().map_err(|source| {
        // What is not whole is in the way of whoever comes next, and takes the room that may be missing.
        let _ = fs::remove_file(&partial);
        ResultsError::Write { path: path.to_owned(), source }
    })
}

/// Flushes the entries of the folder of `path`, where the platform lets a folder be opened.
fn flush_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::File::open(folder)?.sync_all()?;
    }
    Ok(())
}
