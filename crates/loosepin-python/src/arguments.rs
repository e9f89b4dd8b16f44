//! Arguments that several functions of Python take; errors name them.

use std::ops::RangeInclusive;

use loosepin::diagnostics::{Code, problems};
use loosepin::model::{Rule, measured_argument};
use loosepin::simulate::{EXPONENT_TURNS, Integrator};
use loosepin::units::Dimension;
use pyo3::prelude::*;

use crate::error::{raise, raise_problem};

problems! {
    /// An argument of the right type that has an impossible value.
    #[derive(Debug)]
    pub enum ArgumentProblem {
        /// A whole number outside of its range.
        Count { name: &'static str, given: i64, least: i64, most: i64 } => Code::BreaksRule,
            says("{name} {given}; must be between {least} and {most}");
        /// A number of turns that is none.
        Turns { name: &'static str, given: f64, rule: Rule } => Code::BreaksRule,
            says("{name} {given:?}; must be a number {}", rule.words());
        /// A name of an integrator that is none.
        Integrator { given: String } => Code::UnknownChoice,
            says("integrator '{given}'; must be 'explicit' or 'implicit'");
        /// What is integrated, of a model that has no dynamics.
        NoDynamics { call: &'static str } => Code::WrongKindOfFile,
            says("{call} needs a planar model: there is no dynamics in space, where motion() and check() answer");
        /// A table with other columns.
        Columns { found: usize, due: usize } => Code::BadCount,
            says("inputs: {found} columns; must be {due}");
    }
}

/// Threads; as for the command.
const THREADS: RangeInclusive<i64> = 1..=1024;

/// A whole number within `range`.
pub fn count(name: &'static str, given: i64, range: RangeInclusive<i64>) -> PyResult<u32> {
    if range.contains(&given) {
        return Ok(given as u32);
    }
    let (least, most) = range.into_inner();
    Err(raise_problem(&ArgumentProblem::Count { name, given, least, most }))
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
        _ => Err(raise_problem(&ArgumentProblem::Integrator { given: name.to_owned() })),
    }
}

/// The turns of a Lyapunov exponent, where one is asked for.
pub fn lyapunov_turns(turns: Option<i64>) -> PyResult<Option<u32>> {
    turns.map(|turns| count("lyapunov", turns, EXPONENT_TURNS)).transpose()
}
