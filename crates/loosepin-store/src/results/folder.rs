//! A folder of results: writing into it while it is locked, and reading what is finished.

use std::fs;
use std::path::{Path, PathBuf};

use super::REPORT_FILE;
use super::error::ResultsError;
use super::kind::{MARKER_FILE, ResultKind};
use super::lock::FolderLock;
use super::marker::{Marker, inside};
use super::whole::write_whole;

/// Longest part of a folder name that is made from a name in a file, characters.
const LONGEST_NAME_CHARS: usize = 60;

/// A folder of results that is written into: nobody else writes there meanwhile.
#[derive(Debug)]
pub struct ResultsFolder {
    pub(super) path: PathBuf,
    pub(super) marker: Marker,
    /// Held until the folder is dropped.
    pub(super) _lock: FolderLock,
}

/// A finished result, to be read.
#[derive(Debug)]
pub struct FinishedResult {
    path: PathBuf,
    marker: Marker,
}

impl FinishedResult {
    /// Opens the result in the folder `path`, and holds every file against its hash.
    ///
    /// # Errors
    /// There is none, it did not finish, or is not as it was written.
    pub fn open(path: &Path) -> Result<Self, ResultsError> {
        Self::open_but(path, &[])
    }

    /// Without a look at files that are `written_again` anyway.
    fn open_but(path: &Path, written_again: &[&str]) -> Result<Self, ResultsError> {
        if !path.exists() {
            return Err(ResultsError::NoSuchFolder { folder: path.to_owned() });
        }
        if !path.is_dir() {
            return Err(ResultsError::NotAFolder { path: path.to_owned() });
        }
        loop {
            let marker = Marker::read(path)?;
            if !marker.is_finished {
                return Err(ResultsError::Unfinished { folder: path.to_owned(), kind: marker.kind, name: marker.name });
            }
            match marker.verify(path, written_again) {
                Ok(()) => return Ok(Self { path: path.to_owned(), marker }),
                // Somebody has begun to replace it meanwhile, or has replaced it.
                Err(_) if Marker::read(path)? != marker => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// The contents of one of its files.
    ///
    /// # Errors
    /// It is none of its files, or not as it was written any more.
    pub fn read(&self, file_name: &str) -> Result<Vec<u8>, ResultsError> {
        self.marker.read_file(&self.path, file_name)
    }

    /// The text of one of its files.
    ///
    /// # Errors
    /// As for [`FinishedResult::read`]; no text.
    pub fn read_text(&self, file_name: &str) -> Result<String, ResultsError> {
        text(self.read(file_name)?, &self.path, file_name)
    }
}

impl ResultsFolder {
    /// Opens the folder of a finished result to write its page again, whatever became of that.
    ///
    /// # Errors
    /// As for [`FinishedResult::open`]; another process writes there.
    pub fn reopen(path: &Path) -> Result<Self, ResultsError> {
        let FinishedResult { marker, .. } = FinishedResult::open_but(path, &[REPORT_FILE])?;
        let lock = FolderLock::take(path, &format!("report of {} '{}'", marker.kind.words(), marker.name))?;
        // Once more, now that nobody else writes there.
        let FinishedResult { path, marker } = FinishedResult::open_but(path, &[REPORT_FILE])?;
        Ok(Self { path, marker, _lock: lock })
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The kind of its result.
    pub fn kind(&self) -> ResultKind {
        self.marker.kind
    }

    /// Whether it holds the finished result already.
    pub fn is_finished(&self) -> bool {
        self.marker.is_finished
    }

    /// Whether a file of this name belongs to the result.
    pub fn has(&self, file_name: &str) -> bool {
        self.marker.files.contains_key(file_name)
    }

    /// Writes a file of the result, whole or not at all.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write(&mut self, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
        let hash = blake3::hash(contents).to_hex().to_string();
        if self.marker.is_finished {
            let is_there = || fs::read(self.path.join(file_name)).is_ok_and(|held| held == contents);
            if self.marker.files.get(file_name) == Some(&Some(hash.clone())) && is_there() {
                return Ok(());
            }
            // A result stays finished while a page of it is written again: until the page is there, it is not listed.
            self.marker.files.remove(file_name);
            self.marker.write(&self.path)?;
        }
        write_whole(&self.path.join(file_name), contents)?;
        self.marker.files.insert(file_name.to_owned(), Some(hash));
        if self.marker.is_finished { self.marker.write(&self.path) } else { Ok(()) }
    }

    /// Writes a file of the result that differs from run to run, whole or not at all. It has no hash in the marker, which repeats.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write_without_hash(&mut self, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
        write_whole(&self.path.join(file_name), contents)?;
        self.marker.files.insert(file_name.to_owned(), None);
        Ok(())
    }

    /// The contents of a file of the result.
    ///
    /// # Errors
    /// It is none of its files, or is not as it was written.
    pub fn read(&self, file_name: &str) -> Result<Vec<u8>, ResultsError> {
        self.marker.read_file(&self.path, file_name)
    }

    /// The text of a file of the result.
    ///
    /// # Errors
    /// As for [`ResultsFolder::read`]; no text.
    pub fn read_text(&self, file_name: &str) -> Result<String, ResultsError> {
        text(self.read(file_name)?, &self.path, file_name)
    }

    /// The error for a file whose contents cannot be understood.
    pub fn foreign_file(&self, file_name: &str, reason: impl std::fmt::Display) -> ResultsError {
        ResultsError::ForeignFile { path: self.path.join(file_name), reason: reason.to_string() }
    }

    /// Says that all files are there.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn finish(&mut self) -> Result<(), ResultsError> {
        let finished = Marker { is_finished: true, ..self.marker.clone() };
        finished.write(&self.path)?;
        self.marker = finished;
        // What was replaced goes only now that its successor is whole.
        self.remove_replaced()
    }

    /// Keeps what was written so far of a result that did not finish: the next run replaces it.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn leave_unfinished(&mut self) -> Result<(), ResultsError> {
        self.marker.is_finished = false;
        self.marker.write(&self.path)
    }

    /// Removes what was written of a result that cannot be finished, and the folders that were made for it; a finished result
    /// that it was to replace comes back.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn abandon(self) -> Result<(), ResultsError> {
        remove_files(&self.path, self.marker.files.keys())?;
        if !self.marker.replaced.is_empty() {
            // The marker of the finished result comes last: until then it is known what is still to come back.
            let files = self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE);
            for file_name in files.map(String::as_str).chain([MARKER_FILE]) {
                let Some([path, aside]) = self.names(file_name).filter(|[_, aside]| aside.is_file()) else { continue };
                fs::rename(aside, &path).map_err(|source| ResultsError::Write { path, source })?;
            }
            return Ok(());
        }
        let path = self.path.join(MARKER_FILE);
        fs::remove_file(&path).map_err(|source| ResultsError::Write { path, source })
    }

    /// Where a file stands, and where it waits until its successor is whole.
    fn names(&self, file_name: &str) -> Option<[PathBuf; 2]> {
        inside(&self.path, file_name).zip(inside(&self.path, &aside(file_name))).map(|(path, aside)| [path, aside])
    }

    /// Renames what is to be replaced, whatever of that was done before; what has come in its place meanwhile goes.
    pub(super) fn set_replaced_aside(&self) -> Result<(), ResultsError> {
        for file_name in self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE) {
            let Some([path, aside]) = self.names(file_name).filter(|[path, _]| path.is_file()) else { continue };
            let moved = if aside.is_file() { fs::remove_file(&path) } else { fs::rename(&path, aside) };
            moved.map_err(|source| ResultsError::Write { path, source })?;
        }
        Ok(())
    }

    /// Removes what was replaced, now that its successor is whole.
    pub(super) fn remove_replaced(&mut self) -> Result<(), ResultsError> {
        if self.marker.replaced.is_empty() {
            return Ok(());
        }
        let waiting: Vec<String> = self.marker.replaced.iter().map(|file_name| aside(file_name)).collect();
        remove_files(&self.path, &waiting)?;
        self.marker.replaced.clear();
        self.marker.write(&self.path)
    }
}

fn text(contents: Vec<u8>, folder: &Path, file_name: &str) -> Result<String, ResultsError> {
    let foreign = |_| ResultsError::ForeignFile { path: folder.join(file_name), reason: "it is no text".to_owned() };
    String::from_utf8(contents).map_err(foreign)
}

/// The name under which a file of a finished result waits until its successor is whole.
pub(super) fn aside(file_name: &str) -> String {
    format!("{file_name}.replaced")
}

/// Removes files, and nothing outside the folder.
pub(super) fn remove_files<'a>(
    folder: &Path,
    file_names: impl IntoIterator<Item = &'a String>,
) -> Result<(), ResultsError> {
    let files = file_names.into_iter().filter_map(|file_name| inside(folder, file_name));
    for path in files.filter(|path| path.is_file()) {
        fs::remove_file(&path).map_err(|source| ResultsError::Write { path, source })?;
    }
    Ok(())
}

/// A name as part of a path: small letters and digits, everything else a single hyphen.
pub(super) fn folder_name(name: &str) -> String {
    let mut folder = String::new();
    for character in name.chars().flat_map(char::to_lowercase) {
        if character.is_alphanumeric() {
            folder.push(character);
        } else if !folder.is_empty() && !folder.ends_with('-') {
            folder.push('-');
        }
    }
    let folder: String = folder.chars().take(LONGEST_NAME_CHARS).collect();
    match folder.trim_end_matches('-') {
        "" => "unnamed".to_owned(),
        // Windows takes these for devices, whatever stands behind a point.
        name if is_device(name) => format!("{name}-results"),
        name => name.to_owned(),
    }
}

/// Whether Windows keeps this name, in small letters, for a device.
fn is_device(name: &str) -> bool {
    let is_numbered = |kind: &str| {
        let number = name.strip_prefix(kind).map(|rest| rest.chars().collect::<Vec<char>>());
        matches!(number.as_deref(), Some([digit]) if digit.is_ascii_digit() || "¹²³".contains(*digit))
    };
    ["con", "prn", "aux", "nul"].contains(&name) || is_numbered("com") || is_numbered("lpt")
}

#[cfg(test)]
mod tests;
