//! The right to write into a folder, held by one process at a time.

use std::ffi::OsStr;
use std::fs::{File, TryLockError};
use std::io::{self, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::entry::{Entry, FileInfo, FileKind, Identity};
use crate::folder::{Folder, MadeFolders};
use crate::refused::Refused;
use crate::system::file_info;
use crate::temporary::TemporaryKind;

/// The right to write into a folder. Every change of a file below the folder is a method of it.
///
/// The operating system gives the lock back when its holder ends, however that happens. A lock file that is left behind therefore
/// says nothing.
#[derive(Debug)]
pub struct FolderLock {
    pub(crate) folder: Folder,
    kind: LockKind,
    /// `None` if the file system has no locks and nobody relies on one.
    held: Option<(File, Identity)>,
    /// Folders that were made for the lock.
    made: MadeFolders,
}

/// The purpose of a lock. The two locks of a folder do not exclude each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LockKind {
    /// A result, while it is being made.
    Result,
    /// Texts, for the moment in which they are written.
    Text,
}

impl LockKind {
    /// Name of the file that is locked.
    pub const fn file_name(self) -> &'static str {
        match self {
            Self::Result => "loosepin.lock",
            Self::Text => ".loosepin.lock",
        }
    }

    /// The kind of the temporary files that are made under the lock.
    pub(crate) fn temporary(self) -> TemporaryKind {
        match self {
            Self::Result => TemporaryKind::Result,
            Self::Text => TemporaryKind::Text,
        }
    }
}

/// Why a folder cannot be locked.
#[derive(Debug)]
pub enum LockError {
    /// Another process holds it, and says this of itself.
    InUse {
        /// What it says; `None` if it has not written it yet.
        holder: Option<String>,
    },
    /// The file system refuses, or has no locks.
    File {
        /// The file of the lock.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// First line of the file of a lock, by which it is known that loosepin wrote it; the holder stands behind it.
const MARK: &str = "loosepin lock\n";
/// Longest file of a lock, bytes.
const MAX_LOCK_BYTES: u64 = 4096;

/// Most entries that are looked at when left files are removed.
const MAX_ENTRIES: usize = 1 << 20;

impl FolderLock {
    /// Locks the folder at `path`. Folders that are not there are made. Links in the path are followed. `holder` is the line that other
    /// processes are shown.
    ///
    /// # Errors
    /// Another process holds it; the file system refuses, or has no locks.
    pub fn take(path: &Path, kind: LockKind, holder: &str) -> Result<Self, LockError> {
        Self::take_under(path, Path::new(""), kind, holder)
    }

    /// As [`FolderLock::take`], of the folder at `relative` below `root`: links in the path of the root are followed, none below it.
    ///
    /// # Errors
    /// As for [`FolderLock::take`]; a link below the root.
    pub fn take_under(root: &Path, relative: &Path, kind: LockKind, holder: &str) -> Result<Self, LockError> {
        let open = |made: &mut MadeFolders| Folder::open_or_make(root, made)?.open_or_make_below(relative, made);
        Self::take_opened(&root.join(relative), kind, holder, open)
    }

    /// As [`FolderLock::wait_at`], of the folder at `relative` below `base`: no link below it is followed.
    ///
    /// # Errors
    /// As for [`FolderLock::take`]; a link on the way.
    pub fn wait_below(
        base: &Folder,
        relative: &Path,
        kind: LockKind,
        holder: &str,
        patience: Duration,
    ) -> Result<Self, LockError> {
        let path = base.path().join(relative);
        Self::wait_opened(&path, kind, holder, patience, |made| base.open_or_make_below(relative, made))
    }

    /// Locks an existing folder. Another process is waited for as long as `patience`.
    ///
    /// # Errors
    /// As for [`FolderLock::take`].
    pub fn wait(folder: &Folder, kind: LockKind, holder: &str, patience: Duration) -> Result<Self, LockError> {
        Self::wait_opened(folder.path(), kind, holder, patience, |_| Ok(folder.clone()))
    }

    /// As [`FolderLock::take`]; another process is waited for as long as `patience`.
    ///
    /// # Errors
    /// As for [`FolderLock::take`].
    pub fn wait_at(path: &Path, kind: LockKind, holder: &str, patience: Duration) -> Result<Self, LockError> {
        Self::wait_opened(path, kind, holder, patience, |made| Folder::open_or_make(path, made))
    }

    fn wait_opened(
        path: &Path,
        kind: LockKind,
        holder: &str,
        patience: Duration,
        mut open: impl FnMut(&mut MadeFolders) -> io::Result<Folder>,
    ) -> Result<Self, LockError> {
        const LONGEST_REST: Duration = Duration::from_millis(20);
        let end = Instant::now() + patience;
        let mut rest = Duration::from_micros(200);
        loop {
            match Self::take_opened(path, kind, holder, &mut open) {
                Err(LockError::InUse { .. }) if Instant::now() < end => std::thread::sleep(rest),
                taken => return taken,
            }
            rest = (rest * 2).min(LONGEST_REST);
        }
    }

    fn take_opened(
        path: &Path,
        kind: LockKind,
        holder: &str,
        mut open: impl FnMut(&mut MadeFolders) -> io::Result<Folder>,
    ) -> Result<Self, LockError> {
        // The last holder may remove its file, and a folder that was made for it, at any moment.
        const MAX_TRIES: usize = 100;
        let mut last = None;
        for _ in 0..MAX_TRIES {
            let mut made = MadeFolders::default();
            match open(&mut made).and_then(|folder| Ok((LockFile::open(&folder, kind)?, folder))) {
                Ok((file, folder)) => match Self::of_file(file, folder, kind, made, holder)? {
                    Some(taken) => return Ok(taken),
                    None => last = None,
                },
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    made.remove_empty();
                    last = Some(error);
                }
                Err(source) => {
                    made.remove_empty();
                    return Err(LockError::File { path: path.join(kind.file_name()), source });
                }
            }
        }
        Err(match last {
            // Not removed by others again and again: it is not there.
            Some(source) => LockError::File { path: path.join(kind.file_name()), source },
            None => LockError::InUse { holder: None },
        })
    }

    /// The lock, if `file` can be locked and is still the one of the folder; `None` if its last holder has removed it.
    fn of_file(
        LockFile { file, is_new, is_read_only }: LockFile,
        folder: Folder,
        kind: LockKind,
        made: MadeFolders,
        holder: &str,
    ) -> Result<Option<Self>, LockError> {
        let path = folder.path().join(kind.file_name());
        let locked = loop {
            match file.try_lock() {
                Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Interrupted => {}
                locked => break locked,
            }
        };
        match locked {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(LockError::InUse { holder: holder_line(file) }),
            Err(TryLockError::Error(source)) => {
                // It cannot be locked by anybody: what was made for it goes.
                if is_new {
                    let _ = folder.directory.remove_file(OsStr::new(kind.file_name()));
                }
                made.remove_empty();
                return Err(LockError::File { path, source });
            }
        }
        let refused = |source| LockError::File { path: path.clone(), source };
        let info = file_info(&file).map_err(refused)?;
        match found_again(&folder, kind, info.identity) {
            Ok(()) => {}
            Err(error) if Refused::of(&error) == Some(Refused::LockLost) => return Ok(None),
            Err(source) => return Err(refused(source)),
        }
        // Before anything is written: what is not ours is neither changed nor removed.
        if !is_new {
            require_own(&file, &info).map_err(refused)?;
        }
        let mut lock = Self { folder, kind, held: Some((file, info.identity)), made };
        let named = if is_read_only { Ok(()) } else { lock.name_holder(holder) };
        let begun = named.and_then(|()| lock.remove_left());
        begun.map_err(|source| LockError::File { path, source })?;
        Ok(Some(lock))
    }

    /// The folder without a lock, for file systems that have none. What is written is whole all the same; two writers of one file are not
    /// kept apart.
    pub(crate) fn without(folder: &Folder, kind: LockKind) -> Self {
        Self { folder: folder.clone(), kind, held: None, made: MadeFolders::default() }
    }

    /// The kind of the temporary files that are made under this lock.
    pub(crate) fn temporary_kind(&self) -> TemporaryKind {
        self.kind.temporary()
    }

    fn file_name(&self) -> &'static OsStr {
        OsStr::new(self.kind.file_name())
    }

    /// The folder.
    pub fn folder(&self) -> &Folder {
        &self.folder
    }

    /// That the lock is still the one of the folder.
    ///
    /// # Errors
    /// [`Refused::LockLost`]: its file was removed, or another process has made a new one. An error of the file system.
    pub fn check(&self) -> io::Result<()> {
        let Some((_, identity)) = &self.held else { return Ok(()) };
        found_again(&self.folder, self.kind, *identity)
    }

    /// Says in the file who holds it.
    fn name_holder(&mut self, holder: &str) -> io::Result<()> {
        let Some((file, _)) = &mut self.held else { return Ok(()) };
        file.set_len(0)?;
        // In one piece: others read it at any moment.
        file.write_all(format!("{MARK}{holder}\n").as_bytes())
    }

    /// Removes what earlier holders have not brought to its name: they were stopped, or have lost the lock.
    fn remove_left(&self) -> io::Result<()> {
        let own = self.temporary_kind();
        let is_left = |entry: &Entry| match TemporaryKind::of(&entry.name) {
            // It had a name for a moment only, and the process was stopped just then.
            Some(TemporaryKind::Unnamed) => own == TemporaryKind::Result,
            kind => kind == Some(own),
        };
        for entry in self.folder.entries(MAX_ENTRIES)?.into_iter().filter(is_left) {
            let removed = match entry.kind {
                FileKind::Folder => self.remove_temporary_folder(&entry.name),
                _ => self.folder.directory.remove_file(&entry.name),
            };
            match removed.map_err(|error| (error.kind(), error)) {
                // Gone meanwhile; or of another user in a folder of all, or with something in it that was not left by us: it does no harm.
                Ok(())
                | Err((
                    io::ErrorKind::NotFound
                    | io::ErrorKind::PermissionDenied
                    | io::ErrorKind::IsADirectory
                    | io::ErrorKind::NotADirectory
                    | io::ErrorKind::DirectoryNotEmpty,
                    _,
                )) => {}
                Err((_, error)) => return Err(error),
            }
        }
        Ok(())
    }

    /// Removes a folder with the files in it.
    pub(crate) fn remove_temporary_folder(&self, name: &OsStr) -> io::Result<()> {
        let folder = self.folder.open_below(Path::new(name))?;
        for entry in folder.entries(MAX_ENTRIES)? {
            folder.directory.remove_file(&entry.name)?;
        }
        self.folder.directory.remove_directory(name)
    }
}

/// Gives the folder back; one that was made for the lock goes, where nothing came into it.
impl Drop for FolderLock {
    fn drop(&mut self) {
        // Removed while it is still locked: a process that opens the name from now on makes a new file. The lock file of a process that has
        // taken the folder meanwhile stays. Windows does not remove a file that is open: there it stays.
        let Some((file, _)) = &self.held else { return };
        if cfg!(unix) && self.check().is_ok() {
            let _ = self.folder.directory.remove_file(self.file_name());
        }
        // Explicitly, since a child process may hold a copy of the file.
        let _ = file.unlock();
        self.made.remove_empty();
    }
}

/// The file of a lock, open.
struct LockFile {
    file: File,
    /// Whether it was not there before.
    is_new: bool,
    /// Whether it is of somebody else, who lets it be read alone. It can be locked all the same.
    is_read_only: bool,
}

impl LockFile {
    const MODE: u32 = 0o666;

    /// Opens it, or makes it.
    fn open(folder: &Folder, kind: LockKind) -> io::Result<Self> {
        let name = OsStr::new(kind.file_name());
        let of_kind = |error| folder.open_error(name, error);
        let old = |file: File, is_read_only| {
            file_info(&file)?.require_file()?;
            Ok(Self { file, is_new: false, is_read_only })
        };
        match folder.directory.open_to_write(name) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
                return old(folder.directory.open_to_read(name).map_err(|_| error)?, true);
            }
            opened => return old(opened.map_err(of_kind)?, false),
        }
        match folder.directory.create_new(name, Self::MODE) {
            // Made by somebody else meanwhile.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                old(folder.directory.open_to_write(name).map_err(of_kind)?, false)
            }
            created => Ok(Self { file: created?, is_new: true, is_read_only: false }),
        }
    }
}

/// That the file of a lock is still the one of the folder.
fn found_again(folder: &Folder, kind: LockKind, identity: Identity) -> io::Result<()> {
    match folder.find_name(OsStr::new(kind.file_name()))? {
        Some(found) if found.identity == identity => Ok(()),
        _ => Err(Refused::LockLost.into()),
    }
}

/// That a file which was there before is one that a lock has left: it has this name alone, and begins with our mark. Of a process that was
/// stopped while it wrote, a part of the mark is left.
fn require_own(mut file: &File, info: &FileInfo) -> io::Result<()> {
    if info.names > 1 {
        return Err(Refused::HardLink.into());
    }
    let mut bytes = Vec::new();
    file.take(MAX_LOCK_BYTES).read_to_end(&mut bytes)?;
    file.rewind()?;
    let is_own = bytes.starts_with(MARK.as_bytes()) || MARK.as_bytes().starts_with(&bytes);
    if is_own && info.size_bytes <= MAX_LOCK_BYTES { Ok(()) } else { Err(Refused::ForeignLock.into()) }
}

/// Who holds the lock, where the file says so already and can be read.
fn holder_line(file: File) -> Option<String> {
    const MAX_CHARS: usize = 200;
    let mut text = String::new();
    file.take(MAX_LOCK_BYTES).read_to_string(&mut text).ok()?;
    let text = text.strip_prefix(MARK)?;
    let (line, _) = text.split_once('\n')?;
    let line: String = line.chars().filter(|character| !character.is_control()).collect();
    Some(line.chars().take(MAX_CHARS).collect()).filter(|line: &String| !line.is_empty())
}

#[cfg(test)]
mod tests;
