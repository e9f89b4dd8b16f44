//! Finished studies of the served folder, read again.

use loosepin::report::{KnownValue, known_values, witness_words};
use loosepin::result::json::Stored;
use loosepin::results::{MARKER_FILE, MAX_MARKER_BYTES, Marker, ResultKind, SUMMARY_FILE};
use loosepin::study::Study;
use loosepin::study::result::{FORMAT, StudyResult};
use serde::Serialize;

use crate::files::folder::Folder;
use crate::files::listed::TextState;
use crate::files::listing::listing;
use crate::network::refusal::Refusal;
use crate::view::texts::Texts;

/// Largest record of a result, bytes.
const MAX_SUMMARY: usize = 256 << 20;

/// The record of the finished study in a folder of results.
///
/// # Errors
/// The path is none of the served folder; no finished study is there; another version wrote it.
pub fn stored_study(folder: &Folder, path: &str) -> Result<StudyResult, Refusal> {
    let path = path.trim_end_matches('/');
    let marker = marker(folder, path)?;
    if marker.kind != ResultKind::Study {
        let message = format!("'{path}' contains a {}, not a study", marker.kind.words());
        return Err(Refusal::bad(message).with_hint("choose the result of a study"));
    }
    if !marker.is_finished {
        return Err(Refusal::bad(format!("the study in '{path}' is not finished")).with_hint("finish it first"));
    }
    let file = format!("{path}/{SUMMARY_FILE}");
    let result = read(folder, &file, MAX_SUMMARY, StudyResult::from_json)?;
    if result.format != FORMAT {
        let message = format!("'{file}' has format {}; this version reads format {FORMAT}", result.format);
        return Err(Refusal::bad(message).with_hint("run the study again, or use the version that wrote it"));
    }
    Ok(result)
}

fn marker(folder: &Folder, path: &str) -> Result<Marker, Refusal> {
    let file = format!("{}/{MARKER_FILE}", path.trim_end_matches('/'));
    read(folder, &file, MAX_MARKER_BYTES as usize, |text| serde_json::from_str(text))
}

fn read<T>(
    folder: &Folder,
    path: &str,
    most: usize,
    parse: fn(&str) -> Result<T, serde_json::Error>,
) -> Result<T, Refusal> {
    let foreign = |reason: String| {
        Refusal::bad(format!("'{path}' does not have the format of this version: {reason}"))
            .with_hint("run the study again, or use the version that wrote it")
    };
    let bytes = folder.bytes(path, most)?;
    let text = std::str::from_utf8(&bytes).map_err(|error| foreign(error.to_string()))?;
    parse(text).map_err(|error| foreign(error.to_string()))
}

/// The study that a result was made of, from the texts that the result holds.
///
/// # Errors
/// An older version has kept no texts, or this one cannot read them.
pub fn study_of(result: &StudyResult) -> Result<Study, Refusal> {
    let unreadable = || Refusal::bad("this version cannot read the model and the study in this result");
    let file = Texts::of_result(result)?.read_to_run().map_err(|_| unreadable())?;
    file.into_study().map_err(|_| unreadable())
}

/// Available actions on a result.
#[derive(Debug, Default, Serialize)]
pub struct ResultActions {
    /// Name of the result.
    title: String,
    /// Whether it is the result of a study: of others there is nothing to be done.
    is_study: bool,
    /// Mechanisms that can be run by themselves.
    witnesses: Vec<Doing>,
    /// Values that can be taken into the model, in the order of the page.
    known: Vec<Vec<String>>,
    /// Paths of the studies of this name in the served folder, the newest first.
    studies: Vec<String>,
    /// Whether one of these studies has the texts of the result; `None` if there is none.
    texts: Option<TextState>,
}

/// A mechanism that can be run by itself.
#[derive(Debug, Serialize)]
struct Doing {
    /// Its unknown values.
    values: Vec<String>,
    /// The requirements and bounds that it attains.
    attains: Vec<String>,
    /// The command that runs it.
    command: String,
}

/// Available actions on the result in a folder.
///
/// # Errors
/// As for [`stored_study`], but for results that are of no study.
pub fn doings(folder: &Folder, path: &str) -> Result<ResultActions, Refusal> {
    let marker = marker(folder, path)?;
    if marker.kind != ResultKind::Study {
        return Ok(ResultActions { title: marker.name, ..ResultActions::default() });
    }
    let result = stored_study(folder, path)?;
    let witnesses = witness_words(&result).into_iter();
    let listing = listing(folder);
    Ok(ResultActions {
        witnesses: witnesses
            .map(|words| Doing { values: words.values, attains: words.attains, command: words.command })
            .collect(),
        known: known_values(&result).into_iter().map(|KnownValue { words, .. }| vec![words]).collect(),
        studies: listing.studies_named(&result.name),
        texts: listing.texts_of(path.trim_end_matches('/')),
        title: result.name,
        is_study: true,
    })
}
