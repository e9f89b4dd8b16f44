//! The folder that is served: which paths there are in it, reading and writing. Nothing outside of it is opened.

use std::fs;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use axum::http::StatusCode;
use loosepin::results::write_whole;

use crate::refusal::Refusal;

/// Largest text, bytes.
pub const LARGEST_TEXT: usize = 1 << 20;
/// Largest table that a text names, bytes.
const LARGEST_TABLE: usize = 8 << 20;
/// Longest path, bytes.
const LONGEST_PATH: usize = 1024;

/// The served folder.
#[derive(Debug, Clone)]
pub struct Folder {
    /// Without links.
    root: PathBuf,
}

/// A text file as it stands on the disk.
pub struct StoredText {
    /// What it says.
    pub text: String,
    /// By which it is known again.
    pub tag: String,
}

impl Folder {
    /// The folder at `path`.
    ///
    /// # Errors
    /// It is not there, or no folder.
    pub fn new(path: &Path) -> io::Result<Self> {
        let root = path.canonicalize()?;
        if root.is_dir() { Ok(Self { root }) } else { Err(io::Error::from(io::ErrorKind::NotADirectory)) }
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Where `path`, as the page writes it, is on the disk. It must exist, and no link may lead out of the folder.
    ///
    /// # Errors
    /// The path is none of this folder.
    pub fn existing(&self, path: &str) -> Result<PathBuf, Refusal> {
        let joined = self.root.join(relative(path)?);
        let whole = joined.canonicalize().map_err(|error| not_readable(path, &error))?;
        if whole.starts_with(&self.root) { Ok(whole) } else { Err(outside(path)) }
    }

    /// Where a file `path` is to be written: its folder must exist, and it must be no link.
    ///
    /// # Errors
    /// The path is none of this folder.
    fn writable(&self, path: &str) -> Result<PathBuf, Refusal> {
        let relative = relative(path)?;
        let name = relative.file_name().ok_or_else(|| outside(path))?;
        let parent = self.root.join(relative.parent().unwrap_or(Path::new("")));
        let parent = parent.canonicalize().map_err(|error| not_readable(path, &error))?;
        if !parent.starts_with(&self.root) {
            return Err(outside(path));
        }
        let whole = parent.join(name);
        match fs::symlink_metadata(&whole) {
            Ok(found) if !found.is_file() => {
                Err(Refusal::bad(format!("'{path}' is no plain file: it is not written to")))
            }
            _ => Ok(whole),
        }
    }

    /// Reads a text file.
    ///
    /// # Errors
    /// The path is none of this folder; a file that is too large, or no UTF-8.
    pub fn read(&self, path: &str) -> Result<StoredText, Refusal> {
        let bytes = self.bytes(path, LARGEST_TEXT)?;
        let text = String::from_utf8(bytes).map_err(|_| Refusal::bad(format!("'{path}' is not UTF-8")))?;
        Ok(StoredText { tag: tag(&text), text })
    }

    /// Reads a table that a text names.
    ///
    /// # Errors
    /// As [`Self::read`].
    pub fn read_table(&self, path: &str) -> Result<String, Refusal> {
        let bytes = self.bytes(path, LARGEST_TABLE)?;
        String::from_utf8(bytes).map_err(|_| Refusal::bad(format!("'{path}' is not UTF-8")))
    }

    /// Reads a file of at most so many bytes.
    ///
    /// # Errors
    /// The path is none of this folder; a file that is too large.
    pub fn bytes(&self, path: &str, most: usize) -> Result<Vec<u8>, Refusal> {
        let whole = self.existing(path)?;
        // Asked first: opening a pipe would wait for who writes into it.
        if !fs::metadata(&whole).is_ok_and(|found| found.is_file()) {
            return Err(Refusal::bad(format!("'{path}' is no file")));
        }
        let file = fs::File::open(&whole).map_err(|error| not_readable(path, &error))?;
        let mut bytes = Vec::new();
        file.take(most as u64 + 1).read_to_end(&mut bytes).map_err(|error| not_readable(path, &error))?;
        if bytes.len() > most {
            let message = format!("'{path}' has more than {} MiB", most >> 20);
            return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, message));
        }
        Ok(bytes)
    }

    /// Writes a text file whole, or not at all; gives the tag of what is there now. `known` is the tag of what the page has seen there,
    /// nothing where no file is to be there.
    ///
    /// # Errors
    /// The path is none of this folder, or no `.toml` file; somebody else has changed the file.
    pub fn write(&self, path: &str, text: &str, known: Option<&str>) -> Result<String, Refusal> {
        if Path::new(path).extension().is_none_or(|extension| extension != "toml") {
            return Err(Refusal::bad(format!("'{path}' is not written: the studio writes .toml files only")));
        }
        if text.len() > LARGEST_TEXT {
            return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, format!("'{path}' has more than 1 MiB")));
        }
        let whole = self.writable(path)?;
        let found = if whole.exists() { Some(self.read(path)?.tag) } else { None };
        if found.as_deref() != known {
            let message = match found {
                Some(_) => format!("'{path}' was changed by somebody else since it was read"),
                None => format!("'{path}' is not there any more"),
            };
            return Err(Refusal::new(StatusCode::CONFLICT, message));
        }
        write_whole(&whole, text.as_bytes())
            .map_err(|error| Refusal::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string()))?;
        Ok(tag(text))
    }
}

/// A path as the page writes it: names below the served folder, with `/` between them.
fn relative(path: &str) -> Result<PathBuf, Refusal> {
    let is_plain = !path.is_empty()
        && path.len() <= LONGEST_PATH
        && !path.contains(['\\', ':', '\0'])
        && Path::new(path).components().all(|component| matches!(component, Component::Normal(_)));
    if is_plain { Ok(PathBuf::from(path)) } else { Err(outside(path)) }
}

/// By which a text is known again.
fn tag(text: &str) -> String {
    let mut hasher = loosepin::results::InputsHasher::new(loosepin::results::ResultKind::Study);
    hasher.add("text", text);
    hasher.finish().to_string()
}

fn outside(path: &str) -> Refusal {
    let shown: String = path.chars().take(80).collect();
    Refusal::new(StatusCode::FORBIDDEN, format!("'{shown}' is no path in the served folder"))
        .with_hint("paths are names below the folder, with / between them")
}

fn not_readable(path: &str, error: &io::Error) -> Refusal {
    let status = match error.kind() {
        io::ErrorKind::NotFound => StatusCode::NOT_FOUND,
        io::ErrorKind::PermissionDenied => StatusCode::FORBIDDEN,
        _ => StatusCode::BAD_REQUEST,
    };
    let shown: String = path.chars().take(80).collect();
    Refusal::new(status, format!("cannot read '{shown}': {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(folder.read("inside/model.toml").is_ok(), "a link inside of the folder leads nowhere else");
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
