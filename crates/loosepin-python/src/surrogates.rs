//! Surrogates that a study has saved.

use std::collections::BTreeMap;

use loosepin::study::SavedSurrogates;
use loosepin::study::result::WitnessValue;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::error::raise_problem;

/// Everything that a study has learned.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Surrogates(SavedSurrogates);

/// Output, which deviation, unit, places in words, poses in rad, members of lists by path.
type OutputTuple<'py> = (String, &'static str, String, Vec<String>, Vec<f64>, BTreeMap<String, Bound<'py, PyAny>>);

#[pymethods]
impl Surrogates {
    /// Reads the text of `surrogates.json`.
    #[new]
    fn new(text: &str) -> PyResult<Self> {
        SavedSurrogates::from_json(text).map(Self).map_err(|error| raise_problem(&error))
    }

    /// Name of the study.
    #[getter]
    fn study(&self) -> &str {
        &self.0.study
    }

    /// Path and SI unit of each input.
    fn inputs(&self) -> Vec<(String, String)> {
        self.0.inputs.iter().map(|input| (input.path.clone(), input.unit.symbol().to_owned())).collect()
    }

    /// Outputs that can be predicted.
    fn outputs<'py>(&self, py: Python<'py>) -> PyResult<Vec<OutputTuple<'py>>> {
        let of_each = self.0.outputs.iter().map(|output| {
            let places = output.at.iter().map(|at| match (at.pose_rad(), at.reduction()) {
                (Some(pose_rad), _) => format!("at {pose_rad} rad"),
                (None, Some(reduction)) => reduction.word().to_owned(),
                (None, None) => "whole".to_owned(),
            });
            let poses = output.at.iter().map(|at| at.pose_rad().unwrap_or(f64::NAN));
            let member = |(path, value): (&String, &WitnessValue)| {
                let value = match value {
                    WitnessValue::Number(number) => number.into_pyobject(py)?.into_any(),
                    WitnessValue::Choice(word) => word.into_pyobject(py)?.into_any(),
                };
                Ok((path.clone(), value))
            };
            let members = output.members.iter().map(member).collect::<PyResult<BTreeMap<_, _>>>()?;
            let (name, unit) = (output.output.clone(), output.unit.symbol().to_owned());
            Ok((name, output.of.word(), unit, places.collect(), poses.collect(), members))
        });
        of_each.collect()
    }

    /// Output number `output` as the bytes of an ONNX file.
    fn to_onnx<'py>(&self, py: Python<'py>, output: usize) -> PyResult<Bound<'py, PyBytes>> {
        self.places(output)?;
        let bytes = self.0.to_onnx(output).map_err(|error| raise_problem(&error))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Values and standard deviations of their errors, a row for each row of `values`, whose columns are those of `paths`.
    fn predict<'py>(
        &self,
        py: Python<'py>,
        output: usize,
        paths: Vec<String>,
        values: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<[Bound<'py, PyArray2<f64>>; 2]> {
        let places = self.places(output)?;
        let values = values.as_array();
        let rows = values.nrows();
        let (mut predicted, mut deviations) = (Array2::zeros((rows, places)), Array2::zeros((rows, places)));
        for (row, given) in values.rows().into_iter().enumerate() {
            let point = paths.iter().cloned().zip(given.iter().copied()).collect();
            let prediction = self.0.predict(output, &point).map_err(|error| raise_problem(&error))?;
            for place in 0..places {
                predicted[[row, place]] = prediction.values[place];
                deviations[[row, place]] = prediction.deviations[place];
            }
        }
        Ok([predicted.into_pyarray(py), deviations.into_pyarray(py)])
    }
}

impl Surrogates {
    /// How many places output number `output` has.
    fn places(&self, output: usize) -> PyResult<usize> {
        let count = self.0.outputs.len();
        let places = self.0.outputs.get(output).map(|output| output.at.len());
        places.ok_or_else(|| PyIndexError::new_err(format!("output {output}; there are {count}, counted from 0")))
    }
}
