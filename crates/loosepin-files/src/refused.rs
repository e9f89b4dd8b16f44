//! Why a file is not read or written, beyond what the operating system says.

use std::error::Error;
use std::fmt;
use std::io;

use crate::system;

/// A rule of this crate that a file does not keep. It travels inside an [`io::Error`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refused {
    /// A symbolic link where a file or folder is due.
    Link,
    /// A folder, pipe, socket or device where a file is due.
    NotAFile,
    /// A file above the size limit of reading.
    TooLarge {
        /// The largest size, bytes.
        limit_bytes: u64,
        /// Its size, or the number of bytes read from it.
        size_bytes: u64,
    },
    /// A file whose mode lets nobody write it.
    ReadOnly,
    /// The lock of the folder was removed, or another process has taken the folder.
    LockLost,
    /// A name that is no single name below a folder.
    BadName,
    /// A file that has further names (hard links) where one is due that is written in place.
    HardLink,
    /// A file that loosepin did not write, where its lock is due.
    ForeignLock,
}

impl Refused {
    /// Largest size that is written in KiB, bytes.
    const KIBIBYTES_UP_TO: u64 = 1 << 20;

    /// The reason within an error, where it is one of these.
    pub fn of(error: &io::Error) -> Option<Self> {
        error.get_ref()?.downcast_ref().copied()
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Link => formatter.write_str("it is a symbolic link, and links are not followed here"),
            Self::NotAFile => formatter.write_str("it is not a plain file"),
            Self::TooLarge { limit_bytes, .. } if *limit_bytes < Self::KIBIBYTES_UP_TO => {
                write!(formatter, "it has more than {} KiB", limit_bytes >> 10)
            }
            Self::TooLarge { limit_bytes, .. } => write!(formatter, "it has more than {} MiB", limit_bytes >> 20),
            Self::ReadOnly => formatter.write_str("it is read-only"),
            Self::LockLost => formatter
                .write_str("the folder was emptied or taken by another process meanwhile; nothing more is written"),
            Self::BadName => formatter.write_str("it is not a name below the folder"),
            Self::HardLink => {
                formatter.write_str("it is a hard link, and the file has another name as well; move it away")
            }
            Self::ForeignLock => formatter.write_str(
                "loosepin needs this name for its lock, and did not write the file that is there; move it away",
            ),
        }
    }
}

impl Error for Refused {}

impl From<Refused> for io::Error {
    fn from(refused: Refused) -> Self {
        let kind = match refused {
            Refused::TooLarge { .. } => io::ErrorKind::FileTooLarge,
            Refused::ReadOnly => io::ErrorKind::PermissionDenied,
            Refused::Link | Refused::NotAFile | Refused::BadName | Refused::HardLink => io::ErrorKind::InvalidInput,
            Refused::ForeignLock => io::ErrorKind::AlreadyExists,
            Refused::LockLost => io::ErrorKind::Other,
        };
        Self::new(kind, refused)
    }
}

/// Words for a file that may not grow.
pub const FULL_OR_LIMITED: &str = "the disk is full, or the file would exceed the size limit (ulimit -f)";

/// Whether the process has a limit of the size of its files (`ulimit -f`).
pub fn is_file_size_limited() -> bool {
    system::is_file_size_limited()
}

/// An error of the file system in plain words, where it is a usual one.
pub fn io_error_words(error: &io::Error) -> String {
    if let Some(refused) = Refused::of(error) {
        return refused.to_string();
    }
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::AlreadyExists => "it is there already".to_owned(),
        io::ErrorKind::PermissionDenied => "it is not permitted".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::QuotaExceeded => "the disk quota is used up".to_owned(),
        io::ErrorKind::FileTooLarge => FULL_OR_LIMITED.to_owned(),
        io::ErrorKind::ReadOnlyFilesystem => "the file system is read-only".to_owned(),
        io::ErrorKind::NotADirectory => "a part of the path is a file".to_owned(),
        io::ErrorKind::IsADirectory => "a folder of that name is in the way".to_owned(),
        io::ErrorKind::ResourceBusy => "another process writes in this folder".to_owned(),
        io::ErrorKind::WriteZero => "the system wrote nothing".to_owned(),
        _ => error.to_string(),
    }
}
