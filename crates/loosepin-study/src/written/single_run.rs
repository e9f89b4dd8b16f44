//! A single run of one mechanism, in its folder of results, as by `loosepin simulate`.

use std::sync::atomic::AtomicBool;

use crate::file::Study;
use crate::written::inputs::add_planar_model;
use crate::written::simulate_command::witness_settings;
use crate::written::stored_records::run_tables;
use crate::written::tables::{FilesError, SUMMARY_FILE};
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Cycle, Model, PartNames, SetValues};
use loosepin_result::json::Stored;
use loosepin_result::simulation::{EndState, Override, SimulationRecord};
use loosepin_result::study::Witness;
use loosepin_simulate::accuracy::check_quasi_static;
use loosepin_simulate::measured::{MeasuredTable, compare_with_measured};
use loosepin_simulate::{Integrator, MotionState, Plan, Settings, Simulation, columns, simulate_from};
use loosepin_store::results::{InputsHash, InputsHasher, REPORT_FILE, ResultKind, ResultsFolder};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Problem};

/// The settings `path=value` and the plan of the run at a witness of `study`: those of the command that the study prints, random inputs as
/// in the model. `None` if the witness has a parameter of a distribution, which no mechanism has.
pub fn witness_run(study: &Study, witness: &Witness) -> Option<(Vec<String>, Plan)> {
    let settings = witness_settings(study, witness)?;
    let cycle = Cycle {
        transient_turns: study.cycle.transient_turns,
        recorded_turns: study.cycle.recorded_turns,
        ..study.model.cycle()
    };
    let settings_of_run = Settings { tolerance_m: study.sampling.tolerance_m, ..Settings::for_simulation() };
    let overrides = Override::from_settings(&settings);
    Some((
        settings,
        Plan {
            cycle,
            settings: settings_of_run,
            with_states: false,
            lyapunov_turns: None,
            second_run: true,
            overrides,
        },
    ))
}

/// The hash of everything that a single run of `model` is computed from.
pub fn run_inputs(model: &Model, settings: &[String], plan: &Plan, measured: &[MeasuredTable]) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Simulation);
    add_planar_model(&mut hasher, model);
    for set in settings {
        hasher.add("set", set);
    }
    for point in &model.asked_paths {
        hasher.add("path", model.point(*point));
    }
    for table in measured {
        hasher.add("measured", table.text());
    }
    if let Some(turns) = plan.lyapunov_turns {
        hasher.add("lyapunov_turns", turns.to_string());
    }
    if !plan.second_run {
        hasher.add("second_run", "false");
    }
    if plan.settings.integrator == Integrator::Implicit {
        hasher.add("integrator", "implicit");
    }
    hasher
        .add_number("transient_turns", plan.cycle.transient_turns)
        .add_number("recorded_turns", plan.cycle.recorded_turns)
        .add("samples_per_turn", plan.cycle.samples_per_turn.to_string())
        .add_number("tolerance_m", plan.settings.tolerance_m)
        .add("with_states", plan.with_states.to_string())
        .finish()
}

/// A run that came to its end, with its files written.
pub struct FinishedRun {
    /// The record of the page.
    pub record: SimulationRecord,
    /// Why it counts as failed all the same: its energy account does not bear it out.
    pub failure: Option<Diagnostic>,
}

/// Runs `mechanism` until `stop` is set, holds its positions against the worst case of the play, and compares it with measured curves. It
/// begins from `start`, the state at the end of another run, or from the initial state of the model.
///
/// # Errors
/// Why the run failed or was stopped; a state or a measured table that does not fit.
pub fn run_and_compare(
    (mechanism, set): (&Mechanism, &SetValues),
    plan: &Plan,
    start: Option<&EndState>,
    measured: &[MeasuredTable],
    stop: &AtomicBool,
) -> Result<Simulation, Diagnostics> {
    let model = &mechanism.model;
    let start = start.map(|end| MotionState::of_record(mechanism, &set.values, end)).transpose().map_err(report)?;
    let mut simulation = simulate_from(mechanism, &set.values, plan, start.as_ref(), stop)
        .map_err(|failure| failure.diagnostic(model))?;
    for table in measured {
        simulation.record.repeat.add_measured("--measured", table.source());
    }
    // A run that failed stays as it is, without what follows from it.
    if simulation.failure.is_none() {
        // The worst case of the unworn clearance does not hold a worn joint.
        if simulation.record.life.is_none() {
            check_quasi_static(mechanism, &set.values, &mut simulation.record)
                .map_err(|error| error.diagnostic(model))?;
        }
        for table in measured {
            compare_with_measured(table, &mut simulation.record)?;
        }
    }
    Ok(simulation)
}

/// Checks that every column of `measured` is an output of `mechanism`.
///
/// # Errors
/// Each column that is none, or has another dimension.
pub fn check_measured(mechanism: &Mechanism, measured: &[MeasuredTable]) -> Result<(), Diagnostics> {
    let outputs = columns(&mechanism.model);
    let outputs: Vec<_> = outputs.iter().map(|column| (column.name.as_str(), &column.unit)).collect();
    measured.iter().try_for_each(|table| table.check(&outputs))
}

/// As [`run_and_compare`], and writes what came of it into its folder; `page` makes its report. Where it comes to no end, the folder is
/// left to the process that has taken it.
///
/// # Errors
/// As for [`run_and_compare`]; what the file system refuses.
pub fn run_into(
    folder: &mut ResultsFolder,
    of: (&Mechanism, &SetValues),
    plan: &Plan,
    measured: &[MeasuredTable],
    page: &dyn Fn(&SimulationRecord) -> String,
    stop: &AtomicBool,
) -> Result<FinishedRun, Diagnostics> {
    let simulation = run_and_compare(of, plan, None, measured, stop)?;
    let mut write = |name: &str, text: &str| folder.write(name, text.as_bytes()).map_err(report);
    for (name, text) in run_tables(&simulation.record, simulation.states.as_ref()) {
        write(name, &text)?;
    }
    // The last files of a result.
    let summary = simulation.record.to_json().map_err(|source| report(FilesError::Json { source }))?;
    write(SUMMARY_FILE, &summary)?;
    write(REPORT_FILE, &page(&simulation.record))?;
    folder.finish().map_err(report)?;
    let failure = simulation.failure.map(|failure| failure.diagnostic(&of.0.model));
    Ok(FinishedRun { record: simulation.record, failure })
}

fn report(problem: impl Problem) -> Diagnostics {
    Diagnostics::one(&problem, None)
}
