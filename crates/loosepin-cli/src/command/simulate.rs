//! `loosepin simulate`.

use loosepin::accuracy::check_quasi_static;
use loosepin::measured::{MeasuredTable, lay_over};
use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Rule, SetValues, measured_argument};
use loosepin::report::{simulation_page, simulation_text};
use loosepin::results::{
    HISTORY_FILE, IMPACTS_FILE, InputsHash, InputsHasher, ResultKind, ResultsFolder, SPECTRUM_FILE, WEAR_FILE,
};
use loosepin::simulate::record::{Override, SimulationRecord, StopReason};
use loosepin::simulate::{
    Plan, Settings, SmallestClearance, columns, history_csv, impacts_csv, simulate, spectrum_csv, wear_csv,
};
use loosepin::units::Dimension;

use serde::Serialize;

use super::inputs::{add_model, check_tolerance, read_model};
use super::stored::{StoredResult, claim, run_and_write, show_found, write_and_tell};
use crate::arguments::SimulateArguments;
use crate::ending::{Done, Ending, Failure};

/// Runs the model, or shows the run that is there.
pub fn run(arguments: &SimulateArguments) -> Ending {
    run_shown::<SimulationRecord>(arguments)
}

/// Runs the model, or takes the run that is there, and shows it as `R` does.
pub fn run_shown<R: StoredResult + Serialize + From<SimulationRecord>>(arguments: &SimulateArguments) -> Ending {
    let model = read_model(&arguments.model)?;
    let set = model.set_values(&arguments.set)?;
    let plan = plan(arguments, &model)?;
    check_tolerance(plan.settings.tolerance_m, SmallestClearance::of(&set.model, &set.values))?;
    let measured = measured(arguments)?;
    let claim =
        claim(ResultKind::Simulation, &model.name, inputs(&model, arguments, &plan, &measured), &arguments.output);
    // Compiled first, so that a model that cannot run leaves no folder behind.
    let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.complaint(&model))?;
    let outputs = columns(&mechanism.model);
    let outputs: Vec<_> = outputs.iter().map(|column| (column.name.as_str(), &column.unit)).collect();
    for table in &measured {
        table.check(&outputs)?;
    }
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<R>(folder);
    }
    run_and_write(folder, |folder| simulated::<R>(&mechanism, &set, &plan, &measured, folder))
}

impl StoredResult for SimulationRecord {
    const PAGE: fn(&Self) -> String = simulation_page;
    const TEXT: fn(&Self) -> String = simulation_text;

    fn done(&self) -> Done {
        match self.stop {
            StopReason::Finished => Done::Well,
            StopReason::Failed { .. } => Done::RunFailed,
        }
    }
}

/// Runs the model and writes what came of it.
fn simulated<R: StoredResult + Serialize + From<SimulationRecord>>(
    mechanism: &Mechanism,
    set: &SetValues,
    plan: &Plan,
    measured: &[MeasuredTable],
    folder: &mut ResultsFolder,
) -> Ending {
    let model = &mechanism.model;
    let mut simulation = simulate(mechanism, &set.values, plan).map_err(|failure| failure.complaint(model))?;
    for table in measured {
        simulation.record.repeat.add_measured("--measured", table.source());
    }
    // A run that failed is written as it is, without what follows from it.
    if simulation.failure.is_none() {
        check_quasi_static(mechanism, &set.values, &mut simulation.record).map_err(|error| error.complaint(model))?;
        for table in measured {
            lay_over(table, &mut simulation.record)?;
        }
    }
    folder.write(HISTORY_FILE, history_csv(&simulation).as_bytes())?;
    folder.write(IMPACTS_FILE, impacts_csv(&simulation.record).as_bytes())?;
    if let Some(spectrum) = spectrum_csv(&simulation.record) {
        folder.write(SPECTRUM_FILE, spectrum.as_bytes())?;
    }
    if let Some(wear) = wear_csv(&simulation.record.wear) {
        folder.write(WEAR_FILE, wear.as_bytes())?;
    }
    let ending = write_and_tell(&R::from(simulation.record), folder)?;
    // The files stay: they show what went wrong.
    simulation.failure.map_or(Ok(ending), |failure| Err(failure.complaint(model).into()))
}

fn plan(arguments: &SimulateArguments, model: &Model) -> Result<Plan, Failure> {
    let mut cycle = model.cycle.clone();
    cycle.recorded_turns = arguments.turns.unwrap_or(cycle.recorded_turns);
    cycle.transient_turns = arguments.transient.unwrap_or(cycle.transient_turns);
    cycle.samples_per_turn = arguments.samples.map_or(cycle.samples_per_turn, |samples| samples as usize);
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    Ok(Plan {
        cycle,
        settings: Settings { tolerance_m, ..Settings::for_simulation() },
        with_states: arguments.states,
        lyapunov_turns: arguments.lyapunov,
        overrides: Override::of_settings(&arguments.set),
    })
}

/// The tables of measured curves.
fn measured(arguments: &SimulateArguments) -> Result<Vec<MeasuredTable>, Failure> {
    arguments.measured.iter().map(|path| Ok(MeasuredTable::from_path(path)?)).collect()
}

fn inputs(model: &Model, arguments: &SimulateArguments, plan: &Plan, measured: &[MeasuredTable]) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Simulation);
    add_model(&mut hasher, model);
    for set in &arguments.set {
        hasher.add("set", set);
    }
    for table in measured {
        hasher.add("measured", table.text());
    }
    if let Some(turns) = plan.lyapunov_turns {
        hasher.add("lyapunov_turns", turns.to_string());
    }
    hasher
        .add_number("transient_turns", plan.cycle.transient_turns)
        .add_number("recorded_turns", plan.cycle.recorded_turns)
        .add("samples_per_turn", plan.cycle.samples_per_turn.to_string())
        .add_number("tolerance_m", plan.settings.tolerance_m)
        .add("with_states", plan.with_states.to_string())
        .finish()
}
