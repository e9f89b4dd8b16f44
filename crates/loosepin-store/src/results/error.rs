//! Why a folder of results cannot be written or read.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::kind::{MARKER_FILE, ResultKind};
use loosepin_text::diagnostics::{Code, Problem};

/// Why a folder of results cannot be written or read.
#[derive(Debug, Error)]
pub enum ResultsError {
    /// The folder holds results of other inputs.
    #[error(
        "{} holds {}, '{name}' (inputs {}, version {version}); nothing is overwritten",
        folder.display(),
        if held == wanted { format!("another {}", held.words()) } else { format!("a {}", held.words()) },
        inputs_blake3.get(..8).unwrap_or(inputs_blake3)
    )]
    HoldsOtherResults {
        /// The folder.
        folder: PathBuf,
        /// Kind of the result in it.
        held: ResultKind,
        /// Kind of the result to be written.
        wanted: ResultKind,
        /// The name of what it holds.
        name: String,
        /// The hash of its inputs.
        inputs_blake3: String,
        /// The version that wrote it.
        version: String,
    },
    /// The folder holds files that are no results.
    #[error("{} holds files that are not results, '{example}' for one; nothing is overwritten", folder.display())]
    HoldsOtherFiles {
        /// The folder.
        folder: PathBuf,
        /// The first of its files by name.
        example: String,
    },
    /// A file where a folder is due.
    #[error("{} is a file; expected a folder", path.display())]
    NotAFolder {
        /// The path.
        path: PathBuf,
    },
    /// No such folder.
    #[error("there is no folder {}", folder.display())]
    NoSuchFolder {
        /// The folder.
        folder: PathBuf,
    },
    /// A folder without marker.
    #[error("{} holds no results: it has no {MARKER_FILE}", folder.display())]
    NoMarker {
        /// The folder.
        folder: PathBuf,
    },
    /// A marker that cannot be read.
    #[error("{} is not what this version writes: {source}", path.display())]
    ForeignMarker {
        /// The marker.
        path: PathBuf,
        /// The error, with line and column.
        source: serde_json::Error,
    },
    /// A run that did not come to its end.
    #[error("the {} '{name}' in {} did not finish", kind.words(), folder.display())]
    Unfinished {
        /// The folder.
        folder: PathBuf,
        /// Kind of the result.
        kind: ResultKind,
        /// Its name.
        name: String,
    },
    /// A file that belongs to the results cannot be understood.
    #[error("{} is not what this version writes: {reason}", path.display())]
    ForeignFile {
        /// The file.
        path: PathBuf,
        /// The error.
        reason: String,
    },
    /// The marker has no form in JSON.
    #[error("{MARKER_FILE} cannot be laid out: {source}")]
    Layout {
        /// The error.
        source: serde_json::Error,
    },
    /// The file system refused.
    #[error("cannot write {}: {}", path.display(), reason(source))]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Message of the file system.
        source: io::Error,
    },
    /// The file system refused.
    #[error("cannot read {}: {}", path.display(), reason(source))]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// Message of the file system.
        source: io::Error,
    },
}

/// Message of the file system, in plain words where it is a usual one.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "it is not permitted".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::ReadOnlyFilesystem => "the file system is read-only".to_owned(),
        io::ErrorKind::NotADirectory => "a part of the path is a file".to_owned(),
        io::ErrorKind::IsADirectory => "a folder of that name is in the way".to_owned(),
        _ => error.to_string(),
    }
}

impl Problem for ResultsError {
    fn code(&self) -> Code {
        match self {
            Self::HoldsOtherResults { .. } | Self::HoldsOtherFiles { .. } => Code::FolderHoldsOther,
            Self::NoMarker { .. } | Self::ForeignMarker { .. } | Self::Unfinished { .. } | Self::ForeignFile { .. } => {
                Code::NoResults
            }
            Self::NotAFolder { .. }
            | Self::NoSuchFolder { .. }
            | Self::Layout { .. }
            | Self::Write { .. }
            | Self::Read { .. } => Code::FolderNotUsable,
        }
    }

    fn hint(&self) -> Option<String> {
        let hint = match self {
            Self::HoldsOtherResults { .. } => "give another folder, or --force to replace these results",
            Self::HoldsOtherFiles { .. } => {
                "give another folder, or --force to write beside these files and over those of the same names"
            }
            Self::NoMarker { .. } | Self::NoSuchFolder { .. } => {
                "results stand in results/NAME/HASH, or where --out said"
            }
            Self::ForeignMarker { .. } | Self::ForeignFile { .. } => {
                "run it again into another folder, or use the version that wrote it"
            }
            Self::Unfinished { .. } => "run it again: the same command writes into the same folder",
            Self::NotAFolder { .. } | Self::Layout { .. } | Self::Write { .. } | Self::Read { .. } => return None,
        };
        Some(hint.to_owned())
    }
}
