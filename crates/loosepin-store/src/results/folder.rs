//! Claiming a folder for a result, and writing into it.

use std::fs;
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

use super::error::ResultsError;
use super::inputs::InputsHash;
use super::kind::{MARKER_FILE, ResultKind};
use super::marker::Marker;
use loosepin_text::diagnostics::Complaints;

/// Longest part of a folder name that is made from a name in a file, characters.
const LONGEST_NAME_CHARS: usize = 60;

/// Suffix of the name of a file until it is whole.
const PARTIAL: &str = ".partial";

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

/// A folder of results.
#[derive(Debug)]
pub struct ResultsFolder {
    path: PathBuf,
    marker: Marker,
    /// Folders that were made for it, the innermost first.
    made: Vec<PathBuf>,
}

impl Claim {
    /// The folder that results go to.
    pub fn path(&self) -> PathBuf {
        match &self.place {
            Place::Below(root) => root.join(folder_name(&self.name)).join(self.inputs.short()),
            Place::Folder(path) => path.clone(),
        }
    }

    /// Whether the folder holds the finished result, which is to be made anew only with force. Nothing is changed.
    ///
    /// # Errors
    /// The folder holds something else, or cannot be read.
    pub fn is_finished(&self) -> Result<bool, ResultsError> {
        Ok(self.find(&[])?.is_finished)
    }

    /// Whether these are results of the same inputs.
    fn is_same(&self, held: &Marker) -> bool {
        held.kind == self.kind && held.inputs_blake3 == self.inputs.to_string()
    }

    /// Content of the folder `path` that may be replaced, `lock_files` aside.
    fn held(&self, path: &Path, lock_files: &[&str]) -> Result<Option<Marker>, ResultsError> {
        match read_marker(path) {
            Ok(held) if self.is_same(&held) || self.with_force => Ok(Some(held)),
            Ok(held) => Err(ResultsError::HoldsOtherResults {
                folder: path.to_owned(),
                held: held.kind,
                wanted: self.kind,
                name: held.name,
                inputs_blake3: held.inputs_blake3,
                version: held.version,
            }),
            Err(ResultsError::NoMarker { .. }) => match first_entry(path, lock_files)?.filter(|_| !self.with_force) {
                Some(example) => Err(ResultsError::HoldsOtherFiles { folder: path.to_owned(), example }),
                None => Ok(None),
            },
            Err(ResultsError::ForeignMarker { .. }) if self.with_force => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Takes the folder, making it where there is none. A finished result of the same inputs is left as it is (see
    /// [`ResultsFolder::is_finished`]), an unfinished one is taken over, with the finished one that it was to replace. With force
    /// the result is always made anew.
    ///
    /// # Errors
    /// The folder holds something else, or the file system refuses.
    pub fn take(&self) -> Result<ResultsFolder, ResultsError> {
        let found = self.find(&[])?;
        let made = found.make_folder()?;
        found.take(self, made)
    }

    /// The folder under a lock, for a result that takes long to make. `lock` is called with the folder before anything in it is
    /// changed: where it refuses, since another process is at work there, the folder is left as it was. A finished result is
    /// found without one. `lock_files` are the files that the lock itself may make; alone in a folder they say nothing.
    ///
    /// # Errors
    /// As for [`Claim::take`], and those of `lock`.
    pub fn take_locked<L>(
        &self,
        lock_files: &[&str],
        lock: impl Fn(&Path) -> Result<L, Complaints>,
    ) -> Result<(ResultsFolder, Option<L>), Complaints> {
        let complain = |error: ResultsError| Complaints::one(&error, None);
        loop {
            let found = self.find(lock_files).map_err(complain)?;
            if found.is_finished {
                return Ok((found.take(self, Vec::new()).map_err(complain)?, None));
            }
            let made = found.make_folder().map_err(complain)?;
            let held = lock(&found.path).inspect_err(|_| remove_folders(&made))?;
            // Whoever had the lock until now may have finished what was to be made here.
            if self.find(lock_files).map_err(complain)?.held == found.held {
                return Ok((found.take(self, made).map_err(complain)?, Some(held)));
            }
        }
    }

    /// Content of the folder now. Nothing is changed.
    fn find(&self, lock_files: &[&str]) -> Result<Found, ResultsError> {
        let path = self.path();
        if !path.exists() {
            return Ok(Found { path, held: None, is_finished: false });
        }
        if !path.is_dir() {
            return Err(ResultsError::NotAFolder { path });
        }
        let held = self.held(&path, lock_files)?;
        let is_finished = held.as_ref().is_some_and(|held| held.is_finished && self.is_same(held) && !self.with_force);
        Ok(Found { path, held, is_finished })
    }
}

/// Content of a folder that a result may replace.
struct Found {
    path: PathBuf,
    held: Option<Marker>,
    /// Whether that is the finished result itself.
    is_finished: bool,
}

impl Found {
    /// Makes the folder where there is none; gives the folders that were made, the innermost first.
    fn make_folder(&self) -> Result<Vec<PathBuf>, ResultsError> {
        let made = self.path.ancestors().take_while(|folder| !folder.exists()).map(Path::to_owned).collect();
        fs::create_dir_all(&self.path).map_err(|source| ResultsError::Write { path: self.path.clone(), source })?;
        Ok(made)
    }

    /// Takes the folder for `claim`.
    fn take(self, claim: &Claim, made: Vec<PathBuf>) -> Result<ResultsFolder, ResultsError> {
        let Self { path, held, is_finished } = self;
        let replaced = match held {
            Some(marker) if is_finished => {
                let mut folder = ResultsFolder { path, marker, made };
                folder.remove_replaced()?;
                return Ok(folder);
            }
            Some(held) if held.is_finished => prepare_to_replace(&path, &held)?,
            Some(held) => {
                remove_files(&path, &held.files)?;
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
            files: Vec::new(),
            replaced,
        };
        let folder = ResultsFolder { path, marker, made };
        // Said before anything is renamed, so that whoever comes next knows what waits under which name.
        folder.write_marker()?;
        folder.set_replaced_aside()?;
        Ok(folder)
    }
}

impl ResultsFolder {
    /// Opens the folder of a finished result.
    ///
    /// # Errors
    /// There is none, or it did not finish.
    pub fn open(path: &Path) -> Result<ResultsFolder, ResultsError> {
        if !path.exists() {
            return Err(ResultsError::NoSuchFolder { folder: path.to_owned() });
        }
        if !path.is_dir() {
            return Err(ResultsError::NotAFolder { path: path.to_owned() });
        }
        let marker = read_marker(path)?;
        if marker.is_finished {
            Ok(ResultsFolder { path: path.to_owned(), marker, made: Vec::new() })
        } else {
            Err(ResultsError::Unfinished { folder: path.to_owned(), kind: marker.kind, name: marker.name })
        }
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The kind of its result.
    pub fn kind(&self) -> ResultKind {
        self.marker.kind
    }

    /// Whether it holds the finished result already.
    pub fn is_finished(&self) -> bool {
        self.marker.is_finished
    }

    /// Writes a file of the result, whole or not at all.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn write(&mut self, file_name: &str, contents: &[u8]) -> Result<(), ResultsError> {
        write_whole(&self.path.join(file_name), contents)?;
        self.add_file(file_name);
        Ok(())
    }

    /// Notes a file of the result that was written by other means.
    pub fn add_file(&mut self, file_name: &str) {
        if !self.marker.files.iter().any(|known| known == file_name) {
            self.marker.files.push(file_name.to_owned());
        }
    }

    /// The text of a file of the result.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn read(&self, file_name: &str) -> Result<String, ResultsError> {
        let path = self.path.join(file_name);
        fs::read_to_string(&path).map_err(|source| ResultsError::Read { path, source })
    }

    /// The error for a file whose contents cannot be understood.
    pub fn foreign_file(&self, file_name: &str, reason: impl std::fmt::Display) -> ResultsError {
        ResultsError::ForeignFile { path: self.path.join(file_name), reason: reason.to_string() }
    }

    /// Says that all files are there.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn finish(&mut self) -> Result<(), ResultsError> {
        self.marker.is_finished = true;
        self.write_marker()?;
        // What was replaced goes only now that its successor is whole.
        self.remove_replaced()
    }

    /// Keeps what was written so far of a result that did not finish: the next run replaces it.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn leave_unfinished(&mut self) -> Result<(), ResultsError> {
        self.marker.is_finished = false;
        self.write_marker()
    }

    /// Removes what was written of a result that cannot be finished, and the folders that were made for it; a finished result
    /// that it was to replace comes back.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn abandon(self) -> Result<(), ResultsError> {
        remove_files(&self.path, &self.marker.files)?;
        if !self.marker.replaced.is_empty() {
            // The marker of the finished result comes last: until then it is known what is still to come back.
            let files = self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE);
            for file_name in files.map(String::as_str).chain([MARKER_FILE]) {
                let Some([path, aside]) = self.names(file_name).filter(|[_, aside]| aside.is_file()) else { continue };
                fs::rename(aside, &path).map_err(|source| ResultsError::Write { path, source })?;
            }
            return Ok(());
        }
        let path = self.path.join(MARKER_FILE);
        fs::remove_file(&path).map_err(|source| ResultsError::Write { path, source })?;
        remove_folders(&self.made);
        Ok(())
    }

    /// Where a file stands, and where it waits until its successor is whole.
    fn names(&self, file_name: &str) -> Option<[PathBuf; 2]> {
        inside(&self.path, file_name).zip(inside(&self.path, &aside(file_name))).map(|(path, aside)| [path, aside])
    }

    /// Renames what is to be replaced, whatever of that was done before; what has come in its place meanwhile goes.
    fn set_replaced_aside(&self) -> Result<(), ResultsError> {
        for file_name in self.marker.replaced.iter().filter(|file_name| *file_name != MARKER_FILE) {
            let Some([path, aside]) = self.names(file_name).filter(|[path, _]| path.is_file()) else { continue };
            let moved = if aside.is_file() { fs::remove_file(&path) } else { fs::rename(&path, aside) };
            moved.map_err(|source| ResultsError::Write { path, source })?;
        }
        Ok(())
    }

    /// Removes what was replaced, now that its successor is whole.
    fn remove_replaced(&mut self) -> Result<(), ResultsError> {
        if self.marker.replaced.is_empty() {
            return Ok(());
        }
        let waiting: Vec<String> = self.marker.replaced.iter().map(|file_name| aside(file_name)).collect();
        remove_files(&self.path, &waiting)?;
        self.marker.replaced.clear();
        self.write_marker()
    }

    fn write_marker(&self) -> Result<(), ResultsError> {
        write_whole(&self.path.join(MARKER_FILE), self.marker.to_text()?.as_bytes())
    }
}

/// Writes a file so that it is there whole or not at all, whenever the machine stops: under another name first, flushed to the
/// device, then renamed.
///
/// # Errors
/// An error of the file system.
pub fn write_whole(path: &Path, contents: &[u8]) -> Result<(), ResultsError> {
    let mut partial_name = path.as_os_str().to_owned();
    partial_name.push(PARTIAL);
    let partial = PathBuf::from(partial_name);
    let written = || {
        let mut file = fs::File::create(&partial)?;
        file.write_all(contents)?;
        file.sync_all()?;
        fs::rename(&partial, path)?;
        flush_folder(path)
    };
    written().map_err(|source| ResultsError::Write { path: path.to_owned(), source })
}

/// Flushes the entries of the folder of `path`, where the platform lets a folder be opened.
fn flush_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::File::open(folder)?.sync_all()?;
    }
    Ok(())
}

fn read_marker(folder: &Path) -> Result<Marker, ResultsError> {
    let path = folder.join(MARKER_FILE);
    match fs::read_to_string(&path) {
        Ok(text) => serde_json::from_str(&text).map_err(|source| ResultsError::ForeignMarker { path, source }),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            Err(ResultsError::NoMarker { folder: folder.to_owned() })
        }
        Err(source) => Err(ResultsError::Read { path, source }),
    }
}

/// The name under which a file of a finished result waits until its successor is whole.
fn aside(file_name: &str) -> String {
    format!("{file_name}.replaced")
}

/// A file of the folder; nothing where the name leads out of it.
fn inside(folder: &Path, file_name: &str) -> Option<PathBuf> {
    let is_inside = Path::new(file_name).components().all(|part| matches!(part, Component::Normal(_)));
    is_inside.then(|| folder.join(file_name))
}

/// The files of a finished result that are to be set aside, its marker among them, of which a copy is made: the marker itself is
/// overwritten in one step, so that the folder is never without one.
fn prepare_to_replace(folder: &Path, held: &Marker) -> Result<Vec<String>, ResultsError> {
    let is_there = |file_name: &&String| inside(folder, file_name).is_some_and(|path| path.is_file());
    let mut replaced: Vec<String> = held.files.iter().filter(is_there).cloned().collect();
    // What an earlier result has left under these names is not what comes back.
    let waiting: Vec<String> = replaced.iter().chain(&held.replaced).map(|file_name| aside(file_name)).collect();
    remove_files(folder, &waiting)?;
    write_whole(&folder.join(aside(MARKER_FILE)), held.to_text()?.as_bytes())?;
    replaced.push(MARKER_FILE.to_owned());
    Ok(replaced)
}

/// Removes folders that were made, the innermost first. One with something else in it meanwhile is not empty and stays, as it should.
fn remove_folders(made: &[PathBuf]) {
    for folder in made {
        if fs::remove_dir(folder).is_err() {
            break;
        }
    }
}

/// Removes files, and nothing outside the folder.
fn remove_files(folder: &Path, file_names: &[String]) -> Result<(), ResultsError> {
    for path in file_names.iter().filter_map(|file_name| inside(folder, file_name)).filter(|path| path.is_file()) {
        fs::remove_file(&path).map_err(|source| ResultsError::Write { path, source })?;
    }
    Ok(())
}

/// The first entry of a folder by name; none where it is empty. `lock_files` are left aside, and a marker that is not whole: its
/// writer was stopped before anything else was there.
fn first_entry(folder: &Path, lock_files: &[&str]) -> Result<Option<String>, ResultsError> {
    let not_readable = |source| ResultsError::Read { path: folder.to_owned(), source };
    let mut first: Option<String> = None;
    for entry in fs::read_dir(folder).map_err(not_readable)? {
        let name = entry.map_err(not_readable)?.file_name().to_string_lossy().into_owned();
        let is_begun_marker = name.strip_suffix(PARTIAL) == Some(MARKER_FILE);
        if !is_begun_marker && !lock_files.contains(&&name[..]) && first.as_ref().is_none_or(|known| name < *known) {
            first = Some(name);
        }
    }
    Ok(first)
}

/// A name as part of a path: small letters and digits, everything else a single hyphen.
fn folder_name(name: &str) -> String {
    let mut folder = String::new();
    for character in name.chars().flat_map(char::to_lowercase) {
        if character.is_alphanumeric() {
            folder.push(character);
        } else if !folder.is_empty() && !folder.ends_with('-') {
            folder.push('-');
        }
    }
    let folder: String = folder.chars().take(LONGEST_NAME_CHARS).collect();
    match folder.trim_end_matches('-') {
        "" => "unnamed".to_owned(),
        name => name.to_owned(),
    }
}

#[cfg(test)]
mod tests;
