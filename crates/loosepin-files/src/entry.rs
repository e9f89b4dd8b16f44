//! Information about a file without reading it.

use std::ffi::OsString;
use std::io;
use std::time::SystemTime;

use crate::refused::Refused;

/// The kind of a directory entry. Links are not followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// A plain file.
    File,
    /// A folder.
    Folder,
    /// A symbolic link.
    Link,
    /// A pipe, socket or device.
    Other,
}

/// Device and inode number of a file. Where the system tells none (Windows), all are equal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Identity {
    /// The device.
    pub device: u64,
    /// The number of the file on it.
    pub number: u64,
}

/// Information about a file without reading it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FileInfo {
    /// Its kind.
    pub kind: FileKind,
    /// Its size, bytes.
    pub size_bytes: u64,
    /// Time of the last change of its content, if the system reports it.
    pub modified: Option<SystemTime>,
    /// Identity of the file.
    pub identity: Identity,
    /// Its permissions: the lower twelve bits of the mode. Of Windows, 0o444 or 0o666.
    pub mode: u32,
    /// Its owner and group, where the system has them.
    pub owner: Option<(u32, u32)>,
    /// Its names in all folders: more than one where it has hard links. 1 where the system tells none (Windows).
    pub names: u64,
}

impl FileInfo {
    /// Permission to write for owner, group or others.
    const WRITABLE: u32 = 0o222;

    /// That it is a plain file.
    ///
    /// # Errors
    /// A folder ([`io::ErrorKind::IsADirectory`]), a link, or another kind.
    pub fn require_file(&self) -> io::Result<()> {
        match self.kind {
            FileKind::File => Ok(()),
            FileKind::Folder => Err(io::ErrorKind::IsADirectory.into()),
            FileKind::Link => Err(Refused::Link.into()),
            FileKind::Other => Err(Refused::NotAFile.into()),
        }
    }

    /// Whether its mode forbids writing.
    pub fn is_read_only(&self) -> bool {
        self.mode & Self::WRITABLE == 0
    }
}

/// An entry of a folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Its name.
    pub name: OsString,
    /// Its kind.
    pub kind: FileKind,
}
