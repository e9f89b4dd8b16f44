//! A named column of numbers with its unit.

use loosepin::study::{RunColumn, RunData};
use numpy::IntoPyArray;
use pyo3::prelude::*;

/// A column: its name, its SI unit ("1" for pure numbers and words) and its values.
#[pyclass(frozen, get_all, module = "loosepin")]
pub struct Column {
    /// Its name.
    name: String,
    /// SI unit of its values.
    unit: String,
    /// A NumPy array; a list of words where it holds no numbers.
    values: Py<PyAny>,
}

impl Column {
    /// A column of numbers; the values are handed over, not copied.
    pub fn of_numbers(py: Python<'_>, name: &str, unit: &str, values: Vec<f64>) -> Self {
        let values = values.into_pyarray(py).into_any().unbind();
        Self { name: name.to_owned(), unit: unit.to_owned(), values }
    }

    /// A column of values that Python has.
    pub fn of_values(name: String, unit: String, values: Py<PyAny>) -> Self {
        Self { name, unit, values }
    }

    /// A column of a table of runs; the values are handed over, not copied.
    pub fn of_run_column(py: Python<'_>, column: RunColumn) -> PyResult<Self> {
        let values = match column.data {
            RunData::F64(values) => values.into_pyarray(py).into_any(),
            RunData::U64(values) => values.into_pyarray(py).into_any(),
            RunData::Text(words) => words.into_pyobject(py)?,
        };
        Ok(Self { name: column.name, unit: column.unit.symbol().to_owned(), values: values.unbind() })
    }
}
