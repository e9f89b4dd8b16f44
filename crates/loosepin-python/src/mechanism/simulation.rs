//! One run, recorded.

use std::path::PathBuf;

use loosepin::diagnostics::{self, Diagnostics};
use loosepin::report::{
    Frame, short_simulation_text, simulation_excerpt, simulation_frame, simulation_page, simulation_text, wear_text,
};
use loosepin::results::ResultKind;
use loosepin::simulate::record::{EndState, OutputHistory, SimulationRecord};
use loosepin::simulate::{
    self, BodyStates, SpectrumColumn, StartProblem, history_columns, history_csv, impacts_csv, spectrum_columns,
};
use loosepin::study::{RecordFiles, read_run, run_tables};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyBaseException;
use pyo3::prelude::*;

use crate::column::Column;
use crate::error::{Diagnostic, raise, raise_problem};
use crate::mechanism::stored;
use crate::stored_json::{from_pickle, to_json};

/// Everything that tables and pages are made of.
struct RecordedRun {
    record: SimulationRecord,
    states: Option<BodyStates>,
}

/// What a run is pickled by: its record as JSON, and the names and rows of the states of its bodies.
type Parts = (String, Option<(Vec<String>, Vec<Vec<f64>>)>);

/// Joint, radial clearance, x and y.
type Orbit<'py> = (String, f64, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// Output or contact force and its SI unit; orders, their frequencies in Hz, amplitudes; mean, root mean square, peak.
type OneSpectrum<'py> = (String, String, [Bound<'py, PyArray1<f64>>; 3], [f64; 3]);

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

impl Simulation {
    /// The state at its end, from which another run can continue.
    pub fn end_state(&self) -> PyResult<&EndState> {
        let model = &self.0.record.model;
        self.0
            .record
            .end_state
            .as_ref()
            .ok_or_else(|| raise_problem(&StartProblem::NoEndState { model: model.clone() }))
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
        let record = from_pickle::<SimulationRecord>("simulation", &json)?;
        let states = states.map(|(bodies, rows)| BodyStates { bodies, rows });
        Ok(Self(RecordedRun { record, states }, None, Vec::new()))
    }

    /// Reads the finished run in a folder of results.
    #[staticmethod]
    fn load(py: Python<'_>, folder: PathBuf) -> PyResult<Self> {
        let (record, states) = stored::load(py, folder, read_run)?;
        Ok(Self(RecordedRun { record, states }, None, Vec::new()))
    }

    /// Writes it into a folder, as the command does.
    fn save(&self, py: Python<'_>, folder: PathBuf, force: bool) -> PyResult<()> {
        let RecordedRun { record, states } = &self.0;
        let files = RecordFiles {
            kind: ResultKind::Simulation,
            name: record.model.clone(),
            summary: to_json(record)?,
            tables: run_tables(record, states.as_ref()),
            page: simulation_page(record),
        };
        stored::save(py, &files, folder, force)
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

    /// Joint, radial clearance in m, and x and y of the pin in the frame of its bearing, of each pin with play.
    fn orbits<'py>(&self, py: Python<'py>) -> Vec<Orbit<'py>> {
        let array = |values: &Vec<f64>| values.clone().into_pyarray(py);
        let orbits = self.0.record.orbits.iter();
        orbits
            .map(|orbit| (orbit.joint.clone(), orbit.radial_clearance_m, array(&orbit.x_m), array(&orbit.y_m)))
            .collect()
    }

    /// Normal force of each contact, N.
    fn contact_forces<'py>(&self, py: Python<'py>) -> Vec<(&str, Bound<'py, PyArray1<f64>>)> {
        let forces = self.0.record.contact_forces.iter();
        forces.map(|force| (force.joint.as_str(), force.force_n.clone().into_pyarray(py))).collect()
    }

    /// The columns of `spectrum.csv`.
    fn spectra<'py>(&self, py: Python<'py>) -> Vec<OneSpectrum<'py>> {
        let speed_rad_s = self.0.record.settings.drive_speed_rad_s.unwrap_or(f64::NAN);
        let columns = spectrum_columns(&self.0.record).into_iter();
        columns
            .map(|SpectrumColumn { of, unit, spectrum, .. }| {
                let frequency_hz = spectrum.frequencies_hz(speed_rad_s);
                let arrays = [spectrum.orders, frequency_hz, spectrum.amplitudes_si];
                let numbers = [spectrum.mean_si, spectrum.rms_si, spectrum.peak_si];
                (of, unit.to_owned(), arrays.map(|values| values.into_pyarray(py)), numbers)
            })
            .collect()
    }

    /// The text of `summary.json`.
    fn summary_json(&self) -> PyResult<String> {
        to_json(&self.0.record)
    }

    /// The text of `history.csv`.
    fn history_csv(&self) -> String {
        history_csv(&self.0.record, self.0.states.as_ref())
    }

    /// The text of `impacts.csv`.
    fn impacts_csv(&self) -> String {
        impacts_csv(&self.0.record)
    }

    /// The first screen of the terminal, or all of its text.
    fn text(&self, all: bool) -> String {
        if all { simulation_text(&self.0.record) } else { short_simulation_text(&self.0.record) }
    }

    /// The tables of the terminal on the wear of its joints.
    fn wear_text(&self) -> String {
        wear_text(&self.0.record)
    }

    /// The text of `report.html`.
    fn page(&self) -> String {
        simulation_page(&self.0.record)
    }

    /// The first screen of `report.html` for a frame in a notebook, and the angle of its cursor, rad.
    fn frame(&self) -> (String, Option<f64>) {
        let Frame { document, drive_angle_rad } = simulation_frame(&self.0.record);
        (document, drive_angle_rad)
    }

    /// The mechanism and the first chart as HTML without scripts.
    fn excerpt(&self) -> String {
        simulation_excerpt(&self.0.record)
    }
}
