//! Calls by paths, for systems whose directories cannot be held open. Links are looked for before each call.

#![allow(clippy::disallowed_methods, reason = "the one place that calls them")]

use std::ffi::OsStr;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use crate::entry::{Entry, FileInfo, FileKind, Identity};
use crate::refused::Refused;

/// A directory, known by its path without links.
#[derive(Debug)]
pub struct Directory(PathBuf);

impl Directory {
    /// The directory at `path`; links in it are followed.
    pub fn at(path: &Path) -> io::Result<Self> {
        let path = path.canonicalize()?;
        if path.is_dir() { Ok(Self(path)) } else { Err(io::ErrorKind::NotADirectory.into()) }
    }

    /// The path of a name, which is no link.
    fn path(&self, name: &OsStr) -> io::Result<PathBuf> {
        let path = self.0.join(name);
        match fs::symlink_metadata(&path) {
            Ok(found) if found.is_symlink() => Err(Refused::Link.into()),
            _ => Ok(path),
        }
    }

    /// A directory in this one.
    pub fn open_directory(&self, name: &OsStr) -> io::Result<Self> {
        let path = self.path(name)?;
        if fs::metadata(&path)?.is_dir() { Ok(Self(path)) } else { Err(io::ErrorKind::NotADirectory.into()) }
    }

    pub fn make_directory(&self, name: &OsStr) -> io::Result<()> {
        fs::create_dir(self.0.join(name))
    }

    /// A file to be read.
    pub fn open_to_read(&self, name: &OsStr) -> io::Result<File> {
        File::open(self.path(name)?)
    }

    /// Opens an existing file for writing; its content is not changed.
    pub fn open_to_write(&self, name: &OsStr) -> io::Result<File> {
        OpenOptions::new().read(true).write(true).open(self.path(name)?)
    }

    /// Creates a new file.
    pub fn create_new(&self, name: &OsStr, _mode: u32) -> io::Result<File> {
        OpenOptions::new().read(true).write(true).create_new(true).open(self.0.join(name))
    }

    pub fn info(&self, name: &OsStr) -> io::Result<FileInfo> {
        Ok(info(&fs::symlink_metadata(self.0.join(name))?))
    }

    /// Information about the directory itself.
    pub fn metadata(&self) -> io::Result<FileInfo> {
        Ok(info(&fs::metadata(&self.0)?))
    }

    pub fn rename(&self, from: &OsStr, to: &OsStr) -> io::Result<()> {
        fs::rename(self.0.join(from), self.0.join(to))
    }

    /// Renames, if nothing exists at the new path at the time of the check.
    pub fn rename_new(&self, from: &OsStr, to: &OsStr) -> io::Result<()> {
        self.move_new(from, self, to)
    }

    /// As [`Self::rename_new`], into another directory.
    pub fn move_new(&self, from: &OsStr, target: &Self, to: &OsStr) -> io::Result<()> {
        match fs::symlink_metadata(target.0.join(to)) {
            Ok(_) => Err(io::ErrorKind::AlreadyExists.into()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => fs::rename(self.0.join(from), target.0.join(to)),
            Err(error) => Err(error),
        }
    }

    pub fn remove_file(&self, name: &OsStr) -> io::Result<()> {
        fs::remove_file(self.0.join(name))
    }

    pub fn remove_directory(&self, name: &OsStr) -> io::Result<()> {
        fs::remove_dir(self.0.join(name))
    }

    /// Entries cannot be flushed where a directory cannot be opened.
    #[allow(clippy::unused_self, clippy::unnecessary_wraps, reason = "as on Unix")]
    pub fn sync(&self) -> io::Result<()> {
        Ok(())
    }

    /// The entries, in no order; at most `most` of them.
    pub fn entries(&self, most: usize) -> io::Result<Vec<Entry>> {
        let entry = |entry: io::Result<fs::DirEntry>| {
            let entry = entry?;
            Ok(Entry { name: entry.file_name(), kind: kind(entry.file_type()?) })
        };
        fs::read_dir(&self.0)?.take(most).map(entry).collect()
    }
}

/// The file at `path`, to be read; links in it are followed.
pub fn open_named(path: &Path) -> io::Result<File> {
    // A folder cannot be opened here; the caller has to learn that it is one.
    if fs::metadata(path)?.is_dir() { Err(io::ErrorKind::IsADirectory.into()) } else { File::open(path) }
}

/// These systems have no such limit.
pub fn is_file_size_limited() -> bool {
    false
}

/// Information about an open file.
pub fn file_info(file: &File) -> io::Result<FileInfo> {
    Ok(info(&file.metadata()?))
}

/// A new file that can be written replaces only what can be written: there is nothing to keep.
#[allow(clippy::unnecessary_wraps, reason = "as on Unix")]
pub fn keep_owner_and_mode(_file: &File, _replaced: &FileInfo) -> io::Result<()> {
    Ok(())
}

fn kind(file_type: fs::FileType) -> FileKind {
    if file_type.is_symlink() {
        FileKind::Link
    } else if file_type.is_dir() {
        FileKind::Folder
    } else if file_type.is_file() {
        FileKind::File
    } else {
        FileKind::Other
    }
}

fn info(metadata: &Metadata) -> FileInfo {
    FileInfo {
        kind: kind(metadata.file_type()),
        size_bytes: metadata.len(),
        modified: metadata.modified().ok(),
        identity: Identity::default(),
        mode: if metadata.permissions().readonly() { 0o444 } else { 0o666 },
        owner: None,
        names: 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn names_are_made_renamed_and_removed() {
        let desk = tempfile::tempdir().unwrap();
        let [a, b] = ["a", "b"].map(OsStr::new);
        let top = Directory::at(desk.path()).unwrap();
        top.create_new(a, 0o600).unwrap().write_all(b"text").unwrap();
        assert_eq!(top.create_new(a, 0o600).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        top.rename_new(a, b).unwrap();
        assert_eq!((top.info(b).unwrap().kind, top.info(b).unwrap().size_bytes), (FileKind::File, 4));
        top.make_directory(a).unwrap();
        assert_eq!(top.rename_new(b, a).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(top.entries(10).unwrap().len(), 2);
        assert!(top.open_directory(b).is_err());
        top.open_directory(a).unwrap();
        top.remove_directory(a).unwrap();
        top.remove_file(b).unwrap();
        assert_eq!(top.entries(10).unwrap(), []);
    }

    #[cfg(unix)]
    #[test]
    fn links_are_refused() {
        let desk = tempfile::tempdir().unwrap();
        std::os::unix::fs::symlink("..", desk.path().join("out")).unwrap();
        let top = Directory::at(desk.path()).unwrap();
        for refused in [
            top.open_to_read(OsStr::new("out")).err(),
            top.open_to_write(OsStr::new("out")).err(),
            top.open_directory(OsStr::new("out")).err(),
        ] {
            assert_eq!(Refused::of(&refused.unwrap()), Some(Refused::Link));
        }
    }
}
