//! One run, recorded.

use loosepin::diagnostics::{self, Diagnostics};
use loosepin::report::{mechanism_picture, simulation_page, simulation_text};
use loosepin::result::json::Stored;
use loosepin::simulate::record::{OutputHistory, SimulationRecord};
use loosepin::simulate::{self, BodyStates, history_columns, history_csv, impacts_csv};
use loosepin::study::files::FilesError;
use pyo3::exceptions::PyBaseException;
use pyo3::prelude::*;

use crate::column::Column;
use crate::error::{Diagnostic, raise, raise_problem};

/// Everything that tables and pages are made of.
struct RecordedRun {
    record: SimulationRecord,
    states: Option<BodyStates>,
}

/// What a run is pickled by: its record as JSON, and the names and rows of the states of its bodies.
type Parts = (String, Option<(Vec<String>, Vec<Vec<f64>>)>);

/// A finished run.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Simulation(RecordedRun, Option<Diagnostics>, Vec<diagnostics::Diagnostic>);

impl Simulation {
    /// The run for Python, the reason why it counts as failed although it reached its end, and warnings about the requests.
    pub fn new(
        simulation: simulate::Simulation,
        failure: Option<Diagnostics>,
        warnings: Vec<diagnostics::Diagnostic>,
    ) -> Self {
        let simulate::Simulation { record, states, .. } = simulation;
        Self(RecordedRun { record, states }, failure, warnings)
    }
}

#[pymethods]
impl Simulation {
    /// What [`Simulation::from_parts`] makes the same run of.
    fn parts(&self) -> PyResult<Parts> {
        let states = self.0.states.as_ref().map(|states| (states.bodies.clone(), states.rows.clone()));
        Ok((self.summary_json()?, states))
    }

    /// The run with these parts; nothing is run again.
    #[staticmethod]
    fn from_parts(parts: Parts) -> PyResult<Self> {
        let (json, states) = parts;
        let record = SimulationRecord::from_json(&json)
            .map_err(|source| raise_problem(&FilesError::Layout { what: "a pickled simulation".to_owned(), source }))?;
        let states = states.map(|(bodies, rows)| BodyStates { bodies, rows });
        Ok(Self(RecordedRun { record, states }, None, Vec::new()))
    }

    /// Name of the model.
    #[getter]
    fn model(&self) -> &str {
        &self.0.record.model
    }

    /// Warnings about the requests.
    #[getter]
    fn warnings(&self) -> Vec<Diagnostic> {
        self.2.iter().map(Diagnostic::new).collect()
    }

    /// The exception of a run that came to its end and counts as failed.
    fn failure(&self, py: Python<'_>) -> Option<Py<PyBaseException>> {
        self.1.clone().map(|diagnostics| raise(diagnostics).into_value(py))
    }

    /// The columns of `history.csv`, with its names.
    fn history(&self, py: Python<'_>) -> Vec<Column> {
        let columns = history_columns(&self.0.record, self.0.states.as_ref());
        columns
            .iter()
            .map(|column| Column::of_numbers(py, &column.name, column.unit, column.values_si.to_vec()))
            .collect()
    }

    /// Name and SI unit of each output; their values follow time and angle in the history.
    fn outputs(&self) -> Vec<(&str, &str)> {
        self.0.record.outputs.iter().map(|output| (output.name.as_str(), output.unit.symbol())).collect()
    }

    /// The outputs of the ideal mechanism, then the differences from them; empty for an output without an ideal.
    fn ideal_and_deviation(&self, py: Python<'_>) -> [Vec<Column>; 2] {
        let columns = |of: fn(&OutputHistory) -> &Vec<f64>| {
            let outputs = self.0.record.outputs.iter().filter(|output| !of(output).is_empty());
            let column =
                |output: &OutputHistory| Column::of_numbers(py, &output.name, output.unit.symbol(), of(output).clone());
            outputs.map(column).collect()
        };
        [columns(|output| &output.ideal_si), columns(|output| &output.deviation_si)]
    }

    /// The text of `summary.json`.
    fn summary_json(&self) -> PyResult<String> {
        self.0.record.to_json().map_err(|source| raise_problem(&FilesError::Json { source }))
    }

    /// The text of `history.csv`.
    fn history_csv(&self) -> String {
        history_csv(&self.0.record, self.0.states.as_ref())
    }

    /// The text of `impacts.csv`.
    fn impacts_csv(&self) -> String {
        impacts_csv(&self.0.record)
    }

    /// The tables of the terminal.
    fn text(&self) -> String {
        simulation_text(&self.0.record)
    }

    /// The text of `report.html`.
    fn page(&self) -> String {
        simulation_page(&self.0.record)
    }

    /// The mechanism in one pose, as SVG.
    fn picture(&self) -> String {
        mechanism_picture(&self.0.record.drawing, &self.0.record.model)
    }
}
