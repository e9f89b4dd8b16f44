//! Why a folder of results cannot be written or read.

use std::io;
use std::path::{Path, PathBuf};

use super::kind::{MARKER_FILE, ResultKind};
use loosepin_files::{LockError, io_error_words};
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
                "{} contains {}, '{name}' (inputs {}, version {version}); nothing is overwritten",
                folder.display(),
                if held == wanted { format!("another {}", held.words()) } else { format!("a {}", held.words()) },
                inputs_blake3.get(..8).unwrap_or(inputs_blake3)
            ),
            hint("give another folder, or replace these results with --force");
        /// The folder holds files that are no results.
        HoldsOtherFiles { folder: PathBuf, example: String } => Code::FolderHoldsOther,
            says("{} contains files that are not results, for example '{example}'; nothing is overwritten", folder.display()),
            hint("give another folder; --force keeps these files, but overwrites those with the same names");
        /// A file that is none of the results has the name under which a file of theirs is to wait.
        AsideTaken { path: PathBuf } => Code::FolderHoldsOther,
            says("{} already exists; loosepin needs this name for result files while it replaces them", path.display()),
            hint("move it, or give another folder");
        /// Another process writes there; `holder` is its own description.
        InUse { folder: PathBuf, holder: Option<String> } => Code::FolderInUse,
            says(
                "{} is in use by {}; nothing in it is changed",
                folder.display(),
                holder.as_deref().unwrap_or("another loosepin process")
            ),
            hint("wait until it ends, or give another folder with --out");
        /// A file of a finished result is missing.
        Missing { path: PathBuf, kind: ResultKind, name: String } => Code::ResultNotWhole,
            says("{} is missing; it belongs to the finished {} '{name}'", path.display(), kind.words()),
            hint("restore the file, or run the command again with --force");
        /// A file of a finished result has another hash than when it was written.
        Changed { path: PathBuf, kind: ResultKind, name: String } => Code::ResultNotWhole,
            says(
                "{} is not the file that the {} '{name}' wrote: its BLAKE3 hash is not the one in {MARKER_FILE}",
                path.display(),
                kind.words()
            ),
            hint("restore the original file, or run the command again with --force");
        /// A finished result that has no such file.
        NotListed { path: PathBuf, kind: ResultKind, name: String } => Code::NoResults,
            says("{} is not a file of the {} '{name}'", path.display(), kind.words());
        /// A result that has no page.
        NoPage { folder: PathBuf } => Code::NoResults,
            says("{} contains exported networks, which have no report", folder.display()),
            hint("give the folder of the study from which they were exported");
        /// A result of another kind than is wanted.
        OtherKind { folder: PathBuf, held: ResultKind, name: String, wanted: ResultKind } => Code::NoResults,
            says("{} contains the {} '{name}'; expected a {}", folder.display(), held.words(), wanted.words());
        /// A file where a folder is due.
        NotAFolder { path: PathBuf } => Code::FolderNotUsable,
            says("{} is a file; expected a folder", path.display());
        /// No such folder.
        NoSuchFolder { folder: PathBuf } => Code::FolderNotUsable,
            says("there is no folder {}", folder.display()),
            hint("results are in results/NAME/HASH, or in the folder given with --out");
        /// A folder without marker.
        NoMarker { folder: PathBuf } => Code::NoResults,
            says("{} contains no results: it has no {MARKER_FILE}", folder.display()),
            hint("results are in results/NAME/HASH, or in the folder given with --out");
        /// A marker that cannot be read.
        ForeignMarker { path: PathBuf, source: serde_json::Error } => Code::NoResults,
            says("{} does not have the format of this version: {source}", path.display()),
            hint("run the command again with another folder, or use the version that wrote the file");
        /// A run that did not finish.
        Unfinished { folder: PathBuf, kind: ResultKind, name: String } => Code::NoResults,
            says("the {} '{name}' in {} did not finish", kind.words(), folder.display()),
            hint("run the same command again; it writes into the same folder");
        /// A file that belongs to the results cannot be understood.
        ForeignFile { path: PathBuf, reason: String } => Code::NoResults,
            says("{} does not have the format of this version: {reason}", path.display()),
            hint("run the command again with another folder, or use the version that wrote the file");
        /// The marker has no form in JSON.
        Layout { source: serde_json::Error } => Code::FolderNotUsable,
            says("{MARKER_FILE} cannot be written as JSON: {source}");
        /// The file system refused.
        Write { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot write {}: {}", path.display(), io_error_words(source));
        /// The file system refused.
        Read { path: PathBuf, source: io::Error } => Code::FolderNotUsable,
            says("cannot read {}: {}", path.display(), io_error_words(source));
    }
}

impl ResultsError {
    /// Why `folder` cannot be locked.
    pub(super) fn of_lock(folder: &Path, error: LockError) -> Self {
        match error {
            LockError::InUse { holder } => Self::InUse { folder: folder.to_owned(), holder },
            LockError::File { path, source } => Self::Write { path, source },
        }
    }
}
