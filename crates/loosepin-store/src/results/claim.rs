//! Claiming a folder for a result.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use loosepin_files::{Folder, FolderLock, LockKind, Refused, TemporaryKind};

use super::REPORT_FILE;
use super::error::ResultsError;
use super::folder::{ResultsFolder, aside, folder_name, holder, is_file, not_opened, remove_files};
use super::inputs::InputsHash;
use super::kind::{MARKER_FILE, ResultKind};
use super::marker::{Marker, write};

/// Destination of results.
#[derive(Debug, Clone)]
pub enum Destination {
    /// `ROOT/NAME/HASH`: a folder for each set of inputs, so that nothing is ever in the way. Links in `ROOT` are followed, none below it.
    Below(PathBuf),
    /// The same with a root below an open folder. No link below that folder is followed.
    Within(Folder, PathBuf),
    /// This folder. Links in its path are followed.
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
    /// Destination of the result.
    pub destination: Destination,
    /// Whether results and files that are in the way are replaced.
    pub with_force: bool,
}

/// A folder that is locked for a claim, and not changed yet. Dropped, it is as it was.
#[derive(Debug)]
pub struct LockedFolder<'a> {
    claim: &'a Claim,
    lock: Arc<FolderLock>,
    held: Option<Marker>,
}

impl Claim {
    /// The folder that results go to.
    pub fn path(&self) -> PathBuf {
        match &self.destination {
            Destination::Below(root) => root.join(self.below()),
            Destination::Within(folder, root) => folder.path().join(root).join(self.below()),
            Destination::Folder(path) => path.clone(),
        }
    }

    /// `NAME/HASH`.
    fn below(&self) -> PathBuf {
        Path::new(&folder_name(&self.name)).join(self.inputs.short())
    }

    /// The folder, where it is there.
    fn open(&self) -> Result<Option<Folder>, ResultsError> {
        let opened = match &self.destination {
            Destination::Below(root) => Folder::open(root).and_then(|root| root.open_below(&self.below())),
            Destination::Within(folder, root) => folder.open_below(&root.join(self.below())),
            Destination::Folder(path) => Folder::open(path),
        };
        match opened.map_err(|error| not_opened(&self.path(), error)) {
            Err(ResultsError::NoSuchFolder { .. }) => Ok(None),
            opened => opened.map(Some),
        }
    }

    /// Locks the folder, making it where there is none.
    fn take_lock(&self) -> Result<FolderLock, ResultsError> {
        let holder = holder(&format!("{} '{}'", self.kind.words(), self.name));
        let taken = match &self.destination {
            Destination::Below(root) => FolderLock::take_under(root, &self.below(), LockKind::Result, &holder),
            Destination::Within(folder, root) => {
                FolderLock::wait_below(folder, &root.join(self.below()), LockKind::Result, &holder, Duration::ZERO)
            }
            Destination::Folder(path) => FolderLock::take(path, LockKind::Result, &holder),
        };
        taken.map_err(|error| ResultsError::of_lock(&self.path(), error))
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

    /// Locks the folder, making it if there is none; nothing else in it is changed. Files named `beside` may be made under the lock before
    /// [`LockedFolder::begin`]; alone in a folder they say nothing.
    ///
    /// # Errors
    /// As for [`Claim::take`].
    pub fn lock(&self, beside: &[&str]) -> Result<LockedFolder<'_>, ResultsError> {
        // Looked at before it is locked as well: the folder of somebody else is not touched.
        self.find(beside)?;
        let lock = self.take_lock()?;
        let held = self.find_in(lock.folder(), beside)?;
        if let Some(held) = held.as_ref().filter(|held| held.is_finished && !self.is_made(held)) {
            check_names_of_replaced(lock.folder(), held)?;
        }
        if let Some(held) = held.as_ref().filter(|held| self.is_made(held)) {
            held.verify(lock.folder(), &[REPORT_FILE])?;
        }
        Ok(LockedFolder { claim: self, lock: Arc::new(lock), held })
    }

    /// Content of the folder that may be replaced, now.
    fn find(&self, beside: &[&str]) -> Result<Option<Marker>, ResultsError> {
        match self.open()? {
            Some(folder) => self.find_in(&folder, beside),
            None => Ok(None),
        }
    }

    fn find_in(&self, folder: &Folder, beside: &[&str]) -> Result<Option<Marker>, ResultsError> {
        let path = folder.path().to_owned();
        match Marker::read(folder) {
            Ok(held) if self.is_same(&held) || self.with_force => Ok(Some(held)),
            Ok(held) => Err(ResultsError::HoldsOtherResults {
                folder: path,
                held: held.kind,
                wanted: self.kind,
                name: held.name,
                inputs_blake3: held.inputs_blake3,
                version: held.version,
            }),
            Err(ResultsError::NoMarker { .. }) => match first_entry(folder, beside)?.filter(|_| !self.with_force) {
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
    /// Its lock, which the store of runs holds as well.
    pub fn lock(&self) -> &Arc<FolderLock> {
        &self.lock
    }

    /// Whether it holds the finished result, which is made anew only with force.
    pub fn is_finished(&self) -> bool {
        self.held.as_ref().is_some_and(|held| self.claim.is_made(held))
    }

    /// Begins the result: until it is finished, others find an unfinished one. A finished result of the same inputs is left as it is.
    ///
    /// # Errors
    /// The file system refuses.
    pub fn begin(self) -> Result<ResultsFolder, ResultsError> {
        let is_finished = self.is_finished();
        let Self { claim, lock, held } = self;
        let replaced = match held {
            Some(marker) if is_finished => {
                let mut folder = ResultsFolder { marker, lock };
                folder.remove_replaced()?;
                return Ok(folder);
            }
            Some(held) if held.is_finished => prepare_to_replace(&lock, &held)?,
            Some(held) => {
                remove_files(&lock, held.files.keys())?;
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
        marker.write(&lock)?;
        let folder = ResultsFolder { marker, lock };
        folder.set_replaced_aside()?;
        Ok(folder)
    }
}

/// That no file of somebody else has a name under which a file of a finished result is to wait. Those that an earlier result has left are
/// listed in the marker.
fn check_names_of_replaced(folder: &Folder, held: &Marker) -> Result<(), ResultsError> {
    for file_name in held.files.keys().filter(|file_name| !held.replaced.contains(file_name)) {
        let name = aside(file_name);
        let path = folder.path().join(&name);
        match folder.find(Path::new(&name)) {
            Ok(None) => {}
            Ok(Some(_)) => return Err(ResultsError::AsideTaken { path }),
            Err(error) if Refused::of(&error) == Some(Refused::BadName) => {}
            Err(source) => return Err(ResultsError::Read { path, source }),
        }
    }
    Ok(())
}

/// The files of a finished result that are to be set aside, its marker among them, of which a copy is made: the marker itself is
/// overwritten in one step, so that the folder is never without one.
fn prepare_to_replace(lock: &FolderLock, held: &Marker) -> Result<Vec<String>, ResultsError> {
    let mut replaced = Vec::new();
    for file_name in held.files.keys() {
        if is_file(lock.folder(), file_name)? {
            replaced.push(file_name.clone());
        }
    }
    // What an earlier result has left under these names is not what comes back.
    let waiting: Vec<String> = held.replaced.iter().map(|file_name| aside(file_name)).collect();
    remove_files(lock, &waiting)?;
    write(lock, &aside(MARKER_FILE), held.to_text()?.as_bytes())?;
    replaced.push(MARKER_FILE.to_owned());
    Ok(replaced)
}

/// The first entry of a folder by name; `None` if it is empty. Files named `beside` and those of locks are left aside, and what is not
/// whole: its writer was stopped before it had its name.
fn first_entry(folder: &Folder, beside: &[&str]) -> Result<Option<String>, ResultsError> {
    const MAX_ENTRIES: usize = 1 << 20;
    let entries = match folder.entries(MAX_ENTRIES) {
        // Whoever had made it has given it up meanwhile.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        entries => entries.map_err(|source| ResultsError::Read { path: folder.path().to_owned(), source })?,
    };
    let others = entries.into_iter().filter(|entry| TemporaryKind::of(&entry.name).is_none());
    let names = others.map(|entry| entry.name.to_string_lossy().into_owned());
    let is_other = |name: &String| {
        let name = name.as_str();
        name != LockKind::Result.file_name() && name != LockKind::Text.file_name() && !beside.contains(&name)
    };
    Ok(names.filter(is_other).min())
}
