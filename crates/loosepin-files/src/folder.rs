//! Open folders, and reading in them.

use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::entry::{Entry, FileInfo, FileKind};
use crate::refused::Refused;
use crate::system::{Directory, file_info};

/// An open folder. Clones share the handle.
#[derive(Debug, Clone)]
pub struct Folder {
    path: PathBuf,
    pub(crate) directory: Arc<Directory>,
}

/// Folders that were made, the outermost first: each with the one that it was made in.
#[derive(Debug, Default)]
pub(crate) struct MadeFolders(Vec<(Folder, OsString)>);

impl Folder {
    /// The folder at `path`, the current one where that is empty. Links in the path are followed: the user of the program chose it.
    ///
    /// # Errors
    /// It is not there, is no folder, or may not be opened.
    pub fn open(path: &Path) -> io::Result<Self> {
        let named = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        Ok(Self { path: path.to_owned(), directory: Arc::new(Directory::at(named)?) })
    }

    /// Its path, as it was opened. It may lead somewhere else by now.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Information about the folder itself.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn metadata(&self) -> io::Result<FileInfo> {
        self.directory.metadata()
    }

    /// The folder at `relative`, names below this one. No link is followed.
    ///
    /// # Errors
    /// It is not there, is no folder, or a link; the path leads elsewhere.
    pub fn open_below(&self, relative: &Path) -> io::Result<Self> {
        let mut folder = self.clone();
        for name in names(relative)? {
            folder = folder.child(name)?;
        }
        Ok(folder)
    }

    /// As [`Self::open_below`]; folders that are not there are made and noted in `made`.
    pub(crate) fn open_or_make_below(&self, relative: &Path, made: &mut MadeFolders) -> io::Result<Self> {
        let mut folder = self.clone();
        for name in names(relative)? {
            folder = match folder.child(name) {
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    match folder.directory.make_directory(name) {
                        Ok(()) => {
                            made.0.push((folder.clone(), name.to_owned()));
                            folder.directory.sync()?;
                        }
                        // Somebody else has made it meanwhile.
                        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                        Err(error) => return Err(error),
                    }
                    folder.child(name)?
                }
                child => child?,
            };
        }
        Ok(folder)
    }

    /// The folder at `path`, made where it is not there.
    pub(crate) fn open_or_make(path: &Path, made: &mut MadeFolders) -> io::Result<Self> {
        // The innermost folder that is there; what follows is made below it. `..` may follow a folder that is not there yet: such a path
        // is not guessed at.
        for base in path.ancestors() {
            match Self::open(base) {
                Err(error) if error.kind() == io::ErrorKind::NotFound && !base.as_os_str().is_empty() => {}
                opened => {
                    let rest = path.strip_prefix(base).unwrap_or(Path::new(""));
                    return opened?.open_or_make_below(rest, made);
                }
            }
        }
        Err(io::ErrorKind::NotFound.into())
    }

    /// The folder `name` in this one.
    fn child(&self, name: &OsStr) -> io::Result<Self> {
        let opened = self.directory.open_directory(name).map_err(|error| match self.directory.info(name) {
            Ok(found) if found.kind == FileKind::Link => Refused::Link.into(),
            _ => error,
        })?;
        Ok(Self { path: self.path.join(name), directory: Arc::new(opened) })
    }

    /// The folder of a path below this one, and the last name.
    fn parent_of<'p>(&self, relative: &'p Path) -> io::Result<(Self, &'p OsStr)> {
        let name = names(relative)?.next_back().ok_or(Refused::BadName)?;
        Ok((self.open_below(relative.parent().unwrap_or(Path::new("")))?, name))
    }

    /// Removes the folder at `relative` if it is empty, then the folders that it stood in, up to this one. One with anything in it stays.
    ///
    /// # Errors
    /// The path leads elsewhere, or through a link.
    pub fn remove_empty_below(&self, relative: &Path) -> io::Result<()> {
        for path in relative.ancestors().take_while(|path| !path.as_os_str().is_empty()) {
            let (parent, name) = self.parent_of(path)?;
            if parent.directory.remove_directory(name).is_err() {
                break;
            }
        }
        Ok(())
    }

    /// Information about the entry at `relative`, a link itself included; `None` if there is none.
    ///
    /// # Errors
    /// The path leads elsewhere, or through a link; an error of the file system.
    pub fn find(&self, relative: &Path) -> io::Result<Option<FileInfo>> {
        found_or_none(self.parent_of(relative).and_then(|(folder, name)| folder.directory.info(name)))
    }

    /// As [`Self::find`], of a name that is one.
    pub(crate) fn find_name(&self, name: &OsStr) -> io::Result<Option<FileInfo>> {
        found_or_none(self.directory.info(name))
    }

    /// Opens a plain file to be read; its information is that of the open file.
    ///
    /// # Errors
    /// There is none, it is a link or no plain file; the path leads elsewhere.
    pub fn open_file(&self, relative: &Path) -> io::Result<(File, FileInfo)> {
        let (folder, name) = self.parent_of(relative)?;
        let file = folder.directory.open_to_read(name).map_err(|error| folder.open_error(name, error))?;
        let info = file_info(&file)?;
        info.require_file()?;
        Ok((file, info))
    }

    /// The content of a plain file of at most `limit_bytes`.
    ///
    /// # Errors
    /// As for [`Self::open_file`]; a file that is larger.
    pub fn read(&self, relative: &Path, limit_bytes: u64) -> io::Result<Vec<u8>> {
        let (file, info) = self.open_file(relative)?;
        read_limited(file, &info, limit_bytes)
    }

    /// At most `most` entries, in no order. A link is an entry of the kind [`FileKind::Link`].
    ///
    /// # Errors
    /// An error of the file system.
    pub fn entries(&self, most: usize) -> io::Result<Vec<Entry>> {
        self.directory.entries(most)
    }

    /// The reason why `name` could not be opened: that it is a link, or no file, where the system has only a number for it.
    pub(crate) fn open_error(&self, name: &OsStr, error: io::Error) -> io::Error {
        match self.directory.info(name).map(|found| found.kind) {
            Ok(FileKind::Link) => Refused::Link.into(),
            Ok(FileKind::Other) if error.kind() != io::ErrorKind::PermissionDenied => Refused::NotAFile.into(),
            _ => error,
        }
    }
}

impl MadeFolders {
    /// Removes those that are empty, the innermost first. One with something in it meanwhile stays, as it should.
    pub fn remove_empty(&self) {
        for (folder, name) in self.0.iter().rev() {
            if folder.directory.remove_directory(name).is_err() {
                break;
            }
        }
    }
}

/// `None` for what is not there.
fn found_or_none(found: io::Result<FileInfo>) -> io::Result<Option<FileInfo>> {
    match found {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        found => found.map(Some),
    }
}

/// The names of a path below a folder.
fn names(relative: &Path) -> io::Result<impl DoubleEndedIterator<Item = &OsStr>> {
    let is_name = |component: Component<'_>| matches!(component, Component::Normal(_));
    if !relative.components().all(is_name) {
        return Err(Refused::BadName.into());
    }
    Ok(relative.iter())
}

/// The content of an open file of at most `limit_bytes`.
pub(crate) fn read_limited(file: File, info: &FileInfo, limit_bytes: u64) -> io::Result<Vec<u8>> {
    let too_large = |size_bytes| io::Error::from(Refused::TooLarge { limit_bytes, size_bytes });
    if info.size_bytes > limit_bytes {
        return Err(too_large(info.size_bytes));
    }
    // What the system makes up as it is read, as below /proc, says that it has no bytes.
    let mut bytes = Vec::with_capacity(usize::try_from(info.size_bytes).unwrap_or(0));
    file.take(limit_bytes.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit_bytes { Err(too_large(bytes.len() as u64)) } else { Ok(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    const LIMIT_BYTES: u64 = 1000;

    fn refused<T: std::fmt::Debug>(found: io::Result<T>) -> Option<Refused> {
        Refused::of(&found.unwrap_err())
    }

    #[test]
    fn a_path_is_names_below_the_folder() {
        let desk = tempfile::tempdir().unwrap();
        fs::create_dir_all(desk.path().join("served/a")).unwrap();
        fs::write(desk.path().join("secret"), "secret").unwrap();
        fs::write(desk.path().join("served/a/model.toml"), "text").unwrap();
        let folder = Folder::open(&desk.path().join("served")).unwrap();
        let read = |path: &str| folder.read(Path::new(path), LIMIT_BYTES);
        assert_eq!(read("a/model.toml").unwrap(), b"text");
        for path in ["../secret", "a/../../secret", "/etc/passwd", ".", "", "./a/../a/model.toml"] {
            assert_eq!(refused(read(path)), Some(Refused::BadName), "{path}");
        }
        assert_eq!(read("a").unwrap_err().kind(), io::ErrorKind::IsADirectory);
        assert_eq!(read("b").unwrap_err().kind(), io::ErrorKind::NotFound);
        assert_eq!(folder.find(Path::new("b/c")).unwrap(), None);
        assert_eq!(folder.find(Path::new("a/model.toml")).unwrap().unwrap().size_bytes, 4);
    }

    #[test]
    fn what_is_too_large_is_not_read() {
        let desk = tempfile::tempdir().unwrap();
        let sparse = File::create(desk.path().join("sparse")).unwrap();
        // 3 GiB that take no room on the disk.
        sparse.set_len(3 << 30).unwrap();
        let folder = Folder::open(desk.path()).unwrap();
        let found = refused(folder.read(Path::new("sparse"), LIMIT_BYTES));
        assert_eq!(found, Some(Refused::TooLarge { limit_bytes: LIMIT_BYTES, size_bytes: 3 << 30 }));
    }

    #[cfg(unix)]
    #[test]
    fn no_link_is_followed_and_no_pipe_waited_for() {
        use std::os::unix::fs::symlink;
        let desk = tempfile::tempdir().unwrap();
        let root = desk.path().join("served");
        fs::create_dir_all(root.join("a")).unwrap();
        fs::write(desk.path().join("secret"), "secret").unwrap();
        fs::write(root.join("a/model.toml"), "text").unwrap();
        symlink("../secret", root.join("link")).unwrap();
        symlink("..", root.join("out")).unwrap();
        symlink("a", root.join("inside")).unwrap();
        assert!(std::process::Command::new("mkfifo").arg(root.join("pipe")).status().unwrap().success());
        std::os::unix::net::UnixListener::bind(root.join("socket")).unwrap();
        let folder = Folder::open(&root).unwrap();
        for path in ["link", "out/secret", "inside/model.toml"] {
            assert_eq!(refused(folder.read(Path::new(path), LIMIT_BYTES)), Some(Refused::Link), "{path}");
        }
        for path in ["pipe", "socket"] {
            assert_eq!(refused(folder.read(Path::new(path), LIMIT_BYTES)), Some(Refused::NotAFile), "{path}");
        }
        assert_eq!(folder.find(Path::new("out")).unwrap().unwrap().kind, FileKind::Link);
        // The handle is that of the folder, whatever its path leads to.
        fs::rename(&root, desk.path().join("moved")).unwrap();
        symlink(".", &root).unwrap();
        assert_eq!(folder.read(Path::new("a/model.toml"), LIMIT_BYTES).unwrap(), b"text");
    }
}
