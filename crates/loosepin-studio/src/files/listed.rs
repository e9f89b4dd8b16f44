//! What is listed of a file or a result, and kept for the next listing.

use std::collections::HashMap;
use std::time::SystemTime;

use loosepin::files::{FileInfo, Identity};
use serde::Serialize;

/// A model or a study.
#[derive(Debug, Clone, Serialize)]
pub struct ListedFile {
    pub path: String,
    pub kind: &'static str,
    pub title: String,
    /// Of a study.
    pub model: Option<String>,
    pub at_ms: u64,
}

/// A finished result.
#[derive(Debug, Clone, Serialize)]
pub struct ListedResult {
    pub path: String,
    pub title: String,
    pub kind: &'static str,
    pub verdict: Option<&'static str>,
    pub at_ms: u64,
}

/// What was read of files and results, by their paths; nothing of those that are none of ours.
#[derive(Debug, Default)]
pub struct Known {
    pub files: HashMap<String, (Version, Option<ListedFile>)>,
    pub results: HashMap<String, (Version, Option<ListedResult>)>,
}

/// By which the content of a file is known to be the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Version {
    pub identity: Identity,
    pub size_bytes: u64,
    pub modified: Option<SystemTime>,
}

impl From<FileInfo> for Version {
    fn from(info: FileInfo) -> Self {
        Self { identity: info.identity, size_bytes: info.size_bytes, modified: info.modified }
    }
}
