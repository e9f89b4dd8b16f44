//! The files that a study leaves behind. `docs/files/study-results.md` describes them; everything but `timing.json` repeats byte for
//! byte.

mod arrow_schema;
mod bounds_table;
mod parquet;
mod runs_table;
mod timing;

use std::path::PathBuf;

pub use bounds_table::{BOUNDS_COLUMNS, bounds_csv};
pub use parquet::ParquetError;
pub use runs_table::{read_runs_parquet, runs_parquet};
use serde::Deserialize;
pub use timing::Timing;

use crate::question::SavedSurrogates;
use crate::runs::table::RunsTable;
use loosepin_result::json::{Stored, to_json};
use loosepin_result::study::{FORMAT, StudyResult};
pub use loosepin_store::results::SUMMARY_FILE;
use loosepin_store::results::{FinishedResult, ResultsError, ResultsFolder};
use loosepin_text::diagnostics::{Code, problems};

/// Name of the file with one bound a row.
pub const BOUNDS_FILE: &str = "bounds.csv";
/// Name of the file with one run a row.
pub const RUNS_FILE: &str = "runs.parquet";
/// Name of the file with the surrogates.
pub const SURROGATES_FILE: &str = "surrogates.json";
/// Name of the file with everything that does not repeat.
pub const TIMING_FILE: &str = "timing.json";

problems! {
    /// Why a result file could not be written or read.
    #[derive(Debug)]
    pub enum FilesError | Results(ResultsError) {
        /// The text of a file, for example `summary.json`, is not what this version writes.
        Layout { what: String, source: serde_json::Error } => Code::NoResults,
            says("{what} cannot be read: {source}"),
            hint("run the study again, or use the version that wrote it");
        /// Another version of the layout.
        OtherFormat { path: PathBuf, found: u32, known: u32 } => Code::NoResults,
            says("{} has format {found}; this version reads format {known}", path.display()),
            hint("run the study again, or use the version that wrote it");
        /// A value has no form in JSON.
        Json { source: serde_json::Error } => Code::ResultNotStorable,
            says("the result cannot be written as JSON: {source}");
        /// A row could not be written as CSV.
        Csv { source: csv::Error } => Code::ResultNotStorable,
            says("the bounds cannot be written as CSV: {source}");
        /// The columns of the runs differ in length: `name` from `first`.
        UnequalColumns { name: String, rows: usize, expected: usize, first: String } => Code::ResultNotStorable,
            says("column '{name}' of the runs has {rows} rows; must be {expected}, as in column '{first}'");
        /// Two columns of the runs have the same name.
        RepeatedColumn { name: String } => Code::ResultNotStorable,
            says("column '{name}' of the runs appears twice; names must differ");
        /// A stored column has a type that this version does not write.
        ForeignColumn { name: String, stored: String } => Code::NoResults,
            says("column '{name}' of the runs has the type {stored}; must be DOUBLE, INT64 with INTEGER(64, false), or BYTE_ARRAY with STRING"),
            hint("run the study again, or use the version that wrote it");
        /// The runs have no form in Parquet.
        Parquet { source: ParquetError } => Code::ResultNotStorable,
            says("the runs cannot be stored as Parquet: {source}");
        /// The file is no Parquet file of runs.
        UnreadableRuns { source: ParquetError } => Code::NoResults,
            says("{RUNS_FILE} cannot be read: {source}"),
            hint("run the study again, or use the version that wrote it");
        /// The runs are compressed, as earlier versions wrote them.
        CompressedRuns { codec: String } => Code::NoResults,
            says("the runs are compressed with {codec}; this version reads only uncompressed runs"),
            hint("run the study again, or use the version that wrote it; pyarrow and pandas read the file as it is");
    }
}

/// Writes `summary.json`, `bounds.csv`, `runs.parquet` and `timing.json`. Each file appears whole or not at all.
///
/// # Errors
/// What cannot be laid out, and what the file system refuses.
pub fn write_study(
    folder: &mut ResultsFolder,
    result: &StudyResult,
    runs: &RunsTable,
    timing: &Timing,
) -> Result<(), FilesError> {
    let written = |source| FilesError::Json { source };
    let summary = result.to_json().map_err(written)?;
    folder.write(BOUNDS_FILE, &bounds_csv(result)?)?;
    folder.write(RUNS_FILE, &runs_parquet(runs)?)?;
    folder.write_without_hash(TIMING_FILE, to_json(timing).map_err(written)?.as_bytes())?;
    Ok(folder.write(SUMMARY_FILE, summary.as_bytes())?)
}

/// The text of `surrogates.json`.
///
/// # Errors
/// What cannot be laid out.
pub fn surrogates_json(surrogates: &SavedSurrogates) -> Result<String, FilesError> {
    surrogates.to_json().map_err(|source| FilesError::Json { source })
}

/// What every format of `summary.json` has.
#[derive(Deserialize)]
struct Header {
    format: u32,
}

/// Reads the `summary.json` of a folder.
///
/// # Errors
/// A file that is not there, is not as it was written, or that another version wrote.
pub fn read_summary(folder: &FinishedResult) -> Result<StudyResult, FilesError> {
    let text = folder.read_text(SUMMARY_FILE)?;
    // Looked at before the rest, which another format may not have.
    let foreign = |source| FilesError::Layout { what: SUMMARY_FILE.to_owned(), source };
    let Header { format } = serde_json::from_str(&text).map_err(foreign)?;
    if format != FORMAT {
        let path = folder.path().join(SUMMARY_FILE);
        return Err(FilesError::OtherFormat { path, found: format, known: FORMAT });
    }
    StudyResult::from_json(&text).map_err(foreign)
}
