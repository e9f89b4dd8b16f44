//! Runs of a study that are made for another process.

use loosepin::study::{self, NamedText, StudyError, StudyTexts};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::raise;

/// Makes runs of a study that is known by its texts.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct RunRows {
    rows: study::RunRows,
    study: study::Study,
}

/// A row for each run, and the number of the reason why it gave nothing, -1 for a finished one.
type Made<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i32>>);

#[pymethods]
impl RunRows {
    /// The study with these texts and what was stated beside them.
    #[new]
    fn new(py: Python<'_>, texts: Texts, accuracy: Vec<String>, budget: Option<String>) -> PyResult<Self> {
        let study =
            stated(study::Study::from_texts(&study_texts(texts)).map_err(raise)?, &accuracy, budget.as_deref())?;
        let rows = py.detach(|| study::RunRows::new(study.clone(), 1));
        Ok(Self { rows: rows.map_err(|error| raise(error.diagnostic(&study)))?, study })
    }

    /// Makes a run for each row of `random` and `epistemic`, the values of its inputs.
    fn make<'py>(
        &self,
        py: Python<'py>,
        loosened: Vec<(usize, f64)>,
        random: PyReadonlyArray2<'py, f64>,
        epistemic: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Made<'py>> {
        let (random, epistemic) = (random.as_array(), epistemic.as_array());
        let [runs, inputs] = [[random.nrows(), epistemic.nrows()], [random.ncols(), epistemic.ncols()]];
        if runs[0] != runs[1] || inputs != self.rows.inputs() {
            let due = self.rows.inputs();
            return Err(PyValueError::new_err(format!(
                "runs {runs:?} with inputs {inputs:?}; must be as many, with {due:?}"
            )));
        }
        let of_each: Vec<[Vec<f64>; 2]> =
            random.rows().into_iter().zip(epistemic.rows()).map(|(x, u)| [x.to_vec(), u.to_vec()]).collect();
        let made = py.detach(|| self.rows.make(&loosened, of_each));
        let made = made.map_err(|error: StudyError| raise(error.diagnostic(&self.study)))?;
        let length = made.iter().flatten().map(Vec::len).next().unwrap_or(0);
        let mut rows = Array2::from_elem((made.len(), length), f64::NAN);
        for (mut row, numbers) in rows.rows_mut().into_iter().zip(&made) {
            row.iter_mut().zip(numbers.iter().flatten()).for_each(|(place, &number)| *place = number);
        }
        let reasons: Vec<i32> =
            made.iter().map(|row| row.as_ref().err().map_or(-1, |failure| failure.0.into())).collect();
        Ok((rows.into_pyarray(py), reasons.into_pyarray(py)))
    }
}

/// The texts of a study as Python has them: study and model, each with its name; the path of the model; tables.
pub type Texts = (NamedText, NamedText, String, Vec<NamedText>);

/// The texts as the library has them.
pub fn study_texts((study, model, model_path, tables): Texts) -> StudyTexts {
    StudyTexts { study, model, model_path, tables }
}

/// `study` with what is stated beside its file.
pub fn stated(mut study: study::Study, accuracy: &[String], budget: Option<&str>) -> PyResult<study::Study> {
    for text in accuracy {
        study.add_accuracy(text).map_err(raise)?;
    }
    if let Some(text) = budget {
        study.set_budget(text).map_err(raise)?;
    }
    Ok(study)
}
