//! Deleting with a way back: what is deleted is moved into the folder `.trash` of the served folder, and stays there until somebody empties
//! it by hand.
//!
//! Each deletion has an entry of its own, in which everything has the path that it had: `.trash/four-bar-study/four-bar/study.toml`. Every
//! move is a rename that replaces nothing, under the locks of both folders, and follows no link.

use std::io;
use std::path::Path;

use axum::http::StatusCode;
use loosepin::files::{FileKind, FolderLock, lock_result, lock_texts, lock_texts_below};
use loosepin::results::{MARKER_FILE, MAX_MARKER_BYTES, Marker};
use serde::Serialize;

use crate::files::folder::{Folder, TRASH, is_in_trash, not_moved, relative};
use crate::files::listing::{Listing, listing};
use crate::network::refusal::Refusal;
use crate::view::texts::{model_beside, plain};

/// Most entries of one name.
const MAX_SAME_NAMES: usize = 10_000;
/// Characters of an entry's name before its number.
const LONGEST_NAME: usize = 64;
/// Most paths that are moved back at once.
const MAX_PATHS: usize = 8;

/// What was moved into the trash.
#[derive(Debug, Serialize)]
pub struct Trashed {
    /// Its entry in the trash.
    pub entry: String,
    /// The paths that it had.
    pub paths: Vec<String>,
}

/// The paths that go with `path`: a study with its model, where no other study uses that; a model; the folder of a result.
///
/// # Errors
/// It is neither; a study uses the model.
pub fn paths_of(folder: &Folder, path: &str) -> Result<Vec<String>, Refusal> {
    let path = plain(path.trim_end_matches('/'));
    relative(&path)?;
    if is_in_trash(&path) {
        return Err(
            Refusal::bad(format!("'{path}' is in the trash already")).with_hint("empty the folder .trash by hand")
        );
    }
    if Path::new(&path).extension().is_none_or(|extension| extension != "toml") {
        require_result(folder, &path)?;
        return Ok(vec![path]);
    }
    let text = folder.read(&path)?.text;
    let listing = listing(folder);
    let Some(model) = model_beside(&path, &text).map(|model| plain(&model)) else {
        return match listing.studies_of(&path).first() {
            None if listing.is_truncated() => {
                Err(Refusal::new(StatusCode::CONFLICT, format!("it is not known whether a study uses '{path}'"))
                    .with_hint("this folder has more files than are looked at; delete the file by hand"))
            }
            None => Ok(vec![path]),
            Some(study) => Err(Refusal::new(StatusCode::CONFLICT, format!("the study '{study}' uses '{path}'"))
                .with_hint("delete the study: its model goes with it")),
        };
    };
    let with_model = is_only_used_by(&listing, &path, &model) && folder.read(&model).is_ok();
    Ok(std::iter::once(path).chain(with_model.then_some(model)).collect())
}

/// Whether no study but that at `path` uses the model. Of a folder that is not listed whole nobody knows.
fn is_only_used_by(listing: &Listing, path: &str, model: &str) -> bool {
    !listing.is_truncated() && listing.studies_of(model).iter().all(|study| *study == path)
}

fn require_result(folder: &Folder, path: &str) -> Result<(), Refusal> {
    let marker = folder.bytes(&format!("{path}/{MARKER_FILE}"), MAX_MARKER_BYTES as usize)?;
    let marker: Option<Marker> = serde_json::from_slice(&marker).ok();
    if marker.is_some_and(|marker| marker.is_finished) {
        return Ok(());
    }
    Err(Refusal::new(StatusCode::CONFLICT, format!("'{path}' is not a finished result"))
        .with_hint("wait for its run, or stop it; its folder can be deleted by hand"))
}

/// Moves paths, as [`paths_of`] gives them, into the trash.
///
/// # Errors
/// Another process writes there; something is there no more; the file system refuses. Nothing is moved then.
pub fn trash(folder: &Folder, paths: Vec<String>) -> Result<Trashed, Refusal> {
    let entry = free_entry(folder, &paths)?;
    let below = Path::new(TRASH).join(&entry);
    // A result that is being written, or is made again, is not moved.
    let is_result = |path: &&String| Path::new(path).extension().is_none_or(|extension| extension != "toml");
    let held: Vec<FolderLock> =
        paths.iter().filter(is_result).map(|path| hold_result(folder, path)).collect::<Result<_, _>>()?;
    let outcome = move_all(folder, Path::new(""), &below, &paths);
    drop(held);
    outcome?;
    Ok(Trashed { entry, paths })
}

/// Moves what was deleted back to where it was.
///
/// # Errors
/// It is in the trash no more; something is there again; the file system refuses. Nothing is moved then.
pub fn restore(folder: &Folder, entry: &str, paths: &[String]) -> Result<(), Refusal> {
    let is_name = !entry.is_empty() && !entry.starts_with('.') && !entry.contains(['/', '\\', ':', '\0']);
    if !is_name {
        return Err(Refusal::bad("the name of an entry of the trash is a single name"));
    }
    if paths.is_empty() || paths.len() > MAX_PATHS {
        return Err(Refusal::bad(format!("1 to {MAX_PATHS} paths are moved back at once")));
    }
    let below = Path::new(TRASH).join(entry);
    for path in paths {
        if folder.opened().find(&relative(path)?).map_err(|error| not_moved(path, &error))?.is_some() {
            return Err(Refusal::new(StatusCode::CONFLICT, format!("'{path}' is there again; nothing was moved back"))
                .with_hint(format!("rename it, or take the old one out of {TRASH}/{entry} by hand")));
        }
    }
    move_all(folder, &below, Path::new(""), paths)
}

/// Renames what is at the paths below one folder to the same paths below another, or nothing of it; folders that are left empty go.
fn move_all(folder: &Folder, from: &Path, to: &Path, paths: &[String]) -> Result<(), Refusal> {
    for (moved, path) in paths.iter().enumerate() {
        if let Err(refusal) = move_path(folder, from, to, path) {
            for path in &paths[..moved] {
                let _ = move_path(folder, to, from, path);
            }
            return Err(refusal);
        }
    }
    for path in paths {
        remove_empty(folder, &from.join(path));
    }
    Ok(())
}

/// A name that no entry of the trash has.
fn free_entry(folder: &Folder, paths: &[String]) -> Result<String, Refusal> {
    let first = paths.first().map_or("", String::as_str);
    let stem: String = first.strip_suffix(".toml").unwrap_or(first).replace('/', "-");
    let stem: String = stem.trim_start_matches('.').chars().take(LONGEST_NAME).collect();
    for number in 1..=MAX_SAME_NAMES {
        let name = if number == 1 { stem.clone() } else { format!("{stem}-{number}") };
        let found = folder.opened().find(&Path::new(TRASH).join(&name)).map_err(|error| not_moved(TRASH, &error))?;
        if found.is_none() {
            return Ok(name);
        }
    }
    Err(Refusal::new(StatusCode::CONFLICT, format!("{TRASH} has {MAX_SAME_NAMES} entries of this name"))
        .with_hint(format!("empty the folder {TRASH} by hand")))
}

/// Locks a finished result, so that nobody writes it while it is moved.
fn hold_result(folder: &Folder, path: &str) -> Result<FolderLock, Refusal> {
    let opened = folder.opened().open_below(&relative(path)?);
    let lock = opened.and_then(|opened| lock_result(&opened)).map_err(|error| match error.kind() {
        io::ErrorKind::ResourceBusy => {
            Refusal::new(StatusCode::CONFLICT, format!("'{path}' is being written by a run; nothing was deleted"))
                .with_hint("wait for the run, or stop it")
        }
        _ => not_moved(path, &error),
    })?;
    require_result(folder, path)?;
    Ok(lock)
}

/// Renames what is at `path` below one folder to the same path below another, where nothing may be.
fn move_path(folder: &Folder, from: &Path, to: &Path, path: &str) -> Result<(), Refusal> {
    let path_below = relative(path)?;
    let moved = || {
        let name = path_below.file_name().unwrap_or_default();
        let parent = path_below.parent().unwrap_or(Path::new(""));
        let source_folder = folder.opened().open_below(&from.join(parent))?;
        // Looked for before a folder is made for it.
        let found = source_folder.find(Path::new(name))?.ok_or(io::ErrorKind::NotFound)?;
        if found.kind == FileKind::Link {
            return Err(loosepin::files::Refused::Link.into());
        }
        let source = lock_texts(&source_folder)?;
        let target = lock_texts_below(folder.opened(), &to.join(parent))?;
        source.move_new(name, &target)
    };
    moved().map_err(|error| not_moved(path, &error))
}

/// Removes the folders in which nothing is left.
fn remove_empty(folder: &Folder, path: &Path) {
    // One that is in use, or has something in it, stays.
    let _ = folder.opened().remove_empty_below(path.parent().unwrap_or(Path::new("")));
}
