//! A folder of results: writing into it while it is locked, and reading what is finished.

use std::io;
use std::path::Path;
use std::sync::Arc;
use std::time::SystemTime;

use loosepin_files::{FileKind, Folder, FolderLock, LockKind, Refused, read_named_text};
use loosepin_text::date::date;

use super::REPORT_FILE;
use super::error::ResultsError;
use super::kind::{MARKER_FILE, ResultKind};
use super::marker::{Marker, write};

/// Longest part of a folder name that is made from a name in a file, characters.
const LONGEST_NAME_CHARS: usize = 60;

/// A folder of results that is written into: nobody else writes there meanwhile.
#[derive(Debug)]
pub struct ResultsFolder {
    pub(super) marker: Marker,
    /// Held until the folder, and the store of runs in it, are dropped.
    pub(super) lock: Arc<FolderLock>,
}

/// A finished result, to be read.
#[derive(Debug)]
pub struct FinishedResult {
    folder: Folder,
    marker: Marker,
}

impl FinishedResult {
    /// Opens the result in the folder `path`, and holds every file against its hash.
    ///
    /// # Errors
    /// There is none, it did not finish, or is not as it was written.
    pub fn open(path: &Path) -> Result<Self, ResultsError> {
        Self::open_but(open(path)?, &[])
    }

    /// As [`Self::open`], whatever became of its page, which can be made again.
    ///
    /// # Errors
    /// As for [`Self::open`].
    pub fn open_without_page(path: &Path) -> Result<Self, ResultsError> {
        Self::open_but(open(path)?, &[REPORT_FILE])
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Checks the kind of the result.
    ///
    /// # Errors
    /// It is of another kind.
    pub fn demand(&self, wanted: ResultKind) -> Result<(), ResultsError> {
        if self.marker.kind == wanted {
            return Ok(());
        }
        let (folder, name) = (self.path().to_owned(), self.marker.name.clone());
        Err(ResultsError::OtherKind { folder, held: self.marker.kind, name, wanted })
    }

    /// Whether a file of this name belongs to the result.
    pub fn has(&self, file_name: &str) -> bool {
        self.marker.files.contains_key(file_name)
    }

    /// Without a look at files that are `written_again` anyway.
    fn open_but(folder: Folder, written_again: &[&str]) -> Result<Self, ResultsError> {
        loop {
            let marker = Marker::read(&folder)?;
            if !marker.is_finished {
                let folder = folder.path().to_owned();
                return Err(ResultsError::Unfinished { folder, kind: marker.kind, name: marker.name });
            }
            match marker.verify(&folder, written_again) {
                Ok(()) => return Ok(Self { folder, marker }),
                // Somebody has begun to replace it meanwhile, or has replaced it.
                Err(_) if Marker::read(&folder)? != marker => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// The contents of one of its files.
    ///
    /// # Errors
    /// It is none of its files, or not as it was written any more.
    pub fn read(&self, file_name: &str) -> Result<Vec<u8>, ResultsError> {
        self.marker.read_file(&self.folder, file_name)
    }

    /// The text of one of its files.
    ///
    /// # Errors
    /// As for [`FinishedResult::read`]; no text.
    pub fn read_text(&self, file_name: &str) -> Result<String, ResultsError> {
        text(self.read(file_name)?, self.folder.path(), file_name)
    }
}

impl ResultsFolder {
    /// Opens the folder of a finished result to write its page again, whatever became of that.
    ///
    /// # Errors
    /// As for [`FinishedResult::open`]; another process writes there.
    pub fn reopen(path: &Path) -> Result<Self, ResultsError> {
        let FinishedResult { marker, .. } = FinishedResult::open_but(open(path)?, &[REPORT_FILE])?;
        let holder = holder(&format!("report of {} '{}'", marker.kind.words(), marker.name));
        let lock =
            FolderLock::take(path, LockKind::Result, &holder).map_err(|error| ResultsError::of_lock(path, error))?;
        // Once more, now that nobody else writes there.
        let FinishedResult { marker, .. } = FinishedResult::open_but(lock.folder().clone(), &[REPORT_FILE])?;
        Ok(Self { marker, lock: Arc::new(lock) })
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        self.folder().path()
    }

    fn folder(&self) -> &Folder {
        self.lock.folder()
    }

    /// The result that it holds, to be read.
    pub fn finished(&self) -> FinishedResult {
        FinishedResult { folder: self.folder().clone(), marker: self.marker.clone() }
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
            let is_there = || {
                let held = self.folder().read(Path::new(file_name), contents.len() as u64);
                held.is_ok_and(|held| held == contents)
            };
            if self.marker.files.get(file_name) == Some(&Some(hash.clone())) && is_there() {
                return Ok(());
            }
            // A result stays finished while a page of it is written again: until the page is there, it is not listed.
            self.marker.files.remove(file_name);
            self.marker.write(&self.lock)?;
            write(&self.lock, file_name, contents)?;
            self.marker.files.insert(file_name.to_owned(), Some(hash));
            return self.marker.write(&self.lock);
        }
        // Listed first: where the system says that it is not written and it is there all the same, it goes with the others.
        self.marker.files.insert(file_name.to_owned(), Some(hash));
        write(&self.lock, file_name, contents)
    }

    /// Writes a file of the result that differs from run to run, whole or not at all. It has no hash in the marker, which repeats.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write_without_hash(&mut self, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
        self.marker.files.insert(file_name.to_owned(), None);
        write(&self.lock, file_name, contents)
    }

    /// The contents of a file of the result.
    ///
    /// # Errors
    /// It is none of its files, or is not as it was written.
    pub fn read(&self, file_name: &str) -> Result<Vec<u8>, ResultsError> {
        self.marker.read_file(self.folder(), file_name)
    }

    /// The text of a file of the result.
    ///
    /// # Errors
    /// As for [`ResultsFolder::read`]; no text.
    pub fn read_text(&self, file_name: &str) -> Result<String, ResultsError> {
        text(self.read(file_name)?, self.path(), file_name)
    }

    /// The error for a file whose contents cannot be understood.
    pub fn foreign_file(&self, file_name: &str, reason: impl std::fmt::Display) -> ResultsError {
        ResultsError::ForeignFile { path: self.path().join(file_name), reason: reason.to_string() }
    }

    /// Writes a file beside those of the result, which stays when the result is begun again.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write_beside(&self, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
        write(&self.lock, file_name, contents)
    }

    /// Says that all files are there.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn finish(&mut self) -> Result<(), ResultsError> {
        let finished = Marker { is_finished: true, ..self.marker.clone() };
        finished.write(&self.lock)?;
        self.marker = finished;
        // What was replaced goes only now that its successor is whole.
        self.remove_replaced()
    }

    /// Keeps the files of an unfinished result: the next run replaces it.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn leave_unfinished(&mut self) -> Result<(), ResultsError> {
        self.marker.is_finished = false;
        self.marker.write(&self.lock)
    }

    /// Removes the files of a result that cannot be finished, and the folders that were made for it; a finished result that it was to
    /// replace comes back.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn abandon(self) -> Result<(), ResultsError> {
        remove_files(&self.lock, self.marker.files.keys())?;
        if !self.marker.replaced.is_empty() {
            // The marker of the finished result comes last: until then it is known what is still to come back.
            let files = self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE);
            for file_name in files.map(String::as_str).chain([MARKER_FILE]) {
                let aside = aside(file_name);
                if is_file(self.folder(), &aside)? {
                    rename(&self.lock, &aside, file_name)?;
                }
            }
            return Ok(());
        }
        remove(&self.lock, MARKER_FILE)
    }

    /// Renames the replaced files, however many of them were renamed before; files that have taken their place meanwhile are removed.
    pub(super) fn set_replaced_aside(&self) -> Result<(), ResultsError> {
        for file_name in self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE) {
            if !is_file(self.folder(), file_name)? {
                continue;
            }
            let aside = aside(file_name);
            if is_file(self.folder(), &aside)? {
                remove(&self.lock, file_name)?;
            } else {
                rename(&self.lock, file_name, &aside)?;
            }
        }
        Ok(())
    }

    /// Removes the replaced result, now that its successor is whole.
    pub(super) fn remove_replaced(&mut self) -> Result<(), ResultsError> {
        if self.marker.replaced.is_empty() {
            return Ok(());
        }
        let waiting: Vec<String> = self.marker.replaced.iter().map(|file_name| aside(file_name)).collect();
        remove_files(&self.lock, &waiting)?;
        self.marker.replaced.clear();
        self.marker.write(&self.lock)
    }
}

/// The folder at `path`.
pub(super) fn open(path: &Path) -> Result<Folder, ResultsError> {
    Folder::open(path).map_err(|source| not_opened(path, source))
}

/// Why the folder at `path` cannot be opened.
pub(super) fn not_opened(path: &Path, source: io::Error) -> ResultsError {
    let path = path.to_owned();
    match source.kind() {
        io::ErrorKind::NotFound => ResultsError::NoSuchFolder { folder: path },
        io::ErrorKind::NotADirectory => ResultsError::NotAFolder { path },
        _ => ResultsError::Read { path, source },
    }
}

/// The line by which other processes know the holder of a lock.
pub(super) fn holder(work: &str) -> String {
    format!("process {}{} ({work}{})", std::process::id(), on_host(), since(SystemTime::now()))
}

/// `, since DATE`, where the clock of the machine shows a date that has a form.
fn since(now: SystemTime) -> String {
    date(now).map_or_else(String::new, |date| format!(", since {date}"))
}

/// ` on NAME`, where the machine says its name: a folder may be shared by several.
fn on_host() -> String {
    const MAX_BYTES: u64 = 4096;
    let named = read_named_text(Path::new("/proc/sys/kernel/hostname"), MAX_BYTES).ok();
    let named = named.or_else(|| std::env::var("COMPUTERNAME").ok());
    named.map_or_else(String::new, |name| format!(" on {}", name.trim()))
}

fn text(contents: Vec<u8>, folder: &Path, file_name: &str) -> Result<String, ResultsError> {
    let foreign = |_| ResultsError::ForeignFile { path: folder.join(file_name), reason: "it is no text".to_owned() };
    String::from_utf8(contents).map_err(foreign)
}

/// The name under which a file of a finished result waits until its successor is whole.
pub(super) fn aside(file_name: &str) -> String {
    format!("{file_name}.replaced")
}

/// Whether the folder has a plain file of this name.
pub(super) fn is_file(folder: &Folder, file_name: &str) -> Result<bool, ResultsError> {
    let found = match folder.find(Path::new(file_name)) {
        // A marker that was changed by hand names what is not in the folder.
        Err(error) if Refused::of(&error) == Some(Refused::BadName) => return Ok(false),
        found => found,
    };
    let found = found.map_err(|source| ResultsError::Read { path: folder.path().join(file_name), source })?;
    Ok(found.is_some_and(|found| found.kind == FileKind::File))
}

fn remove(lock: &FolderLock, file_name: &str) -> Result<(), ResultsError> {
    let path = || lock.folder().path().join(file_name);
    lock.remove(file_name).map_err(|source| ResultsError::Write { path: path(), source })
}

fn rename(lock: &FolderLock, from: &str, to: &str) -> Result<(), ResultsError> {
    let path = || lock.folder().path().join(to);
    lock.rename(from, to).map_err(|source| ResultsError::Write { path: path(), source })
}

/// Removes plain files; what else has such a name is not of the result.
pub(super) fn remove_files<'a>(
    lock: &FolderLock,
    file_names: impl IntoIterator<Item = &'a String>,
) -> Result<(), ResultsError> {
    for file_name in file_names {
        if is_file(lock.folder(), file_name)? {
            remove(lock, file_name)?;
        }
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
