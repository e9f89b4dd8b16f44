//! `loosepin simulate`.

use std::sync::atomic::AtomicBool;

use loosepin::check::never_moving;
use loosepin::measured::MeasuredTable;
use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Rule, measured_argument};
use loosepin::report::{short_simulation_text, simulation_page, simulation_text};
use loosepin::results::ResultKind;
use loosepin::simulate::record::{Override, SimulationRecord, StopReason};
use loosepin::simulate::{Integrator, Plan, Settings, SmallestClearance};
use loosepin::study::{check_measured, run_inputs, run_into};
use loosepin::units::Dimension;

use super::inputs::{check_tolerance, read_model, warn};
use super::stored::{FirstScreen, StoredResult, claim, print_result, run_and_write, show_found};
use crate::arguments::{IntegratorKind, SimulateArguments};
use crate::ending::{Done, Ending, Failure};

/// Runs the model, or shows the stored run.
pub fn run(arguments: &SimulateArguments) -> Ending {
    simulate_and_show::<SimulationRecord>(arguments)
}

/// Runs the model or reads the stored run, and shows it as an `R`.
pub fn simulate_and_show<R: StoredResult + From<SimulationRecord>>(arguments: &SimulateArguments) -> Ending {
    let model = read_model(&arguments.model)?.with_paths(&arguments.path)?;
    let set = model.set_values(&arguments.set)?;
    warn(&set.warnings());
    let plan = plan(arguments, &model)?;
    check_tolerance(plan.settings.tolerance_m, SmallestClearance::of(&set.model, &set.values))?;
    let measured = measured(arguments)?;
    let claim = claim(
        ResultKind::Simulation,
        &model.name,
        run_inputs(&model, &arguments.set, &plan, &measured),
        &arguments.output,
    );
    // Compiled first, so that no folder is created for a model that cannot run.
    let mechanism = Mechanism::new(&set.model, &set.values).map_err(|error| error.diagnostic(&model))?;
    warn(&never_moving(&mechanism, &set.values));
    check_measured(&mechanism, &measured)?;
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<R>(folder, arguments.shown);
    }
    run_and_write(folder, |folder| {
        let never = AtomicBool::new(false);
        let finished = run_into(folder, (&mechanism, &set), &plan, &measured, &simulation_page, &never)?;
        let done = print_result(&R::from(finished.record), folder, arguments.shown)?;
        // The files are kept to show the cause.
        finished.failure.map_or(Ok(done), |failure| Err(failure.into()))
    })
}

impl StoredResult for SimulationRecord {
    const PAGE: fn(&Self) -> String = simulation_page;
    const TEXT: fn(&Self) -> String = simulation_text;
    const SHORT: Option<FirstScreen<Self>> =
        Some((short_simulation_text, |_| "contact laws, oscillations, impacts per turn, wear and the energy balance"));

    fn done(&self) -> Done {
        match self.stop {
            StopReason::Finished => Done::Well,
            StopReason::Failed { .. } => Done::RunFailed,
        }
    }
}

fn plan(arguments: &SimulateArguments, model: &Model) -> Result<Plan, Failure> {
    let mut cycle = model.cycle.clone();
    cycle.recorded_turns = arguments.turns.unwrap_or(cycle.recorded_turns);
    cycle.transient_turns = arguments.transient.unwrap_or(cycle.transient_turns);
    cycle.samples_per_turn = arguments.samples.map_or(cycle.samples_per_turn, |samples| samples as usize);
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    let integrator = match arguments.integrator {
        IntegratorKind::Explicit => Integrator::Explicit,
        IntegratorKind::Implicit => Integrator::Implicit,
    };
    Ok(Plan {
        cycle,
        settings: Settings { tolerance_m, integrator, ..Settings::for_simulation() },
        with_states: arguments.states,
        lyapunov_turns: arguments.lyapunov,
        second_run: !arguments.no_second_run,
        overrides: Override::from_settings(&arguments.set),
    })
}

/// The tables of measured curves.
fn measured(arguments: &SimulateArguments) -> Result<Vec<MeasuredTable>, Failure> {
    arguments.measured.iter().map(|path| Ok(MeasuredTable::from_path(path)?)).collect()
}
