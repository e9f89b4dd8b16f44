//! Records as the text of `summary.json`, by which objects are shown and pickled.

use loosepin::result::json::Stored;
use loosepin::study::files::FilesError;
use pyo3::prelude::*;

use crate::error::raise_problem;

/// The text of `summary.json`.
pub fn to_json(record: &impl Stored) -> PyResult<String> {
    record.to_json().map_err(|source| raise_problem(&FilesError::Json { source }))
}

/// The record with this text, by which `what` was pickled; nothing is computed again.
pub fn from_pickle<R: Stored>(what: &str, json: &str) -> PyResult<R> {
    R::from_json(json)
        .map_err(|source| raise_problem(&FilesError::Layout { what: format!("a pickled {what}"), source }))
}
