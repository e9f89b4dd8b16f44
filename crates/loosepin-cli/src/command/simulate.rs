//! `loosepin simulate`.

use loosepin::accuracy::check_quasi_static;
use loosepin::measured::{MeasuredTable, lay_over};
use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Rule, SetValues, measured_argument};
use loosepin::report::{simulation_page, simulation_text};
use loosepin::results::{Claim, HISTORY_FILE, IMPACTS_FILE, InputsHash, InputsHasher, REPORT_FILE, ResultKind};
use loosepin::results::{ResultsFolder, SUMMARY_FILE};
use loosepin::simulate::record::SimulationRecord;
use loosepin::simulate::{Plan, Settings, columns, history_csv, impacts_csv, simulate};
use loosepin::units::Dimension;

use super::inputs::{add_model, overrides, read_model};
use super::stored::{StoredResult, place, read_record, run_and_write, show_again, tell, tell_again, to_json};
use crate::arguments::SimulateArguments;
use crate::ending::{Ending, Failure};

/// Runs the model, or shows the run that is there.
pub fn run(arguments: &SimulateArguments) -> Ending {
    let model = read_model(&arguments.model)?;
    let set = model.set_values(&arguments.set)?;
    let plan = plan(arguments, &model)?;
    let measured = measured(arguments)?;
    let claim = Claim {
        kind: ResultKind::Simulation,
        name: model.name.clone(),
        inputs: inputs(&model, arguments, &plan, &measured),
        place: place(&arguments.output),
        with_force: arguments.output.force,
    };
    // Compiled first, so that a model that cannot run leaves no folder behind.
    let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.complaint(&model))?;
    let outputs = columns(&mechanism);
    let outputs: Vec<_> = outputs.iter().map(|column| (column.name.as_str(), &column.unit)).collect();
    for table in &measured {
        table.check(&outputs)?;
    }
    let mut folder = claim.take()?;
    if folder.is_finished() {
        tell_again(&folder);
        return show_again::<SimulationRecord>(&mut folder);
    }
    run_and_write(folder, |folder| {
        let record = simulated(&mechanism, &set, &plan, &measured, folder)?;
        tell(&record, folder)
    })
}

impl StoredResult for SimulationRecord {
    fn read(folder: &ResultsFolder) -> Result<Self, Failure> {
        read_record(folder)
    }

    fn page(&self) -> String {
        simulation_page(self)
    }

    fn text(&self) -> String {
        simulation_text(self)
    }
}

/// Runs the model and writes what came of it.
fn simulated(
    mechanism: &Mechanism,
    set: &SetValues,
    plan: &Plan,
    measured: &[MeasuredTable],
    folder: &mut ResultsFolder,
) -> Result<SimulationRecord, Failure> {
    let model = &mechanism.model;
    let mut simulation = simulate(mechanism, &set.values, plan).map_err(|failure| failure.complaint(model))?;
    check_quasi_static(mechanism, &set.values, &mut simulation.record).map_err(|error| error.complaint(model))?;
    for table in measured {
        lay_over(table, &mut simulation.record)?;
    }
    folder.write(HISTORY_FILE, history_csv(&simulation).as_bytes())?;
    folder.write(IMPACTS_FILE, impacts_csv(&simulation.record).as_bytes())?;
    folder.write(SUMMARY_FILE, to_json(&simulation.record, folder, SUMMARY_FILE)?.as_bytes())?;
    folder.write(REPORT_FILE, simulation_page(&simulation.record).as_bytes())?;
    folder.finish()?;
    Ok(simulation.record)
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
        overrides: overrides(&arguments.set),
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
