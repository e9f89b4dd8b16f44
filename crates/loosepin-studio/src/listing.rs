//! What there is in the served folder: models, studies, results.

use std::fs;
use std::path::Path;
use std::time::UNIX_EPOCH;

use loosepin::diagnostics::Source;
use loosepin::report::verdict_words;
use loosepin::results::{MARKER_FILE, Marker, REPORT_FILE, ResultKind, SUMMARY_FILE};
use loosepin::study::result::Verdict;
use loosepin::study::says_study;
use serde::{Deserialize, Serialize};

use crate::folder::Folder;
use crate::texts::{model_beside, plain};

/// How far below the folder it is looked.
const MOST_LEVELS: usize = 4;
/// How many entries are looked at, and how many of each kind are told.
const MOST_ENTRIES: usize = 20_000;
const MOST_TOLD: usize = 200;

/// The served folder as the page shows it.
#[derive(Debug, Default, Serialize)]
pub struct Listing {
    files: Vec<ListedFile>,
    results: Vec<ListedResult>,
    /// Whether there is more than is told.
    truncated: bool,
}

#[derive(Debug, Serialize)]
struct ListedFile {
    path: String,
    kind: &'static str,
    title: String,
    /// Of a study.
    model: Option<String>,
    at_ms: u64,
}

#[derive(Debug, Serialize)]
struct ListedResult {
    path: String,
    title: String,
    kind: &'static str,
    verdict: Option<&'static str>,
    at_ms: u64,
}

impl Listing {
    /// Paths of the studies of a name, the newest first.
    pub fn studies_named(&self, name: &str) -> Vec<String> {
        let studies = self.files.iter().filter(|file| file.kind == "study" && file.title == name);
        studies.map(|file| file.path.clone()).collect()
    }
}

/// Looks through the folder, the newest first.
pub fn listing(folder: &Folder) -> Listing {
    let mut listing = Listing::default();
    let mut left = MOST_ENTRIES;
    walk(folder, folder.root(), MOST_LEVELS, &mut left, &mut listing);
    listing.truncated = left == 0 || listing.files.len() > MOST_TOLD || listing.results.len() > MOST_TOLD;
    listing.files.sort_by_key(|file| (std::cmp::Reverse(file.at_ms), file.path.clone()));
    listing.results.sort_by_key(|result| (std::cmp::Reverse(result.at_ms), result.path.clone()));
    listing.files.truncate(MOST_TOLD);
    listing.results.truncate(MOST_TOLD);
    listing
}

fn walk(folder: &Folder, at: &Path, levels: usize, left: &mut usize, listing: &mut Listing) {
    let Ok(entries) = fs::read_dir(at) else { return };
    for entry in entries.flatten() {
        if *left == 0 {
            return;
        }
        *left -= 1;
        let path = entry.path();
        // Links are not followed: they may lead out, or in a circle.
        let Ok(kind) = entry.file_type() else { continue };
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        if kind.is_dir() && levels > 0 && !is_hidden {
            if path.join(MARKER_FILE).is_file() {
                listing.results.extend(result(folder, &path));
            } else {
                walk(folder, &path, levels - 1, left, listing);
            }
        } else if kind.is_file() && path.extension().is_some_and(|extension| extension == "toml") {
            listing.files.extend(file(folder, &path));
        }
    }
}

/// The path below the folder as the page writes it; nothing for names that are no UTF-8.
fn told(folder: &Folder, path: &Path) -> Option<String> {
    let relative = path.strip_prefix(folder.root()).ok()?;
    let names: Option<Vec<&str>> = relative.components().map(|component| component.as_os_str().to_str()).collect();
    Some(names?.join("/"))
}

fn at_ms(path: &Path) -> u64 {
    let modified = fs::metadata(path).and_then(|found| found.modified()).ok();
    let since = modified.and_then(|modified| modified.duration_since(UNIX_EPOCH).ok());
    since.and_then(|since| u64::try_from(since.as_millis()).ok()).unwrap_or(0)
}

/// A model or a study; other TOML files are none of ours.
fn file(folder: &Folder, path: &Path) -> Option<ListedFile> {
    let path_told = told(folder, path)?;
    let text = folder.read(&path_told).ok()?.text;
    let source = Source::new(path_told.as_str(), text.as_str());
    let model = model_beside(&path_told, &text).map(|model| plain(&model));
    let is_model = text.contains("[body");
    let kind = match says_study(&source) {
        true if model.is_some() => "study",
        false if is_model => "model",
        _ => return None,
    };
    let name = text.lines().find_map(|line| line.trim().strip_prefix("name")?.trim_start().strip_prefix('='));
    let title = name.map(|name| name.split('#').next().unwrap_or(name).trim().trim_matches(['"', '\'']).to_owned());
    Some(ListedFile {
        kind,
        title: title.filter(|title| !title.is_empty()).unwrap_or_else(|| path_told.clone()),
        model,
        at_ms: at_ms(path),
        path: path_told,
    })
}

/// A result that has its page.
fn result(folder: &Folder, path: &Path) -> Option<ListedResult> {
    let marker: Marker = serde_json::from_slice(&fs::read(path.join(MARKER_FILE)).ok()?).ok()?;
    let report = path.join(REPORT_FILE);
    if !marker.is_finished || !report.is_file() {
        return None;
    }
    let is_study = marker.kind == ResultKind::Study;
    Some(ListedResult {
        path: told(folder, path)?,
        title: marker.name,
        kind: marker.kind.words(),
        verdict: if is_study { verdict(&path.join(SUMMARY_FILE)) } else { None },
        at_ms: at_ms(&report),
    })
}

/// The verdict of a stored study.
fn verdict(summary: &Path) -> Option<&'static str> {
    #[derive(Deserialize)]
    struct Summary {
        requirements: Vec<Requirement>,
    }
    #[derive(Deserialize)]
    struct Requirement {
        verdict: Verdict,
    }
    let reader = std::io::BufReader::new(fs::File::open(summary).ok()?);
    let summary: Summary = serde_json::from_reader(reader).ok()?;
    Verdict::of_all(summary.requirements.into_iter().map(|requirement| requirement.verdict)).map(verdict_words)
}
