//! One run of a model, as the command `loosepin simulate` makes it.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use loosepin::diagnostics::{self, Diagnostics};
use loosepin::measured::MeasuredTable;
use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, SetValues};
use loosepin::simulate::record::EndState;
use loosepin::simulate::{Plan, SmallestClearance, ToleranceProblem};
use loosepin::study::{check_measured, run_and_compare};
use pyo3::prelude::*;

use crate::error::{raise, raise_problem};
use crate::mechanism::simulation::Simulation;
use crate::waiting::wait_for;

/// Refuses a tolerance that is larger than the smallest clearance; a warning where it is coarse.
pub fn check_tolerance(tolerance_m: f64, smallest: Option<SmallestClearance>) -> PyResult<Option<ToleranceProblem>> {
    let checked = smallest.map(|smallest| smallest.check(tolerance_m)).transpose();
    checked.map(Option::flatten).map_err(|error| raise_problem(&error))
}

/// Runs `model` with the settings `set` by `plan`, from `start` or from its initial state, and compares it with the tables of measured curves.
pub fn simulate(
    py: Python<'_>,
    model: &Model,
    set: &[String],
    plan: &Plan,
    start: Option<&EndState>,
    measured: &[PathBuf],
) -> PyResult<Simulation> {
    let set = model.set_values(set).map_err(raise)?;
    let coarse = check_tolerance(plan.settings.tolerance_m, SmallestClearance::of(&set.model, &set.values))?;
    let stop = AtomicBool::new(false);
    let work = || simulated(&set, plan, start, measured, &stop);
    let (outcome, raised) = wait_for(py, &stop, |_| Ok(()), work);
    match (raised, outcome) {
        (Some(error), _) => Err(error),
        (None, Err(diagnostics)) => Err(raise(diagnostics)),
        (None, Ok((simulation, failure))) => {
            let coarse = coarse.iter().map(|warning| diagnostics::Diagnostic::warning(warning, None));
            let warnings = set.warnings().into_iter().chain(coarse).collect();
            Ok(Simulation::new(simulation, failure, warnings))
        }
    }
}

/// The run, and why it counts as failed although it came to its end.
type Simulated = (loosepin::simulate::Simulation, Option<Diagnostics>);

fn simulated(
    set: &SetValues,
    plan: &Plan,
    start: Option<&EndState>,
    measured: &[PathBuf],
    stop: &AtomicBool,
) -> Result<Simulated, Diagnostics> {
    let measured: Vec<MeasuredTable> =
        measured.iter().map(|path| MeasuredTable::from_path(path)).collect::<Result<_, _>>()?;
    let mechanism =
        Mechanism::new(&set.model, &set.values).map_err(|error| Diagnostics::from(error.diagnostic(&set.model)))?;
    check_measured(&mechanism, &measured)?;
    let simulation = run_and_compare((&mechanism, set), plan, start, &measured, stop)?;
    let failure = simulation.failure.as_ref().map(|failure| failure.diagnostic(&mechanism.model).into());
    Ok((simulation, failure))
}
