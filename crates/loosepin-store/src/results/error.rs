//! Why a folder of results cannot be written or read.

use std::io;
use std::path::PathBuf;

use super::kind::{MARKER_FILE, ResultKind};
use loosepin_text::diagnostics::{Code, problems};

problems! {
    /// Why a folder of results cannot be written or read.
    #[derive(Debug)]
    pub enum ResultsError {
        /// The folder holds results of other inputs.
        HoldsOtherResults {
            folder: PathBuf,
            held: ResultKind,
            wanted: ResultKind,
            name: String,
            inputs_blake3: String,
            version: String,
        } => Code::FolderHoldsOther,
            says(
                "{} holds {}, '{name}' (inputs {}, version {version}); nothing is overwritten",
                folder.display(),
                if held == wanted { format!("another {}", held.words()) } else { format!("a {}", held.words()) },
                inputs_blake3.get(..8).unwrap_or(inputs_blake3)
            ),
            hint("give another folder, or --force to replace these results");
        /// The folder holds files that are no results.
        HoldsOtherFiles { folder: PathBuf, example: String } => Code::FolderHoldsOther,
            says("{} holds files that are not results, '{example}' for one; nothing is overwritten", folder.display()),
            hint("give another folder, or --force to write beside these files and over those of the same names");
        /// Another process writes there; `holder` is what it says of itself.
        InUse { folder: PathBuf, holder: Option<String> } => Code::FolderInUse,
            says(
                "{} is in use by {}; nothing in it is changed",
                folder.display(),
                holder.as_deref().unwrap_or("another loosepin")
            ),
            hint("wait for it to end, or give another folder by --out");
        /// A file of a finished result is missing.
        Missing { path: PathBuf, kind: ResultKind, name: String } => Code::ResultNotWhole,
            says("{} is missing; it belongs to the finished {} '{name}'", path.display(), kind.words()),
            hint("put the file back, or run it again with --force");
        /// A file of a finished result has another hash than when it was written.
        Changed { path: PathBuf, kind: ResultKind, name: String } => Code::ResultNotWhole,
            says(
                "{} is not the file that the {} '{name}' wrote: its BLAKE3 hash is not the one in {MARKER_FILE}",
                path.display(),
                kind.words()
            ),
            hint("put the file back as it was, or run it again with --force");
        /// A finished result that has no such file.
        NotListed { path: PathBuf, kind: ResultKind, name: String } => Code::NoResults,
            says("{} is no file of the {} '{name}'", path.display(), kind.words());
        /// A result that has no page.
        NoPage { folder: PathBuf } => Code::NoResults,
            says("{} holds exported networks; they have no report", folder.display()),
            hint("give the folder of the study that they were exported from");
        /// A file where a folder is due.
        NotAFolder { path: PathBuf } => Code::FolderNotUsable,
            says("{} is a file; expected a folder", path.display());
        /// No such folder.
        NoSuchFolder { folder: PathBuf } => Code::FolderNotUsable,
            says("there is no folder {}", folder.display()),
            hint("results stand in results/NAME/HASH, or where --out said");
        /// A folder without marker.
        NoMarker { folder: PathBuf } => Code::NoResults,
            says("{} holds no results: it has no {MARKER_FILE}", folder.display()),
            hint("results stand in results/NAME/HASH, or where --out said");
        /// A marker that cannot be read.
        ForeignMarker { path: PathBuf, source: serde_json::Error } => Code::NoResults,
            says("{} is not what this version writes: {source}", path.display()),
            hint("run it again into another folder, or use the version that wrote it");
        /// A run that did not come to its end.
        Unfinished { folder: PathBuf, kind: ResultKind, name: String } => Code::NoResults,
            says("the {} '{name}' in {} did not finish", kind.words(), folder.display()),
            hint("run it again: the same command writes into the same folder");
        /// A file that belongs to the results cannot be understood.
        ForeignFile { path: PathBuf, reason: String } => Code::NoResults,
            says("{} is not what this version writes: {reason}", path.display()),
            hint("run it again into another folder, or use the version that wrote it");
        /// The marker has no form in JSON.
        Layout { source: serde_json::Error } => Code::FolderNotUsable,
            says("{MARKER_FILE} cannot be laid out: {source}");
        /// The file system refused.
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {}", path.display(), reason(source));
        /// The file system refused.
        Read { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot read {}: {}", path.display(), reason(source));
    }
}

/// Message of the file system, in plain words where it is a usual one.
fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "it is not permitted".to_owned(),
        io::ErrorKind::StorageFull => "the disk is full".to_owned(),
        io::ErrorKind::FileTooLarge => crate::error::FULL_OR_LIMITED.to_owned(),
        io::ErrorKind::ReadOnlyFilesystem => "the file system is read-only".to_owned(),
        io::ErrorKind::NotADirectory => "a part of the path is a file".to_owned(),
        io::ErrorKind::IsADirectory => "a folder of that name is in the way".to_owned(),
        _ => error.to_string(),
    }
}
