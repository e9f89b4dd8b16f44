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
}

/// Cached information on files and results, by their paths; empty for foreign files.
#[derive(Debug, Default)]
pub struct ListingCache {
    pub files: HashMap<String, (FileVersion, Option<ListedFile>)>,
    pub results: HashMap<String, (FileVersion, Option<ListedResult>)>,
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
