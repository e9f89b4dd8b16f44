//! Bounds of any vectorised function of Python: the uncertainty wing without a mechanism.

use std::fmt;

use loosepin::bounds::{self, BoundPair, EvaluateError, Problem, Reading, Request, SampleTable, Sampling, Statistic};
use loosepin::diagnostics::{self, Code};
use loosepin::uncertainty::Copula;
use loosepin::units::listed;
use numpy::{IntoPyArray, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::column::Column;
use crate::error::raise_problem;
use crate::growing_samples::{Accuracy, GrowingSamples};
use crate::inputs::Inputs;
use crate::waiting::without_gil;

/// Bounds that cannot be had of a function.
#[derive(Debug)]
struct FunctionProblem(EvaluateError);

impl fmt::Display for FunctionProblem {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(formatter)
    }
}

impl diagnostics::Problem for FunctionProblem {
    fn code(&self) -> Code {
        match self.0 {
            EvaluateError::Plan(_) => Code::SamplingNotPossible,
            EvaluateError::Table(_) => Code::AllRunsFailed,
        }
    }
}

/// How many runs are spent, as Python states it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Runs {
    outer: usize,
    inner: usize,
    replicates: usize,
    mixture: usize,
    extreme: usize,
    seed: u64,
    confidence: f64,
}

/// Bounds of the statistics of the columns of `function`, which is given a list of arrays, one for each input, random ones first,
/// and gives an array with a row for each run. Returns the answers and the runs as plain values for `_function_bounds.py`.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "they are the arguments of Python")]
#[pyo3(signature = (function, inputs, columns, requests, ranks, reading, runs, accuracy))]
pub fn evaluate<'py>(
    py: Python<'py>,
    function: Bound<'py, PyAny>,
    inputs: Vec<(String, Bound<'py, PyAny>)>,
    columns: Vec<String>,
    requests: Vec<(usize, String, Option<f64>)>,
    ranks: Vec<(String, String, f64)>,
    reading: &str,
    runs: Runs,
    accuracy: Accuracy,
) -> PyResult<Bound<'py, PyDict>> {
    let inputs = Inputs::read(inputs)?;
    let copula = inputs.copula(&ranks)?;
    let problem = Problem {
        random: inputs.random.clone(),
        copula: copula.map(Copula::Gaussian),
        epistemic: inputs.epistemic.clone(),
        parameters: inputs.parameters.clone(),
        reading: reading_of(reading)?,
        readings_beside: Vec::new(),
        columns: columns.len(),
        requests: self::requests(&requests)?,
        compared_columns: (0..columns.len()).collect(),
        band_probability: bounds::BAND_PROBABILITY,
        cut_standard_deviations: bounds::CUT_STANDARD_DEVIATIONS,
        percentiles: bounds::PERCENTILES.to_vec(),
        sampling: Sampling {
            outer: runs.outer,
            inner: runs.inner,
            replicates: runs.replicates,
            mixture: runs.mixture,
            extreme: runs.extreme,
            seed: runs.seed,
            confidence: runs.confidence,
        },
    };
    let fail = |error: EvaluateError| raise_problem(&FunctionProblem(error));
    let mut plan = GrowingSamples::try_new(problem, &accuracy).map_err(|error| fail(error.into()))?;
    let mut table = SampleTable::new(columns.len());
    loop {
        let round = plan.next_round(py, &table, |error| fail(error.into()))?;
        if round.is_empty() {
            break;
        }
        let random = (0..inputs.random.len()).map(|k| round.iter().map(|run| run.random[k]).collect());
        let epistemic = (0..inputs.epistemic.len()).map(|k| round.iter().map(|run| run.epistemic[k]).collect());
        let arrays = random.chain(epistemic).map(|values: Vec<f64>| values.into_pyarray(py));
        let given = function.call1((PyList::new(py, arrays.collect::<Vec<_>>())?,))?;
        let given: PyReadonlyArray2<'_, f64> = given.extract()?;
        for (inputs, row) in round.into_iter().zip(given.as_array().rows()) {
            table.push(inputs, Ok(&row.to_vec())).map_err(|error| fail(error.into()))?;
        }
    }
    let answers = without_gil(py, || plan.results(&table))?.map_err(|error| fail(error.into()))?;
    let names = Names { random: &inputs.random_names, epistemic: &inputs.epistemic_names, columns: &columns };
    let given = answer(py, &answers, &names, &table)?;
    plan.tell(&given)?;
    Ok(given)
}

/// Names of inputs and columns.
pub struct Names<'n> {
    /// The random inputs.
    pub random: &'n [String],
    /// The epistemic inputs.
    pub epistemic: &'n [String],
    /// The columns.
    pub columns: &'n [String],
}

/// Requests for statistics of columns, as Python states them.
pub fn requests(stated: &[(usize, String, Option<f64>)]) -> PyResult<Vec<Request>> {
    let request = |(column, name, parameter): &(usize, String, Option<f64>)| {
        Ok(Request { column: *column, statistic: statistic(name, *parameter)? })
    };
    stated.iter().map(request).collect()
}

/// Names of the inputs in the order of the arrays of [`evaluate`]: the random ones; then the others, and uncertain parameters of
/// distributions.
#[pyfunction]
pub fn input_names(inputs: Vec<(String, Bound<'_, PyAny>)>) -> PyResult<(Vec<String>, Vec<String>)> {
    let inputs = Inputs::read(inputs)?;
    Ok((inputs.random_names, inputs.epistemic_names))
}

fn statistic(name: &str, parameter: Option<f64>) -> PyResult<Statistic> {
    let known = Statistic::from_word(name, parameter);
    // A band for whole curves needs to know which columns are a curve.
    known.filter(|statistic| !statistic.is_of_curve()).ok_or_else(|| {
        let names = |statistics: &[Statistic]| -> Vec<String> {
            let known = statistics.iter().filter(|statistic| !statistic.is_of_curve());
            known.map(|statistic| format!("'{}'", statistic.word())).collect()
        };
        let (plain, with_parameter) = (names(&Statistic::PLAIN), names(&Statistic::with_parameter(f64::NAN)));
        PyValueError::new_err(format!(
            "statistic '{name}'; must be {}, or {{name: number}} with {}",
            plain.join(", "),
            listed(&with_parameter, "or")
        ))
    })
}

fn reading_of(word: &str) -> PyResult<Reading> {
    Reading::ALL.into_iter().find(|reading| reading.file_word() == word).ok_or_else(|| {
        PyValueError::new_err(format!("reading '{word}'; must be 'fixed', 'unknown-distribution' or 'random-set'"))
    })
}

/// Everything as plain values of Python.
pub fn answer<'py>(
    py: Python<'py>,
    answers: &bounds::Bounds,
    names: &Names<'_>,
    table: &SampleTable,
) -> PyResult<Bound<'py, PyDict>> {
    let given = PyDict::new(py);
    given.set_item("bounds", pairs(py, &answers.pairs, names)?)?;
    let levels = answers.levels.iter().map(|level| Ok((level.alpha, pairs(py, &level.pairs, names)?)));
    given.set_item("cuts", levels.collect::<PyResult<Vec<_>>>()?)?;
    let boxes = answers.boxes.iter().map(|each| {
        let ends = |of: &[bounds::Bound]| of.iter().map(|bound| bound.widened).collect::<Vec<f64>>().into_pyarray(py);
        (each.column, each.values.clone().into_pyarray(py), ends(&each.lower), ends(&each.upper))
    });
    given.set_item("boxes", boxes.collect::<Vec<_>>())?;
    let mut bands = Vec::new();
    for each in &answers.comparisons {
        for band in [&each.probability_only, &each.interval_only, &each.mixed] {
            let coverage = (band.coverage.minimum, band.coverage.maximum);
            bands.push((
                each.column,
                band.treatment.word(),
                band.lower.value,
                band.upper.value,
                coverage.0,
                coverage.1,
            ));
        }
    }
    given.set_item("bands", bands)?;
    let rows = || 0..table.len();
    // A run without a number in some column failed there.
    let failed_runs = rows().filter(|&run| table.values(run).iter().any(|value| !value.is_finite())).count();
    given.set_item("runs", (answers.runs, failed_runs, answers.rounds))?;
    given.set_item("gaps", answers.gaps.map(|gaps| (gaps.between_points, gaps.between_runs)))?;
    let of_inputs = |k: usize| rows().map(|run| table.inputs()[run].random[k]).collect();
    let of_unknown = |k: usize| rows().map(|run| table.inputs()[run].epistemic[k]).collect();
    let of_outputs = |k: usize| rows().map(|run| table.values(run)[k]).collect();
    let named = |called: &[String], values: &dyn Fn(usize) -> Vec<f64>| -> Vec<Column> {
        called.iter().enumerate().map(|(k, name)| Column::of_numbers(py, name, "1", values(k))).collect()
    };
    let purposes = rows().map(|run| table.inputs()[run].purpose.word());
    given.set_item("purpose", purposes.collect::<Vec<_>>())?;
    let mut samples = named(names.random, &of_inputs);
    samples.extend(named(names.epistemic, &of_unknown));
    given.set_item("inputs", samples)?;
    given.set_item("outputs", named(names.columns, &of_outputs))?;
    Ok(given)
}

fn pairs<'py>(py: Python<'py>, pairs: &[BoundPair], names: &Names<'_>) -> PyResult<Bound<'py, PyList>> {
    let records = pairs.iter().map(|pair| {
        let [lower, upper] = pair.ends();
        let record = PyDict::new(py);
        record.set_item("column", pair.column)?;
        record.set_item("statistic", pair.statistic.word())?;
        record.set_item("parameter", pair.statistic.parameter())?;
        record.set_item("lower", end(py, &lower, names)?)?;
        record.set_item("upper", end(py, &upper, names)?)?;
        let (guarantee, confidence) = pair.guarantee().word_and_confidence();
        record.set_item("guarantee", guarantee)?;
        record.set_item("confidence", confidence)?;
        Ok(record)
    });
    PyList::new(py, records.collect::<PyResult<Vec<_>>>()?)
}

fn end<'py>(py: Python<'py>, bound: &bounds::Bound, names: &Names<'_>) -> PyResult<Bound<'py, PyDict>> {
    let witness = PyDict::new(py);
    if let Some(found) = &bound.witness {
        for (name, value) in names.epistemic.iter().zip(&found.epistemic) {
            witness.set_item(name, value)?;
        }
        for (name, value) in names.random.iter().zip(&found.random) {
            witness.set_item(name, value)?;
        }
    }
    let record = PyDict::new(py);
    record.set_item("value", bound.value)?;
    record.set_item("widened", bound.widened)?;
    record.set_item("error_sampling", bound.error.sampling)?;
    record.set_item("error_optimisation", bound.error.optimisation)?;
    record.set_item("error_surrogate", bound.error.surrogate)?;
    record.set_item("witness", witness)?;
    Ok(record)
}
