//! Identification of the unknowns of a study from readings and motion of a rig.

use std::sync::atomic::{AtomicBool, Ordering};

use loosepin::identify::{MotionValues, Options, SpecimenStudy, identify, plan_motion, record};
use loosepin::report::{identification_page, identification_text, motion_plan_text};
use loosepin::result::json::to_json;
use loosepin::study::{self, Progress};
use loosepin::units::DisplayUnits;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::path::Path;

use crate::error::raise;
use crate::run_rows::{Texts, study_texts};
use crate::stored_json::from_pickle;
use crate::waiting::{RunCounts, wait_for};

/// The answer of an identification.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Identification {
    answer: record::Identification,
    study: study::Study,
}

#[pymethods]
impl Identification {
    /// The answer as JSON.
    fn json(&self) -> PyResult<String> {
        to_json(&self.answer).map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// The texts of the study that was identified.
    fn study_texts(&self) -> Texts {
        let study::StudyTexts { study, model, model_path, tables } = self.study.texts();
        (study, model, model_path, tables)
    }

    /// The answer with these parts, by which it was pickled: its JSON, and the texts of its study. Nothing is run again.
    #[staticmethod]
    fn from_parts(json: &str, texts: Texts) -> PyResult<Self> {
        let answer = from_pickle::<record::Identification>("identification", json)?;
        Ok(Self { answer, study: study::Study::from_texts(&study_texts(texts)).map_err(raise)? })
    }

    /// The tables of the terminal.
    fn text(&self) -> String {
        identification_text(&self.answer)
    }

    /// The page.
    fn page(&self) -> String {
        identification_page(&self.answer)
    }

    /// The texts of the study with narrowed intervals.
    fn narrowed(&self) -> PyResult<Texts> {
        let narrowed = SpecimenStudy::new(&self.study, &self.answer, Path::new("narrowed.toml")).map_err(raise)?;
        let study::StudyTexts { study, model, model_path, tables } = narrowed.study.texts();
        Ok((study, model, model_path, tables))
    }
}

/// Request for an identification from readings and motion.
pub struct IdentificationRequest {
    /// Values that are tested, confidence, threads.
    pub values: MotionValues,
    /// Specimen, or all.
    pub specimen: Option<String>,
}

/// Identifies the unknowns of `study`.
pub fn identified(
    py: Python<'_>,
    study: &study::Study,
    asked: &IdentificationRequest,
    progress: Option<&Py<PyAny>>,
) -> PyResult<Identification> {
    let IdentificationRequest { values, specimen } = asked;
    let MotionValues { confidence, points, threads, with_posterior, with_lengths } = *values;
    let specimen = specimen.clone();
    let options = Options { confidence, points, threads, with_posterior, with_lengths, specimen, ..Options::default() };
    let answer = with_progress(py, progress, |heard| identify(study, &options, heard).map_err(raise))?;
    Ok(Identification { answer, study: study.clone() })
}

/// Expected information in features of the motion of `study`: JSON, and the table of the terminal.
pub fn planned(
    py: Python<'_>,
    study: &study::Study,
    asked: &IdentificationRequest,
    progress: Option<&Py<PyAny>>,
) -> PyResult<(String, String)> {
    let plan = with_progress(py, progress, |heard| {
        plan_motion(study, asked.specimen.as_deref(), &asked.values, heard).map_err(raise)
    })?;
    let text = motion_plan_text(&plan, &study.model.shown_in(DisplayUnits::default()));
    let json = to_json(&plan).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok((json, text))
}

/// Does `work`, with a callback for values whose runs are made, while Python listens to Ctrl-C.
fn with_progress<T: Send>(
    py: Python<'_>,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(loosepin::identify::ProgressCallback<'_>) -> PyResult<T> + Send,
) -> PyResult<T> {
    let (stop, counts) = (AtomicBool::new(false), RunCounts::default());
    let heard = |finished: usize, most: usize| {
        counts.runs(finished, most);
        !stop.load(Ordering::Relaxed)
    };
    let (outcome, raised) = wait_for(py, &stop, |py| counts.tell(py, progress), || work(&heard));
    match raised {
        Some(error) => Err(error),
        None => {
            counts.tell(py, progress)?;
            outcome
        }
    }
}
