//! A mechanism with its nominal values.

use std::path::PathBuf;
use std::sync::Arc;

use loosepin::diagnostics;
use loosepin::model::{self, Cycle, PathError, Quantity, QuantityId, Rule, Setting, SettingError};
use loosepin::simulate::record::Override;
use loosepin::simulate::{Plan, Settings};
use loosepin::study::{
    InputFile, NamedPlace, NamedQuestion, NamedText, StudyModel, exact_value, model_from_texts, model_texts,
};
use loosepin::sweep::{SWEEP_POINTS, SWEEP_TRANSIENT_TURNS, SWEEP_TURNS, SweepRequest, SweptValues};
use loosepin::units::SiUnit;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;

use crate::arguments::{ArgumentProblem, count, count_threads, integrator_named, lyapunov_turns, tolerance_m};
use crate::error::{Diagnostic, of_argument, of_run, raise, raise_problem};
use crate::mechanism::check::Check;
use crate::mechanism::motion::Motion;
use crate::mechanism::simulation::Simulation;
use crate::mechanism::single_run;
use crate::mechanism::sweep::Sweep;

/// Rows for each turn, at most; as for the command.
const MAX_SAMPLES: i64 = 1_000_000;

/// Key, word, and angle of the drive that the word names, rad.
type Place = (&'static str, String, Option<f64>);

/// A model file and its tables, each with its name.
type ModelTexts = (NamedText, Vec<NamedText>);

/// A checked model.
#[pyclass(frozen, module = "loosepin._loosepin")]
pub struct Model(pub Arc<StudyModel>);

impl Model {
    /// The model as a file whose kind is known.
    fn file(&self) -> InputFile {
        InputFile::Model(self.0.as_ref().clone())
    }

    /// The model for what is integrated by `call`, which no model in space is.
    pub fn planar(&self, call: &'static str) -> PyResult<&model::Model> {
        self.0.demand_planar().map_err(|_| raise_problem(&ArgumentProblem::NoDynamics { call }))
    }

    /// The turns that `call` runs, those of the model where nothing else is said.
    pub fn cycle(
        &self,
        call: &'static str,
        turns: Option<f64>,
        transient: Option<f64>,
        samples: Option<i64>,
    ) -> PyResult<Cycle> {
        for (name, given, rule) in [("turns", turns, Rule::SomeTurns), ("transient", transient, Rule::Turns)] {
            if let Some(turns) = given.filter(|&turns| !rule.allows(turns)) {
                return Err(raise_problem(&ArgumentProblem::Turns { name, given: turns, rule }));
            }
        }
        let samples = samples.map(|samples| count("samples", samples, 1..=MAX_SAMPLES)).transpose()?;
        let mut cycle = self.planar(call)?.cycle.clone();
        cycle.recorded_turns = turns.unwrap_or(cycle.recorded_turns);
        cycle.transient_turns = transient.unwrap_or(cycle.transient_turns);
        cycle.samples_per_turn = samples.map_or(cycle.samples_per_turn, |samples| samples as usize);
        Ok(cycle)
    }
}

/// The diagnostic for a path in `argument` that names no quantity.
fn of_unknown(argument: &str, error: PathError) -> diagnostics::Diagnostic {
    of_argument(argument, diagnostics::Diagnostic::error(&SettingError::from(error), None))
}

#[pymethods]
impl Model {
    /// Reads a model file.
    #[staticmethod]
    fn load(path: PathBuf) -> PyResult<Self> {
        let model = InputFile::from_path(&path).and_then(InputFile::into_any_model);
        Ok(Self(Arc::new(model.map_err(raise)?)))
    }

    /// Reads a model from text that is reported as `name`.
    #[staticmethod]
    fn from_text(text: &str, name: &str) -> PyResult<Self> {
        Ok(Self(Arc::new(StudyModel::from_source(diagnostics::Source::new(name, text)).map_err(raise)?)))
    }

    /// The text that it was read from and those of the tables that it names, by which [`Model::from_texts`] has it again.
    fn texts(&self) -> ModelTexts {
        model_texts(&self.0)
    }

    /// The model with these texts; no file is opened.
    #[staticmethod]
    fn from_texts(texts: ModelTexts) -> PyResult<Self> {
        let (model, tables) = texts;
        Ok(Self(Arc::new(model_from_texts(&model, &tables).map_err(raise)?)))
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        self.0.name()
    }

    /// The text that it was read from.
    #[getter]
    fn text(&self) -> &str {
        self.0.source().text()
    }

    /// Warnings about it.
    #[getter]
    fn warnings(&self) -> Vec<Diagnostic> {
        self.0.warnings().iter().map(Diagnostic::new).collect()
    }

    /// Warnings of values that settings make hardly possible.
    fn warnings_of_settings(&self, set: Vec<String>) -> Vec<Diagnostic> {
        self.0.warnings_of_settings(&set).iter().map(Diagnostic::new).collect()
    }

    /// Name, words and SI unit of each output.
    fn outputs(&self) -> Vec<(String, String, String)> {
        let described = self.0.described_outputs().into_iter();
        described.map(|(name, words, unit)| (name, words, unit.symbol().to_owned())).collect()
    }

    /// Path, SI unit and value of every number that can be set, in the order of the file.
    fn parameters(&self) -> Vec<(String, String, f64)> {
        let nominal = self.0.quantities().nominal();
        let settable = self.0.quantities().iter().filter(|(_, quantity)| quantity.is_settable());
        let of = |(id, quantity): (QuantityId, &Quantity)| {
            (quantity.path.clone(), SiUnit::of_dimension(quantity.dimension).symbol().to_owned(), nominal[id])
        };
        settable.map(of).collect()
    }

    /// The value of the input `path` that `text` states with its unit, SI.
    fn value_of(&self, path: &str, text: &str) -> PyResult<f64> {
        let setting = Setting::parse(&format!("{path}={text}"), self.0.quantities(), |path| self.0.find(path));
        Ok(setting.map_err(|error| raise(of_argument("inputs", error)))?.value_si)
    }

    /// Refuses a value of the input `path`, SI, that the model does not allow.
    fn check_value(&self, path: &str, value_si: f64) -> PyResult<()> {
        let Ok(quantity) = self.0.find(path) else { return Ok(()) };
        let checked = self.0.quantities()[quantity].check(value_si);
        checked.map_err(|error| raise(of_argument("inputs", diagnostics::Diagnostic::error(&error, None))))
    }

    /// Refuses settings `path=value` that the model does not take, and the first row of `values`, SI, whose inputs `names` it does not allow
    /// with them.
    fn check_rows(
        &self,
        names: Vec<String>,
        values: PyReadonlyArray2<'_, f64>,
        settings: Vec<String>,
        paths: Vec<String>,
    ) -> PyResult<()> {
        let planar = self.planar("simulate_many()")?;
        planar.points_of_paths(&paths).map_err(raise)?;
        let is_law =
            |text: &String| text.split_once('=').is_some_and(|(path, _)| planar.contact_of_law(path.trim()).is_some());
        let (laws, numbers): (Vec<String>, Vec<String>) = settings.into_iter().partition(is_law);
        let model = planar.set_values(&laws).map_err(raise)?.model;
        let parse = |text: &String| planar.parse_setting(text).map_err(|error| raise(of_argument("set", error)));
        let stated = numbers.iter().map(parse).collect::<PyResult<Vec<_>>>()?;
        let find = |name: &String| planar.find(name).map_err(|error| raise(of_unknown("inputs", error)));
        let ids = names.iter().map(find).collect::<PyResult<Vec<QuantityId>>>()?;
        for (run, row) in values.as_array().rows().into_iter().enumerate() {
            let stated = stated.iter().map(|setting| (setting.id, setting.value_si));
            let all: Vec<(QuantityId, f64)> = stated.chain(ids.iter().copied().zip(row.iter().copied())).collect();
            if let Err(error) = model.quantities.evaluate(&all) {
                return Err(of_run(run, diagnostics::Diagnostic::error(&error, None)));
            }
        }
        Ok(())
    }

    /// Whether `path` is that of the law of a contact, whatever its name.
    fn is_path_of_law(&self, path: &str) -> bool {
        self.0.contact_of_law(path).is_some()
    }

    /// Output, component, deviation, and key and value of the place of what results call `name`; an angle in rad after its drive.
    #[allow(clippy::type_complexity, reason = "keys of a question")]
    fn question_of(&self, name: &str) -> PyResult<(String, Option<&'static str>, &'static str, Place)> {
        let NamedQuestion { output, component, of, place } =
            NamedQuestion::of_name(&self.0, name).map_err(|error| raise_problem(&error))?;
        let place = match place {
            NamedPlace::Cycle => ("at", "cycle".to_owned(), None),
            NamedPlace::Reduced(word) => ("reduce", word.to_owned(), None),
            NamedPlace::Pose(drive, angle_rad) => ("poses", drive, Some(angle_rad)),
        };
        Ok((output, component, of, place))
    }

    /// Runs it once. `set` holds texts `path=value`, `measured` paths of tables, `paths` points `BODY.POINT`; what is left out is as the file has it.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[pyo3(signature = (turns, transient, samples, tolerance, states, second_run, set, integrator, lyapunov, measured, start, paths))]
    fn simulate(
        &self,
        py: Python<'_>,
        turns: Option<f64>,
        transient: Option<f64>,
        samples: Option<i64>,
        tolerance: &str,
        states: bool,
        second_run: bool,
        set: Vec<String>,
        integrator: &str,
        lyapunov: Option<i64>,
        measured: Vec<PathBuf>,
        start: Option<PyRef<'_, Simulation>>,
        paths: Vec<String>,
    ) -> PyResult<Simulation> {
        let start = start.as_deref().map(Simulation::end_state).transpose()?;
        let plan = Plan {
            // The run that is continued has settled already.
            cycle: self.cycle("simulate()", turns, transient.or(start.map(|_| 0.0)), samples)?,
            settings: Settings {
                tolerance_m: tolerance_m(tolerance)?,
                integrator: integrator_named(integrator)?,
                ..Settings::for_simulation()
            },
            with_states: states,
            lyapunov_turns: lyapunov_turns(lyapunov)?,
            second_run,
            overrides: Override::from_settings(&set),
        };
        single_run::simulate(
            py,
            &self.planar("simulate()")?.with_paths(&paths).map_err(raise)?,
            &set,
            &plan,
            start,
            &measured,
        )
    }

    /// Refuses a model in which no joint wears, or that lacks what a run needs.
    fn demand_wear(&self) -> PyResult<()> {
        let model = self.planar("wear()")?;
        model.demand_dynamics().and_then(|()| model.demand_wear()).map_err(raise)
    }

    /// Its motion without dynamics, with the settings `set` and the paths of the points `paths`.
    fn motion(&self, py: Python<'_>, set: Vec<String>, paths: Vec<String>) -> PyResult<Motion> {
        Motion::of_file(py, self.file(), set, paths)
    }

    /// What is known of it before it runs.
    fn check(&self, py: Python<'_>) -> PyResult<Check> {
        Check::of_file(py, self.file())
    }

    /// A value of the quantity `path`, SI, as a text with its unit that reads back to the same bits. Errors name the `argument`.
    fn text_of_value(&self, argument: &str, path: &str, value_si: f64) -> PyResult<String> {
        let id = self.0.find(path).map_err(|error| raise(of_unknown(argument, error)))?;
        Ok(exact_value(value_si, &SiUnit::of_dimension(self.0.quantities()[id].dimension)))
    }

    /// Runs for many values of the quantity `over`: `points` equally spaced ones from and to the texts `between`, or `values` in SI. Also
    /// warnings about the request.
    #[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
    #[pyo3(signature = (over, between, values, points, transient, turns, tolerance, set, threads, progress))]
    fn sweep(
        &self,
        py: Python<'_>,
        over: &str,
        between: Option<[String; 2]>,
        values: Vec<f64>,
        points: i64,
        transient: i64,
        turns: i64,
        tolerance: &str,
        set: Vec<String>,
        threads: Option<i64>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<(Sweep, Vec<Diagnostic>)> {
        let points = count("points", points, SWEEP_POINTS)? as usize;
        let written = between.map(|[from, to]| format!("{over}={from}..{to}"));
        let request = SweepRequest {
            values: match &written {
                Some(over) => SweptValues::Between { over, points },
                None => SweptValues::Listed { path: over, values_si: &values },
            },
            set: &set,
            transient_turns: count("transient", transient, SWEEP_TRANSIENT_TURNS)?,
            recorded_turns: count("turns", turns, SWEEP_TURNS)?,
            tolerance,
        };
        let by = (tolerance_m(tolerance)?, count_threads(threads)?);
        Sweep::of_model(py, self.planar("sweep()")?, &request, by, progress.as_ref())
    }
}
