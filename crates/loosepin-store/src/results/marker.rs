//! The small file by which a folder of results is known.

use serde::{Deserialize, Serialize};

use super::error::ResultsError;

/// Name of the file that says what a folder holds.
pub const MARKER_FILE: &str = "loosepin.json";

/// What kind of result a folder holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ResultKind {
    /// One dynamic run.
    Simulation,
    /// Ideal motion and quasi-static answer.
    Motion,
    /// An uncertainty study.
    Study,
    /// Runs for many values of a quantity.
    Sweep,
}

impl ResultKind {
    /// As a noun: `simulation`, `motion`, `study`, `sweep`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Simulation => "simulation",
            Self::Motion => "motion",
            Self::Study => "study",
            Self::Sweep => "sweep",
        }
    }
}

/// What a folder holds.
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
    /// What has no form in JSON.
    pub(super) fn to_text(&self) -> Result<String, ResultsError> {
        let mut text = serde_json::to_string_pretty(self).map_err(|source| ResultsError::Layout { source })?;
        text.push('\n');
        Ok(text)
    }
}
