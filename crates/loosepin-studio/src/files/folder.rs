//! The folder that is served: which paths there are in it, reading and writing. Nothing outside of it is opened, and no link is followed.

use std::collections::HashMap;
use std::ffi::OsStr;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};

use axum::http::StatusCode;
use loosepin::files::{self, FileInfo, Refused, io_error_words, lock_texts};

use crate::files::listed::ListingCache;
use crate::network::refusal::Refusal;

/// Largest text, bytes.
pub const MAX_TEXT: usize = 1 << 20;
/// Largest table that a text names, bytes.
const MAX_TABLE: usize = 8 << 20;
/// Characters of a new folder's name.
const LONGEST_NAME: usize = 64;
/// Folder for what was deleted.
pub const TRASH: &str = ".trash";
/// Longest path, bytes.
const LONGEST_PATH: usize = 1024;
/// Most files of which it is remembered what was saved last.
const MAX_SAVED: usize = 4096;

/// The served folder, held open: what its path leads to later does not matter.
#[derive(Debug, Clone)]
pub struct Folder {
    opened: files::Folder,
    known: Arc<Mutex<ListingCache>>,
    /// Tags of what this server has saved last, by the paths.
    saved: Arc<Mutex<HashMap<String, String>>>,
}

/// A text file as it stands on the disk.
pub struct StoredText {
    /// Its text.
    pub text: String,
    /// Tag that identifies its content.
    pub tag: String,
    /// Whether it is what this server has saved there last: no other program has changed it since.
    pub is_saved_here: bool,
}

impl Folder {
    /// The folder at `path`.
    ///
    /// # Errors
    /// It is not there, or no folder.
    pub fn new(path: &Path) -> io::Result<Self> {
        Ok(Self { opened: files::Folder::open(&path.canonicalize()?)?, known: Arc::default(), saved: Arc::default() })
    }

    /// Its path when it was opened.
    pub fn root(&self) -> &Path {
        self.opened.path()
    }

    /// The open folder.
    pub fn opened(&self) -> &files::Folder {
        &self.opened
    }

    /// Cache of earlier listings; `None` while another one has it.
    pub(crate) fn known(&self) -> Option<MutexGuard<'_, ListingCache>> {
        match self.known.try_lock() {
            Ok(known) => Some(known),
            Err(TryLockError::Poisoned(known)) => Some(known.into_inner()),
            Err(TryLockError::WouldBlock) => None,
        }
    }

    /// Information about the entry at `path`, as the page writes it.
    ///
    /// # Errors
    /// The path is none of this folder; nothing is there.
    pub fn info(&self, path: &str) -> Result<FileInfo, Refusal> {
        let found = self.opened.find(&relative(path)?).map_err(|error| not_readable(path, &error))?;
        found.ok_or_else(|| not_readable(path, &io::ErrorKind::NotFound.into()))
    }

    /// Reads a text file.
    ///
    /// # Errors
    /// The path is none of this folder; a file that is too large, or no UTF-8.
    pub fn read(&self, path: &str) -> Result<StoredText, Refusal> {
        let text = text_of(path, self.bytes(path, MAX_TEXT)?)?;
        let tag = tag(&text);
        Ok(StoredText { is_saved_here: self.is_saved_here(path, &tag), tag, text })
    }

    fn saved(&self) -> MutexGuard<'_, HashMap<String, String>> {
        self.saved.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn is_saved_here(&self, path: &str, tag: &str) -> bool {
        self.saved().get(path).is_some_and(|saved| saved == tag)
    }

    fn remember(&self, path: &str, tag: &str) {
        let mut saved = self.saved();
        if saved.len() >= MAX_SAVED {
            saved.clear();
        }
        saved.insert(path.to_owned(), tag.to_owned());
    }

    /// Reads a table that a text names.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_table(&self, path: &str) -> Result<String, Refusal> {
        text_of(path, self.bytes(path, MAX_TABLE)?)
    }

    /// Reads a file of at most `most` bytes.
    ///
    /// # Errors
    /// The path is none of this folder; a file that is too large.
    pub fn bytes(&self, path: &str, most: usize) -> Result<Vec<u8>, Refusal> {
        self.opened.read(&relative(path)?, most as u64).map_err(|error| not_readable(path, &error))
    }

    /// Writes a text file whole, or not at all; returns the tag of its present content. `known` is the tag of what the page has seen there,
    /// `None` if no file is to be there. The tag is compared under a lock that all studios of the folder take: of several that save at once
    /// with one tag, one saves.
    ///
    /// # Errors
    /// The path is none of this folder, or no `.toml` file, or in the trash; somebody else has changed the file.
    pub fn write(&self, path: &str, text: &str, known: Option<&str>) -> Result<String, Refusal> {
        if Path::new(path).extension().is_none_or(|extension| extension != "toml") {
            return Err(Refusal::bad(format!("'{path}' is not written: the studio writes .toml files only")));
        }
        if text.len() > MAX_TEXT {
            return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, format!("'{path}' has more than 1 MiB")));
        }
        refuse_trash(path)?;
        let relative = relative(path)?;
        let name = relative.file_name().and_then(|name| name.to_str()).ok_or_else(|| outside(path))?;
        let parent = self.opened.open_below(relative.parent().unwrap_or(Path::new("")));
        let parent = parent.map_err(|error| not_readable(path, &error))?;
        let lock = lock_texts(&parent).map_err(|error| not_written(path, &error))?;
        let found = match parent.read(Path::new(name), MAX_TEXT as u64) {
            Ok(bytes) => Some(tag(&text_of(path, bytes)?)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(not_written(path, &error)),
        };
        if found.as_deref() != known {
            let message = match found {
                Some(found) if self.is_saved_here(path, &found) => {
                    format!("'{path}' was saved in another tab of the studio after it was read")
                }
                Some(_) => format!("'{path}' was changed by another program after it was read"),
                None => format!("'{path}' no longer exists"),
            };
            return Err(Refusal::new(StatusCode::CONFLICT, message));
        }
        let written = match found {
            Some(_) => lock.write(name, text.as_bytes()),
            None => lock.write_new(&[(name, text.as_bytes())]),
        };
        written.map_err(|error| not_written(path, &error))?;
        let tag = tag(text);
        self.remember(path, &tag);
        Ok(tag)
    }

    /// Makes a folder with files in it, which is there with all of them or not at all.
    ///
    /// # Errors
    /// The name is none for a folder; something of that name is there already; a text that is too long.
    pub fn write_new_folder(&self, name: &str, texts: &[(&str, &str)]) -> Result<(), Refusal> {
        let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if name.is_empty() || name.len() > LONGEST_NAME || !name.chars().all(is_plain) {
            return Err(Refusal::bad("the name of a new folder has only letters, digits, - and _"));
        }
        if let Some((file, _)) = texts.iter().find(|(_, text)| text.len() > MAX_TEXT) {
            return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, format!("'{file}' has more than 1 MiB")));
        }
        let contents: Vec<(&str, &[u8])> = texts.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
        let written = lock_texts(&self.opened).and_then(|lock| lock.write_new_folder(name, &contents));
        written.map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => Refusal::new(StatusCode::CONFLICT, format!("'{name}' already exists")),
            io::ErrorKind::NotFound => {
                Refusal::new(StatusCode::CONFLICT, "the served folder no longer exists; nothing is written")
            }
            _ => not_written(name, &error),
        })?;
        texts.iter().for_each(|(file, text)| self.remember(&format!("{name}/{file}"), &tag(text)));
        Ok(())
    }
}

fn text_of(path: &str, bytes: Vec<u8>) -> Result<String, Refusal> {
    String::from_utf8(bytes).map_err(|_| Refusal::bad(format!("'{path}' is not UTF-8")))
}

/// A path as the page writes it: names below the served folder, with `/` between them.
///
/// # Errors
/// It leads somewhere else.
pub fn relative(path: &str) -> Result<PathBuf, Refusal> {
    // Whether these are names below the folder, the folder says when it looks them up.
    let is_plain = path.len() <= LONGEST_PATH && !path.contains(['\\', ':', '\0']);
    if is_plain { Ok(PathBuf::from(path)) } else { Err(outside(path)) }
}

/// Whether a path, as the page writes it, leads into the folder for what was deleted.
pub fn is_in_trash(path: &str) -> bool {
    let first = Path::new(path).components().find(|component| *component != Component::CurDir);
    first == Some(Component::Normal(OsStr::new(TRASH)))
}

/// That a path does not lead there: what was deleted is not changed.
///
/// # Errors
/// It does.
pub fn refuse_trash(path: &str) -> Result<(), Refusal> {
    if is_in_trash(path) {
        return Err(Refusal::bad(format!("'{path}' is in the trash: nothing is saved there"))
            .with_hint("restore it first, or move it out of the folder .trash by hand"));
    }
    Ok(())
}

/// Tag that identifies a text.
pub fn tag(text: &str) -> String {
    let mut hasher = loosepin::results::InputsHasher::new(loosepin::results::ResultKind::Study);
    hasher.add("text", text);
    hasher.finish().to_string()
}

fn outside(path: &str) -> Refusal {
    let shown: String = path.chars().take(80).collect();
    Refusal::new(StatusCode::FORBIDDEN, format!("'{shown}' is not a path in the served folder"))
        .with_hint("paths are names below the folder, with / between them")
}

fn not_readable(path: &str, error: &io::Error) -> Refusal {
    refused("read", path, error, StatusCode::BAD_REQUEST)
}

/// Why something at `path` was not moved.
pub fn not_moved(path: &str, error: &io::Error) -> Refusal {
    refused("move", path, error, StatusCode::INTERNAL_SERVER_ERROR)
}

/// Why a file at `path` was not written.
pub fn not_written(path: &str, error: &io::Error) -> Refusal {
    refused("write", path, error, StatusCode::INTERNAL_SERVER_ERROR)
}

fn refused(what: &str, path: &str, error: &io::Error, otherwise: StatusCode) -> Refusal {
    if Refused::of(error) == Some(Refused::BadName) {
        return outside(path);
    }
    let status = match (Refused::of(error), error.kind()) {
        (Some(Refused::TooLarge { .. }), _) => StatusCode::PAYLOAD_TOO_LARGE,
        (Some(Refused::NotAFile), _) => StatusCode::BAD_REQUEST,
        (Some(Refused::Link | Refused::ReadOnly), _) | (_, io::ErrorKind::PermissionDenied) => StatusCode::FORBIDDEN,
        (_, io::ErrorKind::NotFound) => StatusCode::NOT_FOUND,
        (_, io::ErrorKind::AlreadyExists) => StatusCode::CONFLICT,
        (_, io::ErrorKind::ResourceBusy) => StatusCode::SERVICE_UNAVAILABLE,
        _ => otherwise,
    };
    let shown: String = path.chars().take(80).collect();
    Refusal::new(status, format!("cannot {what} '{shown}': {}", io_error_words(error)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn nothing_outside_of_the_folder_is_opened() {
        let desk = tempfile::tempdir().unwrap();
        let root = desk.path().join("served");
        fs::create_dir_all(root.join("a")).unwrap();
        fs::write(desk.path().join("secret.toml"), "secret = 1\n").unwrap();
        fs::write(root.join("a/model.toml"), "name = \"a\"\n").unwrap();
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("../secret.toml", root.join("link.toml")).unwrap();
            std::os::unix::fs::symlink("..", root.join("out")).unwrap();
            std::os::unix::fs::symlink("a", root.join("inside")).unwrap();
        }
        let folder = Folder::new(&root).unwrap();
        assert_eq!(folder.read("a/model.toml").unwrap().text, "name = \"a\"\n");
        for path in [
            "../secret.toml",
            "a/../../secret.toml",
            "/etc/passwd",
            "link.toml",
            "out/secret.toml",
            "a\\..\\..\\secret.toml",
            "C:secret.toml",
            "",
            ".",
            "a/./model.toml\0",
        ] {
            let refused = folder.read(path).map(|found| found.text).expect_err(path);
            assert!(!refused.message.contains("secret = 1"), "{path}");
            assert!(folder.write(path, "x = 1\n", None).is_err(), "{path}");
        }
        #[cfg(unix)]
        {
            let refused = folder.read("inside/model.toml").map(|found| found.text).expect_err("a link");
            let words = "it is a symbolic link, and links are not followed here";
            assert_eq!(
                (refused.status, refused.message),
                (StatusCode::FORBIDDEN, format!("cannot read 'inside/model.toml': {words}"))
            );
        }
        assert_eq!(fs::read_to_string(desk.path().join("secret.toml")).unwrap(), "secret = 1\n");
    }

    #[test]
    fn a_file_that_somebody_else_changed_is_not_overwritten() {
        let desk = tempfile::tempdir().unwrap();
        let folder = Folder::new(desk.path()).unwrap();
        let first = folder.write("model.toml", "a = 1\n", None).unwrap();
        assert_eq!(folder.write("model.toml", "a = 2\n", None).unwrap_err().status, StatusCode::CONFLICT);
        let second = folder.write("model.toml", "a = 2\n", Some(&first)).unwrap();
        fs::write(desk.path().join("model.toml"), "a = 3\n").unwrap();
        assert_eq!(folder.write("model.toml", "a = 4\n", Some(&second)).unwrap_err().status, StatusCode::CONFLICT);
        assert_eq!(folder.read("model.toml").unwrap().text, "a = 3\n");
        assert!(folder.write("model.txt", "a", None).is_err(), "the studio writes .toml files only");
    }
}
