//! Cached information on a listed file or result.

use std::collections::HashMap;
use std::time::SystemTime;

use loosepin::files::{FileInfo, Identity};
use loosepin::results::ResultKind;
use loosepin::study::result::Verdict;
use serde::Serialize;

use crate::messages::Document;

/// A model or a study.
#[derive(Debug, Clone, Serialize)]
pub struct ListedFile {
    /// Path in the served folder.
    pub path: String,
    /// Which of both.
    pub kind: Document,
    /// Its name; the path of one that has none.
    pub title: String,
    /// Path of the model of a study.
    pub model: Option<String>,
    /// When it was written, milliseconds since 1970.
    pub at_ms: u64,
    /// The newest result of a study.
    pub result: Option<NewestResult>,
}

/// Whether texts are those that a result was computed from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum TextState {
    /// Letter for letter, tables too.
    Same,
    /// A text has changed since.
    Changed,
    /// The result does not hold its texts: an older version wrote it.
    Unknown,
}

/// The newest result of a study: of its texts as they are, where there is one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct NewestResult {
    /// Path of its folder in the served one.
    pub path: String,
    /// Over all requirements.
    pub verdict: Option<Verdict>,
    /// When it was finished, milliseconds since 1970.
    pub at_ms: u64,
    /// Whether it is one of the texts as they are.
    pub texts: TextState,
}

/// A finished result.
#[derive(Debug, Clone, Serialize)]
pub struct ListedResult {
    /// Path of its folder in the served one.
    pub path: String,
    /// Its name.
    pub title: String,
    /// Kind of the result.
    pub kind: ResultKind,
    /// Over all requirements of a study.
    pub verdict: Option<Verdict>,
    /// When it was finished, milliseconds since 1970.
    pub at_ms: u64,
    /// Whether a study of its name in the folder has its texts; `None` if there is no study of its name.
    pub texts: Option<TextState>,
}

/// Tags of the texts that a result was computed from; none if it does not hold them.
pub type KnownTexts = HashMap<String, Option<ResultTexts>>;

/// Tags of the texts that a result was computed from.
#[derive(Debug, Clone, PartialEq)]
pub struct ResultTexts {
    /// Of the model.
    pub model: String,
    /// Of the study.
    pub study: String,
    /// Of each table.
    pub tables: Vec<String>,
}

/// A model or study with the tag of its text.
#[derive(Debug, Clone)]
pub struct ReadFile {
    /// The file.
    pub listed: ListedFile,
    /// Tag of its text.
    pub tag: String,
}

/// A result with the hash of its inputs, which identifies its texts.
#[derive(Debug, Clone)]
pub struct ReadResult {
    /// The result.
    pub listed: ListedResult,
    /// Hash of its inputs.
    pub inputs: String,
}

/// Cached information on files and results, by their paths; empty for foreign files.
#[derive(Debug, Default)]
pub struct ListingCache {
    pub files: HashMap<String, (FileVersion, Option<ReadFile>)>,
    pub results: HashMap<String, (FileVersion, Option<ReadResult>)>,
    pub texts: KnownTexts,
}

/// Version of a file, by which its content is recognised as unchanged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FileVersion {
    pub identity: Identity,
    pub size_bytes: u64,
    pub modified: Option<SystemTime>,
}

impl From<FileInfo> for FileVersion {
    fn from(info: FileInfo) -> Self {
        Self { identity: info.identity, size_bytes: info.size_bytes, modified: info.modified }
    }
}
