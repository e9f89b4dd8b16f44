//! Arguments that several functions of Python take; errors name them.

use std::ops::RangeInclusive;

use loosepin::diagnostics::{Diagnostic, Diagnostics};
use loosepin::model::{Rule, measured_argument};
use loosepin::simulate::{EXPONENT_TURNS, Integrator};
use loosepin::units::Dimension;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::{of_argument, raise};

/// Threads; as for the command.
const THREADS: RangeInclusive<i64> = 1..=1024;

/// A whole number within `range`.
pub fn count(name: &str, given: i64, range: RangeInclusive<i64>) -> PyResult<u32> {
    if range.contains(&given) {
        return Ok(given as u32);
    }
    let (least, most) = range.into_inner();
    Err(PyValueError::new_err(format!("{name} {given}; must be between {least} and {most}")))
}

/// As many threads as asked for, otherwise as many as the machine has.
pub fn count_threads(asked: Option<i64>) -> PyResult<usize> {
    match asked {
        Some(threads) => Ok(count("threads", threads, THREADS)? as usize),
        None => Ok(loosepin::study::default_threads()),
    }
}

/// The tolerance of positions that `text` states with its unit.
pub fn tolerance_m(text: &str) -> PyResult<f64> {
    measured_argument("tolerance", text, Dimension::LENGTH, Rule::Positive).map_err(raise)
}

/// The integrator with this name.
pub fn integrator_named(name: &str) -> PyResult<Integrator> {
    match name {
        "explicit" => Ok(Integrator::Explicit),
        "implicit" => Ok(Integrator::Implicit),
        _ => Err(PyValueError::new_err(format!("integrator '{name}'; must be 'explicit' or 'implicit'"))),
    }
}

/// The turns of a Lyapunov exponent, where one is asked for.
pub fn lyapunov_turns(turns: Option<i64>) -> PyResult<Option<u32>> {
    turns.map(|turns| count("lyapunov", turns, EXPONENT_TURNS)).transpose()
}

/// Options of the command that hints of the library name, and that are arguments here.
const OPTIONS: [&str; 3] = ["--integrator", "--lyapunov", "--set"];

/// The exception for what the library says of settings or of a run: options of the command are named as the arguments that they are here.
pub fn raise_of_arguments(diagnostics: Diagnostics) -> PyErr {
    let named = |diagnostic: &Diagnostic| {
        let is_of_set = diagnostic.place.as_ref().is_some_and(|place| place.source.name().starts_with("--set"));
        let diagnostic = if is_of_set { of_argument("set", diagnostic.clone()) } else { diagnostic.clone() };
        let plain = |hint: String| OPTIONS.iter().fold(hint, |hint, option| hint.replace(option, &option[2..]));
        Diagnostic { hint: diagnostic.hint.map(plain), ..diagnostic }
    };
    raise(diagnostics.sorted().into_iter().map(named).collect::<Diagnostics>())
}
