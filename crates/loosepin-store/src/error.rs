//! Why a store cannot be used.

use std::path::{Path, PathBuf};

use rusqlite::{ErrorCode, ffi};
use thiserror::Error;

use loosepin_text::diagnostics::{Code, Problem};

/// Why a store cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum StoreError {
    /// Another process has it open.
    #[error("{} is in use by another loosepin", path.display())]
    InUse {
        /// The store.
        path: PathBuf,
    },
    /// It holds runs of this very study, and nobody said what is to become of them.
    #[error("{} holds {runs} finished {} of this study", path.display(), if *runs == 1 { "run" } else { "runs" })]
    HoldsRuns {
        /// The store.
        path: PathBuf,
        /// How many.
        runs: u64,
    },
    /// It holds runs of something else.
    #[error("{} holds runs of another {what} ({found}; this one is {expected})", path.display())]
    OfOther {
        /// The store.
        path: PathBuf,
        /// `study`, `version` or `format`.
        what: &'static str,
        /// Whose runs it holds.
        found: String,
        /// Whose were to be found.
        expected: String,
    },
    /// Its content is not what was written.
    #[error("{} is damaged: {reason}", path.display())]
    Damaged {
        /// The store.
        path: PathBuf,
        /// The error.
        reason: String,
    },
    /// The file system refused.
    #[error("cannot use {}: {reason}", path.display())]
    NotUsable {
        /// The store.
        path: PathBuf,
        /// Message of the file system.
        reason: String,
    },
}

impl StoreError {
    /// The error of SQLite for the store at `path`.
    pub(super) fn of(path: &Path, error: &rusqlite::Error) -> Self {
        let path = path.to_owned();
        let extended = error.sqlite_error().map(|error| error.extended_code);
        match error.sqlite_error_code() {
            // A file of another format, or without the tables: what is asked of it here is always the same, and right.
            Some(ErrorCode::Unknown) => Self::Damaged { path, reason: error.to_string() },
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
            Some(ErrorCode::ReadOnly) if extended == Some(ffi::SQLITE_READONLY) && is_writable(&path) => {
                Self::Damaged { path, reason: "its header is of another version of SQLite".to_owned() }
            }
            Some(ErrorCode::ReadOnly | ErrorCode::PermissionDenied) => {
                Self::NotUsable { path, reason: "it is not permitted to write".to_owned() }
            }
            Some(_) => Self::NotUsable { path, reason: error.to_string() },
            // Numbers and texts where others are due.
            None => Self::Damaged { path, reason: error.to_string() },
        }
    }
}

fn is_writable(path: &Path) -> bool {
    std::fs::OpenOptions::new().write(true).open(path).is_ok()
}

impl Problem for StoreError {
    fn code(&self) -> Code {
        match self {
            Self::InUse { .. } => Code::StoreInUse,
            Self::HoldsRuns { .. } => Code::StudyStarted,
            Self::OfOther { .. } => Code::StoreOfOther,
            Self::Damaged { .. } => Code::StoreDamaged,
            Self::NotUsable { .. } => Code::FolderNotUsable,
        }
    }

    fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::InUse { .. } => "wait for it to end, or give another folder by --out",
            Self::HoldsRuns { .. } => "--resume goes on with them, --force begins anew",
            Self::OfOther { .. } => "give another folder by --out; --force begins anew and drops these runs",
            Self::Damaged { .. } => "restore it from a copy; --force begins anew",
            Self::NotUsable { .. } => "its runs are kept: when there is room again, --resume goes on with them",
        };
        Some(hint.to_owned())
    }
}
