//! Calls on a directory handle. A call that a signal has interrupted is made again.

use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStringExt;
use std::path::Path;
use std::time::{Duration, SystemTime};

use rustix::fs::{self, AtFlags, Dir, FileType, Gid, Mode, OFlags, RawMode, Stat, Uid};
use rustix::io::retry_on_intr;

use crate::entry::{Entry, FileInfo, FileKind, Identity};

/// An open directory.
#[derive(Debug)]
pub struct Directory(OwnedFd);

const DIRECTORY: OFlags = OFlags::RDONLY.union(OFlags::DIRECTORY).union(OFlags::CLOEXEC);
/// A pipe without a writer does not make the caller wait, and a terminal does not become the one of the process.
const NO_WAIT: OFlags = OFlags::NOFOLLOW.union(OFlags::NONBLOCK).union(OFlags::NOCTTY).union(OFlags::CLOEXEC);
const NEW_FOLDER: Mode = Mode::from_raw_mode(0o777);

impl Directory {
    /// The directory at `path`; links in it are followed.
    pub fn at(path: &Path) -> io::Result<Self> {
        Ok(Self(retry_on_intr(|| fs::open(path, DIRECTORY, Mode::empty()))?))
    }

    /// A directory in this one.
    pub fn open_directory(&self, name: &OsStr) -> io::Result<Self> {
        Ok(Self(retry_on_intr(|| fs::openat(&self.0, name, DIRECTORY | OFlags::NOFOLLOW, Mode::empty()))?))
    }

    pub fn make_directory(&self, name: &OsStr) -> io::Result<()> {
        Ok(retry_on_intr(|| fs::mkdirat(&self.0, name, NEW_FOLDER))?)
    }

    /// A file to be read, or any other entry that can be opened.
    pub fn open_to_read(&self, name: &OsStr) -> io::Result<File> {
        Ok(retry_on_intr(|| fs::openat(&self.0, name, OFlags::RDONLY | NO_WAIT, Mode::empty()))?.into())
    }

    /// Opens an existing file for writing; its content is not changed.
    pub fn open_to_write(&self, name: &OsStr) -> io::Result<File> {
        Ok(retry_on_intr(|| fs::openat(&self.0, name, OFlags::RDWR | NO_WAIT, Mode::empty()))?.into())
    }

    /// Creates a new file.
    pub fn create_new(&self, name: &OsStr, mode: u32) -> io::Result<File> {
        let flags = OFlags::RDWR | OFlags::CREATE | OFlags::EXCL | NO_WAIT;
        Ok(retry_on_intr(|| fs::openat(&self.0, name, flags, Mode::from_raw_mode(mode as RawMode)))?.into())
    }

    pub fn info(&self, name: &OsStr) -> io::Result<FileInfo> {
        Ok(info(&retry_on_intr(|| fs::statat(&self.0, name, AtFlags::SYMLINK_NOFOLLOW))?))
    }

    /// Information about the directory itself.
    pub fn metadata(&self) -> io::Result<FileInfo> {
        Ok(info(&retry_on_intr(|| fs::fstat(&self.0))?))
    }

    pub fn rename(&self, from: &OsStr, to: &OsStr) -> io::Result<()> {
        Ok(retry_on_intr(|| fs::renameat(&self.0, from, &self.0, to))?)
    }

    /// Renames, and replaces nothing.
    pub fn rename_new(&self, from: &OsStr, to: &OsStr) -> io::Result<()> {
        self.move_new(from, self, to)
    }

    /// Renames into another directory of the same file system, and replaces nothing.
    pub fn move_new(&self, from: &OsStr, target: &Self, to: &OsStr) -> io::Result<()> {
        #[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
        {
            use rustix::io::Errno;
            match retry_on_intr(|| fs::renameat_with(&self.0, from, &target.0, to, fs::RenameFlags::NOREPLACE)) {
                // A file system that does not know it.
                Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => {}
                renamed => return Ok(renamed?),
            }
        }
        if self.info(from)?.kind == FileKind::Folder {
            // A folder is renamed onto an empty folder at most.
            return Ok(retry_on_intr(|| fs::renameat(&self.0, from, &target.0, to))?);
        }
        retry_on_intr(|| fs::linkat(&self.0, from, &target.0, to, AtFlags::empty()))?;
        self.remove_file(from).inspect_err(|_| {
            let _ = target.remove_file(to);
        })
    }

    pub fn remove_file(&self, name: &OsStr) -> io::Result<()> {
        Ok(retry_on_intr(|| fs::unlinkat(&self.0, name, AtFlags::empty()))?)
    }

    pub fn remove_directory(&self, name: &OsStr) -> io::Result<()> {
        Ok(retry_on_intr(|| fs::unlinkat(&self.0, name, AtFlags::REMOVEDIR))?)
    }

    /// Flushes the entries to the device.
    pub fn sync(&self) -> io::Result<()> {
        match retry_on_intr(|| fs::fsync(&self.0)) {
            // Some file systems of virtual machines flush files only.
            Err(rustix::io::Errno::INVAL | rustix::io::Errno::NOTSUP) => Ok(()),
            flushed => Ok(flushed?),
        }
    }

    /// The entries, in no order; at most `most` of them.
    pub fn entries(&self, most: usize) -> io::Result<Vec<Entry>> {
        let mut entries = Vec::new();
        let mut directory = retry_on_intr(|| Dir::read_from(self.0.as_fd()))?;
        while entries.len() < most
            && let Some(entry) = directory.read()
        {
            let entry = match entry {
                Err(rustix::io::Errno::INTR) => continue,
                entry => entry?,
            };
            let bytes = entry.file_name().to_bytes();
            if bytes == b"." || bytes == b".." {
                continue;
            }
            let name = OsString::from_vec(bytes.to_vec());
            let kind = match entry.file_type() {
                // Some file systems tell it on a closer look only.
                FileType::Unknown => match self.info(&name) {
                    Ok(found) => found.kind,
                    Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                    Err(error) => return Err(error),
                },
                known => kind(known),
            };
            entries.push(Entry { name, kind });
        }
        Ok(entries)
    }
}

/// The file at `path`, to be read; links in it are followed.
pub fn open_named(path: &Path) -> io::Result<File> {
    let flags = OFlags::RDONLY | NO_WAIT.difference(OFlags::NOFOLLOW);
    Ok(retry_on_intr(|| fs::open(path, flags, Mode::empty()))?.into())
}

/// Whether the process has a limit of the size of its files.
pub fn is_file_size_limited() -> bool {
    rustix::process::getrlimit(rustix::process::Resource::Fsize).current.is_some()
}

/// Information about an open file.
pub fn file_info(file: &File) -> io::Result<FileInfo> {
    Ok(info(&retry_on_intr(|| fs::fstat(file))?))
}

/// Gives a new file the owner and the mode of the one that it replaces. Another owner than one's own is kept where that is permitted.
pub fn keep_owner_and_mode(file: &File, replaced: &FileInfo) -> io::Result<()> {
    if let Some((user, group)) =
        replaced.owner.filter(|owner| file_info(file).is_ok_and(|own| own.owner != Some(*owner)))
    {
        let [user, group] = [Some(Uid::from_raw(user)), None].map(|user| (user, Some(Gid::from_raw(group))));
        let changed = retry_on_intr(|| fs::fchown(file, user.0, user.1));
        if changed.is_err() {
            // The group alone may be one of one's own.
            let _ = retry_on_intr(|| fs::fchown(file, group.0, group.1));
        }
    }
    // After the owner, whose change takes bits away.
    if file_info(file)?.mode == replaced.mode {
        return Ok(());
    }
    Ok(retry_on_intr(|| fs::fchmod(file, Mode::from_raw_mode(replaced.mode as RawMode)))?)
}

fn kind(file_type: FileType) -> FileKind {
    match file_type {
        FileType::RegularFile => FileKind::File,
        FileType::Directory => FileKind::Folder,
        FileType::Symlink => FileKind::Link,
        _ => FileKind::Other,
    }
}

#[allow(clippy::unnecessary_cast, clippy::useless_conversion, reason = "the types of a status differ between systems")]
fn info(status: &Stat) -> FileInfo {
    const PERMISSIONS: u32 = 0o7777;
    let seconds = status.st_mtime as i64;
    let since = Duration::new(seconds.unsigned_abs(), u32::try_from(status.st_mtime_nsec).unwrap_or(0));
    let modified = if seconds < 0 { None } else { SystemTime::UNIX_EPOCH.checked_add(since) };
    FileInfo {
        kind: kind(FileType::from_raw_mode(status.st_mode)),
        size_bytes: u64::try_from(status.st_size).unwrap_or(0),
        modified,
        identity: Identity { device: status.st_dev as u64, number: status.st_ino as u64 },
        mode: u32::from(status.st_mode) & PERMISSIONS,
        owner: Some((status.st_uid, status.st_gid)),
        names: status.st_nlink as u64,
    }
}
