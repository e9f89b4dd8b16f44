//! Folders of results of simulations, sweeps and motions.

use std::path::PathBuf;

use loosepin::diagnostics::Diagnostics;
use loosepin::results::FinishedResult;
use loosepin::study::RecordFiles;
use pyo3::prelude::*;

use crate::error::raise;
use crate::waiting::without_gil;

/// What `read` makes of the finished result in a folder, whatever became of its page.
pub fn load<R: Send>(
    py: Python<'_>,
    folder: PathBuf,
    read: impl FnOnce(&FinishedResult) -> Result<R, Diagnostics> + Send,
) -> PyResult<R> {
    let work = || {
        let finished = FinishedResult::open_without_page(&folder);
        finished.map_err(|error| Diagnostics::one(&error, None)).and_then(|finished| read(&finished))
    };
    without_gil(py, work)?.map_err(raise)
}

/// Writes a record into a folder of its own.
pub fn save(py: Python<'_>, files: &RecordFiles, folder: PathBuf, with_force: bool) -> PyResult<()> {
    without_gil(py, || files.save(folder, with_force))?.map_err(raise)
}
