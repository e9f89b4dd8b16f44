//! Contents of the served folder: models, studies, results.
//!
//! A listing looks at no more than [`MAX_ENTRIES`] entries and reads the newest files only. What was read of a file is kept for as long
//! as the file is the same one, of the same size and time.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::path::Path;
use std::time::UNIX_EPOCH;

use loosepin::diagnostics::Source;
use loosepin::document::parse_toml;
use loosepin::files::{self, FileInfo, FileKind};
use loosepin::results::{MARKER_FILE, MAX_MARKER_BYTES, Marker, REPORT_FILE, ResultKind};
use loosepin::study::result::Verdict;
use loosepin::study::says_study;
use serde::{Deserialize, Serialize};

use crate::files::folder::{Folder, MAX_TEXT, tag};
use crate::files::listed::{FileVersion, ListedFile, ListedResult, ListingCache, ReadFile, ReadResult, TextState};
use crate::files::record_head::entry_of;
use crate::files::verdicts::assign;
use crate::messages::Document;
use crate::view::texts::{beside, model_beside, plain};

/// How far below the folder it is looked.
const MAX_LEVELS: usize = 4;
/// Most entries that are looked at.
const MAX_ENTRIES: usize = 50_000;
/// Most files, and most results, that are listed.
const MAX_LISTED: usize = 200;
/// Most bytes that are read for one listing; what then is not known yet comes with the next one.
const MAX_READ_BYTES: u64 = 64 << 20;
/// Most of the record of a study that is read for its verdict, bytes.
const MAX_HEAD_BYTES: u64 = 64 << 10;

/// The served folder as the page shows it.
#[derive(Debug, Default, Serialize)]
pub struct Listing {
    /// Models and studies, the newest first.
    files: Vec<ListedFile>,
    /// Finished results, the newest first.
    results: Vec<ListedResult>,
    /// Whether the list is truncated.
    truncated: bool,
}

impl Listing {
    /// Paths of the studies of a name, the newest first.
    pub fn studies_named(&self, name: &str) -> Vec<String> {
        let studies = self.files.iter().filter(|file| file.kind == Document::Study && file.title == name);
        studies.map(|file| file.path.clone()).collect()
    }

    /// Whether a study in the folder has the texts of the result at a path.
    pub fn texts_of(&self, result: &str) -> Option<TextState> {
        self.results.iter().find(|own| own.path == result).and_then(|own| own.texts)
    }

    /// Paths of the studies of the model at a path.
    pub fn studies_of(&self, model: &str) -> Vec<&str> {
        let studies = self.files.iter().filter(|file| file.model.as_deref() == Some(model));
        studies.map(|file| file.path.as_str()).collect()
    }

    /// Whether the folder holds more than is listed.
    pub fn is_truncated(&self) -> bool {
        self.truncated
    }
}

/// Something that may be listed: its path in the served folder, its file of the version, and its time.
struct Found {
    path: String,
    version: FileVersion,
    at_ms: u64,
}

/// What is found below the folder without reading it.
struct Walk {
    entries_left: usize,
    files: Vec<Found>,
    results: Vec<Found>,
}

/// Looks through the folder, the newest first.
pub fn listing(folder: &Folder) -> Listing {
    let mut walk = Walk { entries_left: MAX_ENTRIES, files: Vec::new(), results: Vec::new() };
    walk.look(folder.opened(), "", MAX_LEVELS);
    let mut reading = Reading { folder, left_bytes: MAX_READ_BYTES, is_cut: walk.entries_left == 0 };
    // Another listing may be reading: this one then reads for itself, and does not wait.
    let mut kept = folder.known();
    let mut own = ListingCache::default();
    let known = kept.as_deref_mut().unwrap_or(&mut own);
    let mut files = newest(walk.files, &mut known.files, &mut reading, |reading, found| reading.file(found));
    let mut results = newest(walk.results, &mut known.results, &mut reading, |reading, found| reading.result(found));
    assign(folder, &mut files, &mut results, &mut known.texts);
    Listing {
        files: files.into_iter().map(|file| file.listed).collect(),
        results: results.into_iter().map(|result| result.listed).collect(),
        truncated: reading.is_cut,
    }
}

/// The newest of `found` that are ours. What is there no more is forgotten.
fn newest<T: Clone>(
    mut found: Vec<Found>,
    known: &mut HashMap<String, (FileVersion, Option<T>)>,
    reading: &mut Reading<'_>,
    read: fn(&mut Reading<'_>, &Found) -> Option<T>,
) -> Vec<T> {
    found.sort_by(|a, b| (Reverse(a.at_ms), &a.path).cmp(&(Reverse(b.at_ms), &b.path)));
    let mut before = std::mem::take(known);
    let mut newest = Vec::new();
    for found in found {
        let kept = before.remove(&found.path).filter(|(version, _)| *version == found.version);
        let is_none_of_ours = matches!(kept, Some((_, None)));
        if newest.len() == MAX_LISTED || (kept.is_none() && reading.left_bytes == 0) {
            reading.is_cut |= !is_none_of_ours;
            // What was read of it once need not be read again.
            known.extend(kept.map(|kept| (found.path, kept)));
            continue;
        }
        let (version, listed) = kept.unwrap_or_else(|| (found.version, read(reading, &found)));
        newest.extend(listed.clone());
        known.insert(found.path, (version, listed));
    }
    newest
}

impl Walk {
    fn look(&mut self, folder: &files::Folder, path: &str, levels: usize) {
        let Ok(entries) = folder.entries(self.entries_left) else { return };
        self.entries_left -= entries.len();
        for entry in entries {
            // Names that are no UTF-8 have no path that the page could write.
            let Some(name) = entry.name.to_str() else { continue };
            let below = if path.is_empty() { name.to_owned() } else { format!("{path}/{name}") };
            // Links are not followed: they may lead out, or in a circle.
            match entry.kind {
                FileKind::Folder if levels > 0 && !name.starts_with('.') => {
                    let Ok(inner) = folder.open_below(Path::new(name)) else { continue };
                    match inner.find(Path::new(MARKER_FILE)) {
                        Ok(Some(marker)) if marker.kind == FileKind::File => {
                            // A result is as old as its page; one without has none to be shown.
                            if let Ok(Some(report)) = inner.find(Path::new(REPORT_FILE))
                                && report.kind == FileKind::File
                            {
                                self.results.push(Found { path: below, version: marker.into(), at_ms: at_ms(&report) });
                            }
                        }
                        _ => self.look(&inner, &below, levels - 1),
                    }
                }
                FileKind::File if Path::new(name).extension().is_some_and(|extension| extension == "toml") => {
                    if let Ok(Some(file)) = folder.find(Path::new(name)) {
                        self.files.push(Found { path: below, version: file.into(), at_ms: at_ms(&file) });
                    }
                }
                _ => {}
            }
        }
    }
}

fn at_ms(info: &FileInfo) -> u64 {
    let since = info.modified.and_then(|modified| modified.duration_since(UNIX_EPOCH).ok());
    since.and_then(|since| u64::try_from(since.as_millis()).ok()).unwrap_or(0)
}

/// What reads the files of a listing.
struct Reading<'f> {
    folder: &'f Folder,
    left_bytes: u64,
    is_cut: bool,
}

impl Reading<'_> {
    fn bytes(&mut self, path: &str, limit_bytes: u64) -> Option<Vec<u8>> {
        let bytes = self.folder.opened().read(Path::new(path), limit_bytes).ok()?;
        self.left_bytes = self.left_bytes.saturating_sub(bytes.len() as u64);
        Some(bytes)
    }

    /// A model or a study; other TOML files are none of ours.
    fn file(&mut self, found: &Found) -> Option<ReadFile> {
        let text = String::from_utf8(self.bytes(&found.path, MAX_TEXT as u64)?).ok()?;
        let source = Source::new(found.path.as_str(), text.as_str());
        let is_model = text.contains("[body");
        // A text that is no TOML is listed by its lines: its card says what is wrong.
        let is_broken = parse_toml(&source).is_err();
        let model = match is_broken {
            true if is_model => None,
            true => value_of(&text, "model").map(|written| beside(&found.path, &written)),
            false => model_beside(&found.path, &text),
        };
        let kind = match says_study(&source) || (is_broken && !is_model) {
            true if model.is_some() => Document::Study,
            false if is_model => Document::Model,
            _ => return None,
        };
        let model = model.map(|model| plain(&model));
        let title = value_of(&text, "name");
        let listed = ListedFile {
            kind,
            title: title.filter(|title| !title.is_empty()).unwrap_or_else(|| found.path.clone()),
            model,
            at_ms: found.at_ms,
            path: found.path.clone(),
            result: None,
        };
        Some(ReadFile { listed, tag: tag(&text) })
    }

    /// A result that is finished.
    fn result(&mut self, found: &Found) -> Option<ReadResult> {
        let marker = self.bytes(&format!("{}/{MARKER_FILE}", found.path), MAX_MARKER_BYTES)?;
        let marker: Marker = serde_json::from_slice(&marker).ok()?;
        if !marker.is_finished {
            return None;
        }
        let is_study = marker.kind == ResultKind::Study;
        let listed = ListedResult {
            title: marker.name,
            kind: marker.kind,
            verdict: if is_study { self.verdict(&found.path) } else { None },
            at_ms: found.at_ms,
            path: found.path.clone(),
            texts: None,
        };
        Some(ReadResult { listed, inputs: marker.inputs_blake3 })
    }

    /// The verdict of a stored study. Its requirements stand at the head of its record, which is read no further.
    fn verdict(&mut self, path: &str) -> Option<Verdict> {
        let requirements: Option<Vec<Requirement>> =
            entry_of(self.folder, path, "requirements", MAX_HEAD_BYTES, &mut self.left_bytes);
        let verdicts = requirements?.into_iter().map(|requirement| requirement.verdict);
        Verdict::of_all(verdicts)
    }
}

/// The text behind a key on the first line that begins with it.
fn value_of(text: &str, key: &str) -> Option<String> {
    let value = text.lines().find_map(|line| line.trim().strip_prefix(key)?.trim_start().strip_prefix('='))?;
    Some(value.split('#').next().unwrap_or(value).trim().trim_matches(['"', '\'']).to_owned())
}

#[derive(Deserialize)]
struct Requirement {
    verdict: Verdict,
}
