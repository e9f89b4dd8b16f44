//! Files that whoever runs the program names by a path. Links in the path are followed when it is read, and up to its last name when it
//! is written.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::TEXT_LOCK_FILE;
use crate::entry::FileKind;
use crate::folder::{Folder, read_limited};
use crate::lock::{FolderLock, LockError};
use crate::refused::Refused;
use crate::system::{Directory, file_info, open_named};
use crate::temporary::{TemporaryKind, random};

/// How long another process that writes beside the file is waited for.
const PATIENCE: Duration = Duration::from_secs(5);

/// The content of the plain file at `path`, of at most so many bytes.
///
/// # Errors
/// There is none; it is a folder ([`io::ErrorKind::IsADirectory`]), no plain file or larger.
pub fn read_named(path: &Path, limit_bytes: u64) -> io::Result<Vec<u8>> {
    let file = open_named(path)?;
    let info = file_info(&file)?;
    match info.kind {
        FileKind::File => read_limited(file, &info, limit_bytes),
        FileKind::Folder => Err(io::ErrorKind::IsADirectory.into()),
        FileKind::Link | FileKind::Other => Err(Refused::NotAFile.into()),
    }
}

/// Writes the file at `path`, whole or not at all, in place of a plain file that is there.
///
/// # Errors
/// Its folder is not there; as for [`FolderLock::write`].
pub fn replace_named(path: &Path, contents: &[u8]) -> io::Result<()> {
    let name = path.file_name().ok_or(Refused::BadName)?;
    let folder = Folder::open(path.parent().unwrap_or(Path::new("")))?;
    lock_where_possible(&folder)?.write(name, contents)
}

/// The content of whatever is at `path`, of at most so many bytes: a pipe or `/dev/stdin` as well, which is waited for.
///
/// # Errors
/// It cannot be opened or read, or is larger.
#[allow(clippy::disallowed_methods, reason = "whoever runs the program names a pipe, and wants to wait for it")]
pub fn read_stream(path: &Path, limit_bytes: u64) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let info = file_info(&file)?;
    read_limited(file, &info, limit_bytes)
}

/// Writes files into the folder at `path`, all of them or none. Where the folder is not there, it comes with the files in it.
///
/// # Errors
/// Something is there that has the name of a file or of the folder ([`io::ErrorKind::AlreadyExists`]); an error of the file system.
pub fn write_new_files<N: AsRef<OsStr>>(path: &Path, files: &[(N, &[u8])]) -> io::Result<()> {
    match Folder::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let name = path.file_name().ok_or(Refused::BadName)?;
            let parent = path.parent().unwrap_or(Path::new(""));
            let lock = match FolderLock::wait_at(parent, TEXT_LOCK_FILE, &holder(), PATIENCE).map_err(lock_error) {
                Err(error) if has_no_locks(&error) => FolderLock::without(&Folder::open(parent)?, TEXT_LOCK_FILE),
                lock => lock?,
            };
            lock.write_new_folder(name, files)
        }
        folder => lock_where_possible(&folder?)?.write_new(files),
    }
}

/// As [`lock_texts`], and without a lock where the file system has none: a file that is named once needs none to be whole.
fn lock_where_possible(folder: &Folder) -> io::Result<FolderLock> {
    match lock_texts(folder) {
        Err(error) if has_no_locks(&error) => Ok(FolderLock::without(folder, TEXT_LOCK_FILE)),
        lock => lock,
    }
}

/// Whether an error is that of a file system without locks.
fn has_no_locks(error: &io::Error) -> bool {
    const NO_LOCKS_AVAILABLE: i32 = 37; // ENOLCK of Linux; others say that it is not supported.
    error.kind() == io::ErrorKind::Unsupported
        || (cfg!(target_os = "linux") && error.raw_os_error() == Some(NO_LOCKS_AVAILABLE))
}

/// Locks a folder for the moment in which texts in it are written. Another process that does the same is waited for.
///
/// # Errors
/// It writes for longer ([`io::ErrorKind::ResourceBusy`]); an error of the file system, or one that has no locks.
pub fn lock_texts(folder: &Folder) -> io::Result<FolderLock> {
    FolderLock::wait(folder, TEXT_LOCK_FILE, &holder(), PATIENCE).map_err(lock_error)
}

fn holder() -> String {
    format!("process {}", std::process::id())
}

fn lock_error(error: LockError) -> io::Error {
    match error {
        LockError::InUse { .. } => io::ErrorKind::ResourceBusy.into(),
        LockError::File { source, .. } => source,
    }
}

/// Whether the file at `path` may be written.
pub fn may_write(path: &Path) -> bool {
    let folder = Directory::at(path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new(".")));
    folder.and_then(|folder| folder.open_to_write(path.file_name().unwrap_or_default())).is_ok()
}

/// A file in `folder` that has no name and is gone when it is closed.
///
/// # Errors
/// An error of the file system, or one that does not remove files that are open.
pub fn unnamed_file(folder: &Path) -> io::Result<File> {
    const PRIVATE_MODE: u32 = 0o600;
    let directory = Directory::at(folder)?;
    let name = TemporaryKind::Unnamed.new_name()?;
    let file = directory.create_new(OsStr::new(&name), PRIVATE_MODE)?;
    directory.remove_file(OsStr::new(&name))?;
    Ok(file)
}

/// A file that only its owner can read; it is removed when this is dropped.
#[derive(Debug)]
pub struct PrivateFile {
    directory: Directory,
    name: String,
    path: PathBuf,
}

/// Writes a file into `folder` that only its owner can read, under a name that nobody can foresee: `BEGINNING-DIGITS.EXTENSION`.
///
/// # Errors
/// An error of the file system.
pub fn create_private(folder: &Path, beginning: &str, extension: &str, contents: &[u8]) -> io::Result<PrivateFile> {
    const PRIVATE_MODE: u32 = 0o600;
    let directory = Directory::at(folder)?;
    let name = format!("{beginning}-{:016x}.{extension}", random()?);
    let mut file = directory.create_new(OsStr::new(&name), PRIVATE_MODE)?;
    let private = PrivateFile { directory, path: folder.join(&name), name };
    file.write_all(contents)?;
    Ok(private)
}

impl PrivateFile {
    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for PrivateFile {
    fn drop(&mut self) {
        let _ = self.directory.remove_file(OsStr::new(&self.name));
    }
}
