//! The small file by which a folder of results is known.

use serde::{Deserialize, Serialize};

use super::error::ResultsError;
use super::kind::ResultKind;

/// The content of [`super::MARKER_FILE`]: what a folder holds, and from which inputs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Marker {
    /// The kind of result.
    pub kind: ResultKind,
    /// Name of the model or study.
    pub name: String,
    /// BLAKE3 of all inputs, 64 hexadecimal digits.
    pub inputs_blake3: String,
    /// Version of the program that wrote the folder.
    pub version: String,
    /// Whether all files are there.
    pub is_finished: bool,
    /// Names of the files that belong to the result, this one left out.
    pub files: Vec<String>,
    /// Files of the finished result that this one replaces: each waits as `NAME.replaced` until this one is finished.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub replaced: Vec<String>,
}

impl Marker {
    /// The text of the file.
    ///
    /// # Errors
    /// An error of JSON.
    pub(super) fn to_text(&self) -> Result<String, ResultsError> {
        let mut text = serde_json::to_string_pretty(self).map_err(|source| ResultsError::Layout { source })?;
        text.push('\n');
        Ok(text)
    }
}
