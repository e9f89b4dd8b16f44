//! Reading and writing below a folder: the one place of the library that changes anything on disk.
//!
//! * A [`Folder`] is an open directory. Names below it are looked up in it, whatever its path leads to later, and no symbolic link below
//!   it is followed. Links in the path by which it is opened are followed: the user of the program chose that path.
//! * Kind and size of a file are checked on the open handle: a plain file, no larger than stated. Opening a pipe or a device does not block.
//! * Files that other processes read are written under a lock of their folder, by a [`FolderLock`]: under a random name, flushed to the
//!   device and renamed, so that a file is there whole or not at all. Files that only this process reads need no lock
//!   ([`anonymous_file`], [`create_private`]).
//! * Before each rename the lock is compared with the lock file in the folder: a process whose folder was emptied and taken by another one
//!   changes nothing more. Taking the lock removes the temporary files of its earlier holders, so that a process that lost it between the
//!   comparison and the rename has nothing left to rename.
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
pub use lock::{FolderLock, LockError, LockKind};
pub use named::{
    PrivateFile, anonymous_file, create_private, lock_result, lock_texts, lock_texts_below, may_write, read_named,
    read_named_text, read_stream, replace_named, write_new_files,
};
pub use refused::{FULL_OR_LIMITED, Refused, io_error_words, is_file_size_limited};
pub use temporary::TemporaryKind;
