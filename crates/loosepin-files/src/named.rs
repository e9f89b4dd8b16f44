//! Files that the user of the program names by a path. Links in the path are followed for reading, and up to the last name for writing.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::folder::{Folder, read_limited};
use crate::lock::{FolderLock, LockError, LockKind};
use crate::refused::Refused;
use crate::system::{Directory, file_info, open_named};
use crate::temporary::{TemporaryKind, random};
use crate::write::PRIVATE_MODE;

/// How long another process that writes beside the file is waited for.
const PATIENCE: Duration = Duration::from_secs(5);

/// The content of the plain file at `path`, of at most `limit_bytes`.
///
/// # Errors
/// There is none; it is a folder ([`io::ErrorKind::IsADirectory`]), no plain file or larger.
pub fn read_named(path: &Path, limit_bytes: u64) -> io::Result<Vec<u8>> {
    let file = open_named(path)?;
    let info = file_info(&file)?;
    info.require_file()?;
    read_limited(file, &info, limit_bytes)
}

/// The text of the plain file at `path`, of at most `limit_bytes`.
///
/// # Errors
/// As for [`read_named`]; no UTF-8 ([`io::ErrorKind::InvalidData`]).
pub fn read_named_text(path: &Path, limit_bytes: u64) -> io::Result<String> {
    let bytes = read_named(path, limit_bytes)?;
    String::from_utf8(bytes).map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-8"))
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

/// The content of whatever is at `path`, of at most `limit_bytes`: also a pipe or `/dev/stdin`, read until it ends.
///
/// # Errors
/// It cannot be opened or read, or is larger.
#[allow(clippy::disallowed_methods, reason = "the user names a pipe, and wants to wait for it")]
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
            let lock = FolderLock::wait_at(parent, LockKind::Text, &holder(), PATIENCE).map_err(lock_error);
            or_without(lock, || Folder::open(parent))?.write_new_folder(name, files)
        }
        folder => lock_where_possible(&folder?)?.write_new(files),
    }
}

/// As [`lock_texts`], or without a lock on a file system that has none.
fn lock_where_possible(folder: &Folder) -> io::Result<FolderLock> {
    or_without(lock_texts(folder), || Ok(folder.clone()))
}

/// The folder without a lock if `lock` failed since its file system has none: a file that is written once needs none to be whole.
fn or_without(lock: io::Result<FolderLock>, folder: impl FnOnce() -> io::Result<Folder>) -> io::Result<FolderLock> {
    match lock {
        Err(error) if has_no_locks(&error) => Ok(FolderLock::without(&folder()?, LockKind::Text)),
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
    FolderLock::wait(folder, LockKind::Text, &holder(), PATIENCE).map_err(lock_error)
}

fn holder() -> String {
    format!("process {}", std::process::id())
}

/// As [`lock_texts`], of the folder at `relative` below `base`, which is made where it is not there. No link below `base` is followed. A
/// folder that was made stays if something comes into it.
///
/// # Errors
/// As for [`lock_texts`]; a link on the way.
pub fn lock_texts_below(base: &Folder, relative: &Path) -> io::Result<FolderLock> {
    FolderLock::wait_below(base, relative, LockKind::Text, &holder(), PATIENCE).map_err(lock_error)
}

/// Locks the folder of a result that is there, as long as nobody writes it.
///
/// # Errors
/// Somebody does ([`io::ErrorKind::ResourceBusy`]); an error of the file system, or one that has no locks.
pub fn lock_result(folder: &Folder) -> io::Result<FolderLock> {
    FolderLock::wait(folder, LockKind::Result, &holder(), Duration::ZERO).map_err(lock_error)
}

fn lock_error(error: LockError) -> io::Error {
    match error {
        LockError::InUse { .. } => io::ErrorKind::ResourceBusy.into(),
        LockError::File { source, .. } => source,
    }
}

/// Whether the file at `path` may be written.
pub fn may_write(path: &Path) -> bool {
    let folder = Folder::open(path.parent().unwrap_or(Path::new("")));
    folder.and_then(|folder| folder.directory.open_to_write(path.file_name().unwrap_or_default())).is_ok()
}

/// A file in `folder` that has no name and is gone when it is closed.
///
/// # Errors
/// An error of the file system, or one that does not remove files that are open.
pub fn anonymous_file(folder: &Path) -> io::Result<File> {
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

/// Writes a file into `folder` that only its owner can read, under a random name: `BEGINNING-DIGITS.EXTENSION`.
///
/// # Errors
/// An error of the file system.
pub fn create_private(folder: &Path, beginning: &str, extension: &str, contents: &[u8]) -> io::Result<PrivateFile> {
    let directory = Directory::at(folder)?;
    let name = format!("{beginning}-{:016x}.{extension}", random()?);
    let mut file = directory.create_new(OsStr::new(&name), PRIVATE_MODE)?;
    let private = PrivateFile { directory, path: folder.join(&name), name };
    file.write_all(contents)?;
    Ok(private)
}

impl PrivateFile {
    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

impl Drop for PrivateFile {
    fn drop(&mut self) {
        let _ = self.directory.remove_file(OsStr::new(&self.name));
    }
}
