//! The motion of a model or a study without dynamics, as the command `loosepin motion` computes it.

use std::path::PathBuf;

use loosepin::accuracy::record::MotionRecord;
use loosepin::report::{motion_page, motion_picture, motion_text, short_motion_text};
use loosepin::results::{MOTION_FILE, ResultKind, write_whole};
use loosepin::simulate::motion_csv;
use loosepin::study::{InputFile, RecordFiles, read_record};
use pyo3::prelude::*;

use crate::error::{raise, raise_problem};
use crate::mechanism::stored;
use crate::stored_json::{from_pickle, to_json};
use crate::waiting::until_interrupted;

/// The ideal motion, and the quasi-static effect of play and scatter on it.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Motion(MotionRecord);

impl Motion {
    /// The motion of `file` with the settings `set`, texts `path=value`, and the paths of points, `BODY.POINT`.
    pub fn of_file(py: Python<'_>, file: InputFile, set: Vec<String>, paths: Vec<String>) -> PyResult<Self> {
        until_interrupted(py, |stop| file.motion_answer(&set, &paths, stop))?.map(Self).map_err(raise)
    }
}

#[pymethods]
impl Motion {
    /// The one with this text of `summary.json`, by which it was pickled; nothing is computed again.
    #[staticmethod]
    fn from_json(summary: &str) -> PyResult<Self> {
        from_pickle("motion", summary).map(Self)
    }

    /// Reads the finished result in a folder.
    #[staticmethod]
    fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        stored::load(py, folder, |folder| read_record(folder, ResultKind::Motion)).map(Self)
    }

    /// Writes it into a folder, as the command does.
    fn save(&self, py: Python<'_>, folder: PathBuf, force: bool) -> PyResult<()> {
        let record = &self.0;
        let files = RecordFiles {
            kind: ResultKind::Motion,
            name: record.model.clone(),
            summary: to_json(record)?,
            tables: vec![(MOTION_FILE, motion_csv(record))],
            page: motion_page(record),
        };
        stored::save(py, &files, folder, force)
    }

    /// The text of `summary.json`.
    fn summary_json(&self) -> PyResult<String> {
        to_json(&self.0)
    }

    /// The first screen of the terminal, or all of its text.
    fn text(&self, all: bool) -> String {
        if all { motion_text(&self.0) } else { short_motion_text(&self.0) }
    }

    /// Writes `report.html`, whole or not at all.
    fn write_page(&self, path: PathBuf) -> PyResult<()> {
        write_whole(&path, motion_page(&self.0).as_bytes()).map_err(|error| raise_problem(&error))
    }

    /// The mechanism in one pose, as SVG.
    fn picture(&self) -> String {
        motion_picture(&self.0)
    }
}
