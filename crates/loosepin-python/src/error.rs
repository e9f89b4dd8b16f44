//! Errors of inputs, as exceptions.

use std::io;

use loosepin::diagnostics::{self, Code, Diagnostics, RefusedFile, Severity};
use pyo3::exceptions::{PyBaseException, PyException, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyTuple, PyType};

use crate::words_of_python::{in_python, sentence};

pyo3::create_exception!(
    loosepin,
    LoosepinError,
    PyException,
    "An input that cannot be used, or a result that cannot be had. Wrong texts and values raise `LoosepinValueError`, a file that is\n\
     not there raises `LoosepinFileNotFoundError`.\n\n\
     `code` is the code of the first error, for example \"E0201\"; `diagnostics` holds\n\
     everything that is wrong, one `Diagnostic` each. `simulation` is the run that came to its end and counts as failed, otherwise None."
);

/// The class, whose attributes are there in any case, also where somebody else has made the exception.
pub fn with_defaults(py: Python<'_>) -> PyResult<Bound<'_, PyType>> {
    let class = py.get_type::<LoosepinError>();
    class.setattr("code", py.None())?;
    class.setattr("diagnostics", PyTuple::empty(py))?;
    class.setattr("simulation", py.None())?;
    Ok(class)
}

/// One thing that is wrong: what, where, and the way out.
#[pyclass(frozen, get_all, eq, hash, module = "loosepin")]
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Diagnostic {
    /// The code, which does not change between versions.
    code: String,
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
    /// All of it, on a line or a few.
    text: String,
}

/// What [`Diagnostic`] is made of: code, severity, message, hint, file, line, column, text.
type Fields = (String, String, String, Option<String>, Option<String>, Option<usize>, Option<usize>, String);

#[pymethods]
impl Diagnostic {
    #[new]
    #[allow(clippy::too_many_arguments, reason = "they are its fields")]
    fn of_fields(
        code: String,
        severity: String,
        message: String,
        hint: Option<String>,
        file: Option<String>,
        line: Option<usize>,
        column: Option<usize>,
        text: String,
    ) -> Self {
        Self { code, severity, message, hint, file, line, column, text }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, Fields) {
        let Self { code, severity, message, hint, file, line, column, text } = self.clone();
        (py.get_type::<Self>(), (code, severity, message, hint, file, line, column, text))
    }

    /// What the code means, in a few sentences with an example; empty for a code of another version.
    #[getter]
    fn explanation(&self) -> String {
        self.code.parse::<Code>().map_or_else(|_| String::new(), |code| sentence(code.entry().explanation))
    }

    fn __str__(&self) -> &str {
        &self.text
    }

    fn __repr__(&self) -> String {
        format!("<Diagnostic {}>", self.text)
    }
}

impl Diagnostic {
    /// The diagnostic as Python sees it.
    pub fn new(diagnostic: &diagnostics::Diagnostic) -> Self {
        let diagnostic = in_python(diagnostic);
        let place = diagnostic.place.as_ref();
        let (line, column) = place.map(diagnostics::Place::line_and_column).unzip();
        Self {
            code: diagnostic.code.as_str().to_owned(),
            severity: diagnostic.severity.to_string(),
            message: diagnostic.message.clone(),
            hint: diagnostic.hint.clone(),
            file: place.map(|place| place.source.name().to_owned()),
            line,
            column,
            text: diagnostic.to_string(),
        }
    }
}

/// The Python module of the classes that are also exceptions of Python.
const CLASSES: &str = "loosepin._objects.errors";

/// What an exception is besides a `LoosepinError`.
enum Kind<'d> {
    /// Nothing else: a run, a folder or the machine failed, or a result cannot be had.
    Other,
    /// A `ValueError`: something is wrong with a text or a value that was given.
    Value,
    /// A `FileNotFoundError`.
    FileNotFound(&'d RefusedFile),
}

/// The one place that decides what an exception for `first` is: by its code, and by what the operating system said of a file.
fn kind(first: &diagnostics::Diagnostic) -> Kind<'_> {
    if let Some(file) = first.refused_file.as_deref().filter(|file| file.reason == io::ErrorKind::NotFound) {
        return Kind::FileNotFound(file);
    }
    match first.code {
        Code::FileNotReadable => Kind::Other,
        Code::DriveStandsStill
        | Code::ToleranceTooLarge
        | Code::ImplausibleNumber
        | Code::WrongKindOfFile
        | Code::NoSurrogateAnswer
        | Code::MeasuredTable
        | Code::MeasuredOutside
        | Code::NotADrawing
        | Code::DrawingNotAMechanism
        | Code::NotARobot
        | Code::RobotNotAMechanism
        | Code::NotExportable => Kind::Value,
        // Files and their values, questions and mechanisms; runs begin behind these codes.
        code if code <= Code::NoDynamics => Kind::Value,
        _ => Kind::Other,
    }
}

/// The exception with the text and of the kind of `first`.
fn exception(py: Python<'_>, text: String, first: Option<&diagnostics::Diagnostic>) -> PyResult<PyErr> {
    static VALUE: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    static FILE_NOT_FOUND: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    Ok(match first.map_or(Kind::Other, kind) {
        Kind::Other => LoosepinError::new_err(text),
        Kind::Value => PyErr::from_type(VALUE.import(py, CLASSES, "LoosepinValueError")?.clone(), text),
        Kind::FileNotFound(file) => {
            let class = FILE_NOT_FOUND.import(py, CLASSES, "LoosepinFileNotFoundError")?;
            let arguments = (text, file.path.as_str(), file.os_code);
            PyErr::from_value(class.call1(arguments)?)
        }
    })
}

/// The exception for `diagnostics`.
pub fn raise(diagnostics: impl Into<Diagnostics>) -> PyErr {
    let diagnostics = diagnostics.into();
    Python::attach(|py| {
        let sorted = diagnostics.sorted();
        let first = sorted.iter().find(|diagnostic| diagnostic.severity == Severity::Error).or(sorted.first()).copied();
        let text = sorted.iter().map(|diagnostic| in_python(diagnostic)).collect::<Diagnostics>().to_string();
        let of_each = |error: &PyErr| {
            let list = sorted.iter().map(|diagnostic| Bound::new(py, Diagnostic::new(diagnostic)));
            let value = error.value(py);
            value.setattr("code", first.map(|diagnostic| diagnostic.code.as_str()))?;
            value.setattr("diagnostics", PyTuple::new(py, list.collect::<PyResult<Vec<_>>>()?)?)
        };
        exception(py, text, first).and_then(|error| of_each(&error).map(|()| error)).unwrap_or_else(|other| other)
    })
}

/// The exception for a problem that no place in a file is to blame for.
pub fn raise_problem(problem: &dyn diagnostics::Problem) -> PyErr {
    raise(Diagnostics::one(problem, None))
}

/// The exception of the Python part for an argument with an impossible value: `LoosepinValueError` with this code.
#[pyfunction]
#[pyo3(signature = (code, message, hint))]
pub fn refusal(py: Python<'_>, code: &str, message: String, hint: Option<String>) -> PyResult<Py<PyBaseException>> {
    let code = code.parse::<Code>().map_err(|error| PyValueError::new_err(error.to_string()))?;
    let (severity, place, labels, refused_file) = (Severity::Error, None, Vec::new(), None);
    Ok(raise(diagnostics::Diagnostic { code, severity, message, hint, place, labels, refused_file }).into_value(py))
}

/// A diagnostic about an argument of Python: its name stands before the words, and no place, since nobody wrote the text that it is in.
pub fn of_argument(argument: &str, diagnostic: diagnostics::Diagnostic) -> diagnostics::Diagnostic {
    let message = format!("{argument}: {}", diagnostic.message);
    diagnostics::Diagnostic { message, place: None, labels: Vec::new(), ..diagnostic }
}

/// The exception for the inputs of one run, before any run is made.
pub fn of_run(run: usize, diagnostic: diagnostics::Diagnostic) -> PyErr {
    let in_si = "numbers are in SI units";
    let hint = diagnostic.hint.as_ref().map_or_else(|| in_si.to_owned(), |hint| format!("{hint}; {in_si}"));
    let diagnostic = diagnostics::Diagnostic { hint: Some(hint), ..diagnostic };
    raise(of_argument(&format!("inputs: run {run}"), diagnostic))
}
