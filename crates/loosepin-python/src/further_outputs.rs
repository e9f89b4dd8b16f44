//! Bounds of any function of Python of what the runs of a study record.

use std::sync::atomic::AtomicBool;

use loosepin::bounds::{Failure, SampleTable};
use loosepin::study::{FurtherOutputs, RunOptions, RunProvider, Study, StudyError};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyReadonlyArray2};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::raise;
use crate::function_bounds::{Names, answer, requests};
use crate::growing_samples::{Accuracy, GrowingSamples};
use crate::python_run_provider::PythonRunProvider;
use crate::waiting::{RunCounts, wait_for, without_gil};

/// Questions about a function.
pub struct FunctionRequests<'a> {
    /// Its columns.
    pub columns: &'a [String],
    /// Column, statistic, and its number.
    pub statistics: &'a [(usize, String, Option<f64>)],
    /// How accurate their bounds are to be.
    pub accuracy: &'a Accuracy,
}

/// Who makes the runs.
pub struct RunBackend {
    /// Threads of this process.
    pub threads: usize,
    /// Others in their place.
    pub provider: Option<PythonRunProvider>,
}

/// Bounds of the statistics of the columns of `function`, which is given a dict with an array for each input and each recorded
/// output of a study, and the number of runs, and gives an array with a row for each run.
pub fn bounds<'py>(
    py: Python<'py>,
    study: &Study,
    function: &Bound<'py, PyAny>,
    asked: &FunctionRequests<'_>,
    by: &RunBackend,
    progress: Option<&Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let FunctionRequests { columns, statistics, accuracy } = *asked;
    let fail = |error: StudyError| match error {
        StudyError::Interrupted { .. } => PyKeyboardInterrupt::new_err("interrupted; nothing is kept"),
        error => raise(error.diagnostic(study)),
    };
    let asked = requests(statistics)?;
    let further = without_gil(py, || FurtherOutputs::new(study))?.map_err(fail)?;
    let plan = GrowingSamples::try_new(further.problem(columns.len(), asked), accuracy);
    let mut plan = plan.map_err(|error| fail(error.into()))?;
    let recorded = further.recorded();
    let random: Vec<String> = study.random.iter().map(|input| input.path.clone()).collect();
    let epistemic: Vec<String> = study.epistemic.iter().map(|input| input.path.clone()).collect();
    let (stop, counts) = (AtomicBool::new(false), RunCounts::default());
    let provider = by.provider.as_ref().map(|provider| provider as &dyn RunProvider);
    let options = RunOptions { provider, ..RunOptions::new(by.threads, &counts, &stop) };
    let mut table = SampleTable::new(columns.len());
    loop {
        let round = plan.next_round(py, &table, |error| fail(error.into()))?;
        if round.is_empty() {
            break;
        }
        let counts_of_runs = [table.len(), plan.most_runs(&table)];
        let work = || further.run(&round, counts_of_runs, &options);
        let (runs, raised) = wait_for(py, &stop, |py| counts.tell(py, progress), work);
        if let Some(error) = by.provider.as_ref().and_then(PythonRunProvider::take_exception).or(raised) {
            return Err(error);
        }
        let runs = runs.map_err(fail)?;
        let given = PyDict::new(py);
        for (k, path) in random.iter().enumerate() {
            given.set_item(path, round.iter().map(|run| run.random[k]).collect::<Vec<f64>>().into_pyarray(py))?;
        }
        for (k, path) in epistemic.iter().enumerate() {
            given.set_item(path, round.iter().map(|run| run.epistemic[k]).collect::<Vec<f64>>().into_pyarray(py))?;
        }
        for output in &recorded {
            let value = |run: usize, place: usize| runs.values(run)[output.columns[place]];
            let shape = (runs.len(), output.columns.len());
            if output.pose_rad.is_some() {
                let curves = Array2::from_shape_fn(shape, |(run, place)| value(run, place));
                given.set_item(&output.name, curves.into_pyarray(py))?;
            } else {
                let numbers: Vec<f64> = (0..runs.len()).map(|run| value(run, 0)).collect();
                given.set_item(&output.name, numbers.into_pyarray(py))?;
            }
        }
        let made: PyReadonlyArray2<'_, f64> = function.call1((given, round.len()))?.extract()?;
        for ((run, inputs), row) in round.into_iter().enumerate().zip(made.as_array().rows()) {
            let row = row.to_vec();
            // What a function makes of a run that failed is nothing.
            let outcome: Result<&[f64], Failure> = runs.failure(run).map_or(Ok(&row), Err);
            table.push(inputs, outcome).map_err(|error| fail(error.into()))?;
        }
    }
    let answers = without_gil(py, || plan.results(&table))?.map_err(|error| fail(error.into()))?;
    counts.tell(py, progress)?;
    let given = answer(py, &answers, &Names { random: &random, epistemic: &epistemic, columns }, &table)?;
    plan.tell(&given)?;
    Ok(given)
}
