//! A finished study.

use std::path::PathBuf;

use loosepin::diagnostics::Diagnostics;
use loosepin::report::{Frame, short_study_text, study_excerpt, study_frame, study_page, study_text};
use loosepin::results::{FinishedResult, write_whole};
use loosepin::study::files::{bounds_csv, surrogates_json};
use loosepin::study::{self, SavedSurrogates, StudyRun, read_study};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::column::Column;
use crate::error::{raise, raise_problem};
use crate::stored_json::{from_pickle, to_json};

/// Result of a study with its runs.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct StudyResult {
    result: study::result::StudyResult,
    surrogates: Option<SavedSurrogates>,
    samples: Vec<Py<Column>>,
}

impl StudyResult {
    /// The result as Python sees it; the runs are handed over, not copied.
    pub fn new(py: Python<'_>, run: StudyRun) -> PyResult<Self> {
        let columns = run.runs.columns.into_iter();
        let samples = columns.map(|column| Py::new(py, Column::of_run_column(py, column)?));
        Ok(Self { result: run.result, surrogates: run.surrogates, samples: samples.collect::<PyResult<Vec<_>>>()? })
    }
}

#[pymethods]
impl StudyResult {
    /// The result with these parts, by which it was pickled: `summary.json`, name, unit and values of each column of the runs, and
    /// `surrogates.json`. Nothing is run again.
    #[staticmethod]
    #[pyo3(signature = (summary, samples, surrogates))]
    fn from_parts(
        py: Python<'_>,
        summary: &str,
        samples: Vec<(String, String, Py<PyAny>)>,
        surrogates: Option<&str>,
    ) -> PyResult<Self> {
        let result = from_pickle::<study::result::StudyResult>("result", summary)?;
        let surrogates = surrogates.map(SavedSurrogates::from_json).transpose();
        let samples =
            samples.into_iter().map(|(name, unit, values)| Py::new(py, Column::of_values(name, unit, values)));
        Ok(Self {
            result,
            surrogates: surrogates.map_err(|error| raise_problem(&error))?,
            samples: samples.collect::<PyResult<Vec<_>>>()?,
        })
    }

    /// Reads the finished study in a folder of results.
    #[staticmethod]
    fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        let read = py.detach(|| {
            let finished = FinishedResult::open_without_page(&folder);
            finished.map_err(|error| Diagnostics::one(&error, None)).and_then(|finished| read_study(&finished))
        });
        Self::new(py, read.map_err(raise)?)
    }

    /// Name of the study.
    #[getter]
    fn name(&self) -> &str {
        &self.result.name
    }

    /// The columns of `runs.parquet`.
    fn samples(&self, py: Python<'_>) -> Vec<Py<Column>> {
        self.samples.iter().map(|column| column.clone_ref(py)).collect()
    }

    /// The text of `summary.json`.
    fn summary_json(&self) -> PyResult<String> {
        to_json(&self.result)
    }

    /// The bytes of `bounds.csv`.
    fn bounds_csv<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &bounds_csv(&self.result).map_err(|error| raise_problem(&error))?))
    }

    /// The text of `surrogates.json`, where the study asked for surrogates.
    fn surrogates_json(&self) -> PyResult<Option<String>> {
        let text = self.surrogates.as_ref().map(surrogates_json).transpose();
        text.map_err(|error| raise_problem(&error))
    }

    /// The first screen of the terminal, or all of its text.
    fn text(&self, all: bool) -> String {
        if all { study_text(&self.result) } else { short_study_text(&self.result) }
    }

    /// The text of `report.html`.
    fn page(&self) -> String {
        study_page(&self.result)
    }

    /// The first screen of `report.html` for a frame in a notebook, and the angle of its cursor, rad.
    fn frame(&self) -> (String, Option<f64>) {
        let Frame { document, drive_angle_rad } = study_frame(&self.result);
        (document, drive_angle_rad)
    }

    /// The answer, the mechanism, the curves and the key table as HTML without styles and scripts.
    fn excerpt(&self) -> String {
        study_excerpt(&self.result)
    }

    /// Writes `report.html`, whole or not at all.
    fn write_page(&self, path: PathBuf) -> PyResult<()> {
        write_whole(&path, study_page(&self.result).as_bytes()).map_err(|error| raise(Diagnostics::one(&error, None)))
    }
}
