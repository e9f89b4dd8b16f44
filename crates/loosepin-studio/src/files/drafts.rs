//! Unsaved texts of pages, kept in the folder `.drafts` of the served one until they are saved or given up. So they are found again at another
//! port, in another browser and after the next start.
//!
//! A draft belongs to a tab, which names itself by random digits. A page is given its own draft, or one whose tab is not there any more;
//! that one is its own from then on.

use std::io;
use std::path::Path;

use axum::http::StatusCode;
use loosepin::files::{FolderLock, lock_texts, lock_texts_below};
use serde::{Deserialize, Serialize};

use crate::files::folder::{Folder, MAX_TEXT, not_written, tag};
use crate::network::refusal::Refusal;

/// Folder of the drafts.
const DRAFTS: &str = ".drafts";
/// Most drafts that are kept.
const MAX_DRAFTS: usize = 64;
/// Most entries of the folder that are looked at.
const MAX_ENTRIES: usize = 1024;
/// Largest file of a draft: two texts, each letter escaped.
const MAX_BYTES: u64 = 12 * MAX_TEXT as u64;
/// Digits of the name of a tab.
const TAB_DIGITS: usize = 32;

/// A text that is not saved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct DraftText {
    /// It.
    pub text: String,
    /// Tag of the file from which it began.
    pub tag: String,
}

/// The unsaved texts of a path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Draft {
    /// When they were kept, ms since 1970.
    pub at: f64,
    /// The path by which they were opened.
    pub path: String,
    /// The model, where it has changed.
    pub model: Option<DraftText>,
    /// The study, where it has changed.
    pub study: Option<DraftText>,
}

/// The draft that a page gets.
#[derive(Debug, Default)]
pub struct Taken {
    /// Its own, or that of a tab that is gone.
    pub draft: Option<Draft>,
    /// A tab that is open has a draft of the path.
    pub is_elsewhere: bool,
}

/// Keeps the draft of a tab in place of the one before; one without texts is removed.
///
/// # Errors
/// What is no name of a tab; texts that are too long; too many drafts; the file system refuses.
pub fn keep(folder: &Folder, tab: &str, draft: &Draft) -> Result<(), Refusal> {
    let name = name_of(tab, &draft.path)?;
    let texts = || draft.model.iter().chain(&draft.study);
    let failed = |error: io::Error| not_written(DRAFTS, &error);
    if texts().next().is_none() {
        let Some(lock) = locked(folder).map_err(failed)? else { return Ok(()) };
        lock.remove(&name).map_err(failed)?;
        drop(lock);
        // With other drafts in it, it stays.
        return folder.opened().remove_empty_below(Path::new(DRAFTS)).map_err(failed);
    }
    if texts().any(|own| own.text.len() > MAX_TEXT) {
        return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, "a text has more than 1 MiB"));
    }
    let lock = lock_texts_below(folder.opened(), Path::new(DRAFTS)).map_err(failed)?;
    let names = names(&lock).map_err(failed)?;
    if names.len() >= MAX_DRAFTS && !names.contains(&name) {
        return Err(Refusal::new(StatusCode::CONFLICT, format!("{MAX_DRAFTS} unsaved texts are kept already"))
            .with_hint(format!("save this one, or remove old files in the folder {DRAFTS}")));
    }
    let text = serde_json::to_vec(draft).map_err(|error| failed(io::Error::other(error)))?;
    lock.write(&name, &text).map_err(failed)
}

/// The draft of a path for a tab: its own, else the newest of the tabs that are not open, which is moved to it.
///
/// # Errors
/// What is no name of a tab; the file system refuses.
pub fn take(folder: &Folder, tab: &str, path: &str, is_open: &dyn Fn(&str) -> bool) -> Result<Taken, Refusal> {
    let own = name_of(tab, path)?;
    let failed = |error: io::Error| not_written(DRAFTS, &error);
    let Some(lock) = locked(folder).map_err(failed)? else { return Ok(Taken::default()) };
    let read = |name: &str| {
        let bytes = lock.folder().read(Path::new(name), MAX_BYTES).ok()?;
        serde_json::from_slice::<Draft>(&bytes).ok().filter(|draft| draft.path == path)
    };
    if let Some(draft) = read(&own) {
        return Ok(Taken { draft: Some(draft), is_elsewhere: false });
    }
    let ending = ending_of(path);
    let mut taken = Taken::default();
    let mut newest: Option<(String, Draft)> = None;
    for name in names(&lock).map_err(failed)? {
        let Some(other) = name.strip_suffix(&ending) else { continue };
        let Some(draft) = read(&name) else { continue };
        if is_open(other) {
            taken.is_elsewhere = true;
        } else if newest.as_ref().is_none_or(|(_, before)| draft.at > before.at) {
            newest = Some((name, draft));
        }
    }
    if let Some((name, draft)) = newest {
        lock.rename(&name, &own).map_err(failed)?;
        taken.draft = Some(draft);
    }
    Ok(taken)
}

/// The locked folder of the drafts; `None` where it is not there.
fn locked(folder: &Folder) -> io::Result<Option<FolderLock>> {
    match folder.opened().open_below(Path::new(DRAFTS)) {
        Ok(opened) => lock_texts(&opened).map(Some),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// Names of the drafts that are there.
fn names(lock: &FolderLock) -> io::Result<Vec<String>> {
    let entries = lock.folder().entries(MAX_ENTRIES)?;
    let names = entries.into_iter().filter_map(|entry| entry.name.into_string().ok());
    Ok(names.filter(|name| name.ends_with(".json")).collect())
}

/// The file of a draft.
fn name_of(tab: &str, path: &str) -> Result<String, Refusal> {
    let is_digit = |digit: u8| digit.is_ascii_digit() || (b'a'..=b'f').contains(&digit);
    if tab.len() != TAB_DIGITS || !tab.bytes().all(is_digit) {
        return Err(Refusal::bad(format!("a tab is named by {TAB_DIGITS} hexadecimal digits")));
    }
    Ok(format!("{tab}{}", ending_of(path)))
}

fn ending_of(path: &str) -> String {
    format!("-{}.json", tag(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABS: [&str; 3] =
        ["0123456789abcdef0123456789abcde0", "0123456789abcdef0123456789abcde1", "0123456789abcdef0123456789abcde2"];
    const PATH: &str = "mine/study.toml";

    fn draft(text: &str, at: f64) -> Draft {
        let model = DraftText { text: text.to_owned(), tag: "t".to_owned() };
        Draft { at, path: PATH.to_owned(), model: Some(model), study: None }
    }

    #[test]
    fn a_draft_is_its_tabs_until_that_is_gone() {
        let desk = tempfile::tempdir().unwrap();
        let folder = Folder::new(desk.path()).unwrap();
        let text = |tab: &str, open: &[&str]| {
            let taken = take(&folder, tab, PATH, &|other| open.contains(&other)).unwrap();
            (taken.draft.map(|draft| draft.model.unwrap().text), taken.is_elsewhere)
        };
        assert_eq!(text(TABS[0], &[]), (None, false));
        assert!(!desk.path().join(DRAFTS).exists(), "nothing is made to look for it");
        keep(&folder, TABS[0], &draft("a = 1", 1.0)).unwrap();
        assert_eq!(text(TABS[1], &[TABS[0]]), (None, true), "it is that of a tab that is open");
        assert_eq!(text(TABS[0], &[TABS[0]]), (Some("a = 1".to_owned()), false));
        // That tab is gone: the next one has it, and it alone.
        assert_eq!(text(TABS[1], &[]), (Some("a = 1".to_owned()), false));
        assert_eq!(text(TABS[2], &[TABS[1]]), (None, true));
        // Of two that were left, the newer one.
        keep(&folder, TABS[0], &draft("a = 2", 2.0)).unwrap();
        assert_eq!(text(TABS[2], &[]), (Some("a = 2".to_owned()), false));
        let other = take(&folder, TABS[0], "other/study.toml", &|_| false).unwrap();
        assert!(other.draft.is_none() && !other.is_elsewhere);
        // What is saved is no draft any more.
        keep(&folder, TABS[2], &Draft { model: None, ..draft("", 3.0) }).unwrap();
        assert_eq!(text(TABS[2], &[TABS[1]]), (None, true));
    }

    #[test]
    fn drafts_are_few_and_named_by_digits() {
        let desk = tempfile::tempdir().unwrap();
        let folder = Folder::new(desk.path()).unwrap();
        for tab in ["", "../../evil", "0123456789ABCDEF0123456789ABCDEF", "0123"] {
            assert_eq!(keep(&folder, tab, &draft("a", 1.0)).unwrap_err().status, StatusCode::BAD_REQUEST, "{tab}");
            assert!(take(&folder, tab, PATH, &|_| false).is_err(), "{tab}");
        }
        for number in 0..MAX_DRAFTS {
            keep(&folder, &format!("{number:032x}"), &draft("a", 1.0)).unwrap();
        }
        let one_more = keep(&folder, &format!("{:032x}", MAX_DRAFTS), &draft("a", 1.0)).unwrap_err();
        assert_eq!(one_more.message, "64 unsaved texts are kept already");
        keep(&folder, &format!("{:032x}", 0), &draft("b", 2.0)).unwrap();
        let long = DraftText { text: "a".repeat(MAX_TEXT + 1), tag: String::new() };
        let long = Draft { study: Some(long), ..draft("a", 1.0) };
        assert_eq!(keep(&folder, TABS[0], &long).unwrap_err().status, StatusCode::PAYLOAD_TOO_LARGE);
    }
}
