//! Runs that are made by whatever a callable of Python hands them to, a cluster for one.

use std::sync::{Mutex, PoisonError};

use loosepin::bounds::{Failure, RunInputs};
use loosepin::study::{RequestedRuns, RunProvider};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyIterator;

/// A callable that is given what is loosened and the inputs of runs, and gives a generator: of rows with the place of the first one
/// and of the reasons why runs failed, or of nothing as long as nothing is finished.
pub struct PythonRunProvider {
    make: Py<PyAny>,
    /// Exception that it has raised.
    exception: Mutex<Option<PyErr>>,
}

/// Place of the first run, rows, and reasons, as [`crate::run_rows::RunRows::make`] gives them.
type FinishedRows<'py> = (usize, PyReadonlyArray2<'py, f64>, PyReadonlyArray1<'py, i32>);

impl PythonRunProvider {
    /// Runs that `make` makes.
    pub fn new(make: Py<PyAny>) -> Self {
        Self { make, exception: Mutex::new(None) }
    }

    /// Exception that the callable has raised since the last call.
    pub fn take_exception(&self) -> Option<PyErr> {
        self.exception.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    fn hand_over(
        &self,
        py: Python<'_>,
        asked: &RequestedRuns<'_>,
        is_stopped: &dyn Fn() -> bool,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, Failure>),
    ) -> PyResult<()> {
        let array = |inputs: fn(&RunInputs) -> &Vec<f64>| {
            let columns = asked.runs.first().map_or(0, |run| inputs(run).len());
            Array2::from_shape_fn((asked.runs.len(), columns), |(run, input)| inputs(asked.runs[run])[input])
                .into_pyarray(py)
        };
        let (random, epistemic) = (array(|run| &run.random), array(|run| &run.epistemic));
        let parts = self.make.bind(py).call1((asked.loosened.to_vec(), random, epistemic))?;
        for part in PyIterator::from_object(&parts)? {
            if let Some((first, rows, reasons)) = part?.extract::<Option<FinishedRows<'_>>>()? {
                for (offset, (row, &reason)) in rows.as_array().rows().into_iter().zip(reasons.as_array()).enumerate() {
                    let failure = u16::try_from(reason).ok().map(Failure);
                    finished(first + offset, failure.map_or_else(|| Ok(row.to_vec()), Err));
                }
            }
            if is_stopped() {
                // It takes back what it has asked for.
                return parts.call_method0("close").map(drop);
            }
        }
        Ok(())
    }
}

impl RunProvider for PythonRunProvider {
    fn make(
        &self,
        asked: &RequestedRuns<'_>,
        is_stopped: &dyn Fn() -> bool,
        finished: &mut dyn FnMut(usize, Result<Vec<f64>, Failure>),
    ) -> Result<(), String> {
        Python::attach(|py| {
            self.hand_over(py, asked, is_stopped, finished).map_err(|error| {
                let words = error.to_string();
                *self.exception.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                words
            })
        })
    }
}
