//! Runs at inputs that the caller chooses.

use std::sync::atomic::AtomicBool;

use loosepin::diagnostics;
use loosepin::study::{self, DesignRuns, EvaluatedModel, RecordedOutput, StudyError};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2, PyReadonlyArray2};
use pyo3::exceptions::{PyKeyboardInterrupt, PyValueError};
use pyo3::prelude::*;

use crate::arguments::{ArgumentProblem, count_threads};
use crate::column::Column;
use crate::error::{of_argument, of_run, raise, raise_problem};
use crate::model::Model;
use crate::study::Study;
use crate::waiting::{RunCounts, wait_for};

/// Name of the text that outputs are read from, which nobody wrote.
const OUTPUTS: &str = "outputs";

/// Name, SI unit, angles of the drive of a curve in rad, and places in a row.
type Recorded = (String, String, Option<Vec<f64>>, Vec<usize>);

/// Rows, why runs failed, counters, and a warning about the tolerance.
type Evaluated<'py> = (Bound<'py, PyArray2<f64>>, Vec<Option<String>>, Vec<Column>, Option<String>);

/// A compiled study that makes runs at any inputs.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Evaluator(DesignRuns);

#[pymethods]
impl Evaluator {
    /// Of a study.
    #[staticmethod]
    fn of_study(py: Python<'_>, study: &Study) -> PyResult<Self> {
        let runs = py.detach(|| DesignRuns::new(study.0.clone()));
        runs.map(Self).map_err(|refused| raise(refused.0.diagnostic(&refused.1)))
    }

    /// Of a model, with the paths of its inputs, laws of contacts by path, and outputs as TOML.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[staticmethod]
    #[pyo3(signature = (model, inputs, laws, outputs, turns, transient, samples, tolerance))]
    fn of_model(
        py: Python<'_>,
        model: &Model,
        inputs: Vec<String>,
        laws: Vec<(String, String)>,
        outputs: String,
        turns: Option<f64>,
        transient: Option<f64>,
        samples: Option<i64>,
        tolerance: String,
    ) -> PyResult<Self> {
        let mut of_model = model.planar("evaluate()")?.clone();
        of_model.cycle = model.cycle("evaluate()", turns, transient, samples)?;
        let laws = laws.into_iter().map(|(path, law)| [path, law]).collect();
        let evaluated = EvaluatedModel { model: of_model, inputs, laws, outputs, tolerance };
        let study = study::Study::of_evaluated(&evaluated).map_err(raise)?;
        let runs = py.detach(|| DesignRuns::new(study));
        runs.map(Self).map_err(|refused| {
            let diagnostic = refused.0.diagnostic(&refused.1);
            match study::argument_of(&refused.0) {
                Some(argument) => raise(of_argument(argument, diagnostic)),
                None => {
                    let place = diagnostic.place.filter(|place| place.source.name() != OUTPUTS);
                    raise(diagnostics::Diagnostic { place, ..diagnostic })
                }
            }
        })
    }

    /// SI unit of each input.
    fn input_units(&self) -> Vec<String> {
        let inputs = study::describe_inputs(self.0.study()).into_iter();
        inputs.map(|input| input.unit.symbol().to_owned()).collect()
    }

    /// Everything that a run records, each once.
    fn recorded(&self) -> Vec<Recorded> {
        self.0.recorded().into_iter().map(recorded).collect()
    }

    /// What each question asks for.
    fn asked(&self) -> Vec<Recorded> {
        self.0.asked().into_iter().map(recorded).collect()
    }

    /// The inputs at points of the unit cube, a row each.
    fn inputs_at<'py>(
        &self,
        py: Python<'py>,
        points: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let rows = rows_of(&points, self.0.inputs())?;
        let values: Vec<Vec<f64>> = rows.iter().map(|point| self.0.inputs_at(point)).collect();
        let table = Array2::from_shape_fn((values.len(), self.0.inputs()), |(run, input)| values[run][input]);
        Ok(table.into_pyarray(py))
    }

    /// Makes a run for each row of `values`.
    #[pyo3(signature = (values, threads, progress))]
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        values: PyReadonlyArray2<'py, f64>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Evaluated<'py>> {
        let threads = count_threads(threads)?;
        let rows = rows_of(&values, self.0.inputs())?;
        for (run, row) in rows.iter().enumerate() {
            if let Some(input) = (0..row.len()).find(|&input| !self.0.is_value(input, row[input])) {
                let text = format!("run {run}: input {input} is {}; must be finite, or the place of a law", row[input]);
                return Err(PyValueError::new_err(text));
            }
        }
        for (run, row) in rows.iter().enumerate() {
            if let Some(error) = self.0.broken_rule(row) {
                return Err(of_run(run, diagnostics::Diagnostic::error(&error, None)));
            }
        }
        let (stop, counts) = (AtomicBool::new(false), RunCounts::default());
        let work = || self.0.evaluate(&rows, threads, &counts, &stop);
        let (made, raised) = wait_for(py, &stop, |py| counts.tell(py, progress.as_ref()), work);
        if let Some(error) = raised {
            let is_interrupt = error.is_instance_of::<PyKeyboardInterrupt>(py);
            return Err(if is_interrupt { PyKeyboardInterrupt::new_err(counts.interrupted()) } else { error });
        }
        let table = made.map_err(|error| self.refusal(&error))?;
        counts.tell(py, progress.as_ref())?;
        let counters = table.counters.into_iter();
        let counters = counters.map(|column| Column::of_run_column(py, column)).collect::<PyResult<_>>()?;
        let mut numbers = Array2::from_elem((rows.len(), self.0.columns()), f64::NAN);
        let mut reasons = Vec::with_capacity(rows.len());
        for (mut place, made) in numbers.rows_mut().into_iter().zip(table.rows) {
            let made = made.unwrap_or_else(|| Err("not made".to_owned()));
            place.iter_mut().zip(made.iter().flatten()).for_each(|(place, &number)| *place = number);
            reasons.push(made.err());
        }
        Ok((numbers.into_pyarray(py), reasons, counters, table.coarse))
    }
}

impl Evaluator {
    /// The exception for runs that could not be made.
    fn refusal(&self, error: &StudyError) -> PyErr {
        let (argument, hint) = match error {
            StudyError::Threads(_) => ("threads", "ask for fewer, or raise the limit of processes (ulimit -u)"),
            _ => ("inputs", "give fewer rows at once; with fewer curves each needs fewer numbers"),
        };
        let diagnostic = error.diagnostic(self.0.study());
        raise(of_argument(argument, diagnostics::Diagnostic { hint: Some(hint.to_owned()), ..diagnostic }))
    }
}

fn recorded(output: RecordedOutput) -> Recorded {
    (output.name, output.unit.symbol().to_owned(), output.pose_rad, output.columns)
}

/// The rows of a table with so many columns.
fn rows_of(table: &PyReadonlyArray2<'_, f64>, columns: usize) -> PyResult<Vec<Vec<f64>>> {
    let table = table.as_array();
    if table.ncols() != columns {
        return Err(raise_problem(&ArgumentProblem::Columns { found: table.ncols(), due: columns }));
    }
    Ok(table.rows().into_iter().map(|row| row.to_vec()).collect())
}
