//! The small file by which a folder of results is known.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use loosepin_files::{Folder, FolderLock, Refused, replace_named};
use serde::{Deserialize, Serialize};

use super::error::ResultsError;
use super::kind::{MARKER_FILE, ResultKind};

/// Largest marker, bytes. It has a hundred for each file of its result.
pub const MAX_MARKER_BYTES: u64 = 1 << 20;
/// Largest file of a result that is read into memory, bytes: tables of runs have gigabytes.
const MAX_FILE_BYTES: u64 = 1 << 36;

/// The content of [`super::MARKER_FILE`]: what a folder holds, and from which inputs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Marker {
    /// The kind of result.
    pub kind: ResultKind,
    /// Name of the model or study.
    pub name: String,
    /// BLAKE3 of all inputs, 64 hexadecimal digits.
    pub inputs_blake3: String,
    /// Version of the program that wrote the folder.
    pub version: String,
    /// Whether all files are there.
    pub is_finished: bool,
    /// BLAKE3 of each file that belongs to the result, by name; `None` for a file that differs from run to run. This one is left out.
    pub files: BTreeMap<String, Option<String>>,
    /// Files of the finished result that this one replaces: each waits as `NAME.replaced` until this one is finished.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub replaced: Vec<String>,
}

impl Marker {
    /// The marker of `folder`.
    ///
    /// # Errors
    /// There is none, or another version wrote it.
    pub(super) fn read(folder: &Folder) -> Result<Self, ResultsError> {
        let path = folder.path().join(MARKER_FILE);
        match folder.read(Path::new(MARKER_FILE), MAX_MARKER_BYTES) {
            Ok(text) => serde_json::from_slice(&text).map_err(|source| ResultsError::ForeignMarker { path, source }),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                Err(ResultsError::NoMarker { folder: folder.path().to_owned() })
            }
            Err(source) => Err(ResultsError::Read { path, source }),
        }
    }

    /// Writes it, whole or not at all.
    ///
    /// # Errors
    /// An error of the file system.
    pub(super) fn write(&self, lock: &FolderLock) -> Result<(), ResultsError> {
        write(lock, MARKER_FILE, self.to_text()?.as_bytes())
    }

    /// Its text.
    ///
    /// # Errors
    /// An error of JSON.
    pub(super) fn to_text(&self) -> Result<String, ResultsError> {
        let mut text = serde_json::to_string_pretty(self).map_err(|source| ResultsError::Layout { source })?;
        text.push('\n');
        Ok(text)
    }

    /// Holds every listed file against its hash, except those that are `written_again` anyway.
    ///
    /// # Errors
    /// A file is missing, or is not the one that was written.
    pub(super) fn verify(&self, folder: &Folder, written_again: &[&str]) -> Result<(), ResultsError> {
        let hashed = self.files.iter().filter_map(|(file_name, hash)| Some((file_name, hash.as_ref()?)));
        for (file_name, expected) in hashed.filter(|(file_name, _)| !written_again.contains(&file_name.as_str())) {
            let mut hasher = blake3::Hasher::new();
            folder
                .open_file(Path::new(file_name))
                .and_then(|(mut file, _)| io::copy(&mut file, &mut hasher))
                .map_err(|error| self.not_readable(folder.path().join(file_name), error))?;
            if hasher.finalize().to_hex().as_str() != expected {
                return Err(self.changed(folder.path(), file_name));
            }
        }
        Ok(())
    }

    /// The contents of a listed file, held against its hash.
    ///
    /// # Errors
    /// The file is not listed, is missing, or is not the one that was written.
    pub(super) fn read_file(&self, folder: &Folder, file_name: &str) -> Result<Vec<u8>, ResultsError> {
        let path = folder.path().join(file_name);
        let Some(listed) = self.files.get(file_name) else {
            return Err(ResultsError::NotListed { path, kind: self.kind, name: self.name.clone() });
        };
        let contents = folder.read(Path::new(file_name), MAX_FILE_BYTES);
        let contents = contents.map_err(|error| self.not_readable(path, error))?;
        match listed {
            Some(expected) if blake3::hash(&contents).to_hex().as_str() != expected => {
                Err(self.changed(folder.path(), file_name))
            }
            _ => Ok(contents),
        }
    }

    fn changed(&self, folder: &Path, file_name: &str) -> ResultsError {
        ResultsError::Changed { path: folder.join(file_name), kind: self.kind, name: self.name.clone() }
    }

    fn not_readable(&self, path: PathBuf, error: io::Error) -> ResultsError {
        if Refused::of(&error) == Some(Refused::BadName) {
            return ResultsError::Changed { path, kind: self.kind, name: self.name.clone() };
        }
        match error.kind() {
            io::ErrorKind::NotFound => ResultsError::Missing { path, kind: self.kind, name: self.name.clone() },
            _ => ResultsError::Read { path, source: error },
        }
    }
}

/// Writes a file that the user names, whole or not at all, in place of a plain file that is there.
///
/// # Errors
/// An error of the file system.
pub fn write_whole(path: &Path, contents: &[u8]) -> Result<(), ResultsError> {
    replace_named(path, contents).map_err(|source| ResultsError::Write { path: path.to_owned(), source })
}

/// Writes a file of a result, whole or not at all.
pub(super) fn write(lock: &FolderLock, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
    let path = || lock.folder().path().join(file_name);
    lock.write(file_name, contents).map_err(|source| ResultsError::Write { path: path(), source })
}
