//! Why a store cannot be used.

use std::io;
use std::path::{Path, PathBuf};

use loosepin_files::{FULL_OR_LIMITED, io_error_words, is_file_size_limited, may_write};
use loosepin_text::diagnostics::{Code, problems};
use rusqlite::{ErrorCode, ffi};

problems! {
    /// Why the store at `path` cannot be used.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub enum StoreError {
        /// Another process has it open.
        InUse { path: PathBuf } => Code::FolderInUse,
            says("{} is in use by another loosepin process", path.display()),
            hint("wait until it ends, or give another folder with --out");
        /// The store holds runs of this very study, and the caller did not state whether to reuse them.
        HoldsRuns { path: PathBuf, runs: u64 } => Code::StudyStarted,
            says("{} contains {runs} finished {} of this study", path.display(), if *runs == 1 { "run" } else { "runs" }),
            hint("--resume continues with them, --force starts again");
        /// The store holds runs of something else: of another `study`, `version` or `format`.
        OfOther { path: PathBuf, what: &'static str, found: String, expected: String } => Code::StoreOfOther,
            says("{} contains runs of another {what} ({found}; this one is {expected})", path.display()),
            hint("give another folder with --out; --force starts again and deletes these runs");
        /// Its content was changed after writing.
        Damaged { path: PathBuf, reason: String } => Code::StoreDamaged,
            says("{} is damaged: {reason}", path.display()),
            hint("restore it from a copy; --force starts again");
        /// The file system refused.
        NotUsable { path: PathBuf, reason: String } => Code::FolderNotUsable,
            says("cannot use {}: {reason}", path.display()),
            hint("make the folder usable, or give another one with --out");
        /// SQLite was refused memory for the file at `path`.
        OutOfMemory { path: PathBuf } => Code::OutOfMemory,
            says("out of memory while {} was in use", path.display()),
            hint("raise the memory limit (ulimit -v, ulimit -d, or that of the container), or use fewer --threads or samples; \
                saved runs are kept: --resume continues with them");
        /// The file system took no further runs; `kept` of them are in it.
        NotSaved { path: PathBuf, reason: String, kept: u64 } => Code::FolderNotUsable,
            says("cannot write to {}: {reason}", path.display()),
            hint_of(Some(match kept {
                0 => "no run could be saved: start again when there is free space".to_owned(),
                1 => "1 run is saved: when there is free space again, --resume continues with it".to_owned(),
                _ => format!("{kept} runs are saved: when there is free space again, --resume continues with them"),
            }));
    }
}

impl StoreError {
    /// The error of the file system for the file at `path`.
    pub(super) fn not_usable(path: &Path, error: &io::Error) -> Self {
        Self::NotUsable { path: path.to_owned(), reason: io_error_words(error) }
    }

    /// The error of SQLite for the store at `path`.
    pub(super) fn of(path: &Path, error: &rusqlite::Error) -> Self {
        let path = path.to_owned();
        let extended = error.sqlite_error().map(|error| error.extended_code);
        match error.sqlite_error_code() {
            // A file of another format, or without the tables: what is asked of it here is always the same, and right.
            Some(ErrorCode::Unknown) => Self::Damaged { path, reason: error.to_string() },
            Some(ErrorCode::OutOfMemory) => Self::OutOfMemory { path },
            Some(ErrorCode::SystemIoFailure) if extended.is_some_and(is_about_memory) => Self::OutOfMemory { path },
            // SQLite says that the disk is full where the system does, and not where a file reaches the limit of its size.
            Some(ErrorCode::SystemIoFailure) if extended.is_some_and(is_about_size) && is_file_size_limited() => {
                Self::NotUsable { path, reason: FULL_OR_LIMITED.to_owned() }
            }
            // It ends within a page.
            Some(ErrorCode::SystemIoFailure) if extended == Some(ffi::SQLITE_IOERR_SHORT_READ) => {
                Self::Damaged { path, reason: error.to_string() }
            }
            Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => Self::InUse { path },
            Some(ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase) => {
                Self::Damaged { path, reason: error.to_string() }
            }
            Some(ErrorCode::DiskFull) => Self::NotUsable { path, reason: "the disk is full".to_owned() },
            // The file may be written, and says that a later version has written it.
            Some(ErrorCode::ReadOnly) if extended == Some(ffi::SQLITE_READONLY) && may_write(&path) => {
                Self::Damaged { path, reason: "its header is from another version of SQLite".to_owned() }
            }
            Some(ErrorCode::ReadOnly | ErrorCode::PermissionDenied) => {
                Self::NotUsable { path, reason: "there is no permission to write".to_owned() }
            }
            Some(_) => Self::NotUsable { path, reason: error.to_string() },
            // Numbers and texts where others are due.
            None => Self::Damaged { path, reason: error.to_string() },
        }
    }
}

/// Whether an error of the file system is one of memory.
fn is_about_memory(extended: i32) -> bool {
    matches!(extended, ffi::SQLITE_IOERR_NOMEM | ffi::SQLITE_IOERR_SHMMAP)
}

/// Whether an error of the file system is that of a file which was to grow.
fn is_about_size(extended: i32) -> bool {
    matches!(extended, ffi::SQLITE_IOERR_WRITE | ffi::SQLITE_IOERR_SHMSIZE | ffi::SQLITE_IOERR_TRUNCATE)
}
