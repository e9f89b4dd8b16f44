//! Reading and writing below a folder: the one place of the library that changes anything on disk.
//!
//! * A [`Folder`] is an open directory. Names below it are looked up in it, whatever becomes of its path, and no symbolic link below
//!   it is followed. The path by which a folder is opened first is the choice of whoever runs the program; its links are followed.
//! * What is opened is checked on the open handle: a plain file, no larger than stated. A pipe or a device does not make anybody wait.
//! * Files that others read are written under a lock of their folder, by a [`FolderLock`]. (Files that only this process reads need none:
//!   [`unnamed_file`], [`create_private`].) A file is written
//!   under a random name, flushed to the device and renamed, so that it is there whole or not at all. Before each rename it is checked
//!   that the lock is still the one of the folder: a process whose folder was emptied and taken by another one changes nothing more.
//! * Whoever takes the lock removes the temporary files of its earlier holders. So a process that was ousted between the check and the
//!   rename has nothing left to rename.
//!
//! Clippy refuses the functions of the standard library that write or open files everywhere else (`clippy.toml`).

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod entry;
mod folder;
mod lock;
mod named;
mod refused;
mod system;
mod temporary;
mod write;

pub use entry::{Entry, FileInfo, FileKind, Identity};
pub use folder::Folder;
pub use lock::{FolderLock, LockError};
pub use named::{
    PrivateFile, create_private, lock_texts, may_write, read_named, read_stream, replace_named, unnamed_file,
    write_new_files,
};
pub use refused::{FULL_OR_LIMITED, Refused, io_error_words, is_file_size_limited};
pub use temporary::TemporaryKind;

/// Name of the file that is locked for the moment in which texts of a folder are written.
pub const TEXT_LOCK_FILE: &str = ".loosepin.lock";
