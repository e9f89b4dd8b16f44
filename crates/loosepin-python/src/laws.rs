//! Distribution functions of the laws that Python states.

use loosepin::uncertainty::RandomVariable;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::inputs::certain_law;

/// P(X <= x) at each of `values`; not-a-number stays.
#[pyfunction]
pub fn law_cdf<'py>(
    py: Python<'py>,
    law: &Bound<'py, PyAny>,
    values: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_each(py, law, &values, |variable, x| if x.is_nan() { x } else { variable.cdf(x) })
}

/// The least x with P(X <= x) at least the probability, at each of `probabilities`; not-a-number outside of [0, 1].
#[pyfunction]
pub fn law_ppf<'py>(
    py: Python<'py>,
    law: &Bound<'py, PyAny>,
    probabilities: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    of_each(py, law, &probabilities, RandomVariable::quantile)
}

fn of_each<'py>(
    py: Python<'py>,
    law: &Bound<'py, PyAny>,
    values: &PyReadonlyArray1<'py, f64>,
    function: impl Fn(&RandomVariable, f64) -> f64,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let variable = certain_law(law)?;
    let found: Vec<f64> = values.as_array().iter().map(|&value| function(&variable, value)).collect();
    Ok(found.into_pyarray(py))
}
