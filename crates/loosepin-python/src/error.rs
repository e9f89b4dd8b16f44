//! Errors of inputs, as exceptions.

use loosepin::diagnostics::{self, Complaints, Severity};
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

pyo3::create_exception!(
    loosepin,
    LoosepinError,
    PyException,
    "An input that cannot be used, or a result that cannot be had; the text is that of the command line.\n\n\
     `code` is the code of the first error, for example \"E0201\" (`loosepin explain E0201` says more); `complaints` holds\n\
     everything that is wrong, one `Complaint` each."
);

/// One thing that is wrong: what, where, and the way out.
#[pyclass(frozen, get_all, module = "loosepin")]
pub struct Complaint {
    /// The code, which does not change between versions.
    code: &'static str,
    /// "error" or "warning".
    severity: String,
    /// The error and the rule.
    message: String,
    /// The way out, where one is known.
    hint: Option<String>,
    /// The file, or the name of the text, where one is at fault.
    file: Option<String>,
    /// Line in it, counted from 1.
    line: Option<usize>,
    /// Column in it, counted from 1 in characters.
    column: Option<usize>,
    /// All of it, as the command line prints it.
    text: String,
}

#[pymethods]
impl Complaint {
    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        format!("<Complaint {}>", self.text)
    }
}

impl Complaint {
    /// The complaint as Python sees it.
    pub fn new(complaint: &diagnostics::Complaint) -> Self {
        let place = complaint.place.as_ref();
        let (line, column) = place.map(diagnostics::Place::line_and_column).unzip();
        Self {
            code: complaint.code.as_str(),
            severity: complaint.severity.to_string(),
            message: complaint.message.clone(),
            hint: complaint.hint.clone(),
            file: place.map(|place| place.source.name().to_owned()),
            line,
            column,
            text: complaint.to_string(),
        }
    }
}

/// The exception for `complaints`.
pub fn raise(complaints: impl Into<Complaints>) -> PyErr {
    let complaints = complaints.into();
    Python::attach(|py| {
        let error = LoosepinError::new_err(complaints.to_string());
        let sorted = complaints.sorted();
        let first = sorted.iter().find(|complaint| complaint.severity == Severity::Error).or(sorted.first());
        let of_each = || {
            let list = sorted.iter().map(|complaint| Bound::new(py, Complaint::new(complaint)));
            let value = error.value(py);
            value.setattr("code", first.map(|complaint| complaint.code.as_str()))?;
            value.setattr("complaints", PyTuple::new(py, list.collect::<PyResult<Vec<_>>>()?)?)
        };
        match of_each() {
            Ok(()) => error,
            Err(other) => other,
        }
    })
}

/// The exception for a problem that no place in a file is to blame for.
pub fn raise_problem(problem: &dyn diagnostics::Problem) -> PyErr {
    raise(Complaints::one(problem, None))
}
