//! Runs for many values of one quantity, as the command `loosepin sweep` makes them.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use loosepin::diagnostics::{self, Code};
use loosepin::model::Model;
use loosepin::report::{sweep_page, sweep_text};
use loosepin::results::{ResultKind, write_whole};
use loosepin::study::{Progress, RecordFiles, read_record};
use loosepin::sweep::record::SweepRecord;
use loosepin::sweep::{
    SECTIONS_FILE, SWEEP_FILE, SweepError, SweepRequest, SweptValues, sections_csv, sweep, sweep_csv,
};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::error::{Diagnostic, of_argument, raise, raise_problem};
use crate::mechanism::single_run::check_tolerance;
use crate::mechanism::stored;
use crate::stored_json::{from_pickle, to_json};
use crate::waiting::{RunCounts, wait_for};

/// A finished sweep.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Sweep(SweepRecord);

#[pymethods]
impl Sweep {
    /// The one with this text of `summary.json`, by which it was pickled; nothing is computed again.
    #[staticmethod]
    fn from_json(summary: &str) -> PyResult<Self> {
        from_pickle("sweep", summary).map(Self)
    }

    /// Reads the finished result in a folder.
    #[staticmethod]
    fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        stored::load(py, folder, |folder| read_record(folder, ResultKind::Sweep)).map(Self)
    }

    /// Writes it into a folder, as the command does.
    fn save(&self, py: Python<'_>, folder: PathBuf, force: bool) -> PyResult<()> {
        let record = &self.0;
        let files = RecordFiles {
            kind: ResultKind::Sweep,
            name: record.model.clone(),
            summary: to_json(record)?,
            tables: vec![(SWEEP_FILE, sweep_csv(record)), (SECTIONS_FILE, sections_csv(record))],
            page: sweep_page(record),
        };
        stored::save(py, &files, folder, force)
    }

    /// The text of `summary.json`.
    fn summary_json(&self) -> PyResult<String> {
        to_json(&self.0)
    }

    /// The tables of the terminal.
    fn text(&self) -> String {
        sweep_text(&self.0)
    }

    /// Writes `report.html`, whole or not at all.
    fn write_page(&self, path: PathBuf) -> PyResult<()> {
        write_whole(&path, sweep_page(&self.0).as_bytes()).map_err(|error| raise_problem(&error))
    }
}

impl Sweep {
    /// Makes the runs of `model` that `request` asks for, with the tolerance that it states; also a warning about that.
    pub fn of_model(
        py: Python<'_>,
        model: &Model,
        request: &SweepRequest<'_>,
        (tolerance_m, threads): (f64, usize),
        progress: Option<&Py<PyAny>>,
    ) -> PyResult<(Self, Vec<Diagnostic>)> {
        model.demand_dynamics().map_err(raise)?;
        let set = model.set_values(request.set).map_err(raise)?;
        let plan = request.plan(model, &set, tolerance_m);
        let plan = plan.map_err(|diagnostic| raise(of_argument(argument_of(request, diagnostic.code), diagnostic)))?;
        plan.check_values(&set).map_err(|(run, error)| {
            let argument = format!("{}: run {run}", argument_of(request, Code::BreaksRule));
            raise(of_argument(&argument, diagnostics::Diagnostic::error(&error, None)))
        })?;
        let coarse = check_tolerance(tolerance_m, plan.smallest_clearance(&set))?;
        let (stop, counts) = (AtomicBool::new(false), RunCounts::default());
        counts.runs(0, plan.points);
        let work = || {
            let mechanism = plan.compile(&set).map_err(raise)?;
            let heard = |finished: usize| counts.runs(finished, plan.points);
            sweep(&mechanism, &set, &plan, threads, &heard, &stop).map_err(|error| refusal(&error))
        };
        let (swept, raised) = wait_for(py, &stop, |py| counts.tell(py, progress), work);
        if let Some(error) = raised {
            let is_interrupt = error.is_instance_of::<PyKeyboardInterrupt>(py);
            return Err(if is_interrupt { PyKeyboardInterrupt::new_err(counts.interrupted()) } else { error });
        }
        let mut record = swept?;
        counts.tell(py, progress)?;
        record.repeat = request.repeat(model);
        let coarse = coarse.iter().map(|warning| diagnostics::Diagnostic::warning(warning, None));
        let warnings = set.warnings().into_iter().chain(coarse);
        Ok((Self(record), warnings.map(|warning| Diagnostic::new(&warning)).collect()))
    }
}

/// The argument that a request without a plan is wrong in.
fn argument_of(request: &SweepRequest<'_>, code: Code) -> &'static str {
    match (request.values, code) {
        (_, Code::UnknownPath | Code::NotSettable | Code::SetTwice) => "over",
        (SweptValues::Between { .. }, _) => "between",
        (SweptValues::Listed { .. }, _) => "values",
    }
}

/// The exception for a sweep without a result.
fn refusal(error: &SweepError) -> PyErr {
    let diagnostic = diagnostics::Diagnostic::error(error, None);
    let with_hint = |hint: &str| diagnostics::Diagnostic { hint: Some(hint.to_owned()), ..diagnostic.clone() };
    match error {
        SweepError::Threads { .. } => {
            let hint = "ask for fewer, or raise the limit of processes (ulimit -u)";
            raise(of_argument("threads", with_hint(hint)))
        }
        SweepError::AllFailed { .. } => raise(with_hint("`Model.simulate` with `set` makes a single run")),
        SweepError::Interrupted { .. } => raise(diagnostic),
    }
}
