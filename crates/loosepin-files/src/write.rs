//! Writing into a folder by the holder of its lock.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;

use crate::entry::{FileInfo, FileKind, Identity};
use crate::folder::Folder;
use crate::lock::FolderLock;
use crate::refused::Refused;
use crate::system::{file_info, keep_owner_and_mode};

/// Mode of a new file, before the mask of the process.
const NEW_MODE: u32 = 0o666;
/// Mode of a file that only its owner can read: until it gets the mode of the file that it replaces, or permanently.
pub(crate) const PRIVATE_MODE: u32 = 0o600;

impl FolderLock {
    /// Writes a file so that it is there whole or not at all, whenever the machine stops. A file that it replaces gives it its mode,
    /// and its owner where that is permitted.
    ///
    /// # Errors
    /// What is there is a link, no plain file or read-only; the lock was lost; an error of the file system.
    pub fn write(&self, name: impl AsRef<OsStr>, contents: &[u8]) -> io::Result<()> {
        let name = single_name(name.as_ref())?;
        let replaced = replaceable(&self.folder, name)?;
        let mode = if replaced.is_some() { PRIVATE_MODE } else { NEW_MODE };
        let temporary = self.write_temporary(contents, mode, replaced.as_ref())?;
        let renamed = self.check().and_then(|()| self.folder.directory.rename(OsStr::new(&temporary.name), name));
        self.or_remove(renamed, &temporary.name)?;
        self.folder.directory.sync().inspect_err(|_| {
            // The caller hears that it is not written: it is not there, unless it has replaced another file.
            if replaced.is_none() {
                self.remove_own(&temporary, name);
            }
        })
    }

    /// Writes files that are not there yet: all of them, each whole, or none.
    ///
    /// # Errors
    /// One is there already; the lock was lost; an error of the file system.
    pub fn write_new<N: AsRef<OsStr>>(&self, files: &[(N, &[u8])]) -> io::Result<()> {
        let mut waiting: Vec<(Temporary, &OsStr)> = Vec::new();
        let written = files.iter().try_for_each(|(name, contents)| {
            let name = single_name(name.as_ref())?;
            waiting.push((self.write_temporary(contents, NEW_MODE, None)?, name));
            Ok(())
        });
        let mut renamed = 0;
        let named = written.and_then(|()| {
            for (temporary, name) in &waiting {
                self.check()?;
                self.folder.directory.rename_new(OsStr::new(&temporary.name), name)?;
                renamed += 1;
            }
            self.folder.directory.sync()
        });
        named.inspect_err(|_| {
            for (temporary, name) in &waiting[..renamed] {
                self.remove_own(temporary, name);
            }
            for (temporary, _) in &waiting[renamed..] {
                let _ = self.folder.directory.remove_file(OsStr::new(&temporary.name));
            }
        })
    }

    /// Makes a folder with files in it, which is there with all of them or not at all.
    ///
    /// # Errors
    /// Something of that name is there already; the lock was lost; an error of the file system.
    pub fn write_new_folder<N: AsRef<OsStr>>(&self, name: impl AsRef<OsStr>, files: &[(N, &[u8])]) -> io::Result<()> {
        let name = single_name(name.as_ref())?;
        if self.folder.find_name(name)?.is_some() {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        let temporary = self.temporary_kind().new_name()?;
        let temporary = OsStr::new(&temporary);
        self.folder.directory.make_directory(temporary)?;
        let written = || {
            let folder = self.folder.open_below(Path::new(temporary))?;
            for (name, contents) in files {
                let mut file = folder.directory.create_new(single_name(name.as_ref())?, NEW_MODE)?;
                file.write_all(contents)?;
                file.sync_all()?;
            }
            folder.directory.sync()?;
            self.check()?;
            self.folder.directory.rename_new(temporary, name)
        };
        written().inspect_err(|_| {
            let _ = self.remove_temporary_folder(temporary);
        })?;
        self.folder.directory.sync().inspect_err(|_| {
            let Ok(folder) = self.folder.open_below(Path::new(name)) else { return };
            for (name, _) in files {
                let _ = folder.directory.remove_file(name.as_ref());
            }
            // What somebody else has put into it meanwhile stays, with it.
            let _ = self.folder.directory.remove_directory(name);
        })
    }

    /// Removes a plain file, if there is one.
    ///
    /// # Errors
    /// It is a link or no plain file; the lock was lost; an error of the file system.
    pub fn remove(&self, name: &str) -> io::Result<()> {
        let name = single_name(OsStr::new(name))?;
        let Some(found) = self.folder.find_name(name)? else { return Ok(()) };
        found.require_file()?;
        self.check()?;
        self.folder.directory.remove_file(name)
    }

    /// Renames a plain file, in place of a plain file that has the new name.
    ///
    /// # Errors
    /// There is none, it is a link or no plain file; the lock was lost; an error of the file system.
    pub fn rename(&self, from: &str, to: &str) -> io::Result<()> {
        let [from, to] = [single_name(OsStr::new(from))?, single_name(OsStr::new(to))?];
        self.folder.directory.info(from)?.require_file()?;
        if let Some(found) = self.folder.find_name(to)? {
            found.require_file()?;
        }
        self.check()?;
        self.folder.directory.rename(from, to)?;
        self.folder.directory.sync()
    }

    /// Moves a plain file or a folder into another locked folder of the same file system, where nothing has the name.
    ///
    /// # Errors
    /// There is none, it is a link or of another kind; something of that name is there already; a lock was lost; an error of the file
    /// system.
    pub fn move_new(&self, name: impl AsRef<OsStr>, target: &Self) -> io::Result<()> {
        let name = single_name(name.as_ref())?;
        match self.folder.directory.info(name)?.kind {
            FileKind::File | FileKind::Folder => {}
            FileKind::Link => return Err(Refused::Link.into()),
            FileKind::Other => return Err(Refused::NotAFile.into()),
        }
        self.check()?;
        target.check()?;
        self.folder.directory.move_new(name, &target.folder.directory, name)?;
        target.folder.directory.sync()?;
        self.folder.directory.sync()
    }

    /// A name for a file that another library writes below the folder, to be brought to its own name by [`FolderLock::adopt`].
    ///
    /// # Errors
    /// The system has no random bytes.
    pub fn temporary_name(&self) -> io::Result<String> {
        self.temporary_kind().new_name()
    }

    /// Flushes a file that another library has written under `temporary`, and renames it. Where that fails it is removed.
    ///
    /// # Errors
    /// The lock was lost; an error of the file system.
    pub fn adopt(&self, temporary: &str, name: &str) -> io::Result<()> {
        let name = single_name(OsStr::new(name))?;
        let adopted = || {
            replaceable(&self.folder, name)?;
            self.folder.directory.open_to_write(OsStr::new(temporary))?.sync_all()?;
            self.check()?;
            self.folder.directory.rename(OsStr::new(temporary), name)
        };
        self.or_remove(adopted(), temporary)?;
        self.folder.directory.sync()
    }

    /// Writes and flushes a file under a temporary name; on failure it is removed.
    fn write_temporary(&self, contents: &[u8], mode: u32, replaced: Option<&FileInfo>) -> io::Result<Temporary> {
        let name = self.temporary_kind().new_name()?;
        let mut file =
            self.folder.directory.create_new(OsStr::new(&name), mode).map_err(|error| match error.kind() {
                // The folder itself was removed.
                io::ErrorKind::NotFound => self.check().err().unwrap_or(error),
                _ => error,
            })?;
        let mut written = || {
            file.write_all(contents)?;
            if let Some(replaced) = replaced {
                keep_owner_and_mode(&file, replaced)?;
            }
            file.sync_all()?;
            Ok(file_info(&file)?.identity)
        };
        let written = written();
        Ok(Temporary { identity: self.or_remove(written, &name)?, name })
    }

    /// Removes a file that was brought to its name, where it is that file still.
    fn remove_own(&self, file: &Temporary, name: &OsStr) {
        if self.folder.directory.info(name).is_ok_and(|found| found.identity == file.identity) {
            let _ = self.folder.directory.remove_file(name);
        }
    }

    /// Removes what is not whole where `outcome` is an error: it takes the room that may be missing.
    fn or_remove<T>(&self, outcome: io::Result<T>, temporary: &str) -> io::Result<T> {
        outcome.inspect_err(|_| {
            let _ = self.folder.directory.remove_file(OsStr::new(temporary));
        })
    }
}

/// A file that is whole and does not have its name yet.
struct Temporary {
    name: String,
    identity: Identity,
}

/// What is to be replaced; `None` if there is nothing of that name.
fn replaceable(folder: &Folder, name: &OsStr) -> io::Result<Option<FileInfo>> {
    let Some(found) = folder.find_name(name)? else { return Ok(None) };
    found.require_file()?;
    if found.is_read_only() {
        return Err(Refused::ReadOnly.into());
    }
    // Whether it may be written the system says when it is opened.
    let open = folder.directory.open_to_write(name)?;
    Ok(Some(file_info(&open)?))
}

/// A name without folders in it.
fn single_name(name: &OsStr) -> io::Result<&OsStr> {
    // A backslash is part of a name on Unix.
    let is_foreign = |byte: &u8| *byte == b'/' || *byte == 0 || (cfg!(windows) && matches!(byte, b'\\' | b':'));
    let is_single = Path::new(name).file_name() == Some(name) && !name.as_encoded_bytes().iter().any(is_foreign);
    if is_single { Ok(name) } else { Err(Refused::BadName.into()) }
}

#[cfg(test)]
mod tests;
