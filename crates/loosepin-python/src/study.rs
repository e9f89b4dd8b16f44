//! A study: what is uncertain in a model, and what is asked.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use loosepin::identify::MotionValues;
use loosepin::study::{self, FurtherOutputs, InputFile, RunOptions, RunProvider};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::count_threads;
use crate::error::{Diagnostic, raise};
use crate::further_outputs::{self, FunctionRequests, RunBackend};
use crate::growing_samples::Accuracy;
use crate::identification::{self, Identification, identified, planned};
use crate::mechanism::check::Check;
use crate::mechanism::motion::Motion;
use crate::model::Model;
use crate::python_run_provider::PythonRunProvider;
use crate::result::StudyResult;
use crate::results_folder::{ExistingFolderOptions, StudyEnd, run_in_folder, run_in_memory};
use crate::run_rows::{Texts, stated, study_texts};
use crate::study_inputs::{self, StudyInput};
use crate::waiting::{RunCounts, wait_for};

/// Name, SI unit, and angles of the drive in rad where it is a curve.
type Recorded = (String, String, Option<Vec<f64>>);

/// Values at which a motion is tested: as for the command.
const MIN_POINTS: i64 = 1;
const MAX_POINTS: i64 = 1_000_000;

/// A checked study.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Study(pub study::Study);

#[pymethods]
impl Study {
    /// Reads a study file and the model that it names.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        InputFile::from_path(&path).and_then(InputFile::into_study).map(Self).map_err(raise)
    }

    /// Reads a study from text that is reported as `name`; the model that it names is opened unless one is given.
    #[staticmethod]
    #[pyo3(signature = (text, name, model))]
    fn from_text(text: &str, name: &str, model: Option<&Model>) -> PyResult<Self> {
        let study = match model {
            Some(model) => study::Study::from_text(name, text, model.0.as_ref().clone()),
            None => study::Study::from_text_at(name, text),
        };
        study.map(Self).map_err(raise)
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Name of its model, in the plane or in space.
    #[getter]
    fn model_name(&self) -> &str {
        self.0.model.name()
    }

    /// The text that it was read from.
    #[getter]
    fn text(&self) -> &str {
        self.0.source().text()
    }

    /// The model, as its file has it.
    #[getter]
    fn model(&self) -> Model {
        Model(std::sync::Arc::new(self.0.model.clone()))
    }

    /// Warnings about it or its model.
    #[getter]
    fn warnings(&self) -> Vec<Diagnostic> {
        self.0.warnings.iter().map(Diagnostic::new).collect()
    }

    /// Warnings of values that settings make hardly possible.
    fn warnings_of_settings(&self, set: Vec<String>) -> Vec<Diagnostic> {
        self.0.model.warnings_of_settings(&set).iter().map(Diagnostic::new).collect()
    }

    /// How many runs it comes to at most.
    fn most_runs(&self, py: Python<'_>) -> PyResult<usize> {
        let planned = py.detach(|| study::plan_runs(&self.0));
        planned.map_err(|error| raise(error.diagnostic(&self.0)))
    }

    /// Runs it.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[pyo3(signature = (folder, resume, force, threads, progress, accuracy, budget, provider, paths))]
    fn run(
        &self,
        py: Python<'_>,
        folder: Option<PathBuf>,
        resume: bool,
        force: bool,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
        accuracy: Vec<String>,
        budget: Option<String>,
        provider: Option<Py<PyAny>>,
        paths: Vec<String>,
    ) -> PyResult<StudyResult> {
        let threads = count_threads(threads)?;
        let mut study = stated(self.0.clone(), &accuracy, budget.as_deref())?;
        study.add_paths(&paths).map_err(raise)?;
        let provider = provider.map(PythonRunProvider::new);
        let made = provider.as_ref().map(|provider| provider as &dyn RunProvider);
        let inputs = study::study_inputs(&study, &accuracy, budget.as_deref());
        let (stop, counts) = (AtomicBool::new(false), RunCounts::default());
        let options = RunOptions { provider: made, ..RunOptions::new(threads, &counts, &stop) };
        let meeting = ExistingFolderOptions { with_resume: resume, with_force: force };
        let work = || match folder {
            Some(folder) => run_in_folder(&study, inputs, folder, meeting, &options),
            None => run_in_memory(&study, &inputs, &options),
        };
        let (outcome, raised) = wait_for(py, &stop, |py| counts.tell(py, progress.as_ref()), work);
        if let Some(error) = provider.as_ref().and_then(PythonRunProvider::take_exception) {
            return Err(error);
        }
        match (outcome, raised) {
            (Ok(StudyEnd::Interrupted(words)), Some(error)) if error.is_instance_of::<PyKeyboardInterrupt>(py) => {
                Err(PyKeyboardInterrupt::new_err(words))
            }
            // What went wrong is told even where a signal came as well.
            (Err(diagnostics), _) => Err(raise(diagnostics)),
            (_, Some(error)) => Err(error),
            (Ok(StudyEnd::Interrupted(words)), None) => Err(PyKeyboardInterrupt::new_err(words)),
            (Ok(StudyEnd::Finished(run)), None) => {
                counts.tell(py, progress.as_ref())?;
                StudyResult::new(py, *run)
            }
        }
    }

    /// Its motion without dynamics, with the settings `set` and the paths of the points `paths`.
    fn motion(&self, py: Python<'_>, set: Vec<String>, paths: Vec<String>) -> PyResult<Motion> {
        Motion::of_file(py, InputFile::Study(Box::new(self.0.clone())), set, paths)
    }

    /// What is known of it before it runs.
    fn check(&self, py: Python<'_>) -> PyResult<Check> {
        Check::of_file(py, InputFile::Study(Box::new(self.0.clone())))
    }

    /// The texts that it was read from, by which [`Study::from_texts`] has it again.
    fn texts(&self) -> Texts {
        let study::StudyTexts { study, model, model_path, tables } = self.0.texts();
        (study, model, model_path, tables)
    }

    /// The study with these texts; no file is opened.
    #[staticmethod]
    fn from_texts(texts: Texts) -> PyResult<Self> {
        study::Study::from_texts(&study_texts(texts)).map(Self).map_err(raise)
    }

    /// What its readings and its motion say of its unknowns.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[pyo3(signature = (points, confidence, specimen, posterior, lengths, threads, progress))]
    fn identify(
        &self,
        py: Python<'_>,
        points: i64,
        confidence: f64,
        specimen: Option<String>,
        posterior: bool,
        lengths: bool,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Identification> {
        let values = MotionValues {
            with_posterior: posterior,
            with_lengths: lengths,
            ..motion_values(points, confidence, threads)?
        };
        let asked = identification::IdentificationRequest { values, specimen };
        identified(py, &self.0, &asked, progress.as_ref())
    }

    /// What features of its motion would tell: JSON, and the table of the terminal.
    #[pyo3(signature = (confidence, specimen, threads, progress))]
    fn plan_motion(
        &self,
        py: Python<'_>,
        confidence: f64,
        specimen: Option<String>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<(String, String)> {
        let asked =
            identification::IdentificationRequest { values: motion_values(MIN_POINTS, confidence, threads)?, specimen };
        planned(py, &self.0, &asked, progress.as_ref())
    }

    /// Its inputs, in the order of the columns of a design.
    fn inputs(&self) -> Vec<StudyInput> {
        study_inputs::of(&self.0)
    }

    /// Columns of every run: name, SI unit, and for a curve the angles of the drive.
    fn recorded(&self, py: Python<'_>) -> PyResult<Vec<Recorded>> {
        let recorded = py.detach(|| FurtherOutputs::new(&self.0).map(|further| further.recorded()));
        let recorded = recorded.map_err(|error| raise(error.diagnostic(&self.0)))?.into_iter();
        Ok(recorded.map(|output| (output.name, output.unit.symbol().to_owned(), output.pose_rad)).collect())
    }

    /// Bounds of a function of what its runs record.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[pyo3(signature = (function, columns, requests, accuracy, threads, progress, provider))]
    fn bounds<'py>(
        &self,
        py: Python<'py>,
        function: Bound<'py, PyAny>,
        columns: Vec<String>,
        requests: Vec<(usize, String, Option<f64>)>,
        accuracy: Accuracy,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
        provider: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let asked = FunctionRequests { columns: &columns, statistics: &requests, accuracy: &accuracy };
        let by = RunBackend { threads: count_threads(threads)?, provider: provider.map(PythonRunProvider::new) };
        further_outputs::bounds(py, &self.0, &function, &asked, &by, progress.as_ref())
    }
}

/// What is asked of a motion.
fn motion_values(points: i64, confidence: f64, threads: Option<i64>) -> PyResult<MotionValues> {
    if !(MIN_POINTS..=MAX_POINTS).contains(&points) {
        let text = format!("points {points}; must be between {MIN_POINTS} and {MAX_POINTS}");
        return Err(PyValueError::new_err(text));
    }
    Ok(MotionValues {
        confidence,
        points: points as usize,
        threads: count_threads(threads)?,
        with_posterior: false,
        with_lengths: false,
    })
}
