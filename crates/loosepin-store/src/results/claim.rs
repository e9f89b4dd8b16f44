//! Claiming a folder for a result.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::REPORT_FILE;
use super::error::ResultsError;
use super::folder::{ResultsFolder, aside, folder_name, remove_files};
use super::inputs::InputsHash;
use super::kind::{MARKER_FILE, ResultKind};
use super::lock::{FolderLock, LOCK_FILE};
use super::marker::{Marker, inside};
use super::whole::{PARTIAL, write_whole};

/// Where results are to go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// `ROOT/NAME/HASH`: a folder for each set of inputs, so that nothing is ever in the way.
    Below(PathBuf),
    /// This folder.
    Folder(PathBuf),
}

/// A result that asks for a folder.
#[derive(Debug, Clone)]
pub struct Claim {
    /// Kind of result.
    pub kind: ResultKind,
    /// Name of the model or study.
    pub name: String,
    /// Hash of its inputs.
    pub inputs: InputsHash,
    /// Where it is to go.
    pub place: Place,
    /// Whether results and files that are in the way are replaced.
    pub with_force: bool,
}

/// A folder that is locked for a claim, and not changed yet. Dropped, it is as it was.
#[derive(Debug)]
pub struct LockedFolder<'a> {
    claim: &'a Claim,
    path: PathBuf,
    lock: FolderLock,
    held: Option<Marker>,
}

impl Claim {
    /// The folder that results go to.
    pub fn path(&self) -> PathBuf {
        match &self.place {
            Place::Below(root) => root.join(folder_name(&self.name)).join(self.inputs.short()),
            Place::Folder(path) => path.clone(),
        }
    }

    /// Whether the folder holds the finished result, which is to be made anew only with force. Nothing is changed. Files without a
    /// marker are no result; whether they are in the way is for [`Claim::lock`] to say, which knows what may stand beside it.
    ///
    /// # Errors
    /// The folder holds another result, or cannot be read.
    pub fn is_finished(&self) -> Result<bool, ResultsError> {
        match self.find(&[]) {
            Err(ResultsError::HoldsOtherFiles { .. }) => Ok(false),
            found => Ok(found?.is_some_and(|held| self.is_made(&held))),
        }
    }

    /// Takes the folder, making it where there is none. A finished result of the same inputs is left as it is (see
    /// [`ResultsFolder::is_finished`]), an unfinished one is taken over, with the finished one that it was to replace. With force
    /// the result is always made anew.
    ///
    /// # Errors
    /// The folder holds something else, or another process writes there; a finished result is not whole; the file system refuses.
    pub fn take(&self) -> Result<ResultsFolder, ResultsError> {
        self.lock(&[])?.begin()
    }

    /// Locks the folder, making it where there is none; nothing else in it is changed. Files named `beside` may be made under the
    /// lock before [`LockedFolder::begin`]; alone in a folder they say nothing.
    ///
    /// # Errors
    /// As for [`Claim::take`].
    pub fn lock(&self, beside: &[&str]) -> Result<LockedFolder<'_>, ResultsError> {
        // Looked at before it is locked as well: the folder of somebody else is not touched.
        self.find(beside)?;
        let path = self.path();
        let lock = FolderLock::take(&path, &format!("{} '{}'", self.kind.words(), self.name))?;
        let held = self.find(beside)?;
        if let Some(held) = held.as_ref().filter(|held| self.is_made(held)) {
            held.verify(&path, &[REPORT_FILE])?;
        }
        Ok(LockedFolder { claim: self, path, lock, held })
    }

    /// Content of the folder that may be replaced, now.
    fn find(&self, beside: &[&str]) -> Result<Option<Marker>, ResultsError> {
        let path = self.path();
        if !path.exists() {
            return Ok(None);
        }
        if !path.is_dir() {
            return Err(ResultsError::NotAFolder { path });
        }
        match Marker::read(&path) {
            Ok(held) if self.is_same(&held) || self.with_force => Ok(Some(held)),
            Ok(held) => Err(ResultsError::HoldsOtherResults {
                folder: path,
                held: held.kind,
                wanted: self.kind,
                name: held.name,
                inputs_blake3: held.inputs_blake3,
                version: held.version,
            }),
            Err(ResultsError::NoMarker { .. }) => match first_entry(&path, beside)?.filter(|_| !self.with_force) {
                Some(example) => Err(ResultsError::HoldsOtherFiles { folder: path, example }),
                None => Ok(None),
            },
            Err(ResultsError::ForeignMarker { .. }) if self.with_force => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Whether these are results of the same inputs.
    fn is_same(&self, held: &Marker) -> bool {
        held.kind == self.kind && held.inputs_blake3 == self.inputs.to_string()
    }

    /// Whether this is the finished result itself, which is not made again.
    fn is_made(&self, held: &Marker) -> bool {
        held.is_finished && self.is_same(held) && !self.with_force
    }
}

impl LockedFolder<'_> {
    /// The folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether it holds the finished result, which is made anew only with force.
    pub fn is_finished(&self) -> bool {
        self.held.as_ref().is_some_and(|held| self.claim.is_made(held))
    }

    /// Begins the result: whoever comes next finds an unfinished one. A finished result of the same inputs is left as it is.
    ///
    /// # Errors
    /// The file system refuses.
    pub fn begin(self) -> Result<ResultsFolder, ResultsError> {
        let is_finished = self.is_finished();
        let Self { claim, path, lock, held } = self;
        let replaced = match held {
            Some(marker) if is_finished => {
                let mut folder = ResultsFolder { path, marker, _lock: lock };
                folder.remove_replaced()?;
                return Ok(folder);
            }
            Some(held) if held.is_finished => prepare_to_replace(&path, &held)?,
            Some(held) => {
                remove_files(&path, held.files.keys())?;
                held.replaced
            }
            None => Vec::new(),
        };
        let marker = Marker {
            kind: claim.kind,
            name: claim.name.clone(),
            inputs_blake3: claim.inputs.to_string(),
            version: loosepin_text::VERSION.to_owned(),
            is_finished: false,
            files: [].into(),
            replaced,
        };
        // Said before anything is renamed, so that whoever comes next knows what waits under which name.
        marker.write(&path)?;
        let folder = ResultsFolder { path, marker, _lock: lock };
        folder.set_replaced_aside()?;
        Ok(folder)
    }
}

/// The files of a finished result that are to be set aside, its marker among them, of which a copy is made: the marker itself is
/// overwritten in one step, so that the folder is never without one.
fn prepare_to_replace(folder: &Path, held: &Marker) -> Result<Vec<String>, ResultsError> {
    let is_there = |file_name: &&String| inside(folder, file_name).is_some_and(|path| path.is_file());
    let mut replaced: Vec<String> = held.files.keys().filter(is_there).cloned().collect();
    // What an earlier result has left under these names is not what comes back.
    let waiting: Vec<String> = replaced.iter().chain(&held.replaced).map(|file_name| aside(file_name)).collect();
    remove_files(folder, &waiting)?;
    write_whole(&folder.join(aside(MARKER_FILE)), held.to_text()?.as_bytes())?;
    replaced.push(MARKER_FILE.to_owned());
    Ok(replaced)
}

/// The first entry of a folder by name; none where it is empty. Files named `beside` and that of a lock are left aside, and a marker
/// that is not whole: its writer was stopped before anything else was there.
fn first_entry(folder: &Path, beside: &[&str]) -> Result<Option<String>, ResultsError> {
    let not_readable = |source| ResultsError::Read { path: folder.to_owned(), source };
    let mut first: Option<String> = None;
    let entries = match fs::read_dir(folder) {
        // Whoever had made it has given it up meanwhile.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        entries => entries.map_err(not_readable)?,
    };
    for entry in entries {
        let name = entry.map_err(not_readable)?.file_name().to_string_lossy().into_owned();
        let is_ours = name == LOCK_FILE || name.strip_suffix(PARTIAL) == Some(MARKER_FILE);
        if !is_ours && !beside.contains(&&name[..]) && first.as_ref().is_none_or(|known| name < *known) {
            first = Some(name);
        }
    }
    Ok(first)
}
